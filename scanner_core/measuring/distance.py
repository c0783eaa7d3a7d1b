"""How far two places are from one another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """A place on a surface or a measured point.

    Attributes
    ----------
    point : (3,) mm
    covariance : (3, 3) mm^2, or None when it is not known
    """

    point: Array
    covariance: Array | None = None

    @classmethod
    def of_cloud(cls, cloud: PointCloud, number: int) -> Place:
        """A point of a cloud, by its index."""
        return cls(cloud.points[number], None if cloud.covariances is None else cloud.covariances[number])

    @classmethod
    def of_mesh(cls, mesh: TriangleMesh, vertex: int, point: Array | None = None) -> Place:
        """A point of a mesh's surface, (3,) mm, and the vertex beside it, which has an uncertainty; without a point the vertex itself."""
        known = mesh.vertex_attributes.get("standard_uncertainty_um")
        sigma_mm = np.nan if known is None else 1e-3 * float(np.asarray(known)[vertex])
        return cls(mesh.vertices[vertex] if point is None else point, sigma_mm**2 * np.eye(3) if np.isfinite(sigma_mm) else None)


@dataclass(frozen=True, slots=True, eq=False)
class Distance:
    """Between two places.

    Attributes
    ----------
    length_mm : straight
    uncertainty_mm : of both places along the line between them; how well a hand meets a place is not in it; None when it is not known
    """

    start: Array
    end: Array
    length_mm: float
    uncertainty_mm: float | None


def measure_distance(start: Place, end: Place) -> Distance:
    """From one place to another, their errors being independent of one another."""
    way = end.point - start.point
    length = float(np.linalg.norm(way))
    along = way / length if length > 0 else np.array([0.0, 0.0, 1.0])
    uncertainty = None
    if start.covariance is not None and end.covariance is not None:
        uncertainty = max(float(along @ (start.covariance + end.covariance) @ along), 0.0) ** 0.5
    return Distance(start.point, end.point, length, uncertainty)
