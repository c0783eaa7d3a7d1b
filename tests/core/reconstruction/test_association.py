from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.proximity import closest_points
from scanner_core.reconstruction.association import Association, associate
from scanner_core.reconstruction.discrete_surface import DiscreteSurface
from scanner_core.reconstruction.observations import observations_of
from tests.core.reconstruction.shapes import Array, on_sphere, sphere


def tied(points: Array, noise_mm: float, *, soft: bool, levels: int = 3, radius: float = 5.0) -> tuple[DiscreteSurface, Association]:
    surface = DiscreteSurface(sphere(radius, levels), lambda: None)
    return surface, associate(surface, observations_of(points, None), noise_mm, softly=soft)


def test_feet_are_the_closest_points() -> None:
    points = on_sphere(5.0, 800, 0.2, 1)
    surface, found = tied(points, 0.2, soft=False)
    assert not found.soft
    places = found.interpolation @ surface.mesh.vertices
    exact = closest_points(surface.mesh, points)
    np.testing.assert_allclose(np.linalg.norm(points - places, axis=1), exact.distances_mm, atol=1e-9)
    np.testing.assert_allclose(found.interpolation.sum(axis=1), 1)
    np.testing.assert_array_equal(found.spread_mm2, 0)
    np.testing.assert_array_equal(found.homes(), exact.vertices)


def test_distances_are_measured_from_the_curved_surface_not_from_its_facets() -> None:
    _, found = tied(on_sphere(5.0, 800, 0.0, 1), 0.0, soft=False)
    middle_of_an_edge = 5 * (1 - np.cos(0.075))  # under the sphere, of an edge of 0.75 mm
    assert float(np.abs(found.distances_mm).max()) < 0.2 * middle_of_an_edge
    _, outside = tied(on_sphere(5.4, 800, 0.0, 1), 0.0, soft=False)
    np.testing.assert_allclose(outside.distances_mm, 0.4, atol=0.005)


def test_noise_against_the_edge_decides_on_the_kind() -> None:
    points = on_sphere(5.0, 300, 0.1, 1)
    surface, below = tied(points, 0.74 * 0.7510, soft=True)
    assert surface.edge_mm == pytest.approx(0.7510, abs=1e-3)
    assert not below.soft
    assert tied(points, 0.76 * 0.7511, soft=True)[1].soft


def test_soft_rows_are_the_gaussian_responsibilities() -> None:
    points = on_sphere(5.0, 200, 0.8, 2)
    surface, found = tied(points, 0.8, soft=True)
    assert found.soft
    away = np.linalg.norm(points[:, None] - surface.mesh.vertices[None], axis=2)
    dense = surface.area * np.exp(-0.5 * (away / 0.8) ** 2)
    within = away <= 3.2 * 0.8
    np.testing.assert_allclose(found.interpolation.sum(axis=1), 1)
    near = within.any(axis=1)
    assert near.sum() > 190
    expected = np.where(within, dense, 0)[near]
    expected /= expected.sum(axis=1, keepdims=True)
    np.testing.assert_allclose(found.interpolation.toarray()[near], expected, atol=1e-12)
    # and the cut tails are small
    np.testing.assert_allclose(expected, dense[near] / dense[near].sum(axis=1, keepdims=True), atol=0.05)
    off = np.einsum("nvk,vk->nv", points[:, None] - surface.mesh.vertices[None], surface.normals)[near]
    mean = (expected * off).sum(axis=1)
    np.testing.assert_allclose(found.distances_mm[near], mean, atol=1e-9)
    np.testing.assert_allclose(found.spread_mm2[near], (expected * (off - mean[:, None]) ** 2).sum(axis=1), atol=1e-9)


def test_soft_distances_have_no_bias_on_a_sphere_and_feet_have_that_of_its_curvature() -> None:
    points = on_sphere(5.0, 40_000, 0.6, 1)
    bias, chance = 0.6**2 / 5, 0.6 / np.sqrt(40_000)
    assert tied(points, 0.6, soft=False)[1].distances_mm.mean() == pytest.approx(bias, abs=3 * chance)
    assert tied(points, 0.6, soft=True)[1].distances_mm.mean() == pytest.approx(0, abs=3 * chance)


def test_a_point_out_of_reach_has_a_foot_also_under_a_soft_association() -> None:
    points = np.concatenate([on_sphere(5.0, 200, 0.6, 3), [[0.0, 0.0, 30.0], [-14.0, 0.0, 0.0]]])
    _, found = tied(points, 0.6, soft=True)
    assert found.soft
    np.testing.assert_allclose(found.distances_mm[-2:], [25, 9], atol=0.1)
    np.testing.assert_allclose(found.interpolation.sum(axis=1), 1)
    np.testing.assert_allclose(found.normals[-2:], [[0, 0, 1], [-1, 0, 0]], atol=0.05)
    np.testing.assert_allclose(np.linalg.norm(found.normals, axis=1), 1)
