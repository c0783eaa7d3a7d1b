"""A scan that did not come to its end is offered on Home: resume, keep what is there, discard and take that back."""

from __future__ import annotations

import json
import sqlite3
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.program import Program
from app.views.home_page import HomePage
from app.views.interrupted_strip import InterruptedStrip
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.recovery import describe
from scanner_core.case.store import CaseStore, Order
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.specimens import load_specimen
from tests.gui.waiting import until, wait_ms


@pytest.fixture(scope="module")
def interrupted(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """A case as a program leaves it that is killed in the second of three views."""
    path = tmp_path_factory.mktemp("cases") / "R-1_left_ear_2026-11-27.impronta"
    specimen = load_specimen("ear")
    with CaseStore.create(path) as store:
        store.put_order(Order("R-1", "P-1", "left", "ear"))
        with open_rig(load_preset("bench"), specimen, seed=5) as rig:
            runner = ScanRunner(rig, PlanRequest(3, 600, specimen.radius_mm, specimen.height_mm), store)
            runner.start()
            while not runner.join(0.005):
                if runner.status().state is ScanState.SCANNING and runner.status().counts.measured > 250:
                    runner.cancel()
    connection = sqlite3.connect(path)
    connection.execute("UPDATE scan SET finish_reason = NULL, ended = NULL WHERE kind = 'scan'")
    connection.commit()
    connection.close()
    return path.read_bytes()


@pytest.fixture
def case(interrupted: bytes, settings_file: Path) -> Path:
    """The same in the case folder of the program that is about to start."""
    folder = Path(json.loads(settings_file.read_text())["case_folder"])
    folder.mkdir(parents=True)
    path = folder / "R-1_left_ear_2026-11-27.impronta"
    path.write_bytes(interrupted)
    return path


@pytest.fixture
def strip(case: Path, program: Program) -> InterruptedStrip:
    """Asked for before the program, so that it starts with the case in its folder."""
    home = program.window.pages["home"]
    assert isinstance(home, HomePage)
    until(lambda: home.strip.text, 20, "the offer")
    assert "R-1" in home.strip.text
    assert "of 600 points, 1 of 3 views complete" in home.strip.text
    assert "The program ended in the middle of it." in home.strip.text
    return home.strip


def _ready(program: Program) -> None:
    rig = program.services.rig
    until(lambda: rig.snapshot.connected and rig.snapshot.calibration is not None and rig.snapshot.calibrating is None, 120, "the rig")


def test_resume_scans_what_is_missing(strip: InterruptedStrip, program: Program, case: Path) -> None:
    services = program.services
    _ready(program)
    until(strip.resume.isEnabled, 10)
    QTest.mouseClick(strip.resume, Qt.MouseButton.LeftButton)
    until(lambda: services.acquisition.running, 20, "the scan")
    assert program.window.page_id == "scan"
    until(lambda: not services.acquisition.running, 120, "its end")
    result = services.acquisition.result
    assert result is not None, program.window.banner.text
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    assert result.resumed is not None
    assert result.resumed > 250
    assert services.case.path == case
    until(lambda: not strip.text, 20, "nothing more to offer")
    assert program.window.banner.text == ""


def test_keep_opens_the_case_with_its_points(strip: InterruptedStrip, program: Program, case: Path) -> None:
    QTest.mouseClick(strip.keep, Qt.MouseButton.LeftButton)
    until(lambda: program.services.case.path == case and program.services.case.cloud is not None, 60, "the case")
    until(lambda: not strip.text, 20, "nothing more to offer")
    program.window.close()
    with CaseStore.open(case) as store:
        assert store.scans()[-1].finish_reason == FinishReason.CANCELLED.value
        assert any(line.event == "kept" for line in store.audit_trail())


def test_discard_deletes_nothing_and_is_taken_back(strip: InterruptedStrip, program: Program, case: Path) -> None:
    QTest.mouseClick(strip.discard, Qt.MouseButton.LeftButton)
    until(lambda: "was discarded" in strip.text, 20, "the words")
    until(lambda: not program.services.recovery.busy, 20)
    with CaseStore.open(case, read_only=True) as store:
        assert describe(store) is None
        assert sum(store.verdict_counts(store.scans()[-1].id).values()) > 250
    QTest.mouseClick(strip.undo, Qt.MouseButton.LeftButton)
    until(lambda: "did not come to its end" in strip.text and not program.services.recovery.busy, 20, "the offer again")
    with CaseStore.open(case, read_only=True) as store:
        assert describe(store) is not None


def test_a_new_case_is_remembered_at_once(program: Program, settings_file: Path) -> None:
    """A program that is killed has no shutdown."""
    _ready(program)
    services = program.services
    program.window.start_scan()
    until(lambda: services.case.path is not None, 20, "the case")
    path = services.case.path
    wait_ms(300)
    assert json.loads(settings_file.read_text())["recent_cases"] == [str(path)]
    program.window.laser_off()
    until(lambda: not services.acquisition.running, 30)


def test_a_scan_that_fails_in_this_session_is_offered(program: Program) -> None:
    _ready(program)
    services, window = program.services, program.window
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.counts.measured > 100, 60, "points")
    rig = services.rig._rig
    assert rig is not None
    rig.left.close()  # it is gone
    until(lambda: not services.acquisition.running, 30, "the end")
    assert services.acquisition.result is not None
    assert services.acquisition.result.finish_reason is FinishReason.FAILED
    home = window.pages["home"]
    assert isinstance(home, HomePage)
    window.show_page("home")
    until(lambda: "A fault ended it." in home.strip.text, 20, "the offer")
