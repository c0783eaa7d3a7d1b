"""Mounts of one object come together with their views and the table's axis; what contradicts is told."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from scanner_core.geometry.mount_refinement import MountedCloud, MountRefinement, refine_mounts
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import RegistrationParameters
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled

Array = np.ndarray
VIEWS, ELEVATION = 6, np.radians(30)
MIDDLE = np.array([0.0, 0.0, 25.0])
TURNS = ((0.0, 0.0, 0.0), (2.1, 0.4, 0.3), (0.3, 1.7, -0.8))
"""Rotation vectors of the mounts, rad, about the middle of the object."""
QUICK = RegistrationParameters(queries=4000)
WRONG_AXIS = RigidTransform.from_vector([4e-4, -3e-4, 0.0], [0.02, -0.03, 0.0])


def _shape(directions: Array) -> Array:
    x, y, z = directions.T
    radius = 14 * (1 + 0.12 * np.sin(3 * x + 1) * np.cos(2 * y) + 0.08 * np.cos(5 * z + x) + 0.1 * y * z)
    return np.asarray(directions * radius[:, None])


def _pose(mount: int) -> RigidTransform:
    """Object as made to the mount's object frame."""
    return RigidTransform(RigidTransform.from_vector(TURNS[mount], np.zeros(3)).rotation, MIDDLE)


@cache
def _measured(mount: int, wrong_axis: bool = False, other_shape: float = 0.0) -> MountedCloud:
    """What is seen of a mount from around the table, in a frame that a wrong axis bends."""
    rng = np.random.default_rng([mount, 7])
    points, views = [], []
    for view in range(VIEWS):
        azimuth = -2 * np.pi * view / VIEWS
        towards = np.array([np.cos(ELEVATION) * np.cos(azimuth), np.cos(ELEVATION) * np.sin(azimuth), np.sin(ELEVATION)])
        directions = rng.normal(size=(4000, 3))
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
        shape = _shape(directions)
        shape[:, 0] *= 1 + other_shape
        pose = _pose(mount)
        seen = pose.rotate(directions) @ towards > np.cos(np.radians(65))
        placed = pose.apply(shape[seen][:450])
        if wrong_axis:
            turn = RigidTransform.about_z(360 * view / VIEWS)
            placed = (turn.inverse() @ WRONG_AXIS @ turn).apply(placed)
        points.append(placed + rng.normal(0, 0.02, placed.shape))
        views.append(np.full(len(placed), view, np.int32))
    cloud = PointCloud(np.concatenate(points), None, np.concatenate(views))
    return MountedCloud(cloud, 360.0 / VIEWS * np.arange(VIEWS, dtype=np.float64), RigidTransform.identity())


def _true(mount: int) -> RigidTransform:
    return _pose(0) @ _pose(mount).inverse()


def _started(mount: MountedCloud, number: int, off_mm: float = 0.25) -> MountedCloud:
    rng = np.random.default_rng(number)
    off = RigidTransform.from_vector(0.01 * rng.normal(size=3), off_mm * rng.normal(size=3))
    about = RigidTransform(np.eye(3), MIDDLE)
    start = RigidTransform.identity() if number == 0 else about @ off @ about.inverse() @ _true(number)
    return MountedCloud(mount.cloud, mount.table_deg, start)


def _error_um(refined: MountRefinement, mount: int, cloud: PointCloud) -> float:
    apart = refined.poses[mount].apply(cloud.points) - _true(mount).apply(cloud.points)
    return float(1e3 * np.sqrt((apart**2).sum(axis=1).mean()))


def test_two_mounts_come_together_within_the_noise() -> None:
    mounts = [_started(_measured(m), m) for m in (0, 1)]
    refined = refine_mounts(mounts, QUICK)
    assert refined.converged
    assert np.array_equal(refined.poses[0].matrix(), np.eye(4))
    assert _error_um(refined, 1, mounts[1].cloud) < 15
    (pair,) = refined.pairs
    assert 0.2 < pair.overlap_fraction < 0.7
    assert pair.agreeing_fraction > 0.95
    assert pair.residual_um == pytest.approx(refined.residual_within_um, rel=0.25)


def test_a_wrong_axis_is_found_because_all_views_share_it() -> None:
    refined = refine_mounts([_started(_measured(m, wrong_axis=True), m) for m in (0, 1)], QUICK)
    tilt_deg, shift_mm = refined.axes[0, :2], refined.axes[0, 2:]
    undone = WRONG_AXIS.inverse()
    assert np.abs(shift_mm - undone.translation[:2]).max() < 0.012
    assert np.abs(np.radians(tilt_deg) - [-4e-4, 3e-4]).max() < 2e-4
    assert _error_um(refined, 1, _measured(1).cloud) < 15
    assert refined.residual_within_um < 26


def test_a_loop_of_three_mounts_closes() -> None:
    refined = refine_mounts([_started(_measured(m), m) for m in (0, 1, 2)], QUICK)
    assert {(pair.first, pair.second) for pair in refined.pairs} == {(0, 1), (0, 2), (1, 2)}
    assert max(pair.closure_um for pair in refined.pairs) < 8
    assert max(_error_um(refined, m, _measured(m).cloud) for m in (1, 2)) < 15


def test_an_object_of_another_size_does_not_fit() -> None:
    mounts = [_measured(0), _measured(1, other_shape=0.04)]
    refined = refine_mounts([_started(mount, m) for m, mount in enumerate(mounts)], QUICK)
    assert max(pair.residual_um for pair in refined.pairs) > 2 * refined.residual_within_um


def test_it_ends_when_it_is_asked_to() -> None:
    with pytest.raises(Cancelled):
        refine_mounts([_started(_measured(m), m) for m in (0, 1)], QUICK, cancelled=lambda: True)


def test_one_mount_alone_is_a_registration_of_its_views() -> None:
    refined = refine_mounts([_measured(0)], QUICK)
    assert refined.pairs == ()
    assert len(refined.corrections[0]) == VIEWS
