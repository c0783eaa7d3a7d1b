from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import cotangent_laplacian, satisfies_taubin, taubin_mu, taubin_smooth, uniform_averaging
from scanner_core.geometry.subdivision import side_lifts, subdivide_uniform


def sphere(radius_mm: float = 10.0, levels: int = 4) -> TriangleMesh:
    mesh = icosahedron((0, 0, 0), radius_mm)
    for _ in range(levels):
        mesh = subdivide_uniform(mesh)
        mesh = TriangleMesh(radius_mm * mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None], mesh.triangles)
    return mesh


def bumpy() -> TriangleMesh:
    mesh = sphere(levels=2)
    return TriangleMesh(mesh.vertices + 0.8 * np.random.default_rng(5).normal(size=mesh.vertices.shape), mesh.triangles)


def test_taubins_condition() -> None:
    mu = taubin_mu(0.33, 0.1)
    assert mu == pytest.approx(-0.3413, abs=1e-4)
    assert satisfies_taubin(0.33, mu, 0.1)
    assert not satisfies_taubin(0.33, -0.33, 0.1)
    assert not satisfies_taubin(0.5, -0.4, 0.1)
    assert not satisfies_taubin(0.9, taubin_mu(0.9, 0.1), 0.1)  # amplifies the highest frequencies


def test_averaging_is_the_mean_of_the_neighbours() -> None:
    mesh = sphere(levels=1)
    averaged = uniform_averaging(mesh) @ mesh.vertices
    for vertex in range(len(mesh.vertices)):
        around = set(mesh.triangles[(mesh.triangles == vertex).any(axis=1)].ravel()) - {vertex}
        np.testing.assert_allclose(averaged[vertex], mesh.vertices[sorted(around)].mean(axis=0), atol=1e-12)


def test_filter_removes_noise_and_neither_shrinks_nor_reconnects() -> None:
    smooth = sphere()
    normals = smooth.vertices / 10.0
    noisy = TriangleMesh(smooth.vertices + 0.05 * np.random.default_rng(3).normal(size=(len(normals), 1)) * normals, smooth.triangles)
    filtered = taubin_smooth(noisy, lambda_=0.33, mu=taubin_mu(0.33, 0.1), iterations=10)
    np.testing.assert_array_equal(filtered.triangles, noisy.triangles)
    spread = np.linalg.norm(filtered.vertices, axis=1).std()
    assert spread < 0.55 * np.linalg.norm(noisy.vertices, axis=1).std()
    assert filtered.volume() == pytest.approx(smooth.volume(), rel=2e-3)


def test_laplacian_of_the_coordinates_is_the_curvature() -> None:
    mesh = sphere(radius_mm=4.0)
    stiffness, area = cotangent_laplacian(mesh)
    np.testing.assert_allclose(np.asarray(stiffness.sum(axis=0)), 0, atol=1e-9)
    assert area.sum() == pytest.approx(mesh.area())
    curvature = ((stiffness @ mesh.vertices) / area[:, None] * mesh.vertices / 4.0).sum(axis=1)
    assert np.median(curvature) == pytest.approx(2 / 4.0, rel=0.02)


def test_a_shared_table_of_edges_changes_nothing() -> None:
    mesh = bumpy()
    table = EdgeTable.of(mesh.triangles)
    averaging = uniform_averaging(mesh), uniform_averaging(mesh, table)
    for one, other in (averaging, (cotangent_laplacian(mesh)[0], cotangent_laplacian(mesh, table)[0])):
        np.testing.assert_array_equal(one.toarray(), other.toarray())
        assert one.has_canonical_format
        assert one.has_sorted_indices
    normals = mesh.vertex_normals()
    np.testing.assert_array_equal(side_lifts(mesh, normals), side_lifts(mesh, normals, table))


def test_laplacian_against_its_sum_over_triangles() -> None:
    mesh = bumpy()
    expected = np.zeros((len(mesh.vertices),) * 2)
    for triangle in mesh.triangles:
        for i in range(3):
            a, b, tip = triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]
            u, w = mesh.vertices[a] - mesh.vertices[tip], mesh.vertices[b] - mesh.vertices[tip]
            half = 0.5 * np.clip(u @ w / np.linalg.norm(np.cross(u, w)), 0.05, 5.0)
            expected[[a, b], [b, a]] -= half
            expected[[a, b], [a, b]] += half
    np.testing.assert_allclose(cotangent_laplacian(mesh)[0].toarray(), expected, atol=1e-12)
