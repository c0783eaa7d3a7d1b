"""Every pixel shows the nearest surface: against a ray through every triangle."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.pictures import raster
from scanner_core.pictures.raster import rasterized

Array = NDArray[np.float64]


def _nearest(points: Array, triangles: NDArray[np.int64], at: Array) -> float:
    """Depth of the nearest surface along the ray at (right, up), -inf without."""
    best = -np.inf
    for a, b, c in points[triangles]:
        matrix = np.array([[b[0] - a[0], c[0] - a[0]], [b[1] - a[1], c[1] - a[1]]])
        if abs(np.linalg.det(matrix)) < 1e-12:
            continue
        s, t = np.linalg.solve(matrix, at - a[:2])
        if min(s, t, 1 - s - t) >= -1e-9:
            best = max(best, float(a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])))
    return best


@pytest.mark.parametrize("at_once", [1, 40, 4_000_000])
def test_against_rays(at_once: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(raster, "_CANDIDATES", at_once)
    rng = np.random.default_rng(3)
    points = rng.uniform(-5, 5, (30, 3))
    triangles = rng.integers(0, 30, (25, 3))
    width, height, pixel, centre = 23, 17, 0.5, np.array([0.3, -0.2])
    picture = rasterized(points, triangles, pixel, width, height, centre)
    for row in range(height):
        for column in range(width):
            at = centre + pixel * np.array([column - 0.5 * (width - 1), 0.5 * (height - 1) - row])
            expected = _nearest(points, triangles, at)
            assert picture.depth[row, column] == pytest.approx(expected, abs=1e-6)
            if np.isfinite(expected):
                place = picture.weights[row, column] @ points[triangles[picture.triangle[row, column]]]
                assert np.allclose(place, [*at, expected], atol=1e-6)
    assert np.array_equal(picture.seen, np.isfinite(picture.depth))
    assert np.allclose(picture.sampled(triangles, points)[:, 2], picture.depth[picture.seen])


def test_a_triangle_larger_than_the_picture_or_beside_it() -> None:
    points = np.array([[-100.0, -100, 1], [100, -100, 1], [0, 100, 1], [50, 0, 5], [51, 0, 5], [50, 1, 5]])
    picture = rasterized(points, np.array([[0, 1, 2], [3, 4, 5]]), 1.0, 8, 6, np.zeros(2))
    assert (picture.triangle == 0).all()
    assert np.allclose(picture.depth, 1)
