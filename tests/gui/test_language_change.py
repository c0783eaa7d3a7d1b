"""Another language: the window is made anew where it was; not while something runs that would be lost."""

from __future__ import annotations

import time
from pathlib import Path

from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

from app.program import Program
from app.views.settings_page import SettingsPage
from tests.gui.waiting import until, wait_ms


def _choose(page: SettingsPage, language: str) -> None:
    page.language.setCurrentIndex(page.language.findData(language))
    page.language.activated.emit(page.language.currentIndex())


def test_the_window_is_made_anew_in_another_language(program: Program, application: QApplication, settings_file: Path) -> None:
    page = program.window.pages["settings"]
    assert isinstance(page, SettingsPage)
    program.window.show_page("settings")
    program.services.draft.edit("order", "4711")
    program.services.reconstruction.running = True
    _choose(page, "it")
    wait_ms(50)
    assert program.again is None
    assert program.window.isVisible()
    assert page._language_note.text().startswith("The window changes its language when")
    program.services.reconstruction.running = False
    _choose(page, "en")  # the window speaks it already
    wait_ms(50)
    assert program.window.isVisible()
    _choose(page, "de")
    until(lambda: not program.window.isVisible(), 30, "the end of the first window")
    again = program.again
    assert again is not None
    second = Program(application, started_s=time.perf_counter(), settings_file=settings_file, after=again)
    try:
        until(lambda: second.window.page_id == "settings", 30, "the page where the person was")
        assert second.services.draft.values.order == "4711"
        assert QLocale().decimalPoint() == ","
    finally:
        second.window.close()
        second.window.deleteLater()
    assert QLocale().name() == QLocale.system().name()
