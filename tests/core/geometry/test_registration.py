from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from scanner_core.geometry.local_surface import LocalSurface
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import RegistrationParameters, fit_rigid_to_surface, register_views
from scanner_core.geometry.rigid import RigidTransform

CENTRE = np.array([0.0, 0.0, 25.0])
VIEWS = 6


def _bumpy(directions: np.ndarray) -> np.ndarray:
    x, y, z = directions.T
    radius = 22 * (1 + 0.12 * np.sin(3 * x + 1) * np.cos(2 * y) + 0.08 * np.cos(5 * z + x) + 0.1 * y * z)
    return directions * radius[:, None] + CENTRE


def _sphere(directions: np.ndarray) -> np.ndarray:
    return 11.133 * directions + CENTRE


def _cylinder(directions: np.ndarray) -> np.ndarray:
    x, y, z = directions.T
    return np.stack([x, y, z], axis=1) / np.hypot(x, y)[:, None] * 12 + CENTRE


def _scan(
    shape: Callable[[np.ndarray], np.ndarray], seed: int, *, noise_mm: float = 0.025, shift_mm: float = 0.0, turn_deg: float = 0.0
) -> tuple[PointCloud, list[RigidTransform]]:
    """Views of a shape from around the table, each moved by a motion of its own, which is returned."""
    rng = np.random.default_rng(seed)
    points, views, motions = [], [], []
    for view in range(VIEWS):
        azimuth = 2 * np.pi * view / VIEWS
        towards = np.array([0.866 * np.cos(azimuth), 0.866 * np.sin(azimuth), 0.5])
        directions = rng.normal(size=(9000, 3))
        directions /= np.linalg.norm(directions, axis=1, keepdims=True)
        directions = directions[(directions @ towards > np.cos(np.radians(70))) & (np.abs(directions[:, 2]) < 0.9)][:1800]
        motion = RigidTransform.from_vector(np.radians(turn_deg) * rng.normal(size=3), shift_mm * rng.normal(size=3))
        points.append(motion.apply(shape(directions) + rng.normal(0, noise_mm, (len(directions), 3))))
        views.append(np.full(len(directions), view, np.int32))
        motions.append(motion)
    return PointCloud(np.concatenate(points), None, np.concatenate(views)), motions


def _disagreement_um(corrections: tuple[RigidTransform, ...], motions: list[RigidTransform]) -> float:
    """How far the views lie apart once corrected, per coordinate: what they all share is no disagreement."""
    where = CENTRE + np.random.default_rng(0).normal(0, 15, (200, 3))
    moved = np.array([(c @ m).apply(where) for c, m in zip(corrections, motions, strict=True)])
    return float(1e3 * np.sqrt(((moved - moved.mean(axis=0)) ** 2).mean()))


@pytest.mark.parametrize("seed", [1, 2])
def test_perturbed_views_come_back_together(seed: int) -> None:
    cloud, motions = _scan(_bumpy, seed, shift_mm=0.05, turn_deg=0.05)
    result = register_views(cloud, RegistrationParameters(prior_position_um=50, prior_angle_deg=0.05))
    identity = tuple(RigidTransform.identity() for _ in motions)
    assert result.applied
    assert result.converged
    assert _disagreement_um(identity, motions) > 30
    assert _disagreement_um(result.corrections, motions) < 10
    assert result.residual_after_um < 35 < result.residual_before_um
    assert min(result.overlap_fraction) > 0.3


def test_good_views_are_left_alone_and_it_is_said() -> None:
    cloud, _ = _scan(_bumpy, 3)
    result = register_views(cloud)
    assert not result.applied
    assert result.reason == "the refinement gained nothing"
    assert result.residual_after_um == result.residual_before_um
    for correction in result.corrections:
        np.testing.assert_array_equal(correction.matrix(), np.eye(4))


@pytest.mark.parametrize("shape", [_sphere, _cylinder])
def test_symmetric_shapes_do_not_drift_along_their_symmetries(shape: Callable[[np.ndarray], np.ndarray]) -> None:
    cloud, motions = _scan(shape, 4, shift_mm=0.02, turn_deg=0.01)
    result = register_views(cloud)
    for correction in result.corrections:
        assert correction.angle_deg() < 0.08
        assert np.linalg.norm(correction.apply(CENTRE) - CENTRE) < 0.12
    # The turns that the shape does not determine stay as they were; the shifts that it does are taken out.
    assert result.residual_after_um < 32
    assert _disagreement_um(result.corrections, motions) < 25


def test_outliers_do_not_pull() -> None:
    cloud, motions = _scan(_bumpy, 5, shift_mm=0.05, turn_deg=0.03)
    rng = np.random.default_rng(6)
    points = cloud.points.copy()
    wild = rng.random(len(points)) < 0.05
    points[wild] += rng.uniform(0.1, 0.9, (np.count_nonzero(wild), 1)) * (points[wild] - CENTRE) / 22
    result = register_views(PointCloud(points, None, cloud.views), RegistrationParameters(prior_position_um=50, prior_angle_deg=0.05))
    assert result.applied
    assert _disagreement_um(result.corrections, motions) < 12


