"""Exact closest points on a triangle mesh, for many points at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.box_tree import BoxTree
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.weld import weld

Array = NDArray[np.float64]
_AT_ONCE = 20_000
_ON_FEATURE = 1e-9
"""A closest point with a barycentric coordinate below this lies on an edge or a vertex."""


class ClosestPoint:
    """The closest point of a mesh to any point of space.

    The triangle with the nearest centroid gives an upper bound, a tree of boxes the few triangles that can be nearer.

    Parameters
    ----------
    mesh : at least one triangle
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        self._mesh = mesh
        self._corners = np.ascontiguousarray(mesh.vertices[mesh.triangles])
        self._centroids = cKDTree(self._corners.mean(axis=1))
        self._tree = BoxTree(self._corners.min(axis=1), self._corners.max(axis=1))
        self._unit: Array | None = None
        self._pseudonormals: tuple[Array, Array] | None = None

    def query(self, points: Array) -> tuple[Array, Array, NDArray[np.int64]]:
        """Closest points on the surface.

        Parameters
        ----------
        points : (n, 3) mm, finite

        Returns
        -------
        closest : (n, 3) mm
        distance : (n,) mm, unsigned
        triangle : (n,) the triangle that holds the closest point; the lowest index where several do
        """
        closest, triangle = np.empty((len(points), 3)), np.empty(len(points), np.int64)
        distance = np.empty(len(points))
        for begin in range(0, len(points), _AT_ONCE):
            part = slice(begin, begin + _AT_ONCE)
            closest[part], distance[part], triangle[part] = self._query(np.asarray(points[part], np.float64))
        return closest, distance, triangle

    def distance(self, points: Array) -> Array:
        """Unsigned distance from the surface, (n,) mm."""
        return self.query(points)[1]

    def signed_distance(self, points: Array) -> Array:
        """Distance from the surface, (n,) mm, positive outside of it.

        The sign is that of the angle-weighted pseudonormal at the closest point, which is right on edges and vertices
        too (Baerentzen and Aanaes, Signed distance computation using the angle weighted pseudonormal, IEEE TVCG 11(3),
        2005).  The mesh should be closed and face outwards; beyond the rim of an open one the sign means little.
        """
        closest, distance, triangle = self.query(points)
        outward = self._normals_at(closest, triangle)
        return np.where(np.einsum("ij,ij->i", points - closest, outward) >= 0, distance, -distance)

    def normals(self, triangle: NDArray[np.int64]) -> Array:
        """Outward unit normals of triangles, (n, 3); zero for a triangle without area."""
        if self._unit is None:
            normal = self._mesh.area_vectors()
            self._unit = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
        return self._unit[triangle]

    def _query(self, points: Array) -> tuple[Array, Array, NDArray[np.int64]]:
        _, first = self._centroids.query(points)
        bound = np.linalg.norm(closest_on_triangles(points, self._corners[first]) - points, axis=1)
        which, triangle = self._tree.boxes_within(points, bound)
        found = closest_on_triangles(points[which], self._corners[triangle])
        difference = found - points[which]
        squared = np.einsum("ij,ij->i", difference, difference)
        best = np.lexsort((triangle, squared, which))
        best = best[np.r_[True, which[best[1:]] != which[best[:-1]]]] if len(best) else best
        return found[best], np.sqrt(squared[best]), triangle[best]

    def _normals_at(self, closest: Array, triangle: NDArray[np.int64]) -> Array:
        """Pseudonormals (n, 3) where the closest points lie on faces, edges or vertices."""
        if self._pseudonormals is None:
            self._pseudonormals = pseudonormals(self._mesh, self.normals(np.arange(len(self._mesh.triangles))))
        at_edge, at_vertex = self._pseudonormals
        weights = barycentric(closest, self._corners[triangle])
        away = weights <= _ON_FEATURE
        outward = self.normals(triangle).copy()
        for corner in range(3):
            edge = away[:, corner] & (away.sum(axis=1) == 1)  # the edge across from this corner
            outward[edge] = at_edge[3 * triangle[edge] + (corner + 1) % 3]
            vertex = ~away[:, corner] & (away.sum(axis=1) == 2)
            outward[vertex] = at_vertex[3 * triangle[vertex] + corner]
        return outward


