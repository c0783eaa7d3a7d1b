"""A scan that did not come to its end is offered on Home: resume, keep what is there, discard and take that back."""

from __future__ import annotations

import json
import sqlite3
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import pytest
from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QUndoStack
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.controllers.case import CaseController
from app.controllers.recovery import RecoveryController, _found
from app.draft import Draft
from app.program import Program
from app.settings import Settings
from app.views.home_page import HomePage
from app.views.interrupted_strip import InterruptedStrip
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.recovery import describe
from scanner_core.case.store import CaseStore, Order
from scanner_core.devices.rig import load_preset
from scanner_core.errors import StorageError
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


@pytest.fixture(scope="module")
def case(interrupted: bytes, module_settings: Path) -> Path:
    """The same in the case folder of the program that is about to start."""
    folder = Path(json.loads(module_settings.read_text())["case_folder"])
    folder.mkdir(parents=True)
    path = folder / "R-1_left_ear_2026-11-27.impronta"
    path.write_bytes(interrupted)
    return path


@pytest.fixture
def program(case: Path, scanning_program: Program) -> Program:
    """Started with the case in its folder."""
    rig = scanning_program.services.rig
    until(lambda: rig.snapshot.connected and rig.snapshot.calibration is not None and rig.snapshot.calibrating is None, 120, "the rig")
    return scanning_program


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
    kept = services.case.store
    assert kept is not None
    assert kept.scans()[-1].finish_reason == FinishReason.CANCELLED.value
    assert any(line.event == "kept" for line in kept.audit_trail())


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


def test_a_new_case_is_remembered_at_once_and_a_scan_that_fails_is_offered(program: Program, module_settings: Path) -> None:
    """A program that is killed has no shutdown."""
    services, window = program.services, program.window
    services.draft.edit("views", 2)
    services.draft.edit("points", 40_000)
    window.start_scan()
    until(lambda: services.acquisition.status is not None and services.acquisition.status.counts.measured > 100, 60, "points")
    assert json.loads(module_settings.read_text())["recent_cases"][0] == str(services.case.path)
    rig = services.rig._devices.rig
    assert rig is not None
    rig.left.close()  # it is gone
    until(lambda: not services.acquisition.running, 30, "the end")
    assert services.acquisition.result is not None
    assert services.acquisition.result.finish_reason is FinishReason.FAILED
    strip = _strip(program)
    until(lambda: "A fault ended it." in strip.text, 20, "the offer")


# ------------------------------------------------------------------------------------------ behind the window
class _Scans(QObject):
    """What recovery knows of the acquisition."""

    began = Signal()
    ended = Signal()
    running = False


@dataclass
class Desk:
    path: Path
    scans: _Scans
    case: CaseController
    recovery: RecoveryController
    told: list[BaseException]


@pytest.fixture
def desk(application: QApplication, interrupted: bytes, tmp_path: Path) -> Iterator[Desk]:
    """The controllers without a window; the interrupted scan is offered."""
    path = tmp_path / "R-3_left_ear_2026-11-27.impronta"
    path.write_bytes(interrupted)
    with CaseStore.open(path) as store:
        store.edit("order", {"number": "R-4", "patient_code": "P-1", "side": "left", "type": "ear"}, "Edit order number")
    told: list[BaseException] = []
    background, settings, scans = Background(), Settings(case_folder=str(tmp_path)), _Scans()
    case = CaseController(background, settings, Draft(QUndoStack()), told.append)
    recovery = RecoveryController(background, settings, case, cast(Any, scans), told.append)
    pump = QTimer()
    pump.timeout.connect(background.drain)
    pump.start(5)
    recovery.look()
    until(lambda: recovery.scan is not None, 20, "the offer")
    yield Desk(path, scans, case, recovery, told)
    recovery.shutdown()
    assert case.shutdown(10.0)
    assert background.join(10.0) == []
    pump.stop()


def _number(path: Path) -> str:
    with CaseStore.open(path, read_only=True) as store:
        assert describe(store) is not None
        return store.order().number


def test_a_discard_that_failed_has_no_undo(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise StorageError("E-DISK-01", path=desk.path)

    monkeypatch.setattr(CaseStore, "edit", full)
    desk.recovery.discard()
    until(lambda: not desk.recovery.busy, 20)
    monkeypatch.undo()
    assert [cast(StorageError, fault).code for fault in desk.told] == ["E-DISK-01"]
    assert desk.recovery.discarded is None
    desk.recovery.undo_discard()
    wait_ms(100)
    assert _number(desk.path) == "R-4"


def test_undo_takes_the_discard_back_and_no_later_edit(desk: Desk) -> None:
    desk.recovery.discard()
    until(lambda: desk.recovery.discarded is not None, 20, "the undo")
    with CaseStore.open(desk.path) as store:
        store.edit("order", {"number": "R-5", "patient_code": "P-1", "side": "left", "type": "ear"}, "Edit order number")
    desk.recovery.undo_discard()
    until(lambda: desk.told, 20, "the sentence")
    assert "edited after the scan was discarded" in str(desk.told[0])
    with CaseStore.open(desk.path) as store:
        assert store.order().number == "R-5"
        store.undo()
    desk.recovery.undo_discard()
    until(lambda: desk.recovery.discarded is None and desk.recovery.scan is not None, 20, "the offer again")
    assert _number(desk.path) == "R-4"
    assert len(desk.told) == 1


def test_keep_does_not_close_the_case_of_a_scan_that_was_begun_meanwhile(desk: Desk) -> None:
    created: list[CaseStore] = []
    desk.recovery.keep()
    desk.scans.running = True
    desk.case.create(created.append)
    until(lambda: created and not desk.recovery.busy, 30, "both")
    wait_ms(100)
    assert desk.case.path == created[0].path
    created[0].audit("scanned", "still open")
    assert desk.told == []


def test_a_case_that_is_closed_during_a_look_is_looked_at_like_any_other(desk: Desk) -> None:
    closed = CaseStore.open(desk.path)
    closed.close()
    found = _found(desk.path.parent, [], closed, threading.Event())
    assert [scan.path for scan in found] == [desk.path]
    ending = threading.Event()
    ending.set()
    assert _found(desk.path.parent, [], None, ending) == []
