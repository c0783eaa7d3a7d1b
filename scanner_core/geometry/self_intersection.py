"""Triangles of a mesh that cross other triangles of the same mesh.

Pairs come from a tree of boxes; each pair is decided by the interval test of Moller ("A fast triangle-triangle
intersection test", Journal of Graphics Tools 2(2), 1997), for all pairs at once.  What two neighbours share by being
neighbours (a vertex, an edge) is no intersection; a fold of one onto the other is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.box_tree import BoxTree
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.weld import weld

Array = NDArray[np.float64]

ON_PLANE = 1e-9
"""A vertex this close to a plane lies on it, in parts of the longest edge of the pair."""
SHORTEST_CUT = 1e-6
"""A common segment (or overlap) shorter than this is a touch, in parts of the longest edge of the pair."""
THINNEST = 1e-7
"""Triangles with less height over their longest edge have no usable normal; they count as degenerate, not here."""
_AT_ONCE = 200_000


def self_intersecting_triangles(mesh: TriangleMesh) -> NDArray[np.int64]:
    """Indices of the triangles that intersect another one, rising, (m,)."""
    return np.unique(self_intersection_pairs(mesh))


def self_intersection_pairs(mesh: TriangleMesh) -> NDArray[np.int64]:
    """Pairs of triangles that intersect in more than what they share as neighbours, (k, 2).

    Vertices with equal coordinates count as shared.  Pairs that only touch (the common part is shorter than
    ``SHORTEST_CUT`` of their longest edge) do not intersect; coplanar pairs do when their areas overlap.
    """
    if len(mesh.triangles) < 2:
        return np.empty((0, 2), np.int64)
    _, joined = weld(mesh.vertices)
    faces = joined[mesh.triangles]
    corners = mesh.vertices[mesh.triangles]
    edges = corners - np.roll(corners, 1, axis=1)
    size = np.sqrt(np.einsum("fij,fij->fi", edges, edges).max(axis=1))
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.sqrt(np.einsum("ij,ij->i", normal, normal))
    usable = np.flatnonzero(length > THINNEST * size * size)
    normal[usable] /= length[usable, None]
    a, b, c = (corners[usable, i] for i in range(3))
    pairs = usable[BoxTree(np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)).overlapping_pairs()]
    found = [np.empty((0, 2), np.int64)]
    for begin in range(0, len(pairs), _AT_ONCE):
        part = pairs[begin : begin + _AT_ONCE]
        shared = _shared_corners(faces[part[:, 0]], faces[part[:, 1]])
        count = np.count_nonzero(shared[:, :, 0] | shared[:, :, 1] | shared[:, :, 2], axis=1)
        cut = count == 3
        apart = count <= 1
        cut[apart] = _intersect(corners, normal, size, part[apart])
        edge = count == 2
        cut[edge] = _folded(corners, normal, size, part[edge], shared[edge])
        found.append(part[cut])
    return np.concatenate(found)


def _shared_corners(a: NDArray[np.int64], b: NDArray[np.int64]) -> NDArray[np.bool_]:
    """(k, 3, 3): corner i of one triangle is corner j of the other."""
    return np.asarray(a[:, :, None] == b[:, None, :], np.bool_)


def _folded(corners: Array, normal: Array, size: Array, pairs: NDArray[np.int64], shared: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Neighbours over an edge overlap when they lie in one plane and on the same side of that edge."""
    one, other = pairs.T
    row = np.arange(len(pairs))
    free_one = np.argmin(shared.any(axis=2), axis=1)
    free_other = np.argmin(shared.any(axis=1), axis=1)
    start, end = corners[one, (free_one + 1) % 3], corners[one, (free_one + 2) % 3]
    apex = corners[other, free_other] - start
    reach = np.maximum(size[one], size[other])
    flat = np.abs(_dot(apex, normal[one])) <= ON_PLANE * reach
    inward = np.cross(normal[one], end - start)  # in the plane of the first triangle, towards its free corner
    same_side = _dot(apex, inward) * _dot(corners[one, free_one] - start, inward) > 0
    return np.asarray(flat[row] & same_side, np.bool_)


