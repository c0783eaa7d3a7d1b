"""The rig tells by itself whether it is ready, and what to do when it is not."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QApplication

from app.controllers.readiness import Readiness, Remedy
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset
from tests.gui.rig_window import RigWindow
from tests.gui.waiting import until, wait_ms


@pytest.fixture
def window(application: QApplication, tmp_path: Path) -> Iterator[RigWindow]:
    made = RigWindow(tmp_path)
    yield made
    made.close()


def _saved(config: RigConfig, folder: Path) -> Path:
    path = folder / "own.toml"
    path.write_text(dump_rig(config), encoding="utf-8")
    return path


def _answer(window: RigWindow, readiness: Readiness) -> None:
    ready = window.readiness
    until(lambda: ready.snapshot.readiness is readiness and not ready.snapshot.checking, 30, f"{readiness}; {window.page.ready.sentence}")


def test_a_rig_that_opens_is_checked_and_green_without_anybodys_doing(window: RigWindow) -> None:
    window.rig.choose(preset="bench")
    _answer(window, Readiness.READY)
    assert (window.page.ready.state, window.page.ready.sentence) == ("Ready", "Ready to measure.")
    assert not window.page.ready.remedy.isVisible()
    assert not any("M3" in line.text or "M4" in line.text for line in window.rig.transcript())


def test_an_uncalibrated_rig_offers_to_calibrate_it(window: RigWindow, tmp_path: Path) -> None:
    window.open(_saved(load_preset("bench").with_calibration(None), tmp_path))
    _answer(window, Readiness.OBSTACLE)
    assert window.page.ready.sentence == "The rig is not calibrated yet."
    assert window.page.ready.remedy.text() == "Calibrate…"
    window.page.ready.remedy.click()
    until(lambda: window.rig.snapshot.calibrating is not None, 10, "the calibration")
    window.rig.cancel_calibration()
    until(lambda: window.rig.snapshot.calibrating is None, 30, "its end")


def test_an_open_lid_is_told_and_its_closing_too(window: RigWindow) -> None:
    window.rig.choose(preset="bench", speed="5")
    _answer(window, Readiness.READY)
    window.rig.let_happen("lid_opened", 0)
    _answer(window, Readiness.OBSTACLE)
    assert window.page.ready.sentence == "The lid was opened: close it, then unlock."
    assert window.page.ready.remedy.text() == "Unlock"
    wait_ms(2500)  # the fault closes it after ten seconds of the rig's clock
    window.page.ready.remedy.click()
    _answer(window, Readiness.READY)


def test_a_disk_that_is_full_is_asked_about_again(window: RigWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=2**28))
    window.rig.choose(preset="bench")
    _answer(window, Readiness.OBSTACLE)
    assert window.page.ready.sentence == "Only 0.2 GB are free where the cases are kept: free some space."
    monkeypatch.undo()
    window.page.ready.remedy.click()
    _answer(window, Readiness.READY)


def test_a_rig_file_that_is_broken_leads_to_the_assistant(window: RigWindow, tmp_path: Path) -> None:
    path = tmp_path / "broken.toml"
    path.write_text("name = 3", encoding="utf-8")
    asked: list[str] = []
    window.page.wanted.connect(asked.append)
    window.open(path)
    _answer(window, Readiness.OBSTACLE)
    assert window.readiness.snapshot.remedy is Remedy.SET_UP
    window.page.ready.remedy.click()
    assert asked == ["assistant"]
