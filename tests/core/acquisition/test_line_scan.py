"""A scan by the laser line from the first move to the points, through the case: what is kept, how it balances, and how it ends."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.line_plan import LinePlanner
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.processing import Gates, Processing, process_case
from scanner_core.case.recovery import interruption
from scanner_core.case.removed_points import RemovedPoints
from scanner_core.case.store import CaseStore
from scanner_core.commands.line import lit_by
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset, parse_rig
from scanner_core.errors import AcquisitionError, UsageError
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.virtual.specimens.specimen import Specimen

RADIUS_MM = 6.0
REQUEST = PlanRequest(views=2, points=1200, object_radius_mm=RADIUS_MM, object_height_mm=2 * RADIUS_MM)


def rig_file() -> RigConfig:
    return lit_by(load_preset("bench"), line=True)


def ball() -> Specimen:
    middle, mesh = np.array([0.0, 0.0, RADIUS_MM]), icosahedron([0.0, 0.0, RADIUS_MM], RADIUS_MM)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
        outward = mesh.vertices - middle
        mesh = TriangleMesh(middle + RADIUS_MM * outward / np.linalg.norm(outward, axis=1, keepdims=True), mesh.triangles)
    return Specimen("ball", mesh)


@contextmanager
def scanning(path: Path, request: PlanRequest = REQUEST) -> Iterator[tuple[OpenRig, CaseStore, ScanRunner]]:
    with open_rig(rig_file(), ball(), seed=1) as rig, CaseStore.create(path) as store:
        runner = ScanRunner(rig, request, store)
        try:
            yield rig, store, runner
        finally:
            runner.cancel()
            runner.join()


@pytest.fixture(scope="module")
def scanned(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ScanResult]:
    path = tmp_path_factory.mktemp("line") / "ball.impronta"
    with scanning(path) as (_, _, runner):
        runner.start()
        runner.join()
    assert runner.result is not None
    return path, runner.result


def test_the_points_lie_on_the_ball(scanned: tuple[Path, ScanResult]) -> None:
    _, result = scanned
    assert result.finish_reason is FinishReason.COMPLETED, result.error
    assert result.views is not None
    points = result.views.cloud.points
    assert len(points) == result.counts.measured > 0.6 * REQUEST.points
    off_um = 1e3 * (np.linalg.norm(points - [0, 0, RADIUS_MM], axis=1) - RADIUS_MM)
    assert np.sqrt(np.mean(off_um**2)) < 80
    assert np.abs(off_um).max() < 500


def test_the_case_gives_the_same_cloud_and_counts_that_balance(scanned: tuple[Path, ScanResult]) -> None:
    path, result = scanned
    with CaseStore.open(path, read_only=True) as store:
        (scan,) = store.scans()
        again = process_case(store, Processing())
        counts, frames = store.verdict_counts(scan.id), store.exposed_ids(scan.id)
    assert result.views is not None
    assert np.array_equal(again.cloud.points, result.views.cloud.points)
    assert again.cloud.covariances is not None
    assert result.views.cloud.covariances is not None
    assert np.array_equal(again.cloud.covariances, result.views.cloud.covariances)
    assert counts == {"measured": result.counts.measured} | result.counts.rejected
    assert result.counts.planned == result.counts.measured + sum(result.counts.rejected.values())
    assert again.counts == result.counts
    # one trigger id a frame, and all of its points go by it
    assert len(frames) == result.exposures
    assert again.cloud.trigger_ids is not None
    assert set(again.cloud.trigger_ids.tolist()) <= set(frames.tolist())


def test_a_narrower_volume_and_a_view_left_out_balance_too(scanned: tuple[Path, ScanResult]) -> None:
    path, result = scanned
    with CaseStore.open(path, read_only=True) as store:
        cut = process_case(store, Processing(gates=Gates(volume_height_mm=8.0), without_views=(1,)))
        with pytest.raises(UsageError, match="least_peak_dn"):
            process_case(store, Processing(gates=Gates(least_peak_dn=20.0)))
    assert cut.cloud.points[:, 2].max() <= 8.0
    assert cut.counts.planned == result.counts.planned
    assert cut.counts.measured + sum(cut.counts.rejected.values()) == cut.counts.planned
    assert cut.counts.rejected["left_out"] > 50


def test_single_points_of_a_frame_are_taken_out(scanned: tuple[Path, ScanResult]) -> None:
    """Several have one trigger id: the peak's number tells them apart, also where a gate has left others away."""
    path, _ = scanned
    with CaseStore.open(path, read_only=True) as store:
        whole = process_case(store, Processing()).cloud
        out = np.random.default_rng(2).random(len(whole)) < 0.5
        removed = RemovedPoints.of_cloud(whole.select(out))
        done = process_case(store, Processing(removed=removed))
        low = process_case(store, Processing(gates=Gates(volume_height_mm=8.0), removed=removed)).cloud
    assert removed.count == out.sum()
    assert np.array_equal(done.cloud.points, whole.points[~out])
    assert done.counts.rejected["removed"] == out.sum()
    assert not removed.of_points(low).any()
    assert 0 < len(low) < len(done.cloud)


