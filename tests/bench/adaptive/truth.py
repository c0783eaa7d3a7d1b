"""A surface against the truth, over all of the truth that can be seen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import fit_rigid_to_surface
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

_SAMPLES = 12_000
_EVERY_DEG = 10.0
_FIT_POINTS = 6000


@dataclass(frozen=True, slots=True, eq=False)
class SeenError:
    """Distances of places of the seeable truth from the surface, um; `within` is the share whose surface claims the wanted uncertainty."""

    distance_um: Array
    rms_um: float
    p50_um: float
    p95_um: float
    max_um: float
    within: float


class SeeableTruth:
    """Area-uniform places of a true surface that the rig can measure at some table angle as it stands."""

    def __init__(self, mesh: TriangleMesh, rig: RigConfig, calibration: StereoCalibration, seed: int = 0) -> None:
        rng = np.random.default_rng(seed)
        area = mesh.areas()
        triangle = rng.choice(len(area), _SAMPLES, p=area / area.sum())
        u, v = np.sqrt(rng.random(_SAMPLES))[:, None], rng.random(_SAMPLES)[:, None]
        a, b, c = (mesh.vertices[mesh.triangles[triangle, i]] for i in range(3))
        places = (1 - u) * a + u * (1 - v) * b + u * v * c
        normals = np.take(mesh.area_vectors(), triangle, axis=0)
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        lines = Sightlines(rig, calibration, mesh, places, normals)
        seeable = np.zeros(len(places), int)
        self.best_um = np.full(len(places), np.inf)
        for angle in np.arange(0, 360, _EVERY_DEG):
            sight = lines.at(float(angle))
            seeable += sight.measurable
            self.best_um = np.fmin(self.best_um, sight.point_sd_um)
        seen = seeable >= 1
        self.share = float(seen.mean())
        self.places, self.normals, self.best_um, self.angles = places[seen], normals[seen], self.best_um[seen], seeable[seen]
        self._mesh = mesh
        self._closest = ClosestPoint(mesh)

    def judge(self, surface: TriangleMesh, cloud: PointCloud, wanted_um: float) -> SeenError:
        """The surface's error; where the object stands is no property of its shape: the cloud is fitted to the truth first."""
        rng = np.random.default_rng(0)
        some = cloud.points if len(cloud) <= _FIT_POINTS else cloud.points[rng.choice(len(cloud), _FIT_POINTS, replace=False)]

        def closest(points: Array) -> tuple[Array, Array]:
            foot, _, triangle = self._closest.query(points)
            return foot, self._closest.normals(triangle)

        motion = fit_rigid_to_surface(some, closest)
        query = ClosestPoint(TriangleMesh(motion.apply(surface.vertices), surface.triangles))
        _, distance, triangle = query.query(self.places)
        um = 1e3 * distance
        corners = surface.triangles[triangle]
        fine = np.asarray(surface.vertex_attributes["supported"]) > 0
        fine &= np.asarray(surface.vertex_attributes["standard_uncertainty_um"]) <= wanted_um
        within = float(fine[corners].all(axis=1).mean())
        return SeenError(um, float(np.sqrt((um**2).mean())), float(np.median(um)), float(np.percentile(um, 95)), float(um.max()), within)