def test_views_without_overlap_are_told_apart_from_failures() -> None:
    rng = np.random.default_rng(7)
    flat = np.c_[rng.uniform(0, 10, (500, 2)), np.zeros(500)]
    cloud = PointCloud(np.concatenate([flat, flat + np.array([100, 0, 0])]), None, np.repeat(np.arange(2, dtype=np.int32), 500))
    result = register_views(cloud)
    assert not result.applied
    assert result.reason == "the views do not overlap"
    assert result.overlap_fraction == (0.0, 0.0)
    assert all(c.angle_deg() == 0 for c in result.corrections)


@pytest.mark.parametrize("n", [0, 1, 40])
def test_tiny_clouds_are_answered(n: int) -> None:
    points = np.random.default_rng(8).normal(size=(n, 3))
    result = register_views(PointCloud(points, None, np.zeros(n, np.int32)))
    assert not result.applied
    assert len(result.corrections) == min(n, 1)


def test_an_empty_view_keeps_its_number() -> None:
    cloud, _ = _scan(_bumpy, 9, shift_mm=0.05)
    views = np.where(cloud.views == 5, 7, cloud.views).astype(np.int32)  # 5 and 6 measured nothing
    result = register_views(PointCloud(cloud.points, None, views), RegistrationParameters(prior_position_um=50))
    assert len(result.corrections) == 8
    for empty in (5, 6):
        np.testing.assert_allclose(result.corrections[empty].matrix(), np.eye(4), atol=1e-9)
        assert result.overlap_fraction[empty] == 0


def test_the_same_cloud_gives_the_same_corrections_with_known_covariances() -> None:
    cloud, motions = _scan(_bumpy, 10, shift_mm=0.05, turn_deg=0.03)
    known = PointCloud(cloud.points, np.broadcast_to(np.eye(3) * 0.025**2, (len(cloud), 3, 3)), cloud.views)
    wide = RegistrationParameters(prior_position_um=50, prior_angle_deg=0.05)
    first, second = register_views(known, wide), register_views(known, wide)
    for a, b in zip(first.corrections, second.corrections, strict=True):
        np.testing.assert_array_equal(a.matrix(), b.matrix())
    assert _disagreement_um(first.corrections, motions) < 12
    assert set(first.as_dict()) >= {"residual_before_um", "residual_after_um", "overlap_fraction", "converged", "applied", "reason"}


def test_local_surface_measures_the_distance_to_a_sphere() -> None:
    rng = np.random.default_rng(11)
    directions = rng.normal(size=(4000, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    upper = directions[directions[:, 2] > -0.2]
    surface = LocalSurface(10 * upper)
    asked = directions[directions[:, 2] > 0.1][:500]
    found = surface.distance(10.05 * asked)
    assert found.valid.mean() > 0.95
    ok = found.valid
    outward = np.sign((found.normals * asked).sum(axis=1))
    assert np.abs(outward * found.signed_mm - 0.05)[ok].max() < 3e-3  # a plane would be off by the sag of 0.03 mm
    assert np.degrees(np.arccos(np.abs((found.normals * asked).sum(axis=1)))[ok]).max() < 1.0
    below = surface.distance(10 * directions[directions[:, 2] < -0.5])
    assert not below.valid.any()


def _to_sphere(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    normals = (points - CENTRE) / np.linalg.norm(points - CENTRE, axis=1, keepdims=True)
    return CENTRE + 11.133 * normals, normals


def _to_box(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The nearest of three faces that meet in a corner at the origin."""
    face = np.abs(points).argmin(axis=1)
    normals = np.eye(3)[face]
    return np.where(normals > 0, 0.0, points), normals


def test_points_are_laid_on_a_known_surface() -> None:
    rng = np.random.default_rng(12)
    points = rng.uniform(1, 20, (600, 3))
    points[np.arange(600), rng.integers(0, 3, 600)] = 0.0
    motion = RigidTransform.from_vector([0.01, -0.02, 0.015], [0.2, -0.3, 0.1])
    found = fit_rigid_to_surface(motion.apply(points), _to_box)
    np.testing.assert_allclose((found @ motion).matrix(), np.eye(4), atol=1e-6)


def test_a_sphere_is_moved_but_not_turned() -> None:
    cloud, _ = _scan(_sphere, 13)
    shift = np.array([0.3, -0.2, 0.5])
    found = fit_rigid_to_surface(cloud.points + shift, _to_sphere)
    np.testing.assert_allclose(found.apply(CENTRE + shift), CENTRE, atol=0.002)
    assert found.angle_deg() < 0.01
