from __future__ import annotations

import numpy as np

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_in_triangles, closest_near, closest_points
from scanner_core.geometry.subdivision import subdivide_uniform


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
