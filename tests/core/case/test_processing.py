"""The points of a case, computed anew: as scanned to the last bit, and otherwise as the choice says."""

from __future__ import annotations

import sqlite3
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.engine import StereoEngine, StereoPair
from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.acquisition.views import register_case
from scanner_core.case.edits import PROCESSING
from scanner_core.case.observation import StereoObservation
from scanner_core.case.points import case_rig, triangulate_observations
from scanner_core.case.processing import GATES, Gates, Processing, case_cloud, chosen_processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.errors import CaseError, CaseFormatError, UsageError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from tests.core.optics.rigs import known_rig

VIEWS, ROW = 3, 300
RIG = replace(load_preset("bench").with_calibration(known_rig()), volume=replace(load_preset("bench").volume, radius_mm=40.0, height_mm=60.0))


def _observations(first: int, seed: int) -> list[StereoObservation]:
    """An ellipsoid in three views; some points outside the volume, on the table, seen twice, or with a mismatched partner."""
    assert RIG.calibration is not None
    rng = np.random.default_rng(seed)
    engine = StereoEngine(RIG.calibration, RIG.volume, RIG.spot.floor_px)
    found = []
    for view in range(VIEWS):
        table_deg = 120.0 * view + 0.01
        directions = rng.normal(size=(ROW, 3))
        points = directions / np.linalg.norm(directions, axis=1)[:, None] * (20, 14, 17) + (2, 0, 25)
        kind = rng.choice(4, ROW, p=[0.85, 0.05, 0.05, 0.05])
        points[kind == 1, 0] += 60.0
        points[kind == 2, 2] = 0.0
        pairs = []
        for i, point in enumerate(points):
            in_rig = RIG.calibration.rig_to_object(table_deg).inverse().apply(point[None])
            left, right = (camera.project(in_rig)[0] + rng.normal(0, 0.02, 2) for camera in (RIG.calibration.left, RIG.calibration.right))
            right[1] += 1.5 * (kind[i] == 3)
            size, peak = rng.uniform(0.9, 1.3), float(rng.integers(40, 250))
            spots = [Spot(float(x), float(y), size, 0.8 * size, peak, 3000.0, 20, 0.02) for x, y in (left, right)]
            hidden = SpotMiss(MissReason.NO_SPOT)
            pairs.append(StereoPair(first + view * ROW + i, 0.1 * i, spots[0], spots[1] if i % 20 else hidden))
        found += engine.evaluate(pairs, view, table_deg).observations
    return found


def _plan(first: int) -> ScanPlan:
    views = tuple(ViewPlan(120.0 * view, (Row(view, first + view * ROW, ROW, 0.0, -1.0, 1.0),)) for view in range(VIEWS))
    return ScanPlan(views, 3.0)


def _scan(store: CaseStore, first: int, seed: int, order: np.random.Generator | None = None) -> int:
    assert RIG.calibration is not None
    bare = dump_rig(RIG.with_calibration(None))
    scan = store.begin_scan("scan", bare, RIG.calibration.identity(), dump_rig(RIG), _plan(first).as_dict())
    seen = _observations(first, seed)
    if order is not None:
        seen = [seen[i] for i in order.permutation(len(seen))]
    for begin in range(0, len(seen), 250):
        store.append(scan, seen[begin : begin + 250])
    for view in range(VIEWS):
        store.put_view(scan, view, 120.0 * view + 0.01)
    store.end_scan(scan, FinishReason.COMPLETED, ScanCounts(VIEWS * ROW))
    return scan


@cache
def small_case() -> bytes:
    """A case of one scan, as a file."""
    with tempfile.TemporaryDirectory() as folder:
        with CaseStore.create(Path(folder) / "a.impronta") as store:
            _scan(store, 0, 1)
        return store.path.read_bytes()


@pytest.fixture
def store(tmp_path: Path) -> Iterator[CaseStore]:
    (tmp_path / "a.impronta").write_bytes(small_case())
    with CaseStore.open(tmp_path / "a.impronta") as store:
        yield store


def same(a: PointCloud, b: PointCloud) -> bool:
    parts = ("points", "covariances", "views", "trigger_ids")
    return all(np.array_equal(getattr(a, part), getattr(b, part)) for part in parts)


def test_as_scanned_is_what_the_scan_gave_to_the_last_bit(store: CaseStore) -> None:
    scan = store.scans()[0]
    rig, calibration = case_rig(store, scan)
    plain = triangulate_observations(store.observations(scan.id), rig, calibration).cloud
    assert same(process_case(store, Processing()).cloud, plain)
    registered = register_case(store, scan.id, rig, calibration).cloud
    done = process_case(store, Processing())
    assert same(done.cloud, registered)
    assert same(case_cloud(store), registered)
    assert not done.registered
    counts = done.counts
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped == VIEWS * ROW
    assert counts.rejected == {name: n for name, n in sorted(store.verdict_counts(scan.id).items()) if name != "measured"}
    assert {"epipolar", "outside_volume", "table", "hidden_right"} <= set(counts.rejected)


