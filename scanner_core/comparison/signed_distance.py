"""Exact signed distance of points from a mesh, open or closed, with the feet on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

from scanner_core.geometry.closest_point import pseudonormals
from scanner_core.geometry.edges import EdgeTable, row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.poly_data import poly_data
from scanner_core.geometry.proximity import Feet, closest_in_triangles, closest_near
from scanner_core.geometry.weld import weld
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]
_ON_FEATURE = 1e-9
"""A foot with a barycentric weight below this lies on an edge or a vertex."""
_AT_ONCE = 5_000
"""Points between two looks at whether to stop: some 50 ms."""


@dataclass(frozen=True, slots=True, eq=False)
class SignedFeet:
    """What n points found on a mesh.

    Attributes
    ----------
    signed_mm : (n,) distance, + outside of the surface
    points : (n, 3) closest points, mm
    triangles : (n,) int64, where they lie
    weights : (n, 3) barycentric
    normals : (n, 3) unit outward pseudonormals there
    on_border : (n,) bool, the closest point lies on a border edge or border vertex: what is opposite was not measured
    """

    signed_mm: Array
    points: Array
    triangles: NDArray[np.int64]
    weights: Array
    normals: Array
    on_border: NDArray[np.bool_]

    def of_vertices(self, mesh: TriangleMesh, values: Array) -> Array:
        """Values of the mesh's vertices (v,) at the feet, (n,)."""
        return np.asarray(np.einsum("nc,nc->n", self.weights, values[mesh.triangles[self.triangles]]))


class SignedDistance:
    """Signed distances from one mesh of at least one triangle.

    The closest point is exact in double precision: a walk over the triangles bounds it, and a search of VTK's cell locator
    within that bound finds it.  The sign is that of the angle-weighted pseudonormal at the foot (Baerentzen and Aanaes, Signed
    distance computation using the angle weighted pseudonormal, IEEE TVCG 11(3), 2005).  It needs no closed mesh; where the foot
    lies on the border of an open one the sign means little, and `on_border` says so.  Neither the parity of rays nor winding
    numbers are right on open meshes.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        self.mesh = mesh
        vectors = mesh.area_vectors()
        self._unit = vectors / np.maximum(np.sqrt(row_dot(vectors, vectors)), 1e-300)[:, None]
        self._at_edge, self._at_vertex = pseudonormals(mesh, self._unit)
        self._border_side, self._border_corner = _borders(mesh)
        self._poly = poly_data(mesh)
        self._locator = vtkStaticCellLocator()
        self._locator.SetDataSet(self._poly)
        self._locator.SetNumberOfCellsPerNode(1)
        self._locator.BuildLocator()

    def feet(self, points: Array, cancelled: IsCancelled = lambda: False, reach_mm: float = np.inf) -> SignedFeet:
        """Signed distances and feet of points (n, 3) mm, finite; raises `Cancelled`.

        Of a point that is farther than `reach_mm` from the mesh only that is certain: its distance may be too large, never within reach.
        """
        points = np.ascontiguousarray(points, np.float64)
        near = closest_near(self.mesh, points)
        triangle = self._exact(points, near, cancelled, reach_mm)
        a, b, c = (np.take(self.mesh.vertices, np.take(column, triangle), axis=0) for column in self.mesh.triangles.T)
        weights, squared = closest_in_triangles(points, a, b, c)
        foot = weights[:, :1] * a + weights[:, 1:2] * b + weights[:, 2:] * c
        normals, on_border = self._features(triangle, weights)
        distance = np.sqrt(np.maximum(squared, 0.0))
        signed = np.where(row_dot(points - foot, normals) >= 0, distance, -distance)
        length = np.sqrt(row_dot(normals, normals))
        return SignedFeet(signed, foot, triangle, weights, normals / np.maximum(length, 1e-300)[:, None], on_border)

    def _exact(self, points: Array, near: Feet, cancelled: IsCancelled, reach_mm: float) -> NDArray[np.int64]:
        triangle = near.triangles.copy()
        # the walk's own foot is within the bound, so that a search without a finding leaves a right answer
        bound = np.minimum(near.distances_mm, reach_mm) * (1 + 1e-12)
        cell, found = vtkGenericCell(), [0.0, 0.0, 0.0]
        which: Any = reference(0)
        sub: Any = reference(0)
        squared: Any = reference(0.0)
        search = self._locator.FindClosestPointWithinRadius
        for begin in range(0, len(points), _AT_ONCE):
            if cancelled():
                raise Cancelled
            part = slice(begin, begin + _AT_ONCE)
            for i, (point, reach) in enumerate(zip(points[part].tolist(), bound[part].tolist(), strict=True), begin):
                if reach > 0 and search(point, reach, found, cell, which, sub, squared) == 1:
                    triangle[i] = which.get()
        return triangle

    def _features(self, triangle: NDArray[np.int64], weights: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Pseudonormals (n, 3), and whether the foot lies on the border, (n,)."""
        away = weights <= _ON_FEATURE
        zeros = away.sum(axis=1)
        normals = np.take(self._unit, triangle, axis=0)
        on_border = np.zeros(len(triangle), np.bool_)
        for corner in range(3):
            edge = np.flatnonzero(away[:, corner] & (zeros == 1))
            side = 3 * triangle[edge] + (corner + 1) % 3  # the edge across from this corner
            normals[edge], on_border[edge] = self._at_edge[side], self._border_side[side]
            vertex = np.flatnonzero(~away[:, corner] & (zeros == 2))
            here = 3 * triangle[vertex] + corner
            normals[vertex], on_border[vertex] = self._at_vertex[here], self._border_corner[here]
        return normals, on_border


def _borders(mesh: TriangleMesh) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """For every half-edge and every corner (3 t,): whether it lies on the border; equal points count as one."""
    _, joined = weld(mesh.vertices)
    triangles = joined[mesh.triangles]
    table = EdgeTable.of(triangles)
    sides = table.side_edges.ravel()
    alone = np.bincount(sides, minlength=len(table.edges))[sides] == 1
    at_vertex = np.zeros(int(triangles.max()) + 1, np.bool_)
    at_vertex[table.edges[np.unique(sides[alone])].ravel()] = True
    return alone, at_vertex[triangles.ravel()]
