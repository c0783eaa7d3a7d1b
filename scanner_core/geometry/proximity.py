"""The closest point of a mesh: exactly, or quickly for points that lie near it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.edges import row_dot, vertex_triangles
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
_CHUNK = 200_000
"""Pairs of point and triangle that are looked at together; bounds the memory."""


@dataclass(frozen=True, slots=True, eq=False)
class Feet:
    """Closest points of a mesh.

    Attributes
    ----------
    points : (n, 3) float64, on the mesh, mm
    triangles : (n,) int64, the triangle that each lies in
    weights : (n, 3) float64, barycentric: ``points = sum_i weights[:, i] * corner_i``
    distances_mm : (n,) float64
    """

    points: Array
    triangles: NDArray[np.int64]
    weights: Array
    distances_mm: Array


def closest_in_triangles(points: Array, a: Array, b: Array, c: Array) -> tuple[Array, Array]:
    """Barycentric weights (n, 3) and squared distance (n,) of the closest point of triangle i to point i.

    Inside by the normal equations, otherwise the best of the three sides.
    """
    ab, ac, ap = b - a, c - a, points - a
    ab2, ac2, ab_ac = row_dot(ab, ab), row_dot(ac, ac), row_dot(ab, ac)
    p_ab, p_ac, p2 = row_dot(ap, ab), row_dot(ap, ac), row_dot(ap, ap)
    determinant = np.maximum(ab2 * ac2 - ab_ac**2, 1e-300)
    v = (ac2 * p_ab - ab_ac * p_ac) / determinant
    w = (ab2 * p_ac - ab_ac * p_ab) / determinant

    outside = np.flatnonzero((v < 0) | (w < 0) | (v + w > 1))
    if len(outside):
        ab2, ac2, ab_ac, q_ab, q_ac, q2 = (x[outside] for x in (ab2, ac2, ab_ac, p_ab, p_ac, p2))
        bc2 = np.maximum(ab2 + ac2 - 2 * ab_ac, 1e-300)
        on_ab = np.clip(q_ab / np.maximum(ab2, 1e-300), 0, 1)
        on_ac = np.clip(q_ac / np.maximum(ac2, 1e-300), 0, 1)
        on_bc = np.clip((q_ac - q_ab - ab_ac + ab2) / bc2, 0, 1)
        zero = np.zeros(len(outside))
        sides_v = np.stack([on_ab, zero, 1 - on_bc])
        sides_w = np.stack([zero, on_ac, on_bc])
        squared = q2 - 2 * (sides_v * q_ab + sides_w * q_ac) + sides_v**2 * ab2 + 2 * sides_v * sides_w * ab_ac + sides_w**2 * ac2
        best = np.argmin(squared, axis=0)
        column = np.arange(len(outside))
        v[outside], w[outside] = sides_v[best, column], sides_w[best, column]
    away = ap - v[:, None] * ab - w[:, None] * ac
    return np.stack([1 - v - w, v, w], axis=1), row_dot(away, away)


def closest_near(mesh: TriangleMesh, points: Array, tree: cKDTree | None = None) -> Feet:
    """Closest points within the one-ring of the nearest vertex, (n, 3) -> n feet.

    Exact for nearly all points within an edge of a well-shaped mesh, and several times faster than `closest_points`.
    """
    tree = cKDTree(mesh.vertices) if tree is None else tree
    nearest = tree.query(points)[1].astype(np.int64)
    offsets, around = vertex_triangles(mesh.triangles, len(mesh.vertices))
    best = _best_of(mesh, points, offsets[nearest], offsets[nearest + 1] - offsets[nearest], around)
    return _feet(mesh, points, *best)


def _best_of(
    mesh: TriangleMesh, points: Array, starts: NDArray[np.int64], counts: NDArray[np.int64], candidates: NDArray[np.int64]
) -> tuple[NDArray[np.int64], Array, Array]:
    """For each point the best of its candidates ``candidates[start : start + count]``: triangle, weights, squared distance."""
    a, b, c = mesh.corners()
    triangle = np.zeros(len(points), np.int64)
    weights = np.zeros((len(points), 3))
    squared = np.zeros(len(points))
    step = max(1, _CHUNK // max(1, int(counts.max()) if len(counts) else 1))
    for low in range(0, len(points), step):
        part = slice(low, min(low + step, len(points)))
        number = counts[part]
        begins = np.concatenate([[0], np.cumsum(number)[:-1]])
        owner = np.repeat(np.arange(len(number)), number)
        tried = candidates[np.repeat(starts[part] - begins, number) + np.arange(len(owner))]
        found, distance = closest_in_triangles(points[part][owner], a[tried], b[tried], c[tried])
        least = np.minimum.reduceat(distance, begins)
        hits = np.flatnonzero(distance <= least[owner])
        first = hits[np.concatenate([[True], owner[hits][1:] != owner[hits][:-1]])]
        triangle[part], weights[part], squared[part] = tried[first], found[first], distance[first]
    return triangle, weights, squared


def _feet(mesh: TriangleMesh, points: Array, triangle: NDArray[np.int64], weights: Array, squared: Array) -> Feet:
    foot = np.einsum("nc,ncd->nd", weights, mesh.vertices[mesh.triangles[triangle]])
    return Feet(foot, triangle, weights, np.sqrt(np.maximum(squared, 0)))


def closest_points(mesh: TriangleMesh, points: Array) -> Feet:
    """The exact closest points of any mesh to any points, (n, 3).

    Triangles are sorted into classes of similar size, each with a tree of its centroids.  A triangle can only be closer
    than a known distance d if its centroid is closer than d plus its radius, so a search with that bound misses nothing.
    """
    quick = closest_near(mesh, points)
    centroids = mesh.vertices[mesh.triangles].mean(axis=1)
    radius = np.sqrt(((mesh.vertices[mesh.triangles] - centroids[:, None]) ** 2).sum(axis=2).max(axis=1))
    octave = np.ceil(np.log2(np.maximum(radius, 1e-12))).astype(np.int64)
    triangle, weights, distance = quick.triangles.copy(), quick.weights.copy(), quick.distances_mm.copy()
    for size in np.unique(octave):
        members = np.flatnonzero(octave == size)
        tree = cKDTree(centroids[members])
        reach = float(radius[members].max())
        _search_class(mesh, points, members, tree, reach, triangle, weights, distance)
    return _feet(mesh, points, triangle, weights, distance**2)


def _search_class(
    mesh: TriangleMesh,
    points: Array,
    members: NDArray[np.int64],
    tree: cKDTree,
    reach_mm: float,
    triangle: NDArray[np.int64],
    weights: Array,
    distance: Array,
) -> None:
    """Improve triangle, weights and distance (mm) of the points with the triangles of one class, in place."""
    waiting = np.arange(len(points))
    neighbours = min(8, len(members))
    while len(waiting):
        away, which = tree.query(points[waiting], k=neighbours)
        away, which = away.reshape(len(waiting), -1), which.reshape(len(waiting), -1)
        useful = away < distance[waiting, None] + reach_mm
        some = np.flatnonzero(useful.any(axis=1))
        if len(some):
            counts = useful[some].sum(axis=1).astype(np.int64)
            starts = np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.int64)
            candidates = members[which[some][useful[some]]]
            rows = waiting[some]
            found, found_weights, squared = _best_of(mesh, points[rows], starts, counts, candidates)
            found_distance = np.sqrt(np.maximum(squared, 0))
            better = found_distance < distance[rows]
            rows = rows[better]
            triangle[rows], weights[rows], distance[rows] = found[better], found_weights[better], found_distance[better]
        if neighbours == len(members):
            return
        waiting = waiting[away[:, -1] < distance[waiting] + reach_mm]
        neighbours = min(4 * neighbours, len(members))
