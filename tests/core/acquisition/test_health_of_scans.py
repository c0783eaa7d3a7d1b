"""Whole small scans on the virtual rig: faults are named by their cause, and a clean scan is not accused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.closure import closure_um
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.virtual.bench_faults import BenchFault, CameraBumped, FramesDropped, LampOn, LostSteps, TriggerLost
from scanner_core.virtual.specimens import Specimen, load_specimen


def _scan(folder: Path, body: Specimen, points: int, views: int, *faults: BenchFault) -> ScanResult:
    request = PlanRequest(views, points, body.radius_mm, body.height_mm)
    with CaseStore.create(folder / "case.impronta") as store, open_rig(load_preset("bench"), body, "max", 11, faults) as rig:
        runner = ScanRunner(rig, request, store)
        runner.start()
        assert runner.join(120)
        result = runner.result
        assert result is not None
        counts = result.counts
        assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
        assert runner.status().findings == result.health.findings
        assert [scan.kind for scan in store.scans()] == ["locate", "scan", "closure"]
        assert result.scan_id is not None
        assert closure_um(store, result.scan_id) == (None if result.closure_um is None else round(result.closure_um, 1))
    json.dumps(result.health.as_dict())
    return result


def _potato() -> Specimen:
    """An ellipsoid of three different axes beside the table's middle: its turns are seen well."""
    mesh = icosahedron((0.0, 0.0, 0.0), 1.0)
    for _ in range(5):
        mesh = subdivide_uniform(mesh)
    on_sphere = mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None]
    return Specimen("potato", TriangleMesh(on_sphere * [16.0, 9.0, 12.0] + np.array([5.0, 3.0, 12.5]), mesh.triangles))


def _codes(result: ScanResult) -> set[str]:
    return {finding.code for finding in result.health.findings}


def test_a_clean_scan_is_not_accused(tmp_path: Path) -> None:
    result = _scan(tmp_path, load_specimen("sphere"), 600, 3)
    assert result.finish_reason is FinishReason.COMPLETED
    assert _codes(result) == {"H-TAB-02"}  # a sphere cannot tell whether the table lost steps
    report = result.health
    assert report.epipolar_sd_px == pytest.approx(report.epipolar_expected_sd_px, rel=0.25)
    assert abs(report.epipolar_mean_px) < 0.02
    assert report.closure is not None
    assert not report.closure.judged
    assert report.closure.closes
    assert report.closure.shift_um < 15
    assert report.closure_um == report.closure.shift_um


def test_what_goes_wrong_is_named_by_its_cause(tmp_path: Path) -> None:
    lamp, bump = LampOn(duration_s=3.0, at_s=20.0), CameraBumped(0.2, 0.0, at_s=24.0)
    faults = lamp, bump, TriggerLost(camera="left", at_s=40.0), FramesDropped(0.15, at_s=48.0)
    result = _scan(tmp_path, load_specimen("sphere"), 900, 4, *faults)
    named = {"H-LGT-01", "H-EPI-01", "H-SYN-01", "H-CAM-01"}
    assert named <= _codes(result) <= named | {"H-TAB-02", "H-VIEW-01", "H-VIEW-02", "H-VIEW-03", "H-VIEW-04"}
    found = {finding.code: finding for finding in result.health.findings}
    assert found["H-EPI-01"].value == pytest.approx(0.2, abs=0.08)
    assert found["H-SYN-01"].fields["late"] == "left"
    assert found["H-CAM-01"].fields["camera"] == "right"
    assert found["H-CAM-01"].fields["count"] == result.health.missing_frames[1]
    assert result.health.missing_frames[0] == 0


def test_lost_steps_are_named_with_their_size(tmp_path: Path) -> None:
    result = _scan(tmp_path, _potato(), 1500, 6, LostSteps(0.4, at_s=40.0))
    lost = next(finding for finding in result.health.findings if finding.code == "H-TAB-01")
    assert lost.value == pytest.approx(-0.4, abs=0.08)
    assert result.health.closure is not None
    assert result.health.closure.lost_steps
