from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import curved_middles, side_lifts, split_edges, subdivide_uniform


def one_by_one(mesh: TriangleMesh) -> set[frozenset[tuple[float, ...]]]:
    """The slow explicit version: every triangle as a set of corners."""
    triangles = set()
    for a, b, c in mesh.vertices[mesh.triangles]:
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        for three in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)):
            triangles.add(frozenset(tuple(np.round(corner, 9)) for corner in three))
    return triangles


def test_uniform_subdivision_gives_exactly_four_times_the_triangles_and_the_same_surface() -> None:
    mesh = icosahedron((0.5, 0.0, 0.0), 1.0)
    fine = subdivide_uniform(mesh)
    assert len(fine.triangles) == 4 * len(mesh.triangles)
    assert len(fine.vertices) == len(mesh.vertices) + 30
    assert {frozenset(tuple(np.round(corner, 9)) for corner in three) for three in fine.vertices[fine.triangles]} == one_by_one(mesh)
    assert fine.volume() == pytest.approx(mesh.volume())
    assert fine.area() == pytest.approx(mesh.area())
    assert len(subdivide_uniform(fine).triangles) == 16 * len(mesh.triangles)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**31))
def test_any_choice_of_edges_keeps_the_mesh_closed_and_adds_two_triangles_each(seed: int) -> None:
    mesh = subdivide_uniform(icosahedron((0, 0, 0), 1.0))
    table = EdgeTable.of(mesh.triangles)
    marked = np.random.default_rng(seed).random(len(table.edges)) < 0.4
    split = split_edges(mesh, table, marked)
    assert len(split.triangles) == len(mesh.triangles) + 2 * marked.sum()
    again = EdgeTable.of(split.triangles)
    assert again.edge_sides is not None
    assert len(split.vertices) - len(again.edges) + len(split.triangles) == 2
    assert split.volume() == pytest.approx(mesh.volume())


def test_curved_middles_approach_the_sphere_with_the_fourth_power_of_the_edge() -> None:
    mesh = icosahedron((0, 0, 0), 1.0)
    flat, curved = [], []
    for _ in range(4):
        mesh = subdivide_uniform(mesh)
        normals = mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None]
        mesh = TriangleMesh(normals, mesh.triangles)
        edges = EdgeTable.of(mesh.triangles).edges
        flat.append(np.abs(np.linalg.norm(0.5 * (normals[edges[:, 0]] + normals[edges[:, 1]]), axis=1) - 1).max())
        curved.append(np.abs(np.linalg.norm(curved_middles(mesh.vertices, normals, edges), axis=1) - 1).max())
    assert np.all(np.divide(flat[:-1], flat[1:]) < 4.5)
    assert np.all(np.divide(curved[:-1], curved[1:]) > 12)
    np.testing.assert_allclose(side_lifts(mesh, normals).max(), flat[-1], rtol=0.01)
