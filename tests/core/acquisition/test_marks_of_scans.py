"""Scans of a rig with marks: visited at every view, kept as measured, beside the counts and points of the object; and asked before resuming."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from scanner_core.acquisition.mark_visits import KIND, VisitPlan, case_marks, marks_report
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.processing import Gates, Processing, case_cloud, process_case
from scanner_core.case.recovery import interruption
from scanner_core.case.store import CaseStore
from scanner_core.devices.marks_config import shipped_marks
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.bench_faults import BenchFault, CameraBumped, LostSteps
from scanner_core.virtual.rim_balls import true_centres_mm
from scanner_core.virtual.specimens import load_specimen

MARKS = shipped_marks("bench")
BENCH = replace(load_preset("bench"), marks=MARKS)
SPHERE = load_specimen("sphere")
VIEWS, POINTS = 3, 180


def scan(store: CaseStore, *faults: BenchFault, resume: bool = False, stop_at: int | None = None) -> ScanResult:
    request = PlanRequest(VIEWS, POINTS, SPHERE.radius_mm, SPHERE.height_mm)
    with open_rig(BENCH, SPHERE, seed=5, faults=faults) as rig:
        runner = ScanRunner(rig, request, store, interruption=interruption(store) if resume else None)
        runner.start()
        while not runner.join(0.005):
            status = runner.status()
            if stop_at is not None and status.state is ScanState.SCANNING and status.counts.measured >= stop_at:
                runner.cancel()
        assert runner.result is not None
        counts = runner.result.counts
        assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
        return runner.result


@pytest.fixture(scope="module")
def interrupted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A case whose scan was stopped in its second view."""
    path = tmp_path_factory.mktemp("cases") / "a.impronta"
    with CaseStore.create(path) as store:
        result = scan(store, stop_at=90)
        assert result.finish_reason is FinishReason.CANCELLED
    return path


@pytest.fixture
def case(interrupted: Path, tmp_path: Path) -> Path:
    path = tmp_path / "a.impronta"
    path.write_bytes(interrupted.read_bytes())
    return path


def test_marks_are_visited_and_everything_of_them_can_be_computed_again(case: Path) -> None:
    with CaseStore.open(case) as store:
        result = scan(store, resume=True)
        assert result.finish_reason is FinishReason.COMPLETED, result.error
        assert not [finding for finding in result.health.findings if finding.code.startswith("H-MARK")]
        report = result.marks
        assert report is not None
        assert report.marks_um is not None
        assert 3 < report.marks_um < 40
        assert report.visits == VIEWS + 1 + 1  # the second view twice, for the interruption, and the end of the turn
        records = [record for record in store.scans() if record.kind == "scan"]
        again = marks_report(store, records[0])
        assert again is not None
        assert again == report
        json.dumps(report.as_dict())
        during = Counter(visit.during for record in store.scans() if (visit := VisitPlan.of(record)) is not None)
        assert during == {"search": 2, "scan": VIEWS + 2, "check": 1}
        for record in store.scans():
            counts: Any = record.counts
            if record.kind == KIND and counts is not None:
                assert counts["planned"] == counts["measured"] + sum(counts["rejected"].values()) + counts["skipped"]
        assert "where they were" in next(line.detail for line in store.audit_trail() if line.event == "marks visited again")
        assert "marks_um" in next(line.detail for line in store.audit_trail() if line.event == "marks" and "calibrated" in line.detail)
        assert case_marks(store) == report
        assert len(case_cloud(store).points) == POINTS
        wide = process_case(store, Processing(gates=Gates(volume_radius_mm=140.0))).cloud.points
        away = np.linalg.norm(wide[:, None] - true_centres_mm(MARKS), axis=2).min(axis=1)
        assert away.min() > MARKS.ball_radius_mm + 1


def test_a_camera_that_moved_meanwhile_ends_it_and_changes_nothing(case: Path) -> None:
    with CaseStore.open(case) as store:
        of = interruption(store)
        assert of is not None
        before = store.exposed_ids(of.record.id)
        result = scan(store, CameraBumped(across_px=0.0, along_px=0.4), resume=True)
        assert result.error is not None
        assert result.error.code == "E-MARK-01"
        assert "camera had moved" in str(result.error)
        np.testing.assert_array_equal(store.exposed_ids(of.record.id), before)
        assert interruption(store) is not None


def test_lost_steps_are_named_on_a_sphere_which_cannot_tell_them_itself(case: Path) -> None:
    with CaseStore.open(case) as store:
        result = scan(store, LostSteps(lost_deg=0.3), resume=True)  # in its first move, after the check
        (lost,) = [finding for finding in result.health.findings if finding.code.startswith("H-MARK")]
        assert (lost.code, lost.view) == ("H-MARK-01", 1)
        assert lost.value == pytest.approx(-0.3, abs=0.02)
        assert result.marks is not None
        assert result.marks.marks_um is not None
        assert result.marks.marks_um > 100
