"""Mounts of a case: kept, chosen, merged, and refused when they do not belong."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

from scanner_core.acquisition.engine import StereoEngine, StereoPair
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case import mount_registration
from scanner_core.case.edits import DISCARDED
from scanner_core.case.mount_registration import register_mounts
from scanner_core.case.processing import Processing, case_cloud, process_case
from scanner_core.case.scan_parts import PlacedMounts
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import CaseFormatError, ComparisonError, UsageError
from scanner_core.geometry.mount_refinement import MountRefinement, PairFit
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.spot import Spot
from tests.core.case.test_processing import RIG

VIEWS, ROW = 4, 260
TILTED = RigidTransform(RigidTransform.from_vector([1.2, 0.2, 0.3], np.zeros(3)).rotation, np.zeros(3))


def _shape(directions: np.ndarray, size: float) -> np.ndarray:
    x, y, z = directions.T
    radius = 14 * (1 + 0.12 * np.sin(3 * x + 1) * np.cos(2 * y) + 0.08 * np.cos(5 * z + x) + 0.1 * y * z)
    return np.asarray(directions * radius[:, None] * (1, 1, size))


def _pose(mount: int) -> RigidTransform:
    """The object as made to the mount's object frame."""
    return RigidTransform((TILTED if mount else RigidTransform.identity()).rotation, np.array([0.0, 0.0, 20.0]))


TRUE = _pose(0) @ _pose(1).inverse()
"""Object frame of mount 1 to that of mount 0."""


def _scan(store: CaseStore, mount: int, seed: int, size: float = 1.0) -> int:
    assert RIG.calibration is not None
    engine = StereoEngine(RIG.calibration, RIG.volume, RIG.spot.floor_px)
    rng, first = np.random.default_rng(seed), store.next_trigger_id()
    rows = [{"view": v, "first_id": first + v * ROW, "count": ROW, "y_deg": 0.0, "x_from_deg": -1.0, "x_to_deg": 1.0} for v in range(VIEWS)]
    plan = {"views": [{"table_deg": 90.0 * v, "rows": [row], "quota": None} for v, row in enumerate(rows)], "sweep_speed_deg_s": 3.0}
    scan = store.begin_scan("scan", dump_rig(RIG.with_calibration(None)), RIG.calibration.identity(), dump_rig(RIG), plan, mount)
    for view in range(VIEWS):
        azimuth = np.radians(-90.0 * view)
        towards = np.array([0.87 * np.cos(azimuth), 0.87 * np.sin(azimuth), 0.5])
        directions = rng.normal(size=(6 * ROW, 3))
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        seen = _pose(mount).rotate(directions) @ towards > 0.3
        points = _pose(mount).apply(_shape(directions[seen][:ROW], size))
        pairs = []
        for i, in_rig in enumerate(RIG.calibration.rig_to_object(90.0 * view).inverse().apply(points)):
            at = [camera.project(in_rig[None])[0] + rng.normal(0, 0.02, 2) for camera in (RIG.calibration.left, RIG.calibration.right)]
            left, right = (Spot(float(x), float(y), 1.0, 0.8, 180.0, 3000.0, 20, 0.02) for x, y in at)
            pairs.append(StereoPair(first + view * ROW + i, 0.1 * i, left, right))
        store.append(scan, engine.evaluate(pairs, view, 90.0 * view).observations)
        store.put_view(scan, view, 90.0 * view)
    store.end_scan(scan, FinishReason.COMPLETED, ScanCounts(VIEWS * ROW))
    return scan


@dataclass(frozen=True)
class Told:
    """What a search may answer."""

    transform: RigidTransform
    accepted: bool = True
    code: str = ""
    fields: Mapping[str, object] = field(default_factory=dict)

    def as_dict(self) -> dict[str, object]:
        return {"verdict": "accepted" if self.accepted else "ambiguous", "margin": 0.5}


def near_the_truth(fixed: PointCloud, moving: PointCloud, **_: object) -> Told:
    off = RigidTransform.from_vector([0.004, -0.003, 0.002], [0.1, -0.15, 0.1])
    return Told(off @ TRUE)


def ambiguous(fixed: PointCloud, moving: PointCloud, **_: object) -> Told:
    return Told(TRUE, False, "E-MNT-03", {"angle": 180})


