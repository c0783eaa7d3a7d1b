"""Finding spheres among other points, and how much of them is covered."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.errors import AcquisitionError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.coverage import sphere_coverage
from scanner_core.metrology.reference_sphere import evaluate_acquisition, shell_width
from scanner_core.metrology.sphere_search import find_sphere, find_spheres

Array = NDArray[np.float64]
R = 11.133


def _ball(rng: np.random.Generator, count: int, centre: tuple[float, float, float], sigma: float, lowest_deg: float = 110.0) -> Array:
    """Points on a sphere from its top down to a polar angle."""
    z = rng.uniform(np.cos(np.radians(lowest_deg)), 1, count)
    turn = rng.uniform(0, 2 * np.pi, count)
    across = np.sqrt(1 - z * z)
    directions = np.c_[across * np.cos(turn), across * np.sin(turn), z]
    return np.asarray(centre + (R + rng.normal(0, sigma, count))[:, None] * directions, np.float64)


def _clutter(rng: np.random.Generator, count: int) -> Array:
    return np.c_[rng.uniform(-20, 20, (count, 2)), rng.normal(0.2, 0.02, count)]


@pytest.mark.parametrize("sigma", [0.002, 0.03, 0.17])
def test_a_sphere_is_told_from_table_and_stem_by_its_shape(sigma: float) -> None:
    rng = np.random.default_rng(1)
    ball = _ball(rng, 3000, (1.0, -2.0, 13.0), sigma)
    height = rng.uniform(0.2, 2.0, 100)
    turn = rng.uniform(0, 6.28, 100)
    stem = np.c_[1 + 1.5 * np.cos(turn), -2 + 1.5 * np.sin(turn), height]
    points = rng.permutation(np.concatenate([ball, stem, _clutter(rng, 300)]))
    found = evaluate_acquisition(PointCloud(points), R)
    assert abs(found.radius_mm - R) < 4 * found.radius_uncertainty_mm + 2e-4
    np.testing.assert_allclose(found.centre_mm, (1, -2, 13), atol=6 * sigma / np.sqrt(1000) + 3e-4)
    assert found.residual_rms_um == pytest.approx(1e3 * sigma, rel=0.06)
    assert found.points >= 0.99 * len(ball)
    assert found.foreign + found.rejected == len(points) - found.points


def test_gross_errors_are_left_out_and_counted() -> None:
    rng = np.random.default_rng(2)
    ball = _ball(rng, 2000, (0.0, 0.0, 13.0), 0.02)
    ball[:30] += 0.3 * (ball[:30] - (0, 0, 13)) / R
    found = find_sphere(ball, R)
    assert found is not None
    assert found.rejected == 30
    assert abs(found.fit.radius_mm - R) < 0.002


def test_two_spheres_come_out_one_after_the_other() -> None:
    rng = np.random.default_rng(3)
    points = np.concatenate([_ball(rng, 900, (-40, 0, 20), 0.03, 120), _ball(rng, 700, (40, 0, 50), 0.03, 120), _clutter(rng, 100)])
    found = find_spheres(points, (R, R))
    assert len(found) == 2
    assert not (found[0].near & found[1].near).any()
    apart = np.linalg.norm(found[0].fit.centre - found[1].fit.centre)
    assert apart == pytest.approx(np.hypot(80, 30), abs=0.005)


def test_there_is_no_sphere_in_a_plane_or_among_few_points() -> None:
    rng = np.random.default_rng(4)
    assert find_sphere(np.c_[rng.uniform(-20, 20, (500, 2)), np.zeros(500)], R) is None
    assert find_sphere(_ball(rng, 40, (0, 0, 13), 0.01), R) is None


def test_what_is_no_single_sphere_is_named() -> None:
    rng = np.random.default_rng(5)
    two = np.concatenate([_ball(rng, 600, (-15, 0, 13), 0.03), _ball(rng, 500, (15, 0, 13), 0.03)])
    flat = _clutter(rng, 800)
    with pytest.raises(AcquisitionError) as few:
        evaluate_acquisition(PointCloud(two[:20]), R)
    with pytest.raises(AcquisitionError) as second:
        evaluate_acquisition(PointCloud(two), R)
    with pytest.raises(AcquisitionError) as none:
        evaluate_acquisition(PointCloud(flat), R)
    assert [error.value.code for error in (few, second, none)] == ["E-MET-05", "E-MET-04", "E-MET-03"]


def test_coverage_sees_how_far_down_and_where_nothing_is() -> None:
    rng = np.random.default_rng(6)
    points = _ball(rng, 6000, (0.0, 0.0, 0.0), 0.0, 105.0)
    whole = sphere_coverage(points)
    assert whole.polar_deg == pytest.approx(105, abs=2)
    assert whole.surface_fraction == pytest.approx(0.5 * (1 - np.cos(np.radians(105))), abs=0.03)
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0]))
    missing = sphere_coverage(points[~((azimuth > 15) & (azimuth < 95) & (points[:, 2] < 5))])
    assert missing.polar_deg < 75
    assert missing.surface_fraction < whole.surface_fraction - 0.03


def test_the_shell_of_95_percent_is_that_of_a_normal_distribution() -> None:
    rng = np.random.default_rng(7)
    assert shell_width(rng.normal(0, 10, 100_000)) == pytest.approx(2 * 1.96 * 10, rel=0.02)
    assert shell_width(np.array([0.0] * 95 + [100.0] * 5)) == 0.0
