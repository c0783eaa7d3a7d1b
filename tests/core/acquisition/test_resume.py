"""An interrupted scan goes on where it was interrupted, when everything still stands where it stood."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.processing import case_cloud
from scanner_core.case.recovery import describe, discard, find_interrupted, interruption, keep
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.errors import CalibrationError
from scanner_core.virtual.specimens import Specimen, load_specimen

BENCH = load_preset("bench")
SPHERE = load_specimen("sphere")
VIEWS, POINTS = 3, 330


def scan(store: CaseStore, specimen: Specimen = SPHERE, *, seed: int, resume: bool = False, stop_at: int | None = None) -> ScanResult:
    """Scan, or go on; ends itself when so many points are measured."""
    request = PlanRequest(VIEWS, POINTS, SPHERE.radius_mm, SPHERE.height_mm)
    with open_rig(BENCH, specimen, seed=seed) as rig:
        runner = ScanRunner(rig, request, store, interruption=interruption(store) if resume else None)
        runner.start()
        while not runner.join(0.005):
            status = runner.status()
            if stop_at is not None and status.state is ScanState.SCANNING and status.counts.measured >= stop_at:
                runner.cancel()
        assert runner.result is not None
        return runner.result


def kinds(store: CaseStore) -> Counter[str]:
    return Counter(record.kind for record in store.scans())


def balanced(result: ScanResult) -> None:
    counts = result.counts
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert counts.skipped >= 0


@pytest.fixture(scope="module")
def interrupted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A case whose scan was stopped in its second view."""
    path = tmp_path_factory.mktemp("cases") / "a.impronta"
    with CaseStore.create(path) as store:
        result = scan(store, seed=3, stop_at=150)
        assert result.finish_reason is FinishReason.CANCELLED
        assert 150 <= result.counts.measured < POINTS
    return path


@pytest.fixture
def case(interrupted: Path, tmp_path: Path) -> Path:
    path = tmp_path / "a.impronta"
    path.write_bytes(interrupted.read_bytes())
    return path


def test_only_the_missing_part_is_scanned(case: Path) -> None:
    with CaseStore.open(case) as store:
        told = describe(store)
        assert told is not None
        assert (told.views_done, told.views, told.wanted) == (1, VIEWS, POINTS)
        scan_id = store.scans()[-1].id
        before = store.exposed_ids(scan_id)
        first = store.observations(scan_id)
        result = scan(store, seed=4, resume=True)
        assert result.finish_reason is FinishReason.COMPLETED, result.error
        assert (result.scan_id, result.resumed, result.counts.measured) == (scan_id, len(first), POINTS)
        balanced(result)
        after = store.exposed_ids(scan_id)
        assert set(before) < set(after)
        again = store.observations(scan_id)
        kept = np.isin(again.trigger_id, first.trigger_id)
        np.testing.assert_array_equal(again.left_px[kept], first.left_px)  # nothing that was known was measured over
        assert kinds(store) == {"locate": 1, "scan": 1, "check": 1, "closure": 1}
        assert interruption(store) is None
        cloud = case_cloud(store)
    assert cloud.trigger_ids is not None
    assert (np.diff(cloud.trigger_ids) > 0).all()
    radius_mm = np.linalg.norm(cloud.points - np.array([0.0, 0.0, SPHERE.height_mm - 11.133]), axis=1)
    assert abs(np.median(radius_mm) - 11.133) < 0.05


def test_an_object_that_was_moved_ends_it_and_changes_nothing(case: Path) -> None:
    moved = replace(SPHERE, mesh=replace(SPHERE.mesh, vertices=SPHERE.mesh.vertices + np.array([0.4, 0.0, 0.0])))
    with CaseStore.open(case) as store:
        scan_id = store.scans()[-1].id
        before = store.exposed_ids(scan_id)
        result = scan(store, moved, seed=4, resume=True)
        assert result.finish_reason is FinishReason.FAILED
        assert result.error is not None
        assert result.error.code == "E-SCAN-03"
        assert result.error.__traceback__ is None  # it would hold the rig for as long as somebody holds the result
        balanced(result)
        assert result.counts.measured == result.resumed
        np.testing.assert_array_equal(store.exposed_ids(scan_id), before)
        assert interruption(store) is not None  # the object may be put back
        audit = [entry for entry in store.audit_trail() if entry.event == "known points measured again"]
        assert not json.loads(audit[-1].detail)["agrees"]


def test_an_object_that_is_gone_ends_it(case: Path) -> None:
    gone = replace(SPHERE, mesh=replace(SPHERE.mesh, vertices=SPHERE.mesh.vertices * 0.05))
    with CaseStore.open(case) as store:
        result = scan(store, gone, seed=4, resume=True)
        assert result.error is not None
        assert result.error.code == "E-SCAN-03"


def test_another_calibration_does_not_go_with_it(case: Path) -> None:
    assert BENCH.calibration is not None
    left = replace(BENCH.calibration.left, translation=BENCH.calibration.left.translation + 0.01)
    other = BENCH.with_calibration(replace(BENCH.calibration, left=left))
    with CaseStore.open(case) as store, open_rig(other, SPHERE) as rig, pytest.raises(CalibrationError, match="E-CAL-06"):
        ScanRunner(rig, PlanRequest(), store, interruption=interruption(store))


def test_what_holds_too_few_points_is_scanned_anew(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        scan(store, seed=3, stop_at=10)
        result = scan(store, seed=3, resume=True)
        assert result.finish_reason is FinishReason.COMPLETED
        assert (result.resumed, result.counts.measured) == (None, POINTS)
        assert kinds(store) == {"locate": 2, "scan": 2, "closure": 1}
        assert interruption(store) is None


def test_kept_and_discarded_scans_are_not_offered_again(case: Path) -> None:
    with CaseStore.open(case) as store:
        discard(store)
        assert interruption(store) is None
        store.undo()
        assert interruption(store) is not None
        keep(store)
        assert store.scans()[-1].finish_reason == "cancelled"
        assert len(store.corrections(store.scans()[-1].id)) == 2
    assert find_interrupted([case, case.parent / "none.impronta"]) == []
