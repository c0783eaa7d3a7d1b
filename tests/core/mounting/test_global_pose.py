"""Mounts without targets: the right pose from anywhere, and never one that the surfaces do not single out."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.mounting.global_pose import find_pose
from scanner_core.mounting.mount_start import MountStart, Verdict
from scanner_core.mounting.picked_pose import pose_from_points
from tests.core.mounting.mounts import Mount, any_pose, ball, barrel, cube, mount, rock

Array = NDArray[np.float64]
Body = Callable[[int, np.random.Generator], tuple[Array, Array]]

POINTS = 7000


def two_mounts(body: Body, seed: int, cut_mm: float = np.inf) -> tuple[Mount, Mount, RigidTransform]:
    """Both mounts and the pose of the second on the first; each is cut `cut_mm` beyond the middle, from opposite sides."""
    rng = np.random.default_rng(seed)
    found = []
    poses = any_pose(rng), any_pose(rng)
    across = rng.normal(size=3)
    across /= np.linalg.norm(across)
    for pose, side in zip(poses, (1, -1), strict=True):
        points, normals = body(POINTS, rng)
        kept = side * (points @ across) < cut_mm
        found.append(mount(points[kept], normals[kept], pose, rng))
    return found[0], found[1], poses[0] @ poses[1].inverse()


def find(fixed: Mount, moving: Mount, seed: int = 1) -> MountStart:
    return find_pose(
        fixed.cloud,
        moving.cloud,
        seed=seed,
        progress=lambda _: None,
        cancelled=lambda: False,
        fixed_towards=fixed.towards,
        moving_towards=moving.towards,
    )


def error_um(found: RigidTransform, true: RigidTransform, moving: Mount) -> float:
    points = moving.cloud.points
    return 1e3 * float(np.sqrt(np.mean(np.sum((found.apply(points) - true.apply(points)) ** 2, axis=1))))


@pytest.mark.parametrize("seed", [1, 2])
def test_mounts_in_any_orientation_come_together(seed: int) -> None:
    fixed, moving, true = two_mounts(rock, seed, cut_mm=4.0)
    found = find(fixed, moving, seed)
    assert found.accepted, found.reason
    assert found.reason == ""
    assert error_um(found.transform, true, moving) < 40
    assert found.margin > 0
    assert found.undetermined.shape == (6, 0)
    assert 15 < found.residual_um < 45
    assert error_um(found.transform, true, moving) < 4 * found.uncertainty_um


@pytest.mark.parametrize(("body", "open_directions"), [(ball, 3), (barrel, 1)])
def test_a_body_of_revolution_is_refused(body: Body, open_directions: int) -> None:
    fixed, moving, _ = two_mounts(body, 3)
    found = find(fixed, moving)
    assert not found.accepted
    assert found.verdict is Verdict.AMBIGUOUS
    assert found.code == "E-MNT-04"
    assert found.undetermined.shape == (6, open_directions)
    assert "pick three points" in found.reason


def test_a_cube_is_refused_until_points_are_picked() -> None:
    fixed, moving, true = two_mounts(cube, 4)
    found = find(fixed, moving)
    assert found.verdict is Verdict.AMBIGUOUS
    assert found.code == "E-MNT-03"
    on_moving = moving.cloud.points[::600]
    rng = np.random.default_rng(5)
    on_fixed = true.apply(on_moving) + rng.normal(0, 0.5, on_moving.shape)
    picked = pose_from_points(
        fixed.cloud,
        moving.cloud,
        on_fixed,
        on_moving,
        seed=1,
        cancelled=lambda: False,
        fixed_towards=fixed.towards,
        moving_towards=moving.towards,
    )
    assert picked.accepted, picked.reason
    assert error_um(picked.transform, true, moving) < 600  # along what two faces of a cube leave open, the picks count


def test_another_object_is_refused() -> None:
    fixed, _, _ = two_mounts(rock, 6)
    moving, _, _ = two_mounts(lambda count, rng: rock(count, rng, shape=2), 6)
    found = find(fixed, moving)
    assert found.verdict is Verdict.NO_FIT
    assert found.as_dict()["verdict"] == "no_fit"


def test_a_few_points_are_refused() -> None:
    fixed, moving, _ = two_mounts(rock, 7)
    few = Mount(moving.cloud.select(np.arange(100)), moving.towards[:100])
    assert find(fixed, few).code == "E-MNT-06"


def test_a_cancelled_search_ends() -> None:
    fixed, moving, _ = two_mounts(rock, 8)
    asked: list[Progress] = []
    with pytest.raises(Cancelled):
        find_pose(fixed.cloud, moving.cloud, seed=1, progress=asked.append, cancelled=lambda: len(asked) > 1)
    assert asked[0].phase == "sampling"
