"""Home: the orders, a new one, an interrupted scan; and what lies over the window on the first day."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

from app.views.home_page import HomePage
from app.views.support_dialog import SupportDialog
from tests.gui.tour.registry import scenes
from tests.gui.tour.tour import Tour
from tests.gui.waiting import until, wait_ms


@scenes("home-empty", "tour")
def first_day(tour: Tour) -> Iterator[str]:
    settings, worklist = tour.services.settings, tour.services.worklist
    before = settings.case_folder, settings.recent_cases
    with tempfile.TemporaryDirectory() as empty:
        settings.case_folder, settings.recent_cases = empty, []
        tour.rig_ready()
        worklist.look()
        until(lambda: worklist.known and not worklist.orders, 30, "no orders")
        tour.window.show_page("home")
        yield "home-empty"
        tour.window.show_tour()
        card = tour.window.help.tour
        assert card is not None
        card.go(1)
        yield "tour"
        card.end()
    settings.case_folder, settings.recent_cases = before
    worklist.look()


@scenes("home", "home-found", "order", "interrupted")
def orders(tour: Tour) -> Iterator[str]:
    page, worklist = tour.page("home", HomePage), tour.services.worklist
    cases = Path(tour.services.settings.case_folder)
    tour.rig_ready()
    worklist.look()
    until(lambda: len(worklist.orders) >= 9, 90, f"the orders, {len(worklist.orders)}")
    tour.window.show_page("home")
    page.list.select_first()
    until(lambda: all(worklist.picture(told) for told in worklist.orders if told.mesh), 60, "the thumbnails")
    page.wedge.setFocus()
    yield "home"
    page.wedge.setText("2026-0142")
    yield "home-found"
    page.wedge.clear()
    tour.window.new_case()
    tour.services.new_order.edit("side", "both")
    page.form.names.unfold(True)
    yield "order"
    page.form.names.unfold(False)
    page.show_start()
    path = tour.prepared.interrupt(cases)
    worklist.look()
    tour.services.recovery.look()
    until(lambda: page.strip.text and page.strip.resume.isEnabled(), 60, "the offer to resume")
    yield "interrupted"
    path.unlink()
    tour.services.recovery.look()
    until(lambda: tour.services.recovery.scan is None, 30, "nothing more to offer")


@scenes("settings")
def settings(tour: Tour) -> Iterator[str]:
    tour.window.show_page("settings")
    yield "settings"


@scenes("shortcuts", "help", "about", "support")
def help_at_hand(tour: Tour) -> Iterator[str]:
    window = tour.window
    window.show_shortcuts()
    shortcuts = window.help.shortcuts
    assert shortcuts is not None
    shortcuts.move(window.x() + 330, window.y() + 80)
    yield "shortcuts"
    shortcuts.close()
    tour.open(tour.ear)
    window.show_page("deliver")
    until(lambda: tour.services.delivery.examination is not None, 120, "the checks")
    window.show_help()
    yield "help"
    window.help.dismiss()
    window.show_page("home")
    window.show_about()
    about = window.help.about
    assert about is not None
    about.move(window.x() + 210, window.y() + 100)
    until(lambda: about.libraries, 60, "the libraries")
    about.list.setCurrentRow(0)
    yield "about"
    about.close()
    window.show_support()
    dialog = window.findChild(SupportDialog)
    assert dialog is not None
    until(lambda: dialog.entries.count(), 60, "the support bundle")
    dialog.move(window.x() + 150, window.y() + 90)
    dialog.entries.setCurrentRow(dialog.entries.count() - 1)
    wait_ms(500)
    yield "support"
    dialog.close()
