"""A scan without frames: one ray for each exposure, and centroids with the noise that the rig's scans have.

A few seconds for a whole scan, for trying out policies of planning; it knows nothing of the spot's size, so that edges come
out too well.  What counts is measured with frames.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.acquisition.plan import PlanRequest, ScanPlan, ViewPlan
from scanner_core.acquisition.planning import locating_plan, scan_plan
from scanner_core.case.observation import ObservationTable
from scanner_core.case.points import MeasuredCloud, triangulate_observations
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.ray_caster import RayCaster
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import Specimen

Array = NDArray[np.float64]

ROW_S, VIEW_S = 0.065, 0.8
"""Between the last exposure of a row and the first of the next, and between two views, as the virtual controller needs them."""

_SHIFT_MM = 0.019
"""Of a centroid on the surface, each camera and axis, by speckle."""
_SURFACE_MM = 0.010
_PIXELS_PX = 0.006
_LEAST_COSINE = 0.08
_REACH_MM = 900.0


class SimulatedScan:
    """Points of plans on one specimen; `exposures` are counted, `rig_s` is the rig's time."""

    def __init__(self, config: RigConfig, calibration: StereoCalibration, specimen: Specimen, seed: int) -> None:
        self.config, self.calibration, self.specimen = config, calibration, specimen
        preset = PRESETS[config.virtual or "bench"]
        self.rate_hz = preset.rate_hz
        self._cameras = preset.cameras
        self._scene = Scene(preset, None)
        self._laser = preset.laser_position_mm
        self._eyes = np.stack([camera.centre_mm() for camera in preset.cameras])
        self._caster = RayCaster(specimen.mesh)
        area = specimen.mesh.area_vectors()
        self._normals = area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None]
        self._rng = np.random.default_rng([seed, 77])
        self.records: list[Array] = []
        self.exposures, self.rig_s = 0, 0.0
        self.plans: tuple[ViewPlan, ...] = ()

    def uniform(self, request: PlanRequest) -> None:
        """The locating pass and the plan of today."""
        located = locating_plan(self.config, request, self.rate_hz)
        kept, self.records = self.records, []
        self.follow(located)
        hits = np.concatenate(self.records)[:, 0].astype(np.int64)
        self.records = kept
        plan = scan_plan(self.config, request, self.rate_hz, located, hits, 1_000_000)
        self.plans = plan.views
        self.follow(plan)

    def follow(self, plan: ScanPlan) -> int:
        """Expose a plan; how many points that gave."""
        owed = total = 0
        for view in plan.views:
            if not view.rows:
                continue
            wanted = None if view.quota is None else view.quota + owed
            beams = [(row.first_id + k, row.view, row.x_from_deg + k * (row.x_to_deg - row.x_from_deg) / (row.count - 1), row.y_deg, number)
                     for number, row in enumerate(view.rows) for k in range(row.count)]  # fmt: skip
            table = np.array(beams)
            records, at = self._measured(table, view.table_deg)
            last = len(table)
            if wanted is not None and len(records) > wanted:
                records, last = records[:wanted], int(at[wanted - 1]) + 1
            rows = int(table[last - 1, 4]) + 1
            self.exposures += last
            self.rig_s += VIEW_S + rows * ROW_S + last / self.rate_hz
            self.records.append(records)
            total += len(records)
            owed = 0 if wanted is None else wanted - len(records)
        return total

    def cloud(self) -> MeasuredCloud:
        """All points so far."""
        values = np.concatenate(self.records)
        size, noise = np.full((len(values), 2), 1.0), np.full(len(values), _PIXELS_PX)
        seen = ObservationTable(
            values[:, 0].astype(np.int64), values[:, 1].astype(np.int32), values[:, 2], values[:, 3:5], values[:, 5:7], noise, noise, size, size
        )
        return triangulate_observations(seen, self.config, self.calibration)

    def _measured(self, beams: Array, table_deg: float) -> tuple[Array, NDArray[np.int64]]:
        """Records of the exposures (n, 5) that give a point, and which those are."""
        turn = RigidTransform.about_z(table_deg).rotation  # object to table
        directions = np.stack([self._scene.beam(x, y)[0] for x, y in beams[:, 2:4]])
        start = self._laser @ turn
        hits, triangles = self._caster.first_hits(np.broadcast_to(start, (len(beams), 3)), start + _REACH_MM * directions @ turn)
        at = np.flatnonzero((triangles >= 0) & (hits[:, 2] > TABLE_MM))
        places, normals = hits[at], self._normals[triangles[at]]
        good = np.ones(len(at), bool)
        for eye in np.vstack([self._laser, self._eyes]) @ turn:
            towards = eye - places
            good &= np.einsum("ij,ij->i", towards, normals) > _LEAST_COSINE * np.linalg.norm(towards, axis=1)
        for eye in self._eyes @ turn:
            kept = np.flatnonzero(good)
            good[kept[self._caster.blocked(places[kept] + 0.01 * normals[kept], eye)]] = False
        at, places, normals = at[good], places[good], normals[good]
        places = places + _SURFACE_MM * self._rng.standard_normal((len(at), 1)) * normals
        pixels = []
        for camera in self._cameras:
            depth = np.linalg.norm(camera.centre_mm() @ turn - places, axis=1)[:, None]
            focal = np.diag(camera.matrix)[:2]
            noise = np.hypot(_SHIFT_MM * focal / depth, _PIXELS_PX) * self._rng.standard_normal((len(at), 2))
            pixels.append(camera.project(places @ turn.T) + noise)
        return np.column_stack([beams[at, :2], np.full(len(at), table_deg), *pixels]), at.astype(np.int64)
