from __future__ import annotations

import json
import logging
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest

from app.program import Program
from app.settings import settings_path
from app.theme import look
from app.views.file_dialogs import FileDialog
from app.views.support_dialog import KINDS, SupportDialog
from app.views.support_preview import MOST_CHARACTERS, SupportPreview
from scanner_core.errors import DeviceError
from scanner_core.log_file import log_files, logging_to_file
from scanner_core.user_folders import log_folder, settings_file
from tests.gui.pictures import near, pixels_of
from tests.gui.waiting import until


@pytest.fixture
def dialog(shared_program: Program, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[SupportDialog]:
    """Opened from the menu, with an order that must not be in it."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with logging_to_file("the window"):
        shared_program.services.draft.edit("order", "QX-7731")
        shared_program.services.draft.edit("patient_code", "Zwölfender")
        logging.getLogger("impronta").warning("typed QX-7731 of Zwölfender")
        until(lambda: shared_program.services.rig.snapshot.connected, 60, "the rig")
        shared_program.window.actions_by_id["support"].trigger()
        made = shared_program.window.findChild(SupportDialog)
        assert made is not None
        until(lambda: made.entries.count() and made.save.isEnabled(), 30, "the entries")
        yield made
        made.close()
        for other in shared_program.window.findChildren(FileDialog):
            other.close()


def _choose(dialog: SupportDialog, name: str) -> None:
    rows = [row for row in range(dialog.entries.count()) if dialog.entries.item(row).data(Qt.ItemDataRole.UserRole) == name]
    dialog.entries.setCurrentRow(rows[0])


def test_every_entry_can_be_read_before_anything_is_saved(dialog: SupportDialog, tmp_path: Path) -> None:
    names = [dialog.entries.item(row).data(Qt.ItemDataRole.UserRole) for row in range(dialog.entries.count())]
    assert names == ["rig.toml", "transcript.txt", "doctor.json", "machine.json", "settings.json", "cases.json", "log-0.txt"]
    for name in names:
        _choose(dialog, name)
        assert len(dialog.preview.toPlainText()) > 2
    _choose(dialog, "doctor.json")
    report = json.loads(dialog.preview.toPlainText())
    assert {"rig", "checks", "controller", "cameras"} <= set(report)
    assert report["controller"]["transcript"]
    assert all(check["verdict"] in ("pass", "warn", "fail") for check in report["checks"])
    assert not list(tmp_path.glob("*.zip"))


def test_what_was_taken_out_is_marked(dialog: SupportDialog) -> None:
    _choose(dialog, "log-0.txt")
    text = dialog.preview.toPlainText()
    assert "typed [order] of [patient]" in text
    assert "7731" not in text
    assert "Replaced: " in dialog.said.text()
    assert near(pixels_of(dialog.preview), look.accent_dim, 6).sum() > 100


def test_an_entry_without_its_tick_is_not_saved(dialog: SupportDialog, tmp_path: Path) -> None:
    before = dialog.said.text()
    dialog.entries.item(0).setCheckState(Qt.CheckState.Unchecked)
    assert dialog.left_out() == ["rig.toml"]
    assert dialog.said.text() != before
    QTest.mouseClick(dialog.save, Qt.MouseButton.LeftButton)
    chooser = dialog.findChild(FileDialog) or next(iter(dialog.parent().findChildren(FileDialog)))
    assert not chooser.isModal()
    path = tmp_path / "bundle.zip"
    chooser.fileSelected.emit(str(path))
    until(lambda: "Saved as" in dialog.said.text(), 20, "the archive")
    with zipfile.ZipFile(path) as archive:
        assert sorted(archive.namelist()) == sorted(
            ["README.txt", "transcript.txt", "doctor.json", "machine.json", "settings.json", "cases.json", "log-0.txt"]
        )
        everything = "".join(archive.read(name).decode() for name in archive.namelist())
    assert "7731" not in everything
    assert "lfender" not in everything


def test_a_place_that_cannot_be_written_is_told_in_the_dialog(dialog: SupportDialog, shared_program: Program, tmp_path: Path) -> None:
    dialog._save(tmp_path / "no" / "such.zip")
    until(lambda: "such.zip" in dialog.said.text(), 20, "the sentence")
    assert "cannot be written" in dialog.said.text()
    assert dialog.save.isEnabled()


def test_it_never_stands_in_the_way(dialog: SupportDialog) -> None:
    assert not dialog.isModal()
    assert QKeySequence.mnemonic(dialog.save.text()) != QKeySequence.mnemonic(dialog.again.text())


def test_a_long_log_is_shown_from_its_end(shared_program: Program) -> None:
    preview = SupportPreview()
    preview.show_text("first\n" + "x" * MOST_CHARACTERS + "\nlast", from_end=True)
    assert preview.toPlainText().endswith("last")
    assert "first\n" not in preview.toPlainText()
    assert len(preview.toPlainText()) < MOST_CHARACTERS + 100


def test_every_kind_of_entry_has_its_words(dialog: SupportDialog) -> None:
    assert {entry.kind for entry in dialog._support.state.bundle.entries} <= set(KINDS)


def test_the_details_of_a_fault_offer_the_bundle_and_the_log_has_it(shared_program: Program, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    banner = shared_program.window.banner
    with logging_to_file("the window"):
        shared_program.tell(DeviceError("E-MOT-02", port="/dev/ttyUSB0", details="errno 5"))
        until(lambda: banner.text, 10, "the banner")
        assert banner._support.isHidden()
        banner._toggle.click()
        assert not banner._support.isHidden()
    text = log_files(log_folder())[0].read_text(encoding="utf-8")
    assert all(part in text for part in ("E-MOT-02", "/dev/ttyUSB0", "errno 5"))
    banner.dismiss()


def test_the_command_finds_the_windows_settings() -> None:
    assert settings_file() == settings_path()
