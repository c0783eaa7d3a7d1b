"""Triangles of a mesh that cross other triangles of the same mesh.

Pairs come from spheres round the triangles (or, where sizes differ widely, from a tree of boxes); each pair is decided by
the interval test of Moller ("A fast triangle-triangle intersection test", Journal of Graphics Tools 2(2), 1997), for all
pairs at once.  What two neighbours share by being neighbours (a vertex, an edge) is no intersection; a fold of one onto the
other is.  Nearly all pairs of a good mesh are neighbours in a smooth place, and those are let go before any geometry: the
triangles round a vertex whose normals lie in one cone, and that go round it once, are a graph over the plane across the
cone (Volino and Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized surface animations using
geometrical shape regularity", Eurographics 1994).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.box_tree import BoxTree
from scanner_core.geometry.edges import row_cross
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
_CONE = 0.2
"""Least cosine between a triangle at a smooth vertex and the mean of those triangles; far from 0, so that rounding cannot matter."""
_WELL_SHAPED = 1e-2
"""Least height over the longest edge of the triangles at a smooth vertex, for the same reason."""
_MOST_PAIRS = 60
"""Pairs of spheres for each triangle from which on a tree of boxes is cheaper."""


def self_intersecting_triangles(mesh: TriangleMesh) -> NDArray[np.int64]:
    """Indices of the triangles that intersect another one, rising, (m,)."""
    return np.unique(self_intersection_pairs(mesh))


class IntersectionWatch:
    """Looks for intersections of the few triangles of a mesh that change, again and again.

    The answers are those that the pairs of the whole mesh would give; what never changes is sorted only once.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        low, high = _boxes(mesh, np.arange(len(mesh.triangles)))
        self._half = 0.5 * (high - low).max(axis=1)
        self._middle = 0.5 * (low + high)
        self._tree = cKDTree(self._middle, balanced_tree=False)
        self._changed = np.zeros(len(mesh.triangles), np.bool_)

    def among(self, mesh: TriangleMesh, some: NDArray[np.int64]) -> NDArray[np.int64]:
        """Indices of the triangles that take part in an intersection with one of `some`, rising, (m,).

        `mesh` has the triangles of the first mesh, but for those that were among `some` in this call or in an earlier one.
        """
        if len(some) == 0:
            return np.empty(0, np.int64)
        self._changed[some] = True
        low, high = _boxes(mesh, some)
        # In the largest coordinate, boxes that overlap have their middles within the sum of their half sizes.
        middle, half = 0.5 * (low + high), 0.5 * (high - low).max(axis=1)
        hits = self._tree.query_ball_point(middle, (half + self._half.max()) * (1 + 1e-6), p=np.inf)
        one = np.repeat(np.arange(len(some)), [len(hit) for hit in hits])
        other = np.concatenate([np.asarray(hit, np.int64) for hit in hits])
        away = np.abs(middle[one] - self._middle[other]).max(axis=1)
        near = self._changed.copy()
        near[other[away <= (half[one] + self._half[other]) * (1 + 1e-6)]] = True
        members = np.flatnonzero(near)
        used, triangles = np.unique(mesh.triangles[members], return_inverse=True)
        pairs = members[self_intersection_pairs(TriangleMesh(mesh.vertices[used], triangles.reshape(-1, 3)))]
        chosen = np.zeros(len(mesh.triangles), np.bool_)
        chosen[some] = True
        return np.unique(pairs[chosen[pairs].any(axis=1)])


