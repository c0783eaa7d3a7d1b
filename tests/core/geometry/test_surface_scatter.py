"""Scatter about the local surface that the covariances do not explain."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.surface_scatter import excess_scatter_mm


def ball(count: int, sigma_mm: float, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    normal = rng.standard_normal((count, 3))
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    return (11.0 + sigma_mm * rng.standard_normal(count))[:, None] * normal


@pytest.mark.parametrize("surface_mm", [0.0, 0.03, 0.06])
def test_it_is_what_was_added(surface_mm: float) -> None:
    points = ball(6000, float(np.hypot(0.02, surface_mm)), 1)
    found = excess_scatter_mm(points, np.tile(0.02**2 * np.eye(3), (6000, 1, 1)))
    assert found == pytest.approx(surface_mm, rel=0.08, abs=0.008)


def test_strays_do_not_count() -> None:
    points = ball(6000, 0.02, 2)
    points[::100] *= 1.05
    assert excess_scatter_mm(points, np.tile(0.02**2 * np.eye(3), (6000, 1, 1))) < 0.012


def test_too_few_points_say_nothing() -> None:
    assert excess_scatter_mm(ball(300, 0.1, 3), np.tile(1e-6 * np.eye(3), (300, 1, 1))) == 0
