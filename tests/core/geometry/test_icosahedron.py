from __future__ import annotations

import numpy as np

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.icosahedron import icosahedron


def test_twelve_vertices_and_twenty_equal_outward_triangles() -> None:
    mesh = icosahedron((1.0, 2.0, 3.0), 5.0)
    assert mesh.vertices.shape == (12, 3)
    assert mesh.triangles.shape == (20, 3)
    np.testing.assert_allclose(np.linalg.norm(mesh.vertices - (1, 2, 3), axis=1), 5.0)
    table = EdgeTable.of(mesh.triangles)
    assert len(table.edges) == 30
    assert table.edge_sides is not None
    np.testing.assert_allclose(table.lengths(mesh.vertices), 5.0 / np.sin(2 * np.pi / 5))
    assert mesh.volume() > 0