def _boxes(mesh: TriangleMesh, some: NDArray[np.int64]) -> tuple[Array, Array]:
    a, b, c = (np.take(mesh.vertices, column, axis=0) for column in np.take(mesh.triangles, some, axis=0).T)
    return np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)


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
    a, b, c = (np.ascontiguousarray(corners[:, i]) for i in range(3))
    squares = np.stack([_dot(x, x) for x in (b - a, c - b, a - c)])
    size = np.sqrt(squares.max(axis=0))
    normal = row_cross(b - a, c - a)
    length = np.sqrt(_dot(normal, normal))
    usable = np.flatnonzero(length > THINNEST * size * size)
    normal[usable] /= length[usable, None]
    smooth = _smooth_vertices(mesh.vertices, faces, normal, length > _WELL_SHAPED * size * size)
    low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
    near = [np.empty((0, 2), np.int64)]
    # What a corner is compared by: the vertex where it is smooth, nothing else in the mesh where it is not.
    names = np.where(smooth[faces], faces, -1 - np.arange(faces.size).reshape(faces.shape)).T
    names = np.ascontiguousarray(names, np.int32 if faces.size < 1 << 31 else np.int64)
    for pairs in _candidates(corners, squares, low, high, usable):
        part = np.sort(pairs[~_share(names, pairs)], axis=1)
        one, other = part.T
        near.append(part[((low[one] <= high[other]) & (low[other] <= high[one])).all(axis=1)])
    left = np.concatenate(near)
    parts = (left[begin : begin + _AT_ONCE] for begin in range(0, max(len(left), 1), _AT_ONCE))
    return np.concatenate([_cut(corners, faces, normal, size, part) for part in parts])


def _cut(corners: Array, faces: NDArray[np.int64], normal: Array, size: Array, pairs: NDArray[np.int64]) -> NDArray[np.int64]:
    """Those of the pairs (k, 2) that intersect."""
    shared = _shared_corners(faces[pairs[:, 0]], faces[pairs[:, 1]])
    count = np.count_nonzero(shared[:, :, 0] | shared[:, :, 1] | shared[:, :, 2], axis=1)
    cut = count == 3
    apart = count <= 1
    cut[apart] = _intersect(corners, normal, size, pairs[apart])
    edge = count == 2
    cut[edge] = _folded(corners, normal, size, pairs[edge], shared[edge])
    return np.asarray(pairs[cut], np.int64)