def _intersect(corners: Array, normal: Array, size: Array, pairs: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Moller's test for pairs (k, 2) that share at most one vertex."""
    result = np.zeros(len(pairs), np.bool_)
    one, other = pairs.T
    reach = np.maximum(size[one], size[other])
    place = corners[one, 0]  # distances from a corner of the pair: no digits are lost on large coordinates
    second = corners[other] - place[:, None]
    over_one = _snapped(np.einsum("kij,kj->ki", second, normal[one]), reach)
    left = np.flatnonzero(_straddles(over_one))
    one, other, reach, place, second, over_one = one[left], other[left], reach[left], place[left], second[left], over_one[left]
    first = corners[one] - place[:, None]
    over_other = _snapped(np.einsum("kij,kj->ki", first - second[:, :1], normal[other]), reach)
    keep = np.flatnonzero(_straddles(over_other))
    left, one, other, reach = left[keep], one[keep], other[keep], reach[keep]
    first, second, over_one, over_other = first[keep], second[keep], over_one[keep], over_other[keep]

    flat = (over_one == 0).all(axis=1) | (over_other == 0).all(axis=1)
    result[left[flat]] = _overlap_in_plane(first[flat], second[flat], normal[one[flat]], reach[flat])
    steep = ~flat
    first, second, over_one, over_other, reach = first[steep], second[steep], over_one[steep], over_other[steep], reach[steep]
    line = np.cross(normal[one[steep]], normal[other[steep]])
    line /= np.maximum(np.linalg.norm(line, axis=1), 1e-300)[:, None]
    from_one, to_one = _interval(np.einsum("kij,kj->ki", first, line), over_other)
    from_other, to_other = _interval(np.einsum("kij,kj->ki", second, line), over_one)
    common = np.minimum(to_one, to_other) - np.maximum(from_one, from_other)
    result[left[steep]] = common > SHORTEST_CUT * reach
    return result


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b), np.float64)


def _snapped(distance: Array, reach: Array) -> Array:
    return np.where(np.abs(distance) <= ON_PLANE * reach[:, None], 0.0, distance)


def _straddles(distance: Array) -> NDArray[np.bool_]:
    """Whether more than one point of a triangle lies on the plane: corners on both sides, or two on it.

    This drops nearly all neighbours over a vertex at once.
    """
    a, b, c = distance.T
    both = (np.minimum(np.minimum(a, b), c) < 0) & (np.maximum(np.maximum(a, b), c) > 0)
    return np.asarray(both | ((a == 0).view(np.int8) + (b == 0).view(np.int8) + (c == 0).view(np.int8) >= 2), np.bool_)


def _interval(along: Array, distance: Array) -> tuple[Array, Array]:
    """Where triangles meet a line in their plane: from, to (k,).

    `along` (k, 3) are the corners' places along the line, `distance` (k, 3) their signed distances from it in the sense
    that a corner with 0 lies on the line.
    """
    low = np.full(len(along), np.inf)
    high = np.full(len(along), -np.inf)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        start, end = distance[:, i], distance[:, j]
        crosses = start * end < 0
        part = np.divide(start, start - end, out=np.zeros_like(start), where=crosses)
        at = along[:, i] + part * (along[:, j] - along[:, i])
        for place, there in ((at, crosses), (along[:, i], start == 0)):
            low = np.where(there, np.minimum(low, place), low)
            high = np.where(there, np.maximum(high, place), high)
    return low, high


def _overlap_in_plane(first: Array, second: Array, normal: Array, reach: Array) -> NDArray[np.bool_]:
    """Whether coplanar triangles (k, 3, 3) overlap: no edge's normal separates them."""
    result = np.ones(len(first), np.bool_)
    for triangle in (first, second):
        for i in range(3):
            edge = triangle[:, (i + 1) % 3] - triangle[:, i]
            axis = np.cross(normal, edge)
            axis /= np.maximum(np.linalg.norm(axis, axis=1), 1e-300)[:, None]
            a = np.einsum("kij,kj->ki", first, axis)
            b = np.einsum("kij,kj->ki", second, axis)
            common = np.minimum(a.max(axis=1), b.max(axis=1)) - np.maximum(a.min(axis=1), b.min(axis=1))
            result &= common > SHORTEST_CUT * reach
    return result
