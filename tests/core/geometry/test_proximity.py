from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_in_triangles, closest_near, closest_points
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.core.geometry.solids import box, sphere, torus


def all_pairs(mesh: TriangleMesh, points: np.ndarray) -> np.ndarray:
    """The slow explicit version: every point against every triangle."""
    a, b, c = mesh.corners()
    return np.array([np.sqrt(closest_in_triangles(np.broadcast_to(p, a.shape), a, b, c)[1].min()) for p in points])


def test_one_triangle_against_a_fine_grid_of_its_points() -> None:
    rng = np.random.default_rng(1)
    u, v = np.meshgrid(np.linspace(0, 1, 201), np.linspace(0, 1, 201))
    inside = u + v <= 1
    weights = np.stack([1 - u[inside] - v[inside], u[inside], v[inside]], axis=1)
    for _ in range(20):
        corners, point = rng.normal(size=(3, 3)), 2 * rng.normal(size=3)
        expected = np.linalg.norm(weights @ corners - point, axis=1).min()
        found, squared = closest_in_triangles(point[None], *(corner[None] for corner in corners))
        assert np.all(found >= -1e-12)
        np.testing.assert_allclose(found.sum(), 1)
        np.testing.assert_allclose(np.sqrt(squared[0]), expected, atol=0.02)
        assert np.sqrt(squared[0]) <= expected + 1e-9


def test_exact_on_a_mesh_of_very_different_triangles() -> None:
    rng = np.random.default_rng(2)
    mesh = icosahedron((0, 0, 0), 10.0)
    small = subdivide_uniform(subdivide_uniform(icosahedron((11.0, 0, 0), 0.5)))
    both = TriangleMesh(np.concatenate([mesh.vertices, small.vertices]), np.concatenate([mesh.triangles, small.triangles + 12]))
    points = rng.normal(size=(300, 3)) * 8
    feet = closest_points(both, points)
    np.testing.assert_allclose(feet.distances_mm, all_pairs(both, points), atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(points - feet.points, axis=1), feet.distances_mm, atol=1e-9)


def test_near_search_is_exact_close_to_a_well_shaped_mesh() -> None:
    mesh = subdivide_uniform(subdivide_uniform(icosahedron((0, 0, 0), 1.0)))
    rng = np.random.default_rng(5)
    points = mesh.vertices[mesh.triangles[:200]].mean(axis=1) + 0.02 * rng.normal(size=(200, 3))
    np.testing.assert_allclose(closest_near(mesh, points).distances_mm, all_pairs(mesh, points), atol=1e-9)


def bumpy(seed: int) -> TriangleMesh:
    """A well-shaped sphere of 5120 triangles with waves and a little noise, as a fitted surface has."""
    rng = np.random.default_rng(seed)
    mesh = icosahedron((0, 0, 0), 1.0)
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
        mesh = TriangleMesh(mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None], mesh.triangles)
    wave = 1 + 0.1 * np.sin(mesh.vertices @ rng.normal(size=(3, 4)) * 3).sum(axis=1)
    return TriangleMesh(mesh.vertices * wave[:, None] + 0.004 * rng.normal(size=mesh.vertices.shape), mesh.triangles)


def about(mesh: TriangleMesh, rng: np.random.Generator, reach: float, count: int = 2000) -> np.ndarray:
    """Points at random within `reach` of a mesh, in no direction more than in another."""
    triangle = rng.integers(0, len(mesh.triangles), count)
    on_it = np.einsum("nc,ncd->nd", rng.dirichlet([1, 1, 1], count), mesh.vertices[mesh.triangles[triangle]])
    away = rng.normal(size=(count, 3))
    return on_it + reach * rng.uniform(0, 1, (count, 1)) * away / np.linalg.norm(away, axis=1)[:, None]


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from([(0.1, 0.002), (0.5, 0.004), (1.0, 0.008)]))
def test_near_search_misses_few_points_within_an_edge(seed: int, case: tuple[float, float]) -> None:
    """The share of points that end in a local minimum, against the exact answer; cold and from a mesh that has moved since."""
    edges, share = case
    rng = np.random.default_rng(seed)
    mesh = bumpy(seed)
    edge = float(EdgeTable.of(mesh.triangles).lengths(mesh.vertices).mean())
    points = about(mesh, rng, edges * edge)
    exact = ClosestPoint(mesh).distance(points)
    before = TriangleMesh(mesh.vertices + 0.15 * edge * rng.normal(size=mesh.vertices.shape), mesh.triangles)
    start = closest_near(before, points).vertices
    table = EdgeTable.of(mesh.triangles)
    for feet in (closest_near(mesh, points), closest_near(mesh, points, start=start), closest_near(mesh, points, start=start, table=table)):
        assert np.all(feet.distances_mm >= exact - 1e-9)
        assert np.mean(feet.distances_mm > exact + 1e-9) <= share
        assert np.max(feet.distances_mm - exact) < 0.35 * edge
        corners = mesh.vertices[mesh.triangles[feet.triangles]]
        np.testing.assert_allclose(np.einsum("nc,ncd->nd", feet.weights, corners), feet.points, atol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(points - feet.points, axis=1), feet.distances_mm, atol=1e-9)
        assert np.all((mesh.triangles[feet.triangles] == feet.vertices[:, None]).any(axis=1))


def test_a_start_on_the_wrong_side_of_a_body_is_found_out() -> None:
    mesh = bumpy(3)
    points = about(mesh, np.random.default_rng(3), 0.01, 500)
    wrong = np.argmin(mesh.vertices @ points.T, axis=0)
    np.testing.assert_allclose(closest_near(mesh, points, start=wrong).distances_mm, ClosestPoint(mesh).distance(points), atol=1e-3)


@pytest.mark.parametrize("mesh", [box(), sphere(2.0), torus()])
def test_exact_search_on_meshes_with_slivers_and_borders(mesh: TriangleMesh) -> None:
    rng = np.random.default_rng(4)
    for cut in (mesh, TriangleMesh(mesh.vertices, mesh.triangles[2:])):
        points = rng.normal(size=(200, 3)) * 3
        np.testing.assert_allclose(closest_points(cut, points).distances_mm, all_pairs(cut, points), atol=1e-9)
        assert np.all(closest_near(cut, points).distances_mm >= all_pairs(cut, points) - 1e-9)
