"""The page of the settings: in force at once, kept at once, and taken back by Ctrl+Z like everything else."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QCheckBox

from app.controllers.preferences import STEPS
from app.main import _scale
from app.palettes import DARK, LIGHT
from app.program import Program
from app.settings import Settings, load_settings, save_settings
from app.theme import look, set_theme
from app.views.settings_page import SettingsPage


def _page(program: Program) -> SettingsPage:
    page = program.window.pages["settings"]
    assert isinstance(page, SettingsPage)
    program.window.show_page("settings")
    return page


def test_a_choice_is_in_force_and_on_the_disk_at_once_and_undo_takes_it_back(
    shared_program: Program, shared_settings: Path, application: QApplication
) -> None:
    page, window = _page(shared_program), shared_program.window
    page.themes["light"].click()
    assert look.text == LIGHT.text
    assert load_settings(shared_settings).theme == "light"
    assert window.actions_by_id["undo"].isEnabled()
    window.undo()
    assert look.text == DARK.text
    assert page.themes["system"].isChecked()
    assert load_settings(shared_settings).theme == "system"
    set_theme(application, "dark")


def test_a_reset_is_one_step(shared_program: Program, shared_settings: Path) -> None:
    page, window = _page(shared_program), shared_program.window
    for box in page.findChildren(QCheckBox):
        box.click()
    page.scales[150].click()
    changed = load_settings(shared_settings)
    assert (changed.code_in_names, changed.live_surface, changed.retry, changed.scale_percent) == (True, False, False, 150)
    page.reset.click()
    first, now = Settings(), load_settings(shared_settings)
    assert {name: getattr(now, name) for name in STEPS} == {name: getattr(first, name) for name in STEPS}
    assert page.scales[100].isChecked()
    window.undo()
    again = load_settings(shared_settings)
    assert {name: getattr(again, name) for name in STEPS} == {name: getattr(changed, name) for name in STEPS}


def test_the_pattern_of_names_shows_what_it_gives_and_is_kept(shared_program: Program, shared_settings: Path) -> None:
    page = _page(shared_program)
    page.names.template.setText("{order}-{rev}")
    page.names.template.textEdited.emit("{order}-{rev}")
    page.names.template.editingFinished.emit()
    assert load_settings(shared_settings).name_template == "{order}-{rev}"
    assert page.names.names.text().endswith("-1.stl")


@pytest.mark.parametrize(("percent", "wanted"), [(100, None), (150, "1.5"), (200, "2"), (1000, None)])
def test_the_size_is_handed_to_qt_before_it_starts(percent: int, wanted: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("QT_SCALE_FACTOR", "")
    monkeypatch.delenv("QT_SCALE_FACTOR")
    save_settings(Settings(scale_percent=percent), tmp_path / "settings.json")
    _scale(tmp_path / "settings.json")
    assert os.environ.get("QT_SCALE_FACTOR") == wanted
