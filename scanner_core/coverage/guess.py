"""A better guess of the surface where no point supports it.

The cap of a reconstruction spans what was not measured like a film, and a film is in plain sight.  But light was there: spots that
only one camera saw have a place on the beam, and with them the surface is reconstructed once more.  It is good enough to tell what
hides what, and nothing else is taken from it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.ray_caster import RayCaster
from scanner_core.jobs.progress import IsCancelled
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct

Array = NDArray[np.float64]

_WORTH = 0.01
"""Fewer spots of one camera, by the points of both, do not change the surface."""
_FARTHEST_MM = 30.0
"""Counterparts are looked for no farther than this along the normal."""


def guessed_surface(surface: TriangleMesh, cloud: PointCloud, seen_by_one: Array, scatter_mm: float, cancelled: IsCancelled) -> TriangleMesh:
    """The surface of the points of both cameras and those of one, (m, 3) mm with `scatter_mm` on each axis; `surface` itself where they are few.

    Raises
    ------
    Cancelled
    """
    if len(seen_by_one) < _WORTH * len(cloud) or cloud.covariances is None:
        return surface
    points = np.concatenate([cloud.points, seen_by_one])
    covariances = np.concatenate([cloud.covariances, np.tile(scatter_mm**2 * np.eye(3), (len(seen_by_one), 1, 1))])
    parameters = ReconstructionParameters(triangles=len(surface.triangles), seed=0, table_mm=0.0)
    try:
        return reconstruct(PointCloud(points, covariances), parameters, progress=lambda told: None, cancelled=cancelled).mesh
    except ReconstructionError:
        return surface


def counterparts(places: Array, normals: Array, other: TriangleMesh) -> tuple[Array, Array]:
    """The places of another surface that stand for places (n, 3) with normals (n, 3), and the normals there.

    The nearest one along the normal, forwards or backwards, that faces the same way; without one the closest point.
    """
    foot, _, triangle = ClosestPoint(other).query(places)
    nearest = np.full(len(places), np.inf)
    caster = RayCaster(other)
    facets = other.area_vectors()
    for sign in (1.0, -1.0):
        hits, met = caster.first_hits(places, places + sign * _FARTHEST_MM * normals)
        distance = np.linalg.norm(hits - places, axis=1)
        better = (met >= 0) & (distance < nearest) & (np.einsum("ij,ij->i", facets[met], normals) > 0)
        foot[better], triangle[better], nearest[better] = hits[better], met[better], distance[better]
    return foot, _smooth_normals(other, foot, triangle)


def _smooth_normals(mesh: TriangleMesh, points: Array, triangle: NDArray[np.int64]) -> Array:
    """Vertex normals interpolated over the triangles that the points (n, 3) lie in, (n, 3)."""
    corners = mesh.vertices[mesh.triangles[triangle]]
    shares = np.stack([np.linalg.norm(np.cross(corners[:, k - 2] - points, corners[:, k - 1] - points), axis=1) for k in range(3)], axis=1)
    summed = np.einsum("nk,nki->ni", shares, mesh.vertex_normals()[mesh.triangles[triangle]])
    return np.asarray(summed / np.maximum(np.linalg.norm(summed, axis=1), 1e-30)[:, None], np.float64)
