"""The stated uncertainty of an alignment against the scatter of many fits to fresh noise, white and correlated."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.comparison.alignment_uncertainty import alignment_uncertainty
from scanner_core.comparison.correlated_fit import generalized_step
from scanner_core.comparison.fine_fit import fit_at
from scanner_core.comparison.fit_rows import FitRows, MutualPairing
from scanner_core.comparison.noise_correlation import measure_correlation
from scanner_core.geometry.rigid import RigidTransform
from tests.core.comparison.aligned import surface
from tests.core.comparison.small_arch import noisy, small_arch

Array = NDArray[np.float64]

DRAWS = 60


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
            stated.append(weighed.stable_um)
        else:
            step = rows.step()
            if draw < 5:
                stated.append(alignment_uncertainty(rows, rng).stable_um)
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


def test_noisy_triangles_follow_a_motion_less_than_the_jacobian_says() -> None:
    """Finite differences of the gradient are the oracle of the response."""
    before, after = noisy(small_arch(), 80.0, 1), noisy(small_arch(step_mm=0.9), 80.0, 2)
    everything = np.ones(len(after.vertices), np.bool_)
    pairing = MutualPairing(surface(before), surface(after), 3.0)

    def gradient(motion: RigidTransform) -> tuple[Array, FitRows]:
        fit = fit_at(pairing, motion, everything)
        rows = pairing.rows(motion, fit.pairs, fit.back, everything)
        return rows.jacobian[:, :6].T @ (rows.weights * rows.distances), rows

    here, rows = gradient(RigidTransform.identity())
    information = (rows.jacobian[:, :6] * rows.weights[:, None]).T @ rows.jacobian[:, :6]
    step = 0.005
    slopes = np.stack([(gradient(rows.motion(step * axis))[0] - here) / step for axis in np.eye(6)], axis=1)
    followed = float(np.mean(np.linalg.eigvals(np.linalg.solve(information, slopes)).real))
    assert rows.response < 0.97
    assert followed == pytest.approx(rows.response, abs=0.02)
