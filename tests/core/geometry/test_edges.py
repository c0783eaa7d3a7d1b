"""The table of edges against a slow dictionary, by both ways of sorting."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.edges import EdgeTable, row_cross, vertex_triangles
from tests.core.geometry.solids import sphere, torus


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.sampled_from([8, 60, 1 << 40]))
def test_any_triangles_have_their_edges_in_lexical_order(seed: int, vertices: int) -> None:
    """With vertices numbered up to 2^30 the keys do not fit one integer together with their places."""
    rng = np.random.default_rng(seed)
    names = np.sort(rng.choice(min(vertices, 1 << 30), 8, replace=False))
    triangles = names[np.array([rng.choice(8, 3, replace=False) for _ in range(12)])]
    table = EdgeTable.of(triangles)
    expected = sorted({tuple(sorted((t[i], t[(i + 1) % 3]))) for t in triangles.tolist() for i in range(3)})
    assert [tuple(edge) for edge in table.edges.tolist()] == expected
    for triangle, edges in zip(triangles, table.side_edges, strict=True):
        for i in range(3):
            assert set(table.edges[edges[i]]) == {triangle[i], triangle[(i + 1) % 3]}


def test_closed_meshes_know_the_two_sides_of_every_edge() -> None:
    for mesh in (sphere(), torus()):
        table = EdgeTable.of(mesh.triangles)
        assert table.edge_sides is not None
        assert np.all(np.diff(table.edge_sides, axis=1) > 0)
        np.testing.assert_array_equal(table.side_edges.ravel()[table.edge_sides], np.arange(len(table.edges))[:, None].repeat(2, axis=1))
        offsets, around = vertex_triangles(mesh.triangles, len(mesh.vertices))
        for vertex in (0, 17):
            assert around[offsets[vertex] : offsets[vertex + 1]].tolist() == np.flatnonzero((mesh.triangles == vertex).any(axis=1)).tolist()
    assert EdgeTable.of(sphere().triangles[1:]).edge_sides is None


def test_vector_products_of_rows() -> None:
    a, b = np.random.default_rng(0).normal(size=(2, 50, 3))
    np.testing.assert_allclose(row_cross(a, b), np.cross(a, b), atol=1e-15)
