from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.bench.reconstruction.bodies import SPHERE, SPHERE_RADIUS_MM
from tests.bench.reconstruction.clouds import Scan, area_uniform, scan
from tests.bench.reconstruction.rows import ROWS, selected

HOW = Scan("sphere", 4000, 0.1, 5)


@pytest.fixture(scope="module")
def ball() -> TriangleMesh:
    mesh = icosahedron((0, 0, 0), SPHERE_RADIUS_MM)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
        mesh = TriangleMesh(SPHERE.project(mesh.vertices), mesh.triangles)
    return mesh


def test_the_same_seed_gives_the_same_points_and_another_draw_others(ball: TriangleMesh) -> None:
    points = scan(SPHERE, ball, HOW)
    np.testing.assert_array_equal(points, scan(SPHERE, ball, HOW))
    assert not np.any(points == scan(SPHERE, ball, HOW.drawn(1)))
    assert HOW.drawn(2).seed == 5 + 2 * 1_000_003


def test_the_noise_is_as_stated_on_every_axis_and_along_the_normal(ball: TriangleMesh) -> None:
    clean, noisy = scan(SPHERE, ball, replace(HOW, sigma_mm=0.0)), scan(SPHERE, ball, HOW)
    assert np.abs(SPHERE.distance(clean)).max() < 1e-6
    np.testing.assert_allclose((noisy - clean).std(axis=0), 0.1, rtol=0.05)
    assert SPHERE.distance(noisy).std() == pytest.approx(0.1, rel=0.05)


def test_points_are_spread_by_area_whatever_the_triangles() -> None:
    # a square of 1 mm of two triangles beside one of 2 mm of eight
    big = [[[x, y, 0], [x + 1, y, 0], [x + 1, y + 1, 0], [x, y + 1, 0]] for x in (1, 2) for y in (0, 1)]
    corners = np.array([[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], *big], np.float64)
    triangles = np.array([[4 * i + a, 4 * i + b, 4 * i + c] for i in range(len(corners)) for a, b, c in ((0, 1, 2), (0, 2, 3))], np.int64)
    points = area_uniform(TriangleMesh(corners.reshape(-1, 3), triangles), 50_000, np.random.default_rng(1))
    assert (points[:, 0] < 1).mean() == pytest.approx(0.2, abs=0.01)
    for axis in (0, 1):
        inside = points[points[:, 0] >= 1, axis]
        middle, width = (2.0, 2.0) if axis == 0 else (1.0, 2.0)
        assert inside.mean() == pytest.approx(middle, abs=0.02)
        assert inside.std() == pytest.approx(width / np.sqrt(12), rel=0.02)


def test_what_is_wrong_with_a_scan_is_as_much_as_stated(ball: TriangleMesh) -> None:
    cut = scan(SPHERE, ball, replace(HOW, sigma_mm=0.0, unscanned_below=-8.0))
    assert len(cut) == HOW.points
    assert cut[:, 2].min() > -8.01
    dense = scan(SPHERE, ball, replace(HOW, sigma_mm=0.0, dense_above=0.0))
    assert (dense[:, 2] > 0).sum() / (dense[:, 2] <= 0).sum() == pytest.approx(10, rel=0.1)
    stray = scan(SPHERE, ball, replace(HOW, sigma_mm=0.0, outliers=0.02))
    assert (np.abs(SPHERE.distance(stray)) > 1e-3).sum() == pytest.approx(80, abs=1)


def test_rows_are_named_once_and_bring_their_clean_reference() -> None:
    names = [row.name for row in ROWS]
    assert len(set(names)) == len(names)
    assert [row.name for row in selected(["*_outliers"])] == ["ear3500_170", "ear3500_170_outliers"]
    with pytest.raises(SystemExit, match="There is no row"):
        selected(["nose"])
