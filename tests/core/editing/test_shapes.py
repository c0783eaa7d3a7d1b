"""A box, the plane at the base, and outliers, on points whose truth is known."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.editing.base_plane import BasePlane, find_base
from scanner_core.editing.crop_box import CropBox
from scanner_core.editing.outliers import outlyingness
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.specimens.ear import ear

RNG = np.random.default_rng(11)


@cache
def _ear() -> TriangleMesh:
    return ear().mesh


def _sampled(count: int, noise_mm: float = 0.02) -> NDArray[np.float64]:
    """Points on the synthetic ear, as the scanner gives them: none of the table."""
    mesh = _ear()
    of = RNG.choice(len(mesh.triangles), count, p=mesh.areas() / mesh.area())
    first, second = np.sqrt(RNG.random(count)), RNG.random(count)
    weights = np.stack([1 - first, first * (1 - second), first * second], axis=1)
    points = np.einsum("nk,nki->ni", weights, mesh.vertices[mesh.triangles[of]]) + RNG.normal(0, noise_mm, (count, 3))
    return np.asarray(points[points[:, 2] > 0.15])


def test_a_box_holds_its_faces_and_its_corners_are_eight() -> None:
    points = RNG.uniform(-1, 1, (500, 3))
    box = CropBox.around(points)
    assert box.holds(points).all()
    small = CropBox(np.array([-1.0, -0.5, 0.0]), np.array([0.2, 0.5, 0.9]))
    expected = [all(low <= value <= high for value, low, high in zip(point, small.low, small.high, strict=True)) for point in points.tolist()]
    assert small.holds(points).tolist() == expected
    assert len(np.unique(small.corners(), axis=0)) == 8


def test_a_table_is_found_under_an_ear_and_so_is_its_tilt() -> None:
    points = _sampled(6_000) + np.array([0.0, 0.0, 2.0])
    table = np.column_stack([RNG.uniform(-20, 20, (3_000, 2)), RNG.normal(0, 0.02, 3_000)])
    tilted = table + np.column_stack([np.zeros((3_000, 2)), table[:, 0] * np.tan(np.radians(3.0))])
    for under, tilt_deg in ((table, 0.0), (tilted, 3.0)):
        base = find_base(np.concatenate([points, under]))
        assert base.tilt_x_deg == pytest.approx(tilt_deg, abs=0.2)
        assert base.tilt_y_deg == pytest.approx(0.0, abs=0.2)
        assert base.below(under).mean() > 0.999
        assert base.below(points).mean() < 0.06


def test_without_a_flat_layer_it_is_just_above_the_lowest_point() -> None:
    points = _sampled(6_000)
    base = find_base(points)
    assert (base.tilt_x_deg, base.tilt_y_deg) == (0.0, 0.0)
    assert 0.1 < base.height_mm - points[:, 2].min() < 0.6
    assert find_base(points[:3]).height_mm > points[:3, 2].min()


def test_a_tilted_plane_rises_as_it_says() -> None:
    base = BasePlane(np.array([1.0, 2.0]), 3.0, 45.0, 0.0)
    assert base.heights(np.array([[1.0, 7.0], [2.0, 2.0]])) == pytest.approx([3.0, 4.0])
    assert base.below(np.array([[2.0, 0.0, 3.9], [2.0, 0.0, 4.1]])).tolist() == [True, False]


@pytest.mark.parametrize("share", [0.002, 0.01])
def test_strays_are_found_and_hardly_any_good_point(share: float) -> None:
    points = _sampled(6_000)
    strays = RNG.uniform(points.min(axis=0) - 3, points.max(axis=0) + 3, (int(share * len(points)), 3))
    clear = cKDTree(points).query(strays)[0] > 1.0  # three times the spacing of so few points
    wrong = outlyingness(np.concatenate([points, strays])).beyond(5.0)
    assert wrong[: len(points)].mean() < 2e-4
    assert wrong[len(points) :][clear].mean() > 0.98


def test_a_group_that_stands_apart_is_one_however_dense() -> None:
    points = _sampled(6_000)
    group = RNG.normal((30.0, 0.0, 5.0), 0.2, (20, 3))
    wrong = outlyingness(np.concatenate([points, group])).beyond(8.0)
    assert wrong[len(points) :].all()
    assert wrong[: len(points)].mean() < 1e-4


def test_few_points_are_all_usual_and_a_search_can_be_cancelled() -> None:
    assert not outlyingness(RNG.random((10, 3))).beyond(3.0).any()
    with pytest.raises(Cancelled):
        outlyingness(RNG.random((100, 3)), cancelled=lambda: True)