def test_cancelled_after_a_view_it_is_dark_and_keeps_that_view(tmp_path: Path) -> None:
    with scanning(tmp_path / "c.impronta", replace(REQUEST, views=3, points=900)) as (rig, store, runner):
        runner.start()
        while not runner.status().counts.measured and not runner.join(0.01):
            pass
        runner.cancel()
        runner.join()
        result = runner.result
        assert result is not None
        assert result.finish_reason is FinishReason.CANCELLED
        assert rig.motion.status().laser_power == 0
        assert result.counts.measured > 0
        assert store.verdict_counts(1) == {"measured": result.counts.measured} | result.counts.rejected
        interrupted = interruption(store)
        assert interrupted is not None
        with pytest.raises(AcquisitionError) as refused:
            ScanRunner(rig, REQUEST, store, interruption=interrupted)
        assert refused.value.code == "E-LINE-03"


def test_a_full_disk_ends_it_and_what_was_kept_before_stays(tmp_path: Path) -> None:
    with scanning(tmp_path / "full.impronta", replace(REQUEST, points=600)) as (rig, store, runner):
        store.limit_growth(6)
        runner.start()
        runner.join()
        result = runner.result
        assert result is not None
        assert result.finish_reason is FinishReason.FAILED
        assert result.error is not None
        assert result.error.code == "E-DISK-01"
        assert rig.motion.status().laser_power == 0
        store.limit_growth(None)
        # a sweep is kept whole or not at all
        assert len(store.exposed_ids(1)) == 0
        assert store.verdict_counts(1) == {}


def test_a_rig_file_tells_the_shape_and_comes_back_as_it_was() -> None:
    config = rig_file()
    assert parse_rig(dump_rig(config), "again").laser == config.laser
    assert "shape" not in dump_rig(load_preset("bench"))
    for wrong in ("shape = 'sheet'", "fan_deg = 10.0"):
        with pytest.raises(UsageError):
            parse_rig(dump_rig(load_preset("bench")).replace("[laser]", f"[laser]\n{wrong}"), "wrong")


def test_until_an_uncertainty_is_refused_before_anything_moves(tmp_path: Path) -> None:
    with open_rig(rig_file(), ball(), seed=1) as rig, CaseStore.create(tmp_path / "u.impronta") as store, pytest.raises(AcquisitionError) as refused:
        ScanRunner(rig, replace(REQUEST, until_um=40.0), store)
    assert refused.value.code == "E-LINE-01"


def test_the_plan_narrows_to_what_was_seen_and_makes_up_for_missing_points() -> None:
    planner = LinePlanner(rig_file(), PlanRequest(views=4, points=8000, object_radius_mm=20, object_height_mm=30), 60.0)
    first = planner.view(0, 0, np.empty((0, 3)), 0)
    known = np.random.default_rng(0).uniform((-5, -5, 5), (5, 5, 15), (1000, 3))
    second = planner.view(1, first.rows[0].count, known, 40)
    assert second.rows[0].first_id == first.rows[0].count
    assert first.rows[0].x_from_deg < second.rows[0].x_from_deg < second.rows[0].x_to_deg < first.rows[0].x_to_deg
    assert second.rows[0].count >= 7000 / 3 / 25
    assert second.sweep_speed_deg_s == pytest.approx((second.rows[0].x_to_deg - second.rows[0].x_from_deg) * 60 / second.rows[0].count)
