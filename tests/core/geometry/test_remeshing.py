from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.edges import EdgeTable, valences
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.remeshing import collapse_short, flip_edges, relax, split_long
from scanner_core.geometry.subdivision import subdivide_uniform


def lumpy(seed: int) -> TriangleMesh:
    mesh = subdivide_uniform(subdivide_uniform(icosahedron((0, 0, 0), 1.0)))
    return TriangleMesh(mesh.vertices + 0.03 * np.random.default_rng(seed).normal(size=mesh.vertices.shape), mesh.triangles)


def assert_sphere(mesh: TriangleMesh) -> None:
    table = EdgeTable.of(mesh.triangles)
    assert table.edge_sides is not None
    sides = table.edge_sides
    start = mesh.triangles.ravel()
    assert np.all(start[sides[:, 0]] != start[sides[:, 1]])  # both triangles of an edge wind the same way
    assert len(mesh.vertices) - len(table.edges) + len(mesh.triangles) == 2
    assert valences(table.edges, len(mesh.vertices)).min() >= 3


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 2**31), st.floats(0.1, 0.6))
def test_every_change_keeps_a_closed_sphere(seed: int, length: float) -> None:
    mesh = lumpy(seed)
    for _ in range(4):
        mesh = split_long(mesh, 1.35 * length)
        assert_sphere(mesh)
        mesh, kept = collapse_short(mesh, 0.6 * length)
        assert len(kept) == len(mesh.vertices)
        assert_sphere(mesh)
        mesh = relax(flip_edges(mesh))
        assert_sphere(mesh)
    assert mesh.volume() > 2.0


def test_collapsing_makes_a_coarse_mesh_of_the_same_body() -> None:
    mesh = lumpy(0)
    before = mesh.volume()
    for _ in range(20):
        mesh = flip_edges(collapse_short(mesh, 0.4)[0])
    lengths = EdgeTable.of(mesh.triangles).lengths(mesh.vertices)
    assert len(mesh.triangles) < 0.5 * len(lumpy(0).triangles)
    assert np.median(lengths) > 0.4
    assert mesh.volume() == pytest.approx(before, rel=0.2)


def test_flips_remove_the_needles_of_a_stretched_mesh() -> None:
    mesh = lumpy(1)
    stretched = TriangleMesh(mesh.vertices * (1.0, 1.0, 2.0), mesh.triangles)
    worst = [min_angle_deg(m) for m in (stretched, flip_edges(stretched, passes=10))]
    assert worst[1] > worst[0]


def min_angle_deg(mesh: TriangleMesh) -> float:
    p = mesh.vertices[mesh.triangles]
    angles = []
    for i in range(3):
        one, two = p[:, (i + 1) % 3] - p[:, i], p[:, (i + 2) % 3] - p[:, i]
        angles.append(np.arccos((one * two).sum(axis=1) / np.linalg.norm(one, axis=1) / np.linalg.norm(two, axis=1)))
    return float(np.degrees(np.percentile(np.min(angles, axis=0), 5)))
