"""Every vertex of the after surface with its counterpart on the before surface, at any pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.spatial import cKDTree

from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.edges import EdgeTable, adjacency, row_dot, valences
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import SurfaceWalk
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_NORMALS_OVER_MM = 0.5
"""Normals are averaged over this length: those of single vertices are noisier than the surfaces are curved."""
_MOST_ROUNDS = 40
_LEAST_COSINE = 0.5
"""Surfaces that face each other at more than 60 degrees are no counterparts."""


@dataclass(frozen=True, slots=True, eq=False)
class Pairs:
    """Signed distances at one pose; rows are all vertices of the after surface.

    Attributes
    ----------
    points : (v, 3) the moved vertices, frame of BEFORE, mm
    normals : (v, 3) unit, the mean of both surfaces' smoothed normals
    distances : (v,) mm along these normals, + outside
    facing : (v,) bool, there is a counterpart
    nearest : (v,) int64, a vertex of the before surface near each; -1 where there is none
    corners : (v, 3) int64, the vertices of the BEFORE surface about the counterpart; where there is one
    response : (v,) by how much `distances` follow a motion along `normals`, 0 to 1: a noisy triangle is tilted against the
        surface, the foot slides along it, and the distance grows by the squared cosine of the tilt only
    """

    points: Array
    normals: Array
    distances: Array
    facing: Mask
    nearest: NDArray[np.int64]
    corners: NDArray[np.int64]
    response: Array


class MeshAverage:
    """Averages values of vertices over a stated length along the surface, by diffusion on the mesh's edges."""

    def __init__(self, mesh: TriangleMesh, table: EdgeTable) -> None:
        joined = adjacency(table.edges, len(mesh.vertices))
        valence = np.maximum(valences(table.edges, len(mesh.vertices)), 1)
        # a vertex keeps half its value: a plain mean of neighbours would oscillate
        self._step = sparse.csr_array(0.5 * sparse.eye_array(len(valence)) + 0.5 * sparse.diags_array(1.0 / valence) @ joined)
        self.edge_mm = float(np.sqrt(np.mean(table.lengths(mesh.vertices) ** 2))) if len(table.edges) else 1.0

    def __call__(self, values: Array, length_mm: float) -> Array:
        """Values (v,) or (v, k), averaged as by a Gaussian with the standard deviation `length_mm` in every direction."""
        # a round moves half of the value by one edge: the variance grows by a quarter of its square in each direction
        rounds = int(np.clip(np.ceil(4 * (length_mm / self.edge_mm) ** 2), 1, _MOST_ROUNDS))
        for _ in range(rounds):
            values = self._step @ values
        return values


class PairedSurface:
    """What does not depend on the pose, nor on which of two surfaces it is.

    Attributes
    ----------
    mesh, supported : of the surface
    edges : of the mesh
    areas : (v,) mm^2 of surface round each vertex
    average : over lengths along the surface
    normals : (v, 3) unit, smoothed
    """

    def __init__(self, surface: ComparedSurface) -> None:
        self.mesh, self.supported = surface.mesh, surface.supported
        self.edges = EdgeTable.of(self.mesh.triangles)
        thirds = np.repeat(self.mesh.areas() / 3, 3)
        self.areas = np.asarray(np.bincount(self.mesh.triangles.ravel(), thirds, minlength=len(self.mesh.vertices)), np.float64)
        self.average = MeshAverage(self.mesh, self.edges)
        normals = self.average(self.mesh.vertex_normals(), _NORMALS_OVER_MM)
        self.normals = np.asarray(normals / np.maximum(np.sqrt(row_dot(normals, normals)), 1e-12)[:, None], np.float64)


class SurfacePairing:
    """Finds counterparts of the after surface's vertices.

    Attributes
    ----------
    before, after : the meshes
    supported : (v_after,) bool
    areas, average, edges : of the after surface, see :class:`PairedSurface`
    """

    def __init__(self, before: PairedSurface, after: PairedSurface, reach_mm: float) -> None:
        self.before, self.after = before.mesh, after.mesh
        self.supported, self.edges, self.average, self.areas = after.supported, after.edges, after.average, after.areas
        self.reach_mm = reach_mm
        self._walk = SurfaceWalk(before.mesh, before.edges)
        self._tree = cKDTree(before.mesh.vertices)
        facets = before.mesh.area_vectors()
        self._facets = facets / np.maximum(np.sqrt(row_dot(facets, facets)), 1e-300)[:, None]
        self._usable: Mask = np.asarray(before.supported[before.mesh.triangles].all(axis=1), np.bool_)
        alone = np.bincount(before.edges.side_edges.ravel(), minlength=len(before.edges.edges)) == 1
        self._border_side: Mask = np.asarray(alone, np.bool_)[before.edges.side_edges.ravel()]
        self._before_normals, self._after_normals = before.normals, after.normals

    def at(self, transform: RigidTransform, last: Pairs | None = None) -> Pairs:
        """Counterparts at a pose, after to before; `last` are those of a pose a millimetre or less away, which spare a search."""
        points = transform.apply(self.after.vertices)
        nearest = self._nearest(points) if last is None else last.nearest.copy()
        near = np.flatnonzero(nearest >= 0)
        distances, facing = np.zeros(len(points)), np.zeros(len(points), np.bool_)
        normals = transform.rotate(self._after_normals)
        around, response = np.zeros((len(points), 3), np.int64), np.ones(len(points))
        if len(near):
            feet = self._walk.feet(points[near], nearest[near])
            nearest[near] = feet.vertices
            corners = self.before.triangles[feet.triangles]
            opposite = np.einsum("nc,ncd->nd", feet.weights, self._before_normals[corners])
            mean = normals[near] + opposite
            mean /= np.maximum(np.sqrt(row_dot(mean, mean)), 1e-12)[:, None]
            # side i runs from corner i to i + 1: a foot lies on it where the third weight is nothing
            on_border = np.any(self._border_side[3 * feet.triangles[:, None] + np.arange(3)] & (feet.weights[:, (2, 0, 1)] < 1e-9), axis=1)
            facing[near] = (
                (feet.distances_mm < self.reach_mm) & ~on_border & self._usable[feet.triangles] & (row_dot(normals[near], opposite) > _LEAST_COSINE)
            )
            distances[near] = row_dot(points[near] - feet.points, mean)
            normals[near] = mean
            around[near] = corners
            inside = feet.weights.min(axis=1) > 0  # a foot on an edge or a corner stays where it is
            response[near] = np.where(inside, row_dot(mean, np.take(self._facets, feet.triangles, axis=0)) ** 2, 1.0)
        return Pairs(points, normals, distances, facing, nearest, around, response)

    def _nearest(self, points: Array) -> NDArray[np.int64]:
        away, nearest = self._tree.query(points, distance_upper_bound=2 * self.reach_mm + 1e-9)
        return np.where(np.isfinite(away) & self.supported, nearest, -1).astype(np.int64)
