"""A mount's cloud with what bringing it onto another one needs: normals, the surface under it, and its own scatter."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.local_surface import LocalSurface, reference_surface
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mounting.oriented_sample import OrientedSample, sample_cloud

Array = NDArray[np.float64]

CELLS = 1200
"""About how many points the larger of two clouds is reduced to."""
_SCATTER_QUERIES = 1200


@dataclass(frozen=True, eq=False)
class MountSurface:
    """Attributes
    ----------
    points : (n, 3) mm
    towards : (n, 3) unit, from each point to where its light came from
    sample : the cloud in few points
    chosen : (n,) a random order of the points, in which they are used where not all are
    """

    points: Array
    towards: Array
    sample: OrientedSample
    chosen: NDArray[np.int64]

    @classmethod
    def of(cls, cloud: PointCloud, towards: Array | None, spacing_mm: float, rng: np.random.Generator) -> MountSurface:
        light = lit_from(cloud) if towards is None else towards
        return cls(cloud.points, light, sample_cloud(cloud.points, light, spacing_mm), rng.permutation(len(cloud)))

    @cached_property
    def surface(self) -> LocalSurface:
        return reference_surface(self.points)

    @cached_property
    def normals(self) -> Array:
        """(n, 3) outward, those of the nearest points of the sample."""
        nearest: Array = self.sample.normals[self.sample.tree.query(self.points)[1]]
        return nearest

    @cached_property
    def scatter_mm(self) -> float:
        """Standard deviation of the points about the surface through the others, robust."""
        apart = np.zeros(len(self.points), np.bool_)
        apart[self.chosen[::2]] = True
        asked = self.chosen[::2][:_SCATTER_QUERIES]
        near = reference_surface(self.points[~apart]).distance(self.points[asked])
        ratio = near.signed_mm[near.valid] / np.sqrt(1 + near.leverage[near.valid])
        return 1.4826 * float(np.median(np.abs(ratio))) if len(ratio) else 0.0


def lit_from(cloud: PointCloud) -> Array:
    """(n, 3) unit: roughly where the cameras and the beam stood, by the covariances, which are longest along the depth.

    Without covariances, or where these do not tell, straight up: the rig looks down on the table.
    """
    up = np.array([0.0, 0.0, 1.0])
    if cloud.covariances is None:
        return np.broadcast_to(up, cloud.points.shape).copy()
    axes = np.linalg.eigh(cloud.covariances)[1][:, :, 2]
    return axes * np.where(axes[:, 2] < 0, -1.0, 1.0)[:, None]
