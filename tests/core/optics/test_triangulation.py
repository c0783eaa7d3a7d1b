from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.optics.triangulation import EpipolarGate, Triangulator
from tests.core.optics.rigs import DISTANCE_MM, known_rig

CALIBRATION = known_rig()
TRIANGULATOR = Triangulator(CALIBRATION)


def _volume(n: int, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-60, 60, (n, 3)) + np.array([0, 0, DISTANCE_MM])


@settings(max_examples=25, deadline=None)
@given(st.floats(5, 40), st.floats(0, 45), st.integers(0, 1000))
def test_what_is_projected_comes_back(half_angle_deg: float, elevation_deg: float, seed: int) -> None:
    calibration = known_rig(half_angle_deg, elevation_deg)
    points = _volume(50, seed)
    sigma = np.full(50, 0.05)
    found = Triangulator(calibration).triangulate(calibration.left.project(points), calibration.right.project(points), sigma, 3 * sigma)
    assert np.abs(found.points - points).max() < 1e-6
    assert np.abs(found.epipolar_residual_px).max() < 1e-6


def test_covariance_and_residual_are_what_the_noise_makes_of_them() -> None:
    rng = np.random.default_rng(11)
    points = _volume(20_000, 12)
    left_sigma, right_sigma = rng.uniform(0.02, 0.1, (2, len(points)))
    left = CALIBRATION.left.project(points) + rng.normal(size=(len(points), 2)) * left_sigma[:, None]
    right = CALIBRATION.right.project(points) + rng.normal(size=(len(points), 2)) * right_sigma[:, None]
    found = TRIANGULATOR.triangulate(left, right, left_sigma, right_sigma)

    error = found.points - points
    mahalanobis = np.einsum("ni,nij,nj->n", error, np.linalg.inv(found.covariances), error)
    assert mahalanobis.mean() == pytest.approx(3.0, rel=0.03)
    whole = np.einsum("ni,nj->ij", error, error) / len(error)
    np.testing.assert_allclose(whole, found.covariances.mean(axis=0), rtol=0.05, atol=2e-5)
    pooled = np.sqrt(0.5 * (left_sigma**2 + right_sigma**2))
    assert (found.epipolar_residual_px / pooled).std() == pytest.approx(1.0, rel=0.03)


def test_no_better_point_minimizes_the_reprojection_error() -> None:
    """Oracle: the slow explicit maximum-likelihood estimate by nonlinear least squares."""
    from scipy.optimize import least_squares

    rng = np.random.default_rng(5)
    points = _volume(10, 6)
    left = CALIBRATION.left.project(points) + rng.normal(0, 0.2, (10, 2))
    right = CALIBRATION.right.project(points) + rng.normal(0, 0.4, (10, 2))
    found = TRIANGULATOR.triangulate(left, right, np.full(10, 0.2), np.full(10, 0.4))
    for i in range(10):

        def residual(p: np.ndarray, i: int = i) -> np.ndarray:
            return np.r_[(CALIBRATION.left.project(p[None])[0] - left[i]) / 0.2, (CALIBRATION.right.project(p[None])[0] - right[i]) / 0.4]

        best = least_squares(residual, points[i], xtol=1e-12).x
        scatter = np.sqrt(np.trace(found.covariances[i]))
        assert np.linalg.norm(found.points[i] - best) < 0.05 * scatter


def test_residual_is_signed_and_in_pixels() -> None:
    points = _volume(200, 3)
    left, right = CALIBRATION.left.project(points), CALIBRATION.right.project(points)
    sigma = np.full(200, 0.05)
    step = np.array([0, 1.0])
    up = TRIANGULATOR.triangulate(left - step, right + step, sigma, sigma).epipolar_residual_px
    down = TRIANGULATOR.triangulate(left + step, right - step, sigma, sigma).epipolar_residual_px
    assert (np.sign(up) == -np.sign(down)).all()
    # One pixel each, straight across epipolar lines that are nearly rows, is a distance of sqrt(2) in all.
    assert np.median(np.abs(up)) == pytest.approx(np.sqrt(2), rel=0.15)


def test_rays_that_do_not_meet_in_front_give_no_point() -> None:
    behind = np.array([[10.0, 5.0, -300.0]])
    sigma = np.full(1, 0.05)
    found = TRIANGULATOR.triangulate(CALIBRATION.left.project(behind), CALIBRATION.right.project(behind), sigma, sigma)
    assert np.isnan(found.points).all()
    assert np.isinf(found.epipolar_residual_px).all()
    assert not EpipolarGate().accepts(found.epipolar_residual_px, sigma, sigma).any()


def test_nothing_in_nothing_out() -> None:
    found = TRIANGULATOR.triangulate(np.empty((0, 2)), np.empty((0, 2)), np.empty(0), np.empty(0))
    assert found.points.shape == (0, 3)
    assert found.covariances.shape == (0, 3, 3)


def test_gate_follows_the_uncertainty_and_has_a_floor() -> None:
    gate = EpipolarGate(sigmas=3.0, floor_px=0.3)
    residual = np.array([0.29, 0.31, 0.55, -0.55, 0.65, np.inf, np.nan])
    sigma = np.array([0.01, 0.01, 0.2, 0.2, 0.2, 0.2, 0.2])
    assert gate.accepts(residual, sigma, sigma).tolist() == [True, False, True, True, False, False, False]
