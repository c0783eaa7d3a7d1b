"""Where the beam pointed at every exposure of a scan, and what became of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles, beam_directions
from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.acquisition.plan import ScanPlan
from scanner_core.case.observation import ExposureTable
from scanner_core.coverage.beam_fit import fit_beam
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

_MEET_MM = 1.0
"""Beam and line of sight of a camera's spot that pass each other at more than this do not belong together."""
_UNKNOWN_MM = 0.5
"""Error of the nominal beam where it could not be fitted."""


@dataclass(frozen=True, slots=True, eq=False)
class Exposures:
    """n exposures of a scan.

    Attributes
    ----------
    rig : with the beam as it is
    seen : what became of them
    beam_deg : (n, 2) pan X and tilt Y that the beam was told
    cloud : the points that were measured, object frame
    scatter_mm : of the beam about where it was told to be
    """

    rig: RigConfig
    seen: ExposureTable
    beam_deg: Array
    cloud: PointCloud
    scatter_mm: float

    def seen_by_one(self, calibration: StereoCalibration) -> Array:
        """Places (m, 3) mm, object frame, of the spots that only one camera saw: where its line of sight meets the beam."""
        to_table = calibration.rig_to_table()
        pivot = np.array(self.rig.laser.position_mm)
        seen = self.seen
        places = [np.empty((0, 3))]
        for camera, own, other in ((calibration.left, seen.left_px, seen.right_px), (calibration.right, seen.right_px, seen.left_px)):
            alone = np.flatnonzero(np.isfinite(own[:, 0]) & np.isnan(other[:, 0]))
            if not len(alone):
                continue
            eye = to_table.apply(camera.centre_mm())
            sight = to_table.rotate(np.c_[camera.normalize(own[alone]), np.ones(len(alone))] @ camera.rotation)
            sight /= np.linalg.norm(sight, axis=1)[:, None]
            beam = beam_directions(self.rig.laser, self.beam_deg[alone])
            on_beam, on_sight = _closest(pivot, beam, eye, sight)
            meets = np.linalg.norm(on_beam - on_sight, axis=1) < _MEET_MM
            places.append(_turned(0.5 * (on_beam + on_sight)[meets], -seen.table_deg[alone][meets]))
        found = np.concatenate(places)
        volume = self.rig.volume
        inside = (found[:, 2] >= TABLE_MM) & (found[:, 2] <= volume.height_mm) & (np.hypot(found[:, 0], found[:, 1]) <= volume.radius_mm)
        return np.asarray(found[inside], np.float64)


def exposures_of(seen: ExposureTable, plan: ScanPlan, cloud: PointCloud, rig: RigConfig) -> Exposures:
    """The exposures of a scan by its plan, of which `cloud` (object frame) holds the points."""
    told = _told(plan, seen.trigger_id)
    if cloud.trigger_ids is None:
        raise ValueError("the points of a scan have trigger ids")
    row = np.searchsorted(seen.trigger_id, cloud.trigger_ids)
    ours = np.isin(cloud.trigger_ids, seen.trigger_id)
    ours[ours] &= np.isfinite(told[row[ours], 0])
    fit = fit_beam(rig.laser, _turned(cloud.points[ours], seen.table_deg[row[ours]]), told[row[ours]])
    known = np.isfinite(told[:, 0])
    if fit is None:
        return Exposures(rig, seen.select(known), told[known], cloud, _UNKNOWN_MM)
    return Exposures(replace(rig, laser=fit.laser), seen.select(known), told[known], cloud, fit.scatter_mm)


def aimed_at(places: Array, seen: ExposureTable, cloud: PointCloud, rig: RigConfig) -> Exposures:
    """Exposures of a beam that points at places (n, 3) mm, object frame, exactly."""
    return Exposures(rig, seen, beam_angles(rig.laser, _turned(places, seen.table_deg)), cloud, 0.0)


def _closest(a: Array, along_a: Array, b: Array, along_b: Array) -> tuple[Array, Array]:
    """The points (n, 3) where lines from a and b, (3,), along unit vectors (n, 3), come closest to each other."""
    between = a - b
    cosine = np.einsum("ij,ij->i", along_a, along_b)
    by_a, by_b = along_a @ between, along_b @ between
    sine2 = np.maximum(1 - cosine**2, 1e-12)
    t, u = (cosine * by_b - by_a) / sine2, (by_b - cosine * by_a) / sine2
    return a + t[:, None] * along_a, b + u[:, None] * along_b


def _turned(points: Array, angles_deg: Array) -> Array:
    """Points (n, 3) turned about +z, each by its own angle (n,)."""
    turn = np.radians(angles_deg)
    x, y, z = points.T
    return np.stack([np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y, z], axis=1)


def _told(plan: ScanPlan, trigger_ids: NDArray[np.int64]) -> Array:
    """Pan and tilt (n, 2) of the plan, NaN for ids that it does not hold."""
    told = np.full((len(trigger_ids), 2), np.nan)
    for row in (row for view in plan.views for row in view.rows):
        first, end = np.searchsorted(trigger_ids, [row.first_id, row.first_id + row.count])
        along = (trigger_ids[first:end] - row.first_id) / max(row.count - 1, 1)
        told[first:end, 0], told[first:end, 1] = row.x_from_deg + along * (row.x_to_deg - row.x_from_deg), row.y_deg
    return told
