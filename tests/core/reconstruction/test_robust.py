from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from scanner_core.reconstruction.cloud_scale import CloudScale, measure_scale
from scanner_core.reconstruction.robust import robust_weights
from tests.core.reconstruction.shapes import Array, on_sphere


@pytest.fixture(scope="module")
def cloud() -> tuple[Array, Array, CloudScale]:
    """Points on a ball, residuals of 0.1 mm, the scale."""
    points = on_sphere(10.0, 4000, 0.0, 1)
    return points, 0.1 * np.random.default_rng(2).normal(size=4000), measure_scale(points, cKDTree(points), 0)


def test_weights_fall_from_three_to_five_sigma(cloud: tuple[Array, Array, CloudScale]) -> None:
    _, residuals, scale = cloud
    marked = residuals.copy()
    marked[:4] = 0.05, -0.4, 0.8, -3.0
    sigma = 1.4826 * float(np.median(np.abs(marked)))
    weights = robust_weights(marked, scale, patient=False)
    expected = np.clip((5 - np.abs(marked) / sigma) / 2, 0, 1)
    np.testing.assert_allclose(weights, expected, atol=1e-12)
    assert weights[0] == 1
    assert 0 < weights[1] < 1
    assert weights[2] == weights[3] == 0


@pytest.mark.parametrize("patient", [True, False])
def test_single_outliers_are_rejected(cloud: tuple[Array, Array, CloudScale], patient: bool) -> None:
    _, residuals, scale = cloud
    out = np.random.default_rng(3).choice(4000, 60, replace=False)
    marked = residuals.copy()
    marked[out] = np.where(np.arange(60) % 2, 2.0, -2.0)
    weights = robust_weights(marked, scale, patient=patient)
    assert (weights[out] == 0).mean() > 0.97
    assert np.delete(weights, out).mean() > 0.99


def test_a_group_that_agrees_keeps_its_weight_with_patience_only(cloud: tuple[Array, Array, CloudScale]) -> None:
    points, residuals, scale = cloud
    group = points[:, 2] > 9
    marked = residuals.copy()
    marked[group] += 2.0
    inner = points[:, 2] > 9.3
    assert robust_weights(marked, scale)[inner].min() == 1
    assert robust_weights(marked, scale, patient=False)[inner].max() == 0


def test_isolated_points_weigh_nothing_even_on_the_surface() -> None:
    points = np.concatenate([on_sphere(10.0, 2000, 0.0, 1), [[0.0, 0.0, 60.0]]])
    scale = measure_scale(points, cKDTree(points), 0)
    assert robust_weights(np.zeros(2001), scale)[-1] == 0


def test_residuals_far_below_the_spacing_reject_nothing(cloud: tuple[Array, Array, CloudScale]) -> None:
    _, residuals, scale = cloud
    tiny = 1e-6 * residuals
    tiny[0] = 1e-5
    np.testing.assert_array_equal(robust_weights(tiny, scale, patient=False), 1)