def _smooth_vertices(vertices: Array, faces: NDArray[np.int64], normal: Array, shaped: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Vertices (v,) whose triangles cannot intersect one another.

    All their normals lie in one cone, so that each triangle keeps its orientation when the fan is seen along the axis of
    that cone; the fan is closed; and it goes round once: then the triangles share nothing but the vertex and their edges.
    """
    count = len(vertices)
    corner = faces.ravel()
    axis: Array = np.stack([np.bincount(corner, np.repeat(normal[:, i], 3), minlength=count) for i in range(3)], axis=1)
    axis /= np.maximum(np.sqrt(_dot(axis, axis)), 1e-300)[:, None]
    outside = np.stack([_dot(normal, axis[faces[:, i]]) for i in range(3)], axis=1) < _CONE
    outside |= ~shaped[:, None]
    bad = np.bincount(corner[outside.ravel()], minlength=count)
    # Closed: every neighbour is entered as often as it is left.  Sums of random 40-bit numbers are exact in float64.
    tag = np.random.default_rng(0).integers(0, 1 << 40, count).astype(np.float64)
    # Once round: seen along the axis, one triangle only passes the ray across `side`, from its right to its left.
    side = np.zeros((count, 3))
    least = np.argmin(np.abs(axis), axis=1)
    side[np.arange(count), least] = 1.0
    side = row_cross(axis, side)
    height_of = _dot(vertices, side)
    balance, turns = np.zeros(count), np.zeros(count)
    for i in range(3):
        here, ahead, behind = faces[:, i], faces[:, (i + 1) % 3], faces[:, (i + 2) % 3]
        across = side[here]
        level = height_of[here]
        passes = (_dot(vertices[ahead], across) < level) & (_dot(vertices[behind], across) >= level)
        balance += np.bincount(here, tag[ahead] - tag[behind], minlength=count)
        turns += np.bincount(here[passes], minlength=count)
    return np.asarray((bad == 0) & (balance == 0) & (turns == 1), np.bool_)


def _share(names: NDArray[np.int32] | NDArray[np.int64], pairs: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which pairs (k, 2) have a corner of the same name; `names` (3, t)."""
    first, second = ([np.take(column, side) for column in names] for side in pairs.T)
    share = np.zeros(len(pairs), np.bool_)
    for x in first:
        for y in second:
            share |= x == y
    return share


def _candidates(corners: Array, squares: Array, low: Array, high: Array, usable: NDArray[np.int64]) -> Iterator[NDArray[np.int64]]:
    """Batches (k, 2) of pairs of usable triangles that hold all pairs whose boxes and whose spheres overlap.

    `squares` (3, t) are the squared sides, from corner to next corner; `low`, `high` (t, 3) the boxes.  Triangles are sorted into classes of similar
    spheres, so that one search radius fits all pairs of two classes.
    """
    middle, radius = _spheres(corners[usable], squares[:, usable])
    octave = np.ceil(2 * np.log2(np.maximum(radius, 1e-150))).astype(np.int64)
    # A mesh of similar triangles has few classes; classes with few members join the next larger one.
    names, sizes = np.unique(octave, return_counts=True)
    classes: list[tuple[NDArray[np.int64], cKDTree, float]] = []
    waiting: list[np.int64] = []
    held = 0
    for name, number in zip(names, sizes, strict=True):
        waiting.append(name)
        held += int(number)
        if held >= 0.02 * len(usable) or name == names[-1]:
            members = np.flatnonzero((octave >= waiting[0]) & (octave <= name))
            classes.append((members, cKDTree(middle[members], balanced_tree=False, compact_nodes=False), float(radius[members].max())))
            waiting, held = [], 0
    budget = _MOST_PAIRS * len(usable)
    steps = [(i, j) for i in range(len(classes)) for j in range(i, len(classes))]
    for i, j in steps:
        reach = (classes[i][2] + classes[j][2]) * (1 + 1e-6)
        budget -= _estimated_pairs(classes[i][1], classes[j][1], reach)
        if budget < 0:
            yield usable[BoxTree(low[usable], high[usable]).overlapping_pairs()]
            return
    for i, j in steps:
        (ours, tree, _), (theirs, other, _) = classes[i], classes[j]
        reach = (classes[i][2] + classes[j][2]) * (1 + 1e-6)
        if i == j:
            near = tree.query_pairs(reach, output_type="ndarray")
            one, two = ours[near[:, 0]], ours[near[:, 1]]
        else:
            found = tree.sparse_distance_matrix(other, reach, output_type="ndarray")
            one, two = ours[found["i"]], theirs[found["j"]]
        yield np.stack([usable[one], usable[two]], axis=1)


def _estimated_pairs(one: cKDTree, other: cKDTree, reach: float) -> int:
    """About how many pairs are within `reach`, from at most some 500 members of the larger tree: counting all takes as long as finding them."""
    if one.n < other.n:
        one, other = other, one
    every = 1 + one.n // 500
    return int(every * cKDTree(one.data[::every]).count_neighbors(other, reach))


def _spheres(corners: Array, squares: Array) -> tuple[Array, Array]:
    """Middles (t, 3) and radii (t,) of small spheres that hold the triangles (t, 3, 3): about the longest side if that is enough.

    `squares` (3, t) are the squared sides, from corner to next corner.
    """
    turn = np.argmax(squares, axis=0)
    flat = corners.reshape(-1, 3)
    row = 3 * np.arange(len(corners))
    start, end, tip = (np.take(flat, row + (turn + i) % 3, axis=0) for i in range(3))
    middle = 0.5 * (start + end)
    u, w = end - start, tip - start
    uu, ww, uw = _dot(u, u), _dot(w, w), _dot(u, w)
    acute = np.flatnonzero(ww > uw)  # the sphere over the longest side leaves the tip out where (tip - start) . (tip - end) > 0
    uu_, ww_, uw_ = uu[acute], ww[acute], uw[acute]
    scale = 0.5 / np.maximum(uu_ * ww_ - uw_ * uw_, 1e-300)
    centre = start[acute] + (ww_ * (uu_ - uw_) * scale)[:, None] * u[acute] + (uu_ * (ww_ - uw_) * scale)[:, None] * w[acute]
    middle[acute] = centre
    away = np.maximum(np.maximum(*(_dot(middle - x, middle - x) for x in (start, end))), _dot(middle - tip, middle - tip))
    return middle, np.sqrt(away)


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
