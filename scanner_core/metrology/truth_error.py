"""The error of points and mesh against a specimen whose surface is known.

Where the object stands on the table is no property of its shape, so the measured object is first moved rigidly onto
the truth (least squares, point to plane, on the points); the length of that motion is reported beside the errors.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import fit_rigid_to_surface
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens import Specimen

Array = NDArray[np.float64]
_FIT_POINTS = 20_000
_SAMPLES = 60_000


@dataclass(frozen=True, slots=True)
class TruthError:
    """Distances to the true surface in um; the mesh's over area-uniform points of its supported part."""

    points_rms: float
    mesh_rms: float
    mesh_p95: float
    mesh_max: float
    frame_shift: float
    """How far the rigid fit moved the object's middle, um."""

    def as_dict(self) -> dict[str, float]:
        return {name: round(getattr(self, name), 3) for name in self.__dataclass_fields__}


def truth_error(specimen: Specimen, cloud: PointCloud, mesh: TriangleMesh, seed: int = 0) -> TruthError:
    """Errors of a scan of `specimen`; cloud and mesh in the object frame, mm."""
    rng = np.random.default_rng(seed)
    some = cloud.points if len(cloud) <= _FIT_POINTS else cloud.points[rng.choice(len(cloud), _FIT_POINTS, replace=False)]
    surface = ClosestPoint(specimen.mesh)

    def closest(points: Array) -> tuple[Array, Array]:
        foot, _, triangle = surface.query(points)
        return foot, surface.normals(triangle)

    motion: RigidTransform = fit_rigid_to_surface(some, closest)
    on_points = 1e3 * specimen.distance_mm(motion.apply(cloud.points))
    on_mesh = 1e3 * specimen.distance_mm(motion.apply(_sample_supported(mesh, rng)))
    middle = some.mean(axis=0)
    return TruthError(
        points_rms=float(np.sqrt((on_points**2).mean())),
        mesh_rms=float(np.sqrt((on_mesh**2).mean())),
        mesh_p95=float(np.percentile(np.abs(on_mesh), 95)),
        mesh_max=float(np.abs(on_mesh).max()),
        frame_shift=float(1e3 * np.linalg.norm(motion.apply(middle) - middle)),
    )


def _sample_supported(mesh: TriangleMesh, rng: np.random.Generator) -> Array:
    """Area-uniform points (n, 3) on the triangles whose corners are all supported by data."""
    area = mesh.areas()
    supported = mesh.vertex_attributes.get("supported")
    if supported is not None:
        area = area * (np.asarray(supported) > 0)[mesh.triangles].all(axis=1)
    triangle = rng.choice(len(area), _SAMPLES, p=area / area.sum())
    u, v = np.sqrt(rng.random(_SAMPLES))[:, None], rng.random(_SAMPLES)[:, None]
    a, b, c = (mesh.vertices[mesh.triangles[triangle, i]] for i in range(3))
    return np.asarray((1 - u) * a + u * (1 - v) * b + u * v * c, np.float64)
