from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares

from scanner_core.errors import UsageError
from scanner_core.geometry.fitting import fit_rigid, fit_sphere
from scanner_core.geometry.rigid import RigidTransform


def _cap(n: int, opening_deg: float, rng: np.random.Generator) -> np.ndarray:
    """Directions within `opening_deg` of +z."""
    z = rng.uniform(np.cos(np.radians(opening_deg)), 1, n)
    azimuth = rng.uniform(0, 2 * np.pi, n)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth), z], axis=1)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.5, 500), st.floats(20, 180), st.integers(0, 1000))
def test_a_true_sphere_is_found_exactly(radius_mm: float, opening_deg: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    centre = rng.uniform(-300, 300, 3)
    fit = fit_sphere(centre + radius_mm * _cap(50, opening_deg, rng))
    assert fit.radius_mm == pytest.approx(radius_mm, rel=1e-8)
    np.testing.assert_allclose(fit.centre, centre, atol=1e-7 * max(radius_mm, 10))


def test_fit_is_the_least_squares_minimum() -> None:
    """Oracle: a general minimizer of the same sum."""
    rng = np.random.default_rng(1)
    points = [5, -3, 400] + 11.133 * _cap(300, 90, rng) + rng.normal(0, 0.1, (300, 3))
    fit = fit_sphere(points)
    best = least_squares(lambda p: np.linalg.norm(points - p[:3], axis=1) - p[3], [5, -3, 400, 11], xtol=1e-14, ftol=1e-14).x
    np.testing.assert_allclose(np.r_[fit.centre, fit.radius_mm], best, atol=1e-6)
    assert fit.rms_mm == pytest.approx(0.1, rel=0.1)


def test_stated_uncertainty_is_the_scatter_of_repeats() -> None:
    rng = np.random.default_rng(2)
    directions = _cap(300, 100, rng)
    fits = [fit_sphere(11.133 * directions + rng.normal(0, 0.03, (300, 3))) for _ in range(400)]
    centres = np.array([fit.centre for fit in fits])
    radii = np.array([fit.radius_mm for fit in fits])
    assert radii.std() == pytest.approx(np.median([fit.radius_uncertainty_mm for fit in fits]), rel=0.12)
    np.testing.assert_allclose(centres.std(axis=0), np.median([fit.centre_uncertainty_mm for fit in fits], axis=0), rtol=0.15)
    assert abs(radii.mean() - 11.133) < 4 * radii.std() / np.sqrt(400) + 0.03**2 / 11.133


@pytest.mark.parametrize("points", [np.zeros((4, 3)), np.zeros((9, 3)), np.c_[np.random.default_rng(3).normal(size=(20, 2)), np.zeros(20)]])
def test_what_is_no_sphere_is_refused(points: np.ndarray) -> None:
    with pytest.raises(UsageError, match="no sphere"):
        fit_sphere(points)


@settings(max_examples=25, deadline=None)
@given(st.tuples(*[st.floats(-2, 2)] * 3), st.tuples(*[st.floats(-100, 100)] * 3), st.integers(3, 40))
def test_rigid_motion_between_corresponding_points(turn: tuple[float, float, float], shift: tuple[float, float, float], n: int) -> None:
    points = np.random.default_rng(n).normal(0, 20, (n, 3))
    motion = RigidTransform.from_vector(turn, shift)
    np.testing.assert_allclose(fit_rigid(points, motion.apply(points)).matrix(), motion.matrix(), atol=1e-9)


def test_mirrored_points_give_a_rotation_all_the_same() -> None:
    points = np.random.default_rng(4).normal(size=(30, 3))
    assert np.linalg.det(fit_rigid(points, points * [1, 1, -1]).rotation) == pytest.approx(1)


def test_weights_decide() -> None:
    points = np.random.default_rng(5).normal(size=(20, 3))
    target = points + np.array([1.0, 2.0, 3.0])
    target[15:] += 50
    weights = np.r_[np.ones(15), np.zeros(5)]
    np.testing.assert_allclose(fit_rigid(points, target, weights).translation, [1, 2, 3], atol=1e-9)
