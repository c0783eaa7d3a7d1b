from __future__ import annotations

import numpy as np
import pytest

from scanner_core.reconstruction.spline import SmoothingSpline
from scanner_core.reconstruction.support import FITTED, MEASURED
from tests.core.reconstruction.shapes import on_sphere, sphere, spline_on


def test_density_share_inside_at_the_rim_and_far_from_the_points() -> None:
    mesh = sphere(10.0, 5)
    points = on_sphere(10.0, 8000, 0.0, 4)
    spline = spline_on(mesh, points[points[:, 2] > -3], 0.0)
    spacing = float(np.sqrt(4 * np.pi * 100 / 8000))
    inside = 10 * (np.arcsin(mesh.vertices[:, 2] / 10) - np.arcsin(-0.3)) / spacing  # of the rim, in spacings
    share = spline.share
    assert np.median(share[inside > 5]) == pytest.approx(1, abs=0.05)
    assert share[inside > 5].min() > MEASURED
    assert share[inside < -8].max() < FITTED
    # the level one half is at the rim within a spacing
    assert (share[(inside > 0.5) & (inside < 1.5)] > MEASURED).mean() > 0.95
    assert (share[(inside > -2.5) & (inside < -1.5)] < MEASURED).mean() > 0.95


def test_density_share_does_not_depend_on_the_density() -> None:
    """Ten times as dense on one side: both sides are measured."""
    mesh = sphere(10.0, 5)
    dense, sparse = on_sphere(10.0, 20_000, 0.0, 1), on_sphere(10.0, 2000, 0.0, 2)
    spline = spline_on(mesh, np.concatenate([dense[dense[:, 0] > 0], sparse[sparse[:, 0] < 0]]), 0.0)
    for side in (mesh.vertices[:, 0] > 3, mesh.vertices[:, 0] < -3):
        assert np.median(spline.share[side]) == pytest.approx(1, abs=0.15)
        assert (spline.share[side] > MEASURED).mean() > 0.99


def test_rejected_points_bear_out_nothing() -> None:
    mesh = sphere(10.0, 4)
    points = on_sphere(10.0, 4000, 0.0, 1)
    whole = spline_on(mesh, points, 0.0)
    robust = np.where(points[:, 2] > 2, 0.0, 1.0)
    spline = SmoothingSpline(mesh, whole.observations, robust, np.full(4000, whole.spacing_mm), 0.0, lambda: None)
    assert spline.share[mesh.vertices[:, 2] > 5].max() < FITTED
    assert spline.share[mesh.vertices[:, 2] < 0].min() > MEASURED
