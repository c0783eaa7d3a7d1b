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
from tests.gui.waiting import until


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


@pytest.fixture(scope="module")
def case(interrupted: bytes, shared_settings: Path) -> Path:
    """The same in the case folder of the program that is about to start."""
    folder = Path(json.loads(shared_settings.read_text())["case_folder"])
    folder.mkdir(parents=True)
    path = folder / "R-1_left_ear_2026-11-27.impronta"
    path.write_bytes(interrupted)
    return path


@pytest.fixture
def program(case: Path, shared_program: Program) -> Program:
    """Started with the case in its folder."""
    rig = shared_program.services.rig
    until(lambda: rig.snapshot.connected and rig.snapshot.calibration is not None and rig.snapshot.calibrating is None, 120, "the rig")
    return shared_program


def _strip(program: Program) -> InterruptedStrip:
    home = program.window.pages["home"]
    assert isinstance(home, HomePage)
    program.window.show_page("home")
    return home.strip


def test_at_the_start_discard_deletes_nothing_is_taken_back_and_keep_opens_the_case(program: Program, case: Path) -> None:
    services, strip = program.services, _strip(program)
    until(lambda: strip.text, 20, "the offer")
    assert "R-1" in strip.text
    assert "of 600 points, 1 of 3 views complete" in strip.text
    assert "The program ended in the middle of it." in strip.text
    QTest.mouseClick(strip.discard, Qt.MouseButton.LeftButton)
    until(lambda: "was discarded" in strip.text, 20, "the words")
    until(lambda: not services.recovery.busy, 20)
    with CaseStore.open(case, read_only=True) as store:
        assert describe(store) is None
        assert sum(store.verdict_counts(store.scans()[-1].id).values()) > 250
    QTest.mouseClick(strip.undo, Qt.MouseButton.LeftButton)
    until(lambda: "did not come to its end" in strip.text and not services.recovery.busy, 20, "the offer again")
    with CaseStore.open(case, read_only=True) as store:
        assert describe(store) is not None
    QTest.mouseClick(strip.keep, Qt.MouseButton.LeftButton)
    until(lambda: services.case.path == case and services.case.cloud is not None, 60, "the case")
    until(lambda: not strip.text, 20, "nothing more to offer")
    store = services.case.store
    assert store is not None
    assert store.scans()[-1].finish_reason == FinishReason.CANCELLED.value
    assert any(line.event == "kept" for line in store.audit_trail())


def test_resume_scans_what_is_missing(program: Program, case: Path, interrupted: bytes) -> None:
    services, strip = program.services, _strip(program)
    other = case.with_name("R-2_left_ear_2026-11-27.impronta")
    other.write_bytes(interrupted)
    services.recovery.look()
    until(lambda: strip.text and strip.resume.isEnabled(), 20, "the offer")
    QTest.mouseClick(strip.resume, Qt.MouseButton.LeftButton)
    until(lambda: services.acquisition.running, 20, "the scan")
    assert program.window.page_id == "scan"
    until(lambda: not services.acquisition.running, 120, "its end")
    result = services.acquisition.result
    assert result is not None, program.window.banner.text
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    assert result.resumed is not None
    assert result.resumed > 250
    assert services.case.path == other
    store = services.case.store
    assert store is not None
    newest = [scan for scan in store.scans() if scan.kind == "scan"][-1]
    assert (services.case.source["scans"], services.case.source["calibration"]) == ([newest.id], newest.calibration_id)
    until(lambda: not strip.text, 20, "nothing more to offer")
    assert program.window.banner.text == ""


def test_a_new_case_is_remembered_at_once_and_a_scan_that_fails_is_offered(program: Program, shared_settings: Path) -> None:
    """A program that is killed has no shutdown."""
    services, window = program.services, program.window
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.counts.measured > 100, 60, "points")
    assert json.loads(shared_settings.read_text())["recent_cases"][0] == str(services.case.path)
    rig = services.rig._rig
    assert rig is not None
    rig.left.close()  # it is gone
    until(lambda: not services.acquisition.running, 30, "the end")
    assert services.acquisition.result is not None
    assert services.acquisition.result.finish_reason is FinishReason.FAILED
    strip = _strip(program)
    until(lambda: "A fault ended it." in strip.text, 20, "the offer")
