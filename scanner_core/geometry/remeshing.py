"""Local changes of a closed mesh's connectivity: split, collapse, flip, relax.

Every function returns a mesh that is closed and 2-manifold, with the genus of the mesh it was given.  All changes of
one call are made at once on an independent set, so that they are array operations; a caller repeats the call.
Botsch and Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable, adjacency, row_dot, valences
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import split_edges

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


def edge_targets(table: EdgeTable, sizes_mm: Array | float) -> Array:
    """The wanted length of every edge, (e,), from a length for all or from one at each vertex."""
    if np.ndim(sizes_mm) == 0:
        return np.full(len(table.edges), float(sizes_mm))
    sizes = np.asarray(sizes_mm)
    return np.asarray(np.minimum(sizes[table.edges[:, 0]], sizes[table.edges[:, 1]]))


def split_long(mesh: TriangleMesh, longest_mm: Array | float, table: EdgeTable | None = None) -> TriangleMesh:
    """Split the edges that are longer than `longest_mm`, a length or one for each vertex; `table` as far as it is known."""
    table = table or EdgeTable.of(mesh.triangles)
    marked = table.lengths(mesh.vertices) > edge_targets(table, longest_mm)
    return split_edges(mesh, table, marked) if np.any(marked) else mesh


def collapse_short(
    mesh: TriangleMesh, shortest_mm: Array | float, *, keep: Mask | None = None, table: EdgeTable | None = None
) -> tuple[TriangleMesh, NDArray[np.int64]]:
    """Collapse edges shorter than `shortest_mm` into their middles.

    Returns the mesh and (v,) int64: for each new vertex, the old one it continues.  Vertices of `keep` stay.
    """
    table = table or EdgeTable.of(mesh.triangles)
    lengths = table.lengths(mesh.vertices)
    ratio = lengths / edge_targets(table, shortest_mm)
    wanted = ratio < 1
    if keep is not None:
        wanted &= ~(keep[table.edges[:, 0]] | keep[table.edges[:, 1]])
    return collapse_edges(mesh, table, wanted, ratio)


def collapse_edges(
    mesh: TriangleMesh, table: EdgeTable, wanted: Mask, cost: Array, *, most: int | None = None
) -> tuple[TriangleMesh, NDArray[np.int64]]:
    """Collapse an independent set of the wanted edges, cheapest first, at most `most` of them.

    An edge is collapsed only if its ends have exactly two common neighbours (the link condition, so that the surface
    stays a manifold of the same genus), if no triangle turns over, and if no edge at the new vertex gets longer than
    the two old one-rings.  Each collapse removes one vertex and two triangles.
    Returns the mesh and, for each new vertex, the old one it continues, (v,).
    """
    v, t = mesh.vertices, mesh.triangles
    unchanged = mesh, np.arange(len(v))
    chosen = np.flatnonzero(wanted)
    if not len(chosen):
        return unchanged
    chosen = chosen[np.argsort(cost[chosen], kind="stable")]
    joined = adjacency(table.edges, len(v))
    a, b = table.edges[chosen].T
    common = joined[a].multiply(joined[b]).sum(axis=1)
    chosen = chosen[np.asarray(common).ravel() == 2]
    chosen = chosen[_independent(table.edges[chosen], t, len(v))]
    if most is not None:
        chosen = chosen[:most]
    a, b = table.edges[chosen].T
    middle = 0.5 * (v[a] + v[b])
    moved = v.copy()
    moved[a], moved[b] = middle, middle
    collapse_of = np.full(len(v), -1, np.int64)
    collapse_of[a] = collapse_of[b] = np.arange(len(chosen))
    refused = _turned_over(v, moved, t, collapse_of, len(chosen))
    chosen, a, b, middle = chosen[~refused], a[~refused], b[~refused], middle[~refused]
    if not len(chosen):
        return unchanged
    target = np.arange(len(v))
    target[b] = a
    vertices = v.copy()
    vertices[a] = middle
    triangles = target[t]
    gone = (triangles[:, 0] == triangles[:, 1]) | (triangles[:, 1] == triangles[:, 2]) | (triangles[:, 2] == triangles[:, 0])
    stays = np.ones(len(v), bool)
    stays[b] = False
    number = np.cumsum(stays) - 1
    return TriangleMesh(vertices[stays], number[triangles[~gone]]), np.flatnonzero(stays)


def _independent(edges: NDArray[np.int64], triangles: NDArray[np.int64], vertices: int) -> Mask:
    """Of edges in order of preference, those that share no triangle of their one-rings with a preferred one."""
    rank = np.arange(len(edges))
    best_at_vertex = np.full(vertices, len(edges))
    for end in (0, 1):
        np.minimum.at(best_at_vertex, edges[:, end], rank)
    best_of_triangle = best_at_vertex[triangles].min(axis=1)
    for corner in range(3):
        np.minimum.at(best_at_vertex, triangles[:, corner], best_of_triangle)
    return np.asarray((best_at_vertex[edges[:, 0]] == rank) & (best_at_vertex[edges[:, 1]] == rank))


def _turned_over(before: Array, after: Array, triangles: NDArray[np.int64], collapse_of: NDArray[np.int64], collapses: int) -> Mask:
    """Which collapses turn a triangle by more than about 70 degrees or flatten it to a sliver."""
    which = collapse_of[triangles].max(axis=1)
    touched = triangles[which >= 0]
    which = which[which >= 0]
    first, second, third = (collapse_of[touched[:, i]] for i in range(3))
    vanishes = ((first >= 0) & ((first == second) | (first == third))) | ((second >= 0) & (second == third))
    touched, which = touched[~vanishes], which[~vanishes]
    old, new = (np.cross(p[touched[:, 1]] - p[touched[:, 0]], p[touched[:, 2]] - p[touched[:, 0]]) for p in (before, after))
    size_old, size_new = np.sqrt(row_dot(old, old)), np.sqrt(row_dot(new, new))
    sides = sum(((after[touched[:, i]] - after[touched[:, i - 1]]) ** 2).sum(axis=1) for i in range(3))
    bad = row_dot(old, new) < 0.35 * size_old * size_new
    bad |= 2 * np.sqrt(3) * size_new < 0.1 * sides
    return np.asarray(np.bincount(which[bad], minlength=collapses) > 0)


def flip_edges(mesh: TriangleMesh, *, passes: int = 1, crease_cosine: float = 0.6, table: EdgeTable | None = None) -> TriangleMesh:
    """Flip edges whose two opposite angles exceed 180 degrees together (towards an intrinsic Delaunay mesh).

    Flips across a crease (cosine of the dihedral angle below `crease_cosine`), flips that turn a triangle over and
    flips that would leave a vertex with less than three edges are not made.
    """
    for _ in range(passes):
        flipped = _flip_once(mesh, crease_cosine, table)
        if flipped is None:
            break
        mesh, table = flipped, None
    return mesh


def _flip_once(mesh: TriangleMesh, crease_cosine: float, table: EdgeTable | None) -> TriangleMesh | None:
    v, t = mesh.vertices, mesh.triangles
    table = table or EdgeTable.of(t)
    assert table.edge_sides is not None
    triangle, corner = np.divmod(table.edge_sides, 3)
    cotangents = _side_cotangents(v, t)
    delaunay = cotangents[triangle[:, 0], corner[:, 0]] + cotangents[triangle[:, 1], corner[:, 1]]
    chosen = np.flatnonzero(delaunay < -1e-3)
    if not len(chosen):
        return None
    # triangle (a, b, c) and (b, a, d) become (c, d, b) and (d, c, a)
    one, other = triangle[chosen].T
    a, b = t[one, corner[chosen, 0]], t[one, (corner[chosen, 0] + 1) % 3]
    c, d = t[one, (corner[chosen, 0] + 2) % 3], t[other, (corner[chosen, 1] + 2) % 3]
    valence = valences(table.edges, len(v))
    old_one, old_other = np.cross(v[b] - v[a], v[c] - v[a]), np.cross(v[a] - v[b], v[d] - v[b])
    new_one, new_other = np.cross(v[d] - v[c], v[b] - v[c]), np.cross(v[c] - v[d], v[a] - v[d])
    mean = old_one + old_other
    ok = row_dot(old_one, old_other) > crease_cosine * np.sqrt(row_dot(old_one, old_one)) * np.sqrt(row_dot(old_other, old_other))
    for new in (new_one, new_other):
        ok &= row_dot(new, mean) > 0.5 * np.sqrt(row_dot(new, new)) * np.sqrt(row_dot(mean, mean))
    ok &= (valence[a] > 3) & (valence[b] > 3) & (c != d)
    count = len(v)
    key = np.minimum(c, d) * count + np.maximum(c, d)
    present = table.edges[:, 0] * count + table.edges[:, 1]
    place = np.minimum(np.searchsorted(present, key), len(present) - 1)
    ok &= present[place] != key
    chosen, order = chosen[ok], np.argsort(delaunay[chosen[ok]], kind="stable")
    one, other, a, b, c, d = (x[ok][order] for x in (one, other, a, b, c, d))
    rank = np.arange(len(order))
    best = np.full(count, len(order))
    for corner_vertices in (a, b, c, d):
        np.minimum.at(best, corner_vertices, rank)
    free = (best[a] == rank) & (best[b] == rank) & (best[c] == rank) & (best[d] == rank)
    if not np.any(free):
        return None
    triangles = t.copy()
    triangles[one[free]] = np.stack([c[free], d[free], b[free]], axis=1)
    triangles[other[free]] = np.stack([d[free], c[free], a[free]], axis=1)
    return TriangleMesh(v, triangles)


def _side_cotangents(vertices: Array, triangles: NDArray[np.int64]) -> Array:
    """Cotangent of the angle that faces each side of every triangle, (t, 3)."""
    p = vertices[triangles]
    to_next = p[:, (1, 2, 0)] - p
    double_area = np.maximum(np.linalg.norm(np.cross(to_next[:, 0], -to_next[:, 2]), axis=1), 1e-30)
    # the angle that faces side i lies at corner i + 2, between sides i + 2 (leaving) and i + 1 (arriving)
    return np.stack([-row_dot(to_next[:, (i + 2) % 3], to_next[:, (i + 1) % 3]) / double_area for i in range(3)], axis=1)


def relax(mesh: TriangleMesh, *, step: float = 0.5, normals: Array | None = None, table: EdgeTable | None = None) -> TriangleMesh:
    """Move every vertex towards the middle of its neighbours, within its tangent plane only."""
    table = table or EdgeTable.of(mesh.triangles)
    joined = adjacency(table.edges, len(mesh.vertices))
    middle = (joined @ mesh.vertices) / np.maximum(joined.sum(axis=1), 1)[:, None]
    n = mesh.vertex_normals() if normals is None else normals
    shift = middle - mesh.vertices
    shift -= row_dot(shift, n)[:, None] * n
    return TriangleMesh(mesh.vertices + step * shift, mesh.triangles)
