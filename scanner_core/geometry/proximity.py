"""The closest point of a mesh: exactly, or quickly for points that lie near it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.edges import EdgeTable, row_cross, row_dot
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
_STEPS = 24
"""Longest walk, in triangles; one in a circle (round a vertex like a spike) ends here."""
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
    vertices : (n,) int64, the corner of that triangle that weighs most: where to start the next search
    """

    points: Array
    triangles: NDArray[np.int64]
    weights: Array
    distances_mm: Array
    vertices: NDArray[np.int64]


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


def closest_near(
    mesh: TriangleMesh, points: Array, tree: cKDTree | None = None, start: NDArray[np.int64] | None = None, table: EdgeTable | None = None
) -> Feet:
    """Closest points by walking from triangle to triangle, (n, 3) -> n feet.

    Exact for nearly all points within an edge of a well-shaped mesh, and several times faster than `closest_points`.

    Parameters
    ----------
    mesh : at least one triangle
    points : (n, 3) mm
    tree : of ``mesh.vertices``, built where it is needed and not given
    start : (n,) int64, a vertex near each point, for example ``Feet.vertices`` of the last search; without it the nearest
        vertex is looked up.  Where the walk from it ends more than an edge away from the point, the tree is asked after all.
    table : the edges of `mesh`, made if None
    """
    walk = SurfaceWalk(mesh, table)
    if start is None:
        tree = cKDTree(mesh.vertices) if tree is None else tree
        start = tree.query(points)[1].astype(np.int64)
        return walk.feet(points, start)
    feet = walk.feet(points, start)
    squared = feet.distances_mm**2
    far = np.flatnonzero(squared > 0.5 * float(np.median(mesh.areas())))  # few need a closer look
    a, b, c = (mesh.vertices[column] for column in mesh.triangles[feet.triangles[far]].T)
    lost = far[3 * squared[far] > row_dot(b - a, b - a) + row_dot(c - b, c - b) + row_dot(a - c, a - c)]
    if len(lost):
        tree = cKDTree(mesh.vertices) if tree is None else tree
        again = walk.feet(points[lost], tree.query(points[lost])[1].astype(np.int64))
        nearer = again.distances_mm < feet.distances_mm[lost]
        for name in ("points", "triangles", "weights", "distances_mm", "vertices"):
            getattr(feet, name)[lost[nearer]] = getattr(again, name)[nearer]
    return feet


class SurfaceWalk:
    """Closest points on one mesh, by walks over its triangles.

    Two triangles at an edge are parted by the plane through that edge and the mean of their normals: a point is nearer to
    the plane of the triangle on whose side it lies.  From a triangle the walk goes over the side where the point is
    farthest beyond, and ends where the point is beyond none.
    """

    def __init__(self, mesh: TriangleMesh, table: EdgeTable | None = None) -> None:
        self.mesh = mesh
        t, v = mesh.triangles, mesh.vertices
        table = EdgeTable.of(t) if table is None else table
        normals = mesh.area_vectors()
        normals /= np.maximum(np.sqrt(row_dot(normals, normals)), 1e-300)[:, None]
        corners = t.ravel()
        one, other = _sides(table)
        triangle_one, triangle_other = one // 3, other // 3
        self.across = np.repeat(np.arange(len(t)), 3)
        self.across[one], self.across[other] = triangle_other, triangle_one
        mean = np.take(normals, triangle_one, axis=0) + np.take(normals, triangle_other, axis=0)
        foot = np.take(v, corners[one], axis=0)
        along = np.take(v, t[:, (1, 2, 0)].ravel()[one], axis=0) - foot
        plane = np.empty((len(one), 4))
        plane[:, :3] = row_cross(mean, along)
        plane[:, :3] /= np.maximum(np.sqrt(row_dot(plane[:, :3], plane[:, :3])), 1e-300)[:, None]
        plane[:, 3] = row_dot(plane[:, :3], foot)
        # (t, 3, 4): the height over the plane of a side is row . (x, y, z, -1), positive inside
        planes = np.empty((3 * len(t), 4))
        planes[other] = -plane
        planes[one] = plane  # a side at a border is its own other one, and the walk ends there
        self.planes = planes.reshape(len(t), 12)
        self.triangle_of = np.zeros(len(v), np.int64)
        self.triangle_of[corners] = np.arange(len(corners)) // 3

    def feet(self, points: Array, start: NDArray[np.int64]) -> Feet:
        """Feet of points (n, 3), each walk beginning at a triangle round the vertex `start` (n,)."""
        triangle = self.triangle_of[start]
        active, here = np.arange(len(points)), triangle
        p = np.empty((len(points), 4))
        p[:, :3], p[:, 3] = points, -1.0
        for _ in range(_STEPS):
            planes = np.take(self.planes, here, axis=0).reshape(-1, 3, 4)
            height = np.einsum("nij,nj->ni", planes, p)
            worst = np.argmin(height, axis=1)
            following = np.take(self.across, 3 * here + worst)
            go = np.flatnonzero((height.ravel()[3 * np.arange(len(here)) + worst] < 0) & (following != here))
            if not len(go):
                break
            active, p, here = active[go], np.take(p, go, axis=0), following[go]
            triangle[active] = here
        a, b, c = (np.take(self.mesh.vertices, np.take(column, triangle), axis=0) for column in self.mesh.triangles.T)
        weights, squared = closest_in_triangles(points, a, b, c)
        return _feet(self.mesh, points, triangle, weights, squared)


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
    corners = np.take(mesh.triangles, triangle, axis=0)
    foot = np.einsum("nc,ncd->nd", weights, np.take(mesh.vertices, corners, axis=0))
    vertices = np.take(corners.ravel(), 3 * np.arange(len(corners)) + np.argmax(weights, axis=1))
    return Feet(foot, triangle, weights, np.sqrt(np.maximum(squared, 0)), vertices)


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


def _sides(table: EdgeTable) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Pairs of sides that are neighbours, each (k,), every pair once; a side without exactly one neighbour is paired with itself."""
    if table.edge_sides is not None:
        return np.ascontiguousarray(table.edge_sides[:, 0]), np.ascontiguousarray(table.edge_sides[:, 1])
    edge = table.side_edges.ravel()
    order = np.argsort(edge, kind="stable")
    begins = np.flatnonzero(np.r_[True, edge[order][1:] != edge[order][:-1]])
    two = np.diff(np.r_[begins, len(edge)]) == 2
    one, other = order[begins[two]], order[begins[two] + 1]
    alone = np.ones(len(edge), np.bool_)
    alone[one] = alone[other] = False
    rest = np.flatnonzero(alone)
    return np.concatenate([one, rest]), np.concatenate([other, rest])
