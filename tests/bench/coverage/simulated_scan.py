"""A scan without images: every exposure of an even raster is a ray to the true surface, and two to the cameras.

The beam stands where the virtual rig has it, not where the rig file says; centroids scatter by the noise of the bench's spots; a
camera loses flat spots as often as it does on rendered frames.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles, beam_directions
from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.case.observation import MEASURED, ExposureTable
from scanner_core.coverage.sightlines import pixel_noise_px
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.ray_caster import RayCaster
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]

PIVOT_WRONG_MM = (2.4, -1.7, 1.9)
ANGLE_RAD = 4.9e-5
"""As the noise model finds it on rendered scans of the bench."""
LOST, KEPT = 0.02, 0.10
"""Cosines of the view at which no spot and every spot is found, straight between them."""


@dataclass(frozen=True, slots=True, eq=False)
class SimulatedScan:
    """What a case would hold of it; `rig` is the true one, with the beam where it stands."""

    plan: ScanPlan
    seen: ExposureTable
    cloud: PointCloud
    rig: RigConfig


def simulated_scan(mesh: TriangleMesh, rig: RigConfig, calibration: StereoCalibration, points: int, views: int, seed: int) -> SimulatedScan:
    """About `points` points over `views` even table angles."""
    rng = np.random.default_rng(seed)
    position = tuple(np.add(rig.laser.position_mm, PIVOT_WRONG_MM).tolist())
    true = replace(rig, laser=replace(rig.laser, position_mm=position))
    caster = RayCaster(mesh)
    angles = [360.0 * k / views for k in range(views)]
    step = 0.25
    coarse = [_view(mesh, caster, true, calibration, angle, step, rng) for angle in angles]
    found = sum(int((view.verdict == MEASURED).sum()) for view, _, _ in coarse)
    step *= float(np.sqrt(found / points))
    plans, tables, first_id = [], [], 0
    for number, angle in enumerate(angles):
        table, grid, _ = _view(mesh, caster, true, calibration, angle, step, rng)
        rows: list[Row] = []
        for y_deg, low, count in grid:
            rows.append(Row(number, first_id + sum(row.count for row in rows), count, y_deg, low, low + (count - 1) * step))
        plans.append(ViewPlan(angle, tuple(rows)))
        tables.append(replace(table, trigger_id=table.trigger_id + first_id))
        first_id += len(table.trigger_id)
    seen = ExposureTable(*(np.concatenate([getattr(table, name) for table in tables]) for name in ExposureTable.__dataclass_fields__))
    return SimulatedScan(ScanPlan(tuple(plans), 60 * step), seen, _cloud(seen, true, calibration), true)


def _view(
    mesh: TriangleMesh, caster: RayCaster, rig: RigConfig, calibration: StereoCalibration, table_deg: float, step: float, rng: np.random.Generator
) -> tuple[ExposureTable, list[tuple[float, float, int]], Array]:
    """Exposures of one view with ids from 0, and its rows: tilt, first pan and count."""
    turn = RigidTransform.about_z(table_deg)
    outline = beam_angles(rig.laser, turn.apply(mesh.vertices))
    (x0, y0), (x1, y1) = outline.min(axis=0) - step, outline.max(axis=0) + step
    columns, tilts = max(3, round((x1 - x0) / step)), np.arange(y0 + rng.random() * step, y1, step)
    told = np.stack([np.tile(x0 + step * np.arange(columns), len(tilts)), np.repeat(tilts, columns)], axis=1)
    pivot = np.array(rig.laser.position_mm)
    along = beam_directions(rig.laser, told) @ turn.rotation
    start = np.broadcast_to(pivot @ turn.rotation, along.shape)
    hits, triangle = caster.first_hits(start, start + 1500 * along)
    met = np.flatnonzero(triangle >= 0)
    area = mesh.area_vectors()
    normals = (area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None])[triangle[met]]
    lost_both = np.full((len(told), 2), np.nan)
    pixels, to_rig = [lost_both.copy(), lost_both.copy()], calibration.rig_to_object(table_deg).inverse()
    for k, camera in enumerate((calibration.left, calibration.right)):
        eye = calibration.rig_to_object(table_deg).apply(camera.centre_mm())
        towards = eye - hits[met]
        cosine = np.einsum("ij,ij->i", towards, normals) / np.linalg.norm(towards, axis=1)
        sees = rng.random(len(met)) < (cosine - LOST) / (KEPT - LOST)
        sees[sees] = ~caster.blocked((hits[met] + 2e-3 * normals)[sees], eye)
        noise = np.hypot(pixel_noise_px(rig.spot, 198 * np.maximum(cosine, LOST))[:, None], ANGLE_RAD * np.diag(camera.matrix)[:2])
        there = camera.project(to_rig.apply(hits[met])) + noise * rng.standard_normal((len(met), 2))
        pixels[k][met[sees]] = there[sees]
    left, right = (np.isfinite(px[:, 0]) for px in pixels)
    verdict = np.select([left & right, right, left], [MEASURED, "hidden_left", "hidden_right"], "no_spot").astype(np.object_)
    verdict[met[hits[met, 2] < TABLE_MM]] = "table"
    ids = np.arange(len(told))
    rows = [(float(tilt), float(x0), columns) for tilt in tilts]
    return ExposureTable(ids, np.full(len(told), table_deg), verdict, pixels[0], pixels[1]), rows, told


def _cloud(seen: ExposureTable, rig: RigConfig, calibration: StereoCalibration) -> PointCloud:
    measured = seen.select(seen.verdict == MEASURED)
    flat = np.full((len(measured.trigger_id), 2), 0.012)
    sigmas = NoiseModel(angle_rad=ANGLE_RAD).centroid_sigmas(calibration, CentroidNoise(flat, flat))
    found = Triangulator(calibration).triangulate(measured.left_px, measured.right_px, *sigmas)
    points, covariances = np.empty_like(found.points), np.empty_like(found.covariances)
    for angle in np.unique(measured.table_deg):
        here, to_object = measured.table_deg == angle, calibration.rig_to_object(float(angle))
        points[here], covariances[here] = to_object.apply(found.points[here]), to_object.rotate_covariances(found.covariances[here])
    return PointCloud(points, covariances, trigger_ids=measured.trigger_id, table_deg=measured.table_deg)