def test_every_point_knows_its_epipolar_residual(store: CaseStore) -> None:
    cloud = process_case(store, Processing()).cloud
    assert cloud.epipolar_sigmas is not None
    assert 0.8 < np.std(cloud.epipolar_sigmas) < 1.2  # in their own standard deviations
    some = cloud.select(np.arange(10, 20))
    assert some.epipolar_sigmas is not None
    assert np.array_equal(some.epipolar_sigmas, cloud.epipolar_sigmas[10:20])


def test_every_scan_has_the_rig_that_it_was_made_with(store: CaseStore) -> None:
    """Also where two rigs have one calibration: the case holds that only once, with the first of them."""
    assert RIG.calibration is not None
    other = replace(RIG, volume=replace(RIG.volume, radius_mm=7.0))
    store.begin_scan("scan", dump_rig(other.with_calibration(None)), RIG.calibration.identity(), dump_rig(other), _plan(5000).as_dict())
    for scan, radius_mm in zip(store.scans(), (40.0, 7.0), strict=True):
        rig, calibration = case_rig(store, scan)
        assert rig.volume.radius_mm == radius_mm
        assert rig.calibration is calibration
        assert calibration.identity() == scan.calibration_id


def test_gates_as_they_were_change_no_verdict(store: CaseStore) -> None:
    before = process_case(store, Processing())
    gates = Gates(epipolar_sigmas=3.0, volume_radius_mm=40.0, volume_height_mm=60.0, table_mm=0.15, least_peak_dn=0.0, most_sigma_px=99.0)
    after = process_case(store, Processing(gates=gates))
    assert after.counts == before.counts
    assert after.registered
    assert after.cloud.trigger_ids is not None
    assert before.cloud.trigger_ids is not None
    assert np.array_equal(after.cloud.trigger_ids, before.cloud.trigger_ids)


@pytest.mark.parametrize(
    ("gates", "gone"),
    [
        (Gates(volume_radius_mm=200.0), "outside_volume"),
        (Gates(table_mm=-1.0), "table"),
        (Gates(epipolar_sigmas=100.0), "epipolar"),
    ],
)
def test_wider_gates_take_in_again_what_both_cameras_saw(store: CaseStore, gates: Gates, gone: str) -> None:
    before = process_case(store, Processing()).counts
    after = process_case(store, Processing(gates=gates)).counts
    assert after.rejected.get(gone, 0) < before.rejected[gone]
    assert after.measured > before.measured
    assert after.planned == after.measured + sum(after.rejected.values()) + after.skipped
    assert after.skipped == before.skipped


@pytest.mark.parametrize(
    ("gates", "reason"),
    [
        (Gates(least_peak_dn=120), "too_dim"),
        (Gates(least_sigma_px=1.0), "too_small"),
        (Gates(most_sigma_px=1.0), "too_large"),
        (Gates(most_uncertainty_px=0.01), "too_uncertain"),
        (Gates(epipolar_sigmas=0.5), "epipolar"),
        (Gates(volume_radius_mm=15.0), "outside_volume"),
        (Gates(table_mm=25.0), "table"),
    ],
)
def test_narrower_gates_reject_with_their_reason(store: CaseStore, gates: Gates, reason: str) -> None:
    before = process_case(store, Processing()).counts
    if reason == "too_uncertain":
        with pytest.raises(CaseError, match="E-CASE-05"):
            process_case(store, Processing(gates=gates))
        return
    done = process_case(store, Processing(gates=gates))
    assert done.counts.rejected[reason] > before.rejected.get(reason, 0)
    assert done.counts.measured == len(done.cloud)
    assert done.counts.planned == done.counts.measured + sum(done.counts.rejected.values()) + done.counts.skipped


def test_a_view_is_left_out(store: CaseStore) -> None:
    done = process_case(store, Processing(without_views=(1,)))
    assert done.cloud.views is not None
    assert set(done.cloud.views.tolist()) == {0, 2}
    assert done.counts.rejected["left_out"] > 100
    with pytest.raises(UsageError, match="has no view 7"):
        process_case(store, Processing(without_views=(7,)))
    with pytest.raises(CaseError, match="E-CASE-05"):
        process_case(store, Processing(without_views=(0, 1, 2)))


