"""The stated uncertainty of an alignment against the scatter of many fits to fresh noise, white and correlated."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.comparison.alignment_uncertainty import alignment_uncertainty
from scanner_core.comparison.correlated_fit import generalized_step
from scanner_core.comparison.fit_rows import FitRows
from scanner_core.comparison.noise_correlation import measure_correlation

Array = NDArray[np.float64]

DRAWS = 60
CHOICE = 1.15  # the allowance for a region that was chosen with the noise; here it is given


def bowl() -> tuple[Array, Array]:
    """Points and normals of a lopsided bowl, 24 x 24 mm, 0.4 mm apart."""
    x, y = (grid.ravel() for grid in np.meshgrid(np.arange(-12, 12, 0.4), np.arange(-12, 12, 0.4)))
    z = 3 * np.sin(0.4 * x) * np.cos(0.3 * y) + 0.02 * x * y
    slope_x = 1.2 * np.cos(0.4 * x) * np.cos(0.3 * y) + 0.02 * y
    slope_y = -0.9 * np.sin(0.4 * x) * np.sin(0.3 * y) + 0.02 * x
    normals = np.stack([-slope_x, -slope_y, np.ones_like(x)], axis=1)
    return np.stack([x, y, z], axis=1), normals / np.linalg.norm(normals, axis=1)[:, None]


def noise(points: Array, length_mm: float, rng: np.random.Generator) -> Array:
    """0.05 mm, white or with correlation ``exp(-h^2 / 2 l^2)``."""
    if length_mm == 0:
        return np.asarray(rng.normal(0, 0.05, len(points)))
    waves, phases = rng.normal(0, 1 / length_mm, (300, 3)), rng.uniform(0, 2 * np.pi, 300)
    return np.asarray(0.05 * np.sqrt(2 / 300) * np.cos(points @ waves.T + phases).sum(axis=1))


def rows_with(distances: Array) -> FitRows:
    points, normals = bowl()
    about = points / 10.0
    jacobian = np.c_[np.cross(about, normals), normals, np.einsum("ij,ij->i", about, normals)]
    return FitRows(points, jacobian, distances, np.full(len(points), 1 / len(points)), np.zeros(3), 10.0)


@pytest.mark.parametrize(("length_mm", "general"), [(0.0, False), (1.0, False), (1.0, True)], ids=["white", "correlated", "correlated, weighed"])
def test_fits_scatter_as_stated(length_mm: float, general: bool) -> None:
    rng = np.random.default_rng(7)
    points = bowl()[0]
    moved, stated = [], []
    for draw in range(DRAWS if not general else 8):
        rows = rows_with(noise(points, length_mm, rng))
        if general:
            step, weighed = generalized_step(rows, measure_correlation(points, rows.distances * rows.weights, rng), rng)
            stated.append(weighed.stable_um / CHOICE)
        else:
            step = rows.step()
            if draw < 5:
                stated.append(alignment_uncertainty(rows, rng).stable_um / CHOICE)
        moved.append(1e3 * np.sqrt(np.mean(np.sum((step.apply(points) - points) ** 2, axis=1))))
    # six freedoms times the draws: the scatter itself is known to 4 % (10 % of the eight)
    assert np.sqrt(np.mean(np.square(moved))) == pytest.approx(np.mean(stated), rel=0.2 if not general else 0.3)


def test_the_length_of_the_correlation_is_measured() -> None:
    rng = np.random.default_rng(3)
    points = bowl()[0]
    white = measure_correlation(points, noise(points, 0.0, rng), rng)
    alike = measure_correlation(points, noise(points, 1.0, rng), rng)
    assert white.length_mm < 0.4
    assert alike.length_mm == pytest.approx(np.sqrt(2.0), rel=0.3)  # pi length^2 = 2 pi l^2


def test_a_change_of_size_is_reported_with_its_sign() -> None:
    points, normals = bowl()
    grown = 1.01 * points  # the after surface is one per cent larger: it lies outside by this along the normals
    distances = np.einsum("ij,ij->i", grown - points, normals) + np.random.default_rng(2).normal(0, 0.01, len(points))
    found = alignment_uncertainty(rows_with(distances), np.random.default_rng(0))
    assert found.scale_ratio == pytest.approx(1.01, abs=5e-4)