def closest_on_triangles(points: Array, corners: Array) -> Array:
    """The closest point to each point (n, 3) on its own triangle (n, 3, 3), by the region of the triangle's plane
    (Ericson, Real-Time Collision Detection, 2005, 5.1.5)."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    ab, ac, ap = b - a, c - a, points - a
    d1, d2 = _dot(ab, ap), _dot(ac, ap)
    bp, cp = points - b, points - c
    d3, d4, d5, d6 = _dot(ab, bp), _dot(ac, bp), _dot(ab, cp), _dot(ac, cp)
    va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    total = va + vb + vc
    inside = np.divide(1.0, total, out=np.zeros_like(total), where=total > 0)
    v, w = vb * inside, vc * inside
    on_bc = _ratio(d4 - d3, (d4 - d3) + (d5 - d6))
    on_ac, on_ab, zero, one = _ratio(d2, d2 - d6), _ratio(d1, d1 - d3), np.zeros_like(d1), np.ones_like(d1)
    for region, v_there, w_there in (
        ((va <= 0) & (d4 >= d3) & (d5 >= d6), 1 - on_bc, on_bc),
        ((vb <= 0) & (d2 >= 0) & (d6 <= 0), zero, on_ac),
        ((vc <= 0) & (d1 >= 0) & (d3 <= 0), on_ab, zero),
        ((d6 >= 0) & (d5 <= d6), zero, one),
        ((d3 >= 0) & (d4 <= d3), one, zero),
        ((d1 <= 0) & (d2 <= 0), zero, zero),
    ):
        v, w = np.where(region, v_there, v), np.where(region, w_there, w)
    return np.asarray(a + v[:, None] * ab + w[:, None] * ac, np.float64)


def barycentric(points: Array, corners: Array) -> Array:
    """Barycentric coordinates (n, 3) of points (n, 3) in the planes of their triangles (n, 3, 3)."""
    a = corners[:, 0]
    ab, ac, ap = corners[:, 1] - a, corners[:, 2] - a, points - a
    aa, bb, mixed = _dot(ab, ab), _dot(ac, ac), _dot(ab, ac)
    determinant = aa * bb - mixed * mixed
    v = _ratio(bb * _dot(ab, ap) - mixed * _dot(ac, ap), determinant)
    w = _ratio(aa * _dot(ac, ap) - mixed * _dot(ab, ap), determinant)
    return np.column_stack([1 - v - w, v, w])


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b), np.float64)


def _ratio(a: Array, b: Array) -> Array:
    return np.divide(a, b, out=np.zeros_like(a), where=b > 0)


def pseudonormals(mesh: TriangleMesh, unit: Array) -> tuple[Array, Array]:
    """For every half-edge and for every corner (3 t, 3) the pseudonormal of its edge and of its vertex.

    Half-edge ``3 t + i`` runs from corner ``i`` of triangle ``t`` to the next; `unit` (t, 3) are the triangles' unit normals.
    """
    _, joined = weld(mesh.vertices)
    triangles = joined[mesh.triangles]
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    key = np.minimum(start, end) * np.int64(len(mesh.vertices)) + np.maximum(start, end)
    _, edge = np.unique(key, return_inverse=True)
    corners = mesh.vertices[mesh.triangles]
    forward = np.roll(corners, -1, axis=1) - corners
    backward = np.roll(corners, 1, axis=1) - corners
    sine = np.linalg.norm(np.cross(forward, backward), axis=2)
    angle = np.arctan2(sine, np.einsum("fij,fij->fi", forward, backward)).ravel()
    normal = np.repeat(unit, 3, axis=0)
    at_edge = np.column_stack([np.bincount(edge, normal[:, axis]) for axis in range(3)])
    at_vertex = np.column_stack([np.bincount(start, angle * normal[:, axis], minlength=len(mesh.vertices)) for axis in range(3)])
    return np.asarray(at_edge[edge], np.float64), np.asarray(at_vertex[start], np.float64)
