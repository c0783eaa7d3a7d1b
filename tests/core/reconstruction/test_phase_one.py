from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.voxel_region import VoxelGrid, signed_depth
from scanner_core.reconstruction.cloud_scale import CloudScale, measure_scale
from scanner_core.reconstruction.inflate import Balloon, choose_lengths, inflate, unreached_share
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.region import EnclosedRegion, enclosed_region

Array = NDArray[np.float64]


def pace() -> Pace:
    return Pace(lambda progress: None, lambda: False)


def ball(count: int, radius: float = 10.0, seed: int = 0) -> Array:
    directions = np.random.default_rng(seed).normal(size=(count, 3))
    return np.asarray(radius * directions / np.linalg.norm(directions, axis=1)[:, None])


def box(size: tuple[float, float, float], count: int, open_below: bool = False, seed: int = 0) -> Array:
    """Points on the surface of a box about the origin, evenly, mm."""
    rng = np.random.default_rng(seed)
    half = 0.5 * np.array(size)
    areas = np.array([half[1] * half[2]] * 2 + [half[0] * half[2]] * 2 + [half[0] * half[1]] * 2)
    if open_below:
        areas[4] = 0
    face = rng.choice(6, size=count, p=areas / areas.sum())
    points = rng.uniform(-1, 1, size=(count, 3)) * half
    axis = face // 2
    points[np.arange(count), axis] = np.where(face % 2, 1, -1) * half[axis]
    return points


def scale_of(points: Array) -> CloudScale:
    return measure_scale(points, cKDTree(points), 0)


def region_of(points: Array, table_mm: float | None = None) -> EnclosedRegion:
    return enclosed_region(points, scale_of(points), pace(), table_mm)


def assert_sound(balloon: Balloon) -> None:
    checks = check_mesh(balloon.mesh)
    assert checks.closed
    assert checks.genus == 0
    assert 0.88 < balloon.fill < 1.1


@pytest.mark.parametrize("count", [200, 1000])
def test_the_region_and_the_balloon_of_a_ball(count: int) -> None:
    points = ball(count)
    region = region_of(points)
    assert region.handles == 0
    assert region.volume_mm3() == pytest.approx(4 / 3 * np.pi * 1000, rel=0.1)
    balloon = inflate(region, pace())
    assert_sound(balloon)
    assert unreached_share(balloon, points, scale_of(points)) == 0


def test_a_thin_plate_is_filled() -> None:
    points = box((15, 10, 1.5), 4000)
    region = region_of(points)
    assert region.volume_mm3() == pytest.approx(225, rel=0.15)
    balloon = inflate(region, pace())
    assert_sound(balloon)
    assert unreached_share(balloon, points, scale_of(points)) < 0.01


def test_a_sparse_thin_plate_asks_for_a_blur_below_the_spacing() -> None:
    # 30 x 20 x 1.2 mm with a point every 0.65 mm: a blur of that width wipes it out
    region = region_of(box((30, 20, 1.2), 3000))
    assert region.volume_mm3() == pytest.approx(720, rel=0.2)


@pytest.mark.parametrize("table_mm", [-0.9, None])
def test_a_half_ball_is_closed_below_with_a_table_and_without(table_mm: float | None) -> None:
    points = ball(5000)
    points = points[points[:, 2] > 0]
    region = region_of(points, table_mm)
    depth = region.grid.sample(region.depth_mm, np.array([[0.0, 0.0, 1.0], [7.0, 0.0, 4.0], [0.0, 0.0, 12.0], [0.0, 0.0, -5.0], [0.0, 0.0, -0.4]]))
    assert (depth[:4] > 0).tolist() == [True, True, False, False]
    if table_mm is not None:
        assert depth[4] > 0  # straight down to the table
    assert_sound(inflate(region, pace()))


def test_under_an_overhang_the_standing_body_leaves_air() -> None:
    # an open box whose walls lean out upwards: nothing is below the brim
    points = box((10, 10, 8), 5000, open_below=True)
    points[:, 2] += 4
    points[:, :2] *= (0.6 + 0.1 * points[:, 2])[:, None]
    region = region_of(points, table_mm=0.0)
    depth = region.grid.sample(region.depth_mm, np.array([[0.0, 0.0, 1.0], [6.0, 0.0, 1.0], [6.0, 0.0, 7.5]]))
    assert (depth > 0).tolist() == [True, False, True]


def from_solid(inside: NDArray[np.bool_], voxel_mm: float) -> EnclosedRegion:
    return EnclosedRegion(VoxelGrid(np.zeros(3), voxel_mm, inside.shape), inside, signed_depth(inside, voxel_mm), 0)


def body_with_a_stalk() -> EnclosedRegion:
    x, y, z = np.meshgrid(*(np.arange(n) for n in (44, 44, 90)), indexing="ij")
    away = np.hypot(x - 22, y - 22)
    return from_solid((away**2 + (z - 24.0) ** 2 <= 18**2) | ((away <= 5) & (z >= 24) & (z <= 80)), 0.5)


def test_edges_are_short_in_a_stalk_only() -> None:
    region = body_with_a_stalk()
    lengths = choose_lengths(region, pace())
    body, stalk = lengths.at(np.array([[11.0, 11.0, 4.0], [11.0, 11.0, 35.0]]))
    assert stalk <= body
    balloon = inflate(region, pace())
    assert_sound(balloon)
    assert balloon.mesh.vertices[:, 2].max() > 38  # it got into the stalk
    assert lengths.times(0.5).least_mm() == pytest.approx(0.5 * lengths.least_mm())


def test_points_out_of_reach_are_counted_and_lonely_ones_are_not() -> None:
    points = ball(1500)
    balloon = inflate(region_of(points), pace())
    stalk = np.random.default_rng(1).normal(size=(150, 3)) * 0.4 + (0, 0, 18)
    both = np.concatenate([points, stalk, [[30.0, 0, 0]]])
    assert unreached_share(balloon, both, scale_of(both)) == pytest.approx(150 / 1651, abs=1e-6)
