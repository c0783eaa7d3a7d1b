"""Folds and self-intersections: found, and smoothed away where they are.

They arise in slits narrower than a few spacings, where both walls pull at the same triangles.  Only the places themselves
are touched: there the umbrella operator takes over from the points until the surface is simple again.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.remeshing import flip_edges
from scanner_core.geometry.self_intersection import self_intersecting_triangles
from scanner_core.geometry.smoothing import uniform_averaging

Indices = NDArray[np.int64]

_FOLD_COSINE = -0.3
"""Two neighbouring triangles that turn by more than this (107 degrees) are a fold; a sharp rim turns by 90."""


def folded_triangles(mesh: TriangleMesh) -> Indices:
    """Triangles at an edge where the surface turns back onto itself, (m,)."""
    table = EdgeTable.of(mesh.triangles)
    assert table.edge_sides is not None
    normals = mesh.area_vectors()
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-30)[:, None]
    pairs = table.edge_sides // 3
    turned = (normals[pairs[:, 0]] * normals[pairs[:, 1]]).sum(axis=1) < _FOLD_COSINE
    return np.unique(pairs[turned])


def unfold(mesh: TriangleMesh, rounds: int = 12) -> TriangleMesh:
    """Smooth the surroundings of folds until there is none."""
    return _smooth_where(mesh, folded_triangles, rounds, lambda: None)


def without_self_intersections(mesh: TriangleMesh, check: Callable[[], None], rounds: int = 25) -> TriangleMesh:
    """Smooth the surroundings of self-intersections until there is none, or `rounds` have passed."""
    return _smooth_where(mesh, self_intersecting_triangles, rounds, check)


def _smooth_where(mesh: TriangleMesh, find: Callable[[TriangleMesh], Indices], rounds: int, check: Callable[[], None]) -> TriangleMesh:
    ever = np.zeros(len(mesh.vertices), bool)
    for tick in range(rounds):
        check()
        bad = find(mesh)
        if not len(bad):
            break
        check()
        averaging = uniform_averaging(mesh)
        ever[mesh.triangles[bad].ravel()] = True
        share = ever.astype(np.float64)
        for _ in range(1 + tick // 3):  # the longer it takes, the wider the surroundings
            share = np.maximum(share, averaging @ share * 0.999)
            share[share > 0.1] = 1.0
        moving = np.flatnonzero(share > 0.1)
        rows = averaging[moving]
        vertices = mesh.vertices.copy()
        for _ in range(4):
            vertices[moving] = 0.5 * (vertices[moving] + rows @ vertices)
        mesh = flip_edges(TriangleMesh(vertices, mesh.triangles))
    return mesh
