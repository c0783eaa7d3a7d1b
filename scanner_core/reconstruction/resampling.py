"""Local re-sampling: more triangles where they are wanted, fewer where there are too many."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.remeshing import collapse_edges, flip_edges, relax
from scanner_core.geometry.subdivision import curved_middles, split_edges

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

_CLEARLY = 0.6
"""Edges count as clearly among the longest above so much of the 99th percentile of their excess."""

_TOO_SHORT = 0.7
"""An edge below so much of its wanted length is collapsed; twice that is the length above which a split makes none too short."""

_MOST_ROUNDS = 40
"""A round collapses edges that share no neighbour, a few per cent of them."""


def split_towards(
    mesh: TriangleMesh, sizes: Array, values: Array, triangles: int, check: Callable[[], None], *, down_to: float = 0.0
) -> tuple[TriangleMesh, Array]:
    """Split the edges that are longest against their wanted length until there are so many triangles.

    Parameters
    ----------
    sizes : (v,) wanted edge lengths, up to a common factor
    values : (v, k) whatever is known of the vertices; new ones get the mean of the ends of their edge
    down_to : stop where no edge exceeds so much of the 90th percentile of the excess at the beginning; 0 to use the budget up

    Returns
    -------
    The mesh, on the curved surface that the vertex normals describe, and the values of its vertices.
    """
    state = np.column_stack([sizes, values])
    goal = triangles
    least = 0.0
    for turn in range(6):
        missing = (goal - len(mesh.triangles)) // 2
        if missing <= 0:
            break
        check()
        table = EdgeTable.of(mesh.triangles)
        excess = table.lengths(mesh.vertices) / (0.5 * (state[table.edges[:, 0], 0] + state[table.edges[:, 1], 0]))
        if turn == 0:
            least = down_to * float(np.quantile(excess, 0.9))
        # All edges at once is the uniform 1:4; otherwise only those that are clearly among the longest.
        enough = excess > _CLEARLY * float(np.quantile(excess, 0.99)) if missing < len(excess) else excess > 0
        if least > 0:
            enough = excess > least
        marked = np.zeros(len(excess), bool)
        marked[np.argsort(-excess, kind="stable")[:missing]] = True
        marked &= enough
        if not np.any(marked):
            break
        chosen = table.edges[marked]
        places = curved_middles(mesh.vertices, mesh.vertex_normals(), chosen)
        state = np.concatenate([state, 0.5 * (state[chosen[:, 0]] + state[chosen[:, 1]])])
        mesh = flip_edges(split_edges(mesh, table, marked, places), passes=2)
    return relax(mesh, step=0.3), state[:, 1:]


def coarsened(mesh: TriangleMesh, sizes_mm: Array, check: Callable[[], None]) -> tuple[TriangleMesh, Indices]:
    """Collapse edges that are much shorter than wanted at both ends (v,); also, for each vertex, the one that it continues."""
    kept = np.arange(len(mesh.vertices))
    for _ in range(_MOST_ROUNDS):
        check()
        table = EdgeTable.of(mesh.triangles)
        wanted = sizes_mm[kept]
        ratio = table.lengths(mesh.vertices) / np.minimum(wanted[table.edges[:, 0]], wanted[table.edges[:, 1]])
        if not np.any(ratio < _TOO_SHORT):
            break
        before = len(kept)
        mesh, continued = collapse_edges(mesh, table, ratio < _TOO_SHORT, ratio)
        kept = kept[continued]
        if len(kept) > 0.995 * before:  # what is left is hardly worth another round
            break
        mesh = flip_edges(mesh)
    return mesh, kept


def reduced(mesh: TriangleMesh, triangles: int, check: Callable[[], None], sizes: Array | None = None) -> tuple[TriangleMesh, Indices]:
    """Collapse the edges that are shortest against their wanted length (v,) until at most so many triangles are left.

    Also returns, for each vertex, the one that it continues.
    """
    kept = np.arange(len(mesh.vertices))
    for _ in range(200):
        check()
        excess = (len(mesh.triangles) - triangles + 1) // 2
        if excess <= 0:
            break
        table = EdgeTable.of(mesh.triangles)
        cost = table.lengths(mesh.vertices)
        if sizes is not None:
            cost = cost / (sizes[kept[table.edges[:, 0]]] + sizes[kept[table.edges[:, 1]]])
        mesh, continued = collapse_edges(mesh, table, np.ones(len(cost), bool), cost, most=excess)
        kept = kept[continued]
        mesh = flip_edges(mesh)
    return mesh, kept