def test_another_calibration_gives_other_points(store: CaseStore) -> None:
    assert RIG.calibration is not None
    right = RIG.calibration.right
    other = replace(RIG.calibration, right=replace(right, translation=right.translation * 1.01), date="2026-02-02")
    with pytest.raises(UsageError, match="holds no calibration"):
        process_case(store, Processing(other.identity()))
    store.put_calibration(other.identity(), dump_rig(RIG.with_calibration(other)))
    done = process_case(store, Processing(other.identity()))
    assert done.calibrations == (other.identity(),)
    assert done.registered
    before = process_case(store, Processing())
    # One percent more baseline is one percent more of everything.
    assert np.ptp(done.cloud.points, axis=0)[2] > 1.005 * np.ptp(before.cloud.points, axis=0)[2]
    small = replace(RIG.calibration, right=replace(right, translation=right.translation * 1.02, size_px=(320, 200)))
    store.put_calibration(small.identity(), dump_rig(RIG.with_calibration(small)))
    with pytest.raises(UsageError, match="cameras with other images"):
        process_case(store, Processing(small.identity()))
    store.put_calibration("mine", dump_rig(RIG))
    with pytest.raises(CaseFormatError, match="its calibration mine is empty, or another"):
        process_case(store, Processing("mine"))


def test_the_order_of_the_rows_in_the_file_does_not_matter(store: CaseStore, tmp_path: Path) -> None:
    """As after a scan that was resumed several times."""
    with CaseStore.create(tmp_path / "b.impronta") as other:
        _scan(other, 0, 1, order=np.random.default_rng(4))
        assert same(process_case(other, Processing()).cloud, process_case(store, Processing()).cloud)
        wide = Processing(gates=Gates(table_mm=-1.0))
        a, b = process_case(other, wide), process_case(store, wide)
        assert same(a.cloud, b.cloud)
        assert a.as_dict() == b.as_dict()
        assert a.cloud.trigger_ids is not None
        assert (np.diff(a.cloud.trigger_ids) > 0).all()


def test_scans_are_merged_in_the_order_of_their_trigger_ids(store: CaseStore) -> None:
    second = _scan(store, 10_000, 2)
    newest = process_case(store, Processing())
    assert newest.processing.scans == (second,)
    both = process_case(store, Processing(scans=(1, second)))
    first = process_case(store, Processing(scans=(1,)))
    assert not first.registered
    assert both.registered
    assert len(both.cloud) == len(first.cloud) + len(newest.cloud)
    assert both.counts.planned == 2 * VIEWS * ROW
    assert both.cloud.views is not None
    assert both.cloud.trigger_ids is not None
    assert set(both.cloud.views.tolist()) == set(range(2 * VIEWS))
    assert (np.diff(both.cloud.trigger_ids) > 0).all()
    store.edit("discarded_scans", [second], "Scan discarded")
    assert process_case(store, Processing()).processing.scans == (1,)
    with pytest.raises(UsageError, match="no scan 9"):
        process_case(store, Processing(scans=(9,)))


def test_the_choice_is_kept_and_can_be_undone(store: CaseStore) -> None:
    choice = Processing(gates=Gates(least_peak_dn=100, table_mm=-0.5), without_views=(2,))
    before = case_cloud(store)
    store.edit(PROCESSING, choice.as_dict(), "Points computed anew")
    assert chosen_processing(store) == choice
    assert same(case_cloud(store), process_case(store, choice).cloud)
    store.undo()
    assert same(case_cloud(store), before)


@pytest.mark.parametrize("value", [[], "x", {"gates": 3}, {"gates": {"x": 1}}, {"gates": {"table_mm": "1"}}, {"without_views": [0.5]}, {"scans": 1}])
def test_a_damaged_choice_is_refused(store: CaseStore, value: object) -> None:
    store.edit(PROCESSING, value, "by hand")
    with pytest.raises(CaseFormatError, match="processing"):
        case_cloud(store)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -1.0, True])
def test_gates_are_numbers(value: float) -> None:
    with pytest.raises(UsageError, match="E-USE-01"):
        Gates(least_peak_dn=value)
    assert len(GATES) == 8


def test_centroids_that_give_no_points_are_refused(store: CaseStore) -> None:
    """A spot far outside the image, whose ray no camera model follows."""
    store.close()
    connection = sqlite3.connect(store.path)
    connection.execute("UPDATE observation SET left_x_px = 99999, left_y_px = -99999 WHERE left_x_px IS NOT NULL")
    connection.commit()
    connection.close()
    with CaseStore.open(store.path) as again:
        try:
            cloud = case_cloud(again)
        except CaseFormatError:
            return
        assert np.isfinite(cloud.points).all()
