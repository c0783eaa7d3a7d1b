"""Help at the place, all keys, the tour, and what the program is made of."""

from __future__ import annotations

import re

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QShortcut
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.actions import ACTIONS
from app.program import Program
from app.views.help_words import HELP
from app.views.shortcuts_dialog import key_lines
from scanner_core.support.libraries import shipped_libraries
from tests.gui.waiting import until, wait_ms


def test_every_page_has_three_to_eight_sentences_of_help(shared_program: Program) -> None:
    assert set(shared_program.window.pages) <= set(HELP)
    for page, words in HELP.items():
        sentences = re.findall(r"[.:!?](?:\s|$)", " ".join((words.purpose, words.now, words.numbers)))
        assert 3 <= len(sentences) <= 8, page


def test_help_follows_the_page_and_the_control_in_hand(shared_program: Program) -> None:
    window = shared_program.window
    window.show_page("settings")
    window.actions_by_id["help"].trigger()
    panel = window.help.panel
    assert panel is not None
    assert panel.isVisible()
    assert panel.texts[0] == HELP["settings"].purpose
    window.rail.stop_button.setFocus()
    until(lambda: panel.texts[3] == "Stop · laser off", 5, "the control's name")
    assert "Stops every movement" in panel.texts[4]
    window.show_page("scan")
    assert panel.texts[1] == HELP["scan"].now
    assert panel.geometry().right() < window.pages["scan"].mapTo(window.centralWidget(), window.pages["scan"].rect().topLeft()).x() + 2
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert panel.isHidden()


def test_every_key_of_the_window_stands_in_the_overview_and_is_found(shared_program: Program) -> None:
    window = shared_program.window
    lines = key_lines(window.pages)
    told = {keys for _, _, keys in lines}
    assert {info.shortcut for info in ACTIONS if info.shortcut} <= told
    assert {"Ctrl+1", "Ctrl+,"} <= told
    shortcuts = [made for page in window.pages.values() for made in page.findChildren(QShortcut)]
    assert [made.key().toString() for made in shortcuts if not made.whatsThis()] == []
    window.actions_by_id["shortcuts"].trigger()
    dialog = window.help.shortcuts
    assert dialog is not None
    assert not dialog.isModal()
    dialog.search.setText("laser esc")
    shown = [item for group, item in dialog._items if not item.isHidden() and not group.isHidden()]
    assert [item.text(1) for item in shown] == ["Esc"]
    dialog.search.setText("nothing like that")
    assert all(group.isHidden() for group, _ in dialog._items)
    assert max(map(len, dialog.text.splitlines())) <= 80
    dialog.close()


def test_the_question_mark_opens_the_overview(shared_program: Program) -> None:
    window = shared_program.window
    window.show_page("scan")
    window.activateWindow()
    wait_ms(20)
    QTest.keyClick(window, Qt.Key.Key_Question)  # as Qt itself matches the key on every layout, whatever it is typed with
    until(lambda: window.help.shortcuts is not None and window.help.shortcuts.isVisible(), 5, "the overview")
    assert window.help.shortcuts is not None
    window.help.shortcuts.close()


def test_the_tour_points_at_what_is_there_and_costs_no_click(shared_program: Program) -> None:
    window = shared_program.window
    window.show_tour()
    tour = window.help.tour
    assert tour is not None
    titles = []
    while not tour.isHidden():
        titles.append(tour.step.title)
        target = tour.step.target()
        if target is not None:
            assert target.isVisible(), tour.step.title
            place = target.mapTo(window.centralWidget(), target.rect().center())
            assert not tour.geometry().contains(place), tour.step.title
            assert window.centralWidget().childAt(place) in (target, *target.children()), "a click there is the target's"
        assert window.centralWidget().rect().contains(tour.geometry())
        assert not tour.hasFocus()
        tour.next.click()
    assert 5 <= len(titles) <= 6
    assert len(set(titles)) == len(titles)


def test_escape_ends_the_tour_and_still_stops(shared_program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    window = shared_program.window
    stopped = []
    monkeypatch.setattr(shared_program.services.rig, "laser_off", lambda: stopped.append(True))
    window.show_tour()
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert window.help.tour is not None
    assert window.help.tour.isHidden()
    assert stopped


def test_what_is_in_the_program_is_told_with_its_licences(shared_program: Program) -> None:
    window = shared_program.window
    window.actions_by_id["about"].trigger()
    dialog = window.help.about
    assert dialog is not None
    until(lambda: dialog.copy.isEnabled(), 60, "the libraries")
    assert dialog.list.count() == len(dialog.libraries)
    dialog.copy.click()
    text = QApplication.clipboard().text()
    assert text.startswith("Impronta ")
    assert "numpy" in text
    dialog.close()


def test_the_shipped_libraries_have_names_versions_and_mostly_texts() -> None:
    libraries = {library.name.casefold(): library for library in shipped_libraries()}
    assert {"python", "numpy", "scipy", "vtk", "pyvista", "pyside6_essentials", "matplotlib"} <= set(libraries)
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in libraries["pyside6_essentials"].text
    assert "Permission is hereby granted" in libraries["pyvista"].text
    assert all(library.version for library in libraries.values())
    assert sum(not library.text for library in libraries.values()) <= 2
