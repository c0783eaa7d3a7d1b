"""Splitting triangles: all of them into four, or only those at chosen edges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable, row_dot
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]


def subdivide_uniform(mesh: TriangleMesh) -> TriangleMesh:
    """Every triangle into four at the middles of its edges; the surface does not move.

    The old vertices keep their indices; vertex attributes are not carried over.
    """
    table = EdgeTable.of(mesh.triangles)
    return split_edges(mesh, table, np.ones(len(table.edges), bool))


def split_edges(mesh: TriangleMesh, table: EdgeTable, marked: NDArray[np.bool_], places: Array | None = None) -> TriangleMesh:
    """Split the marked edges and re-triangulate their triangles into two, three or four.

    A closed mesh stays closed and gains two triangles for each marked edge.

    Parameters
    ----------
    table : the edges of `mesh`
    marked : (e,) bool
    places : (number of marked, 3) new vertices in mm; the middles of the edges if None
    """
    v, t = mesh.vertices, mesh.triangles
    chosen = table.edges[marked]
    if places is None:
        places = 0.5 * (v[chosen[:, 0]] + v[chosen[:, 1]])
    middle_of_edge = np.full(len(table.edges), -1, np.int64)
    middle_of_edge[marked] = len(v) + np.arange(len(chosen))
    middles = middle_of_edge[table.side_edges]
    split = middles >= 0
    count = split.sum(axis=1)
    vertices = np.concatenate([v, places])
    parts = [t[count == 0]]

    full = count == 3
    (a, b, c), (ab, bc, ca) = t[full].T, middles[full].T
    parts += _triangles((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))

    once = np.flatnonzero(count == 1)
    turn = np.argmax(split[once], axis=1)  # turn the triangle until the split side comes first
    a, b, c = (t[once, (turn + i) % 3] for i in range(3))
    ab = middles[once, turn]
    parts += _triangles((a, ab, c), (ab, b, c))

    twice = np.flatnonzero(count == 2)
    turn = (np.argmin(split[twice], axis=1) + 1) % 3  # the side that stays whole comes last
    a, b, c = (t[twice, (turn + i) % 3] for i in range(3))
    ab, bc = middles[twice, turn], middles[twice, (turn + 1) % 3]
    parts += _triangles((ab, b, bc))
    shorter = ((vertices[ab] - vertices[c]) ** 2).sum(axis=1) < ((vertices[a] - vertices[bc]) ** 2).sum(axis=1)
    one, other = shorter, ~shorter
    parts += _triangles((a[one], ab[one], c[one]), (ab[one], bc[one], c[one]))
    parts += _triangles((a[other], ab[other], bc[other]), (a[other], bc[other], c[other]))
    return TriangleMesh(vertices, np.concatenate(parts))


def _triangles(*corners: tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]) -> list[NDArray[np.int64]]:
    return [np.stack(three, axis=1) for three in corners]


def curved_middles(vertices: Array, normals: Array, edges: NDArray[np.int64]) -> Array:
    """Middles of edges, lifted onto the curved surface that the normals at the two ends describe, (e, 3).

    The middle of the cubic that leaves each end in its tangent plane, as in curved point-normal triangles
    (Vlachos et al. 2001): ``(a + b) / 2 + ((b - a) . n_b n_b - (b - a) . n_a n_a) / 8``.  The lift is at most a fifth of
    the edge.
    """
    a, b = (np.take(vertices, end, axis=0) for end in edges.T)
    normal_a, normal_b = (np.take(normals, end, axis=0) for end in edges.T)
    return np.asarray(0.5 * (a + b) + _lifts(b - a, normal_a, normal_b))


def _lifts(along: Array, normal_a: Array, normal_b: Array) -> Array:
    """From the straight to the curved middle of edges, (e, 3), from their vectors and the unit normals at their ends."""
    lift = row_dot(along, normal_b)[:, None] * normal_b
    lift -= row_dot(along, normal_a)[:, None] * normal_a
    lift *= 0.125
    size = np.sqrt(row_dot(lift, lift))
    bound = 0.2 * np.sqrt(row_dot(along, along))
    lift *= np.minimum(1, bound / np.maximum(size, 1e-30))[:, None]
    return lift


def side_lifts(mesh: TriangleMesh, normals: Array, table: EdgeTable | None = None) -> Array:
    """Height of the curved surface over the middle of each side of every triangle, along its normal, (t, 3), mm.

    Over the point with barycentric weights w the curved surface stands at ``sum over sides 4 w_i w_j lift``.
    `table` are the edges of the mesh, made if None.
    """
    table = EdgeTable.of(mesh.triangles) if table is None else table
    i, j = table.edges.T
    normal_i, normal_j = np.take(normals, i, axis=0), np.take(normals, j, axis=0)
    lift = _lifts(np.take(mesh.vertices, j, axis=0) - np.take(mesh.vertices, i, axis=0), normal_i, normal_j)
    mean = normal_i + normal_j
    height = row_dot(lift, mean) / np.maximum(np.sqrt(row_dot(mean, mean)), 1e-30)
    return np.asarray(np.take(height, table.side_edges))
