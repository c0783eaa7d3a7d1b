"""The wanted uncertainty on the scan page: what the button says, what is told while it runs and at the end."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from app.program import Program
from app.views.scan_page import ScanPage
from app.views.scan_words import coverage_words, step_words
from scanner_core.acquisition.passes import PassesEnd, SteeringResult, SteeringStatus
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.status import ScanCounts, ScanState, ScanStatus
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import Reason
from scanner_core.coverage.report import CoverageReport
from scanner_core.errors import ReconstructionError


def place(reason: Reason) -> CoveragePlace:
    return CoveragePlace(reason, (0.0, 0.0, 1.0), (0.0, 0.0, 1.0), 12.0, None)


def result(end: PassesEnd | None, *places: CoveragePlace) -> SteeringResult:
    report = CoverageReport(40.0, np.zeros(4, np.uint8), 0.9, 0.984, places)
    return SteeringResult(40.0, (), end, report, None, None, 1.0)


def test_the_wish_is_a_draft_value_that_the_scan_is_asked_with(shared_program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    window, services = shared_program.window, shared_program.services
    page = window.pages["scan"]
    assert isinstance(page, ScanPage)
    asked: list[PlanRequest] = []
    monkeypatch.setattr(services.acquisition, "start", asked.append)
    window.show_page("scan")
    field = page.wish.fields["until_um"]
    assert field.text() == "none"
    window.start_scan()
    field.setValue(40)
    assert services.draft.values.until_um == 40
    assert page.start.text() == "Scan until 40 µm"
    window.start_scan()
    window.undo()
    assert field.value() == 0
    assert page.start.text() == "Start scan"
    assert [request.until_um for request in asked] == [None, 40.0]


def test_while_it_runs_the_pass_and_what_is_within_are_told(application: QApplication) -> None:
    def told(steering: SteeringStatus | None, state: ScanState = ScanState.SCANNING) -> str:
        return step_words(ScanStatus(state, ScanCounts(100, 50), view=17, views=24, steering=steering))

    assert told(None) == "View 18 of 24"
    assert told(SteeringStatus(40.0, 1, False)) == "Coarse pass: view 18 of 24"
    assert told(SteeringStatus(40.0, 1, True)) == "Computing where more points are needed…"
    assert told(SteeringStatus(40.0, 2, False, 0.71, 0.9)) == "Pass 2, where it is needed: view 18 of 24\n71 % within 40 µm so far"
    assert told(SteeringStatus(40.0, 2, False, 0.71, 0.9), ScanState.PAUSED).startswith("Paused")


def test_at_the_end_one_line_says_what_it_has_come_to(application: QApplication) -> None:
    hidden = [place(Reason.BELOW), place(Reason.LEFT_HIDDEN)]
    assert coverage_words(result(PassesEnd.WITHIN)) == "98 % within 40 µm"
    assert coverage_words(result(PassesEnd.NO_GAIN, *hidden, place(Reason.FEW_POINTS))) == (
        "98 % within 40 µm; 2 places cannot be seen from this mount; more points would not help"
    )
    assert (
        coverage_words(result(PassesEnd.POINTS_SPENT, hidden[0])) == "98 % within 40 µm; 1 place cannot be seen from this mount; all points are spent"
    )
    refused = SteeringResult(40.0, (), PassesEnd.UNIFORM, None, None, ReconstructionError("E-REC-02", reason="they leave no inside"), 0.0)
    assert "they leave no inside" in coverage_words(refused)