@pytest.fixture(scope="module")
def one_mount(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    path = tmp_path_factory.mktemp("cases") / "one.impronta"
    with CaseStore.create(path) as store:
        _scan(store, 0, 1)
    return path.read_bytes()


@pytest.fixture(scope="module")
def two_mounts(one_mount: bytes, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    path = tmp_path_factory.mktemp("cases") / "two.impronta"
    path.write_bytes(one_mount)
    with CaseStore.open(path) as store:
        _scan(store, 1, 2)
    return path.read_bytes()


@pytest.fixture
def store(one_mount: bytes, tmp_path: Path) -> Iterator[CaseStore]:
    """A case of one mount."""
    (tmp_path / "a.impronta").write_bytes(one_mount)
    with CaseStore.open(tmp_path / "a.impronta") as store:
        yield store


@pytest.fixture
def pair(two_mounts: bytes, tmp_path: Path) -> Iterator[CaseStore]:
    """A case of two mounts that were not registered."""
    (tmp_path / "a.impronta").write_bytes(two_mounts)
    with CaseStore.open(tmp_path / "a.impronta") as store:
        yield store


def _error_um(pose: RigidTransform) -> float:
    where = _pose(1).apply(np.random.default_rng(0).normal(0, 8, (200, 3)))
    return float(1e3 * np.sqrt(((pose.apply(where) - TRUE.apply(where)) ** 2).sum(axis=1).mean()))


def test_a_second_mount_joins_when_its_pose_was_accepted(store: CaseStore) -> None:
    assert store.next_mount() == 1
    alone = case_cloud(store)
    second = _scan(store, 1, 2)
    assert [scan.mount for scan in store.scans()] == [0, 1]
    assert store.next_mount() == 2
    assert np.array_equal(case_cloud(store).points, alone.points)  # until it is registered it takes no part
    with pytest.raises(UsageError, match="how mount 1 of the case lies"):
        process_case(store, Processing(scans=(1, second)))

    result = register_mounts(store, find=near_the_truth)
    assert result.refused == ()
    assert result.error(store) is None
    told = result.as_dict()
    assert told["joined"] == [0, 1]
    assert told["loop_closure_um"] is None
    pose = store.mount_poses()[1].transform
    assert pose is not None
    assert _error_um(pose) < 15
    done = process_case(store, Processing())
    assert tuple(done.mounts) == (0, 1)
    assert not done.registered
    assert done.processing.scans == (1, second)
    cloud = done.cloud
    assert cloud.views is not None
    assert len(cloud) > 1.9 * len(alone)
    assert len(np.unique(cloud.views)) == 2 * VIEWS
    radius = np.linalg.norm(cloud.points - [0, 0, 20], axis=1)
    directions = (cloud.points - [0, 0, 20]) / radius[:, None]
    off_mm = radius - np.linalg.norm(_shape(directions, 1.0), axis=1)
    assert 1.4826 * np.median(np.abs(off_mm)) < 0.06
    own = process_case(store, Processing(scans=(second,)))
    assert tuple(own.mounts) == (1,)
    assert np.abs(pose.apply(own.cloud.points) - cloud.points[cloud.views >= VIEWS]).max() < 1e-9
    assert process_case(store, Processing(without_views=(0,))).mounts.keys() == {0, 1}


def test_the_pose_and_the_report_survive_and_older_ones_stay(pair: CaseStore) -> None:
    register_mounts(pair, find=near_the_truth)
    before = case_cloud(pair)
    path = pair.path
    pair.close()
    with CaseStore.open(path) as again:
        assert np.array_equal(case_cloud(again).points, before.points)
        report = again.mount_poses()[1].report
        assert report["start"] == "found"
        assert register_mounts(again, find=ambiguous).as_dict()["joined"] == [0, 1]  # joined before: it is not searched for again
        assert register_mounts(again, find=ambiguous, anew=True).as_dict()["joined"] == [0]
        assert again.counting_scans() == [1]
    with sqlite3.connect(path) as raw:
        assert raw.execute("SELECT count(*) FROM mount_pose").fetchone()[0] == 3
    raw.close()


def test_the_search_is_told_where_the_light_of_each_point_came_from(pair: CaseStore) -> None:
    asked: list[Mapping[str, object]] = []

    def find(fixed: PointCloud, moving: PointCloud, **told: object) -> Told:
        asked.append({"fixed": fixed, "moving": moving, **told})
        return Told(TRUE, False, "E-MNT-03", {"angle": 180})

    register_mounts(pair, find=find)
    for which in ("fixed", "moving"):
        cloud, towards = asked[0][which], asked[0][f"{which}_towards"]
        assert isinstance(cloud, PointCloud)
        assert isinstance(towards, np.ndarray)
        assert cloud.table_deg is not None
        for table_deg in (0.0, 270.0):
            point = int(np.flatnonzero(np.isclose(cloud.table_deg, table_deg))[0])
            to_pivot = RigidTransform.about_z(-table_deg).apply(np.array([RIG.laser.position_mm]))[0] - cloud.points[point]
            np.testing.assert_allclose(towards[point], to_pivot / np.linalg.norm(to_pivot), atol=1e-12)


def test_a_mount_that_the_others_contradict_is_kept_apart(pair: CaseStore, monkeypatch: pytest.MonkeyPatch) -> None:
    fit = PairFit(0, 1, 0.4, 0.99, 20.0, 24.0, 900)

    def refined(*_: object, **__: object) -> PlacedMounts:
        found = MountRefinement((TRUE, TRUE), ((), ()), np.zeros((1, 4)), 20.0, (fit,), False, 12)
        return PlacedMounts((0, 1), found, {0: RigidTransform.identity(), 1: TRUE}, {})

    monkeypatch.setattr(mount_registration, "refine_parts", refined)
    result = register_mounts(pair, find=near_the_truth)
    (outcome,) = result.refused
    assert outcome.code == "E-MNT-13"
    assert "24" in outcome.reason
    assert pair.mount_poses()[1].transform is None


def test_an_ambiguous_mount_is_kept_apart_and_said(pair: CaseStore) -> None:
    result = register_mounts(pair, find=ambiguous)
    error = result.error(pair)
    assert error is not None
    assert error.code == "E-MNT-10"
    assert "fits in more than one way" in str(error)
    assert "All points are kept" in str(error)
    assert pair.mount_poses()[1].transform is None
    assert len(case_cloud(pair)) < VIEWS * ROW + 1


def test_an_object_that_changed_its_shape_is_refused(store: CaseStore) -> None:
    _scan(store, 1, 2, size=1.04)
    (refused,) = register_mounts(store, find=near_the_truth).refused
    assert refused.code == "E-MNT-12"


def test_the_newest_scan_of_each_mount_counts_unless_it_was_discarded(store: CaseStore) -> None:
    second, third = _scan(store, 1, 2), _scan(store, 1, 3)
    assert store.counting_scans() == [1]
    report: dict[str, object] = {"first_mount": 0}
    store.put_mount_poses([(1, TRUE, report)])
    assert store.counting_scans() == [1, third]
    store.edit(DISCARDED, [third], "Discard")
    assert store.counting_scans(without=[third]) == [1, second]
    assert process_case(store, Processing()).processing.scans == (1, second)
    assert store.counting_scans(without=[1]) == [third]  # alone, in a frame of its own


def test_picks_on_a_mount_that_is_not_there_are_refused(pair: CaseStore) -> None:
    some = np.zeros((3, 3))
    with pytest.raises(UsageError, match="picked on mount 4"):
        register_mounts(pair, {4: (some, some)}, find=ambiguous)
    with pytest.raises(ComparisonError):
        register_mounts(pair, {1: (some, some)}, find=ambiguous)


@pytest.mark.parametrize("value", ["[1]", "{}", "nonsense", "[[1,0,0,0],[0,1,0,0],[0,0,2,0],[0,0,0,1]]"])
def test_a_damaged_pose_is_said(pair: CaseStore, value: str) -> None:
    path = pair.path
    pair.close()
    with sqlite3.connect(path) as raw:
        raw.execute("INSERT INTO mount_pose (mount, created, transform_json, report_json) VALUES (1, '2026-01-01', ?, '{}')", (value,))
    raw.close()
    with CaseStore.open(path, read_only=True) as again, pytest.raises(CaseFormatError):
        case_cloud(again)
