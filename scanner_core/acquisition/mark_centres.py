"""Where the balls on the table's rim are, from what was measured on them: a sphere of known radius through the points of each.

Point to sphere along the radius, weighted by the points' covariances, with robust weights (Tukey's biweight): rows over a
ball also touch the table, and at its limb a spot is half a spot.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import ObservationTable
from scanner_core.devices.marks_config import MarksConfig
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel, along_axes
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]

MIN_POINTS = 10
"""Fewer do not tell a ball from an edge of something else."""
_TUKEY = 4.685
_ROUNDS = 30
_FROM_AFAR = 8
"""Rounds that reject nothing: until the sphere is near, every point is beside it."""
_LEAST_SCATTER_MM = 5e-3
_MOST_SCATTER_MM = 0.2
"""Of the points about the sphere: what scatters more is something else."""
_OVERDISPERSION = 1.3
"""Errors of neighbouring points are not independent: the scatter of clean centres over what independent points predict."""


@dataclass(frozen=True, slots=True, eq=False)
class MarkCentre:
    """One ball as it was seen on one visit.

    Attributes
    ----------
    number : of the ball, from 0
    centre : (3,) mm, object frame by the table's reading
    covariance : (3, 3) mm^2, by the points' scatter; without the calibration's part
    points : that lie on the ball
    scatter_mm : of them about the sphere, along the radius
    """

    number: int
    centre: Array
    covariance: Array
    points: int
    scatter_mm: float


def mark_points(table: ObservationTable, rig: RigConfig, calibration: StereoCalibration) -> tuple[Array, Array]:
    """Points (n, 3) mm of the object frame and their covariances (n, 3, 3) mm^2 by the centroids' noise."""
    pixels = CentroidNoise(along_axes(table.left_uncertainty_px, table.left_sigma_px), along_axes(table.right_uncertainty_px, table.right_sigma_px))
    sigmas = NoiseModel.prior(calibration, rig.spot.floor_px).centroid_sigmas(calibration, pixels)
    seen = Triangulator(calibration).triangulate(table.left_px, table.right_px, *sigmas)
    points, covariances = np.empty_like(seen.points), np.empty_like(seen.covariances)
    for table_deg in np.unique(table.table_deg):
        here = table.table_deg == table_deg
        transform = calibration.rig_to_object(float(table_deg))
        points[here], covariances[here] = transform.apply(seen.points[here]), transform.rotate_covariances(seen.covariances[here])
    return points, covariances


def mark_centres(table: ObservationTable, rig: RigConfig, calibration: StereoCalibration) -> list[MarkCentre]:
    """The balls that one visit shows, in the order of their numbers; all observations are of one table position."""
    marks = rig.marks
    if marks is None or not len(table):
        return []
    points, covariances = mark_points(table, rig, calibration)
    of = nearest_mark(marks, points)
    towards = calibration.rig_to_object(float(table.table_deg[0])).apply(_between(calibration)[None])[0]
    found = [_centre(marks, number, points[of == number], covariances[of == number], towards) for number in range(len(marks.places_mm()))]
    return [centre for centre in found if centre is not None]


def nearest_mark(marks: MarksConfig, points: Array) -> NDArray[np.int64]:
    """Number (n,) of the ball whose place is nearest to each point (n, 3) mm of the object frame."""
    away = np.linalg.norm(points[:, None, :] - marks.places_mm(), axis=2)
    nearest: NDArray[np.int64] = away.argmin(axis=1)
    return nearest


def _between(calibration: StereoCalibration) -> Array:
    """The middle between the cameras, rig frame: what is seen of a ball faces it."""
    middle: Array = 0.5 * (calibration.left.centre_mm() + calibration.right.centre_mm())
    return middle


def _centre(marks: MarksConfig, number: int, points: Array, covariances: Array, towards: Array) -> MarkCentre | None:
    if len(points) < MIN_POINTS:
        return None
    radius = marks.ball_radius_mm
    middle = np.median(points, axis=0)
    centre = middle - radius * (towards - middle) / np.linalg.norm(towards - middle)
    information, scatter, on_ball = np.eye(3), np.inf, np.zeros(len(points), bool)
    for turn in range(_ROUNDS):
        away = points - centre
        distance = np.linalg.norm(away, axis=1)
        normals = away / np.maximum(distance, 1e-9)[:, None]
        sigma = np.sqrt(np.einsum("ni,nij,nj->n", normals, covariances, normals))
        residual = distance - radius
        ratio = residual / sigma
        spread = max(1.4826 * float(np.median(np.abs(ratio))), _LEAST_SCATTER_MM / float(np.median(sigma)))
        u = np.abs(ratio) / (_TUKEY * spread)
        robust = 1.0 / np.maximum(1.0, np.abs(ratio) / spread) if turn < _FROM_AFAR else np.where(u < 1, (1 - u * u) ** 2, 0.0)
        weight = robust / (spread * sigma) ** 2
        information = (normals * weight[:, None]).T @ normals
        if np.linalg.eigvalsh(information)[0] < 1e-2:  # nothing holds it in some direction
            return None
        step = np.linalg.solve(information, (normals * weight[:, None]).T @ residual)
        centre = centre + step
        on_ball, scatter = u < 1, spread * float(np.median(sigma))
        if turn > _FROM_AFAR and float(np.abs(step).max()) < 1e-5:
            break
    if np.count_nonzero(on_ball) < MIN_POINTS or scatter > _MOST_SCATTER_MM:
        return None
    covariance = np.asarray(_OVERDISPERSION**2 * np.linalg.inv(information), np.float64)
    return MarkCentre(number, centre, covariance, int(np.count_nonzero(on_ball)), scatter)
