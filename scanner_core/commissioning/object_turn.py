"""Which way and how far the table turns, by the object that stands on it: for a calibrated rig without the board.

The beam sweeps some rows over the object, the table turns a little, and they are swept again.  The turn about the calibrated axis
that lays the second view's points onto the first view's surface is what the table did.  After a whole turn the views are compared
once more: the same small error of angle then stands over 360 degrees.  An object that looks the same after a turn tells nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.exposure_run import expose_run
from scanner_core.commissioning.rig_findings import AxisFinding
from scanner_core.commissioning.sighting import Place
from scanner_core.geometry.local_surface import LocalSurface
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.optics.triangulation import EpipolarGate, Triangulator

Array = NDArray[np.float64]

_ROWS_DEG = tuple(0.2 * k for k in range(-7, 8))
_HALF_DEG = 2.5
_SPEED_DEG_S = 5.0
_SPARE_S = 0.4
_TURN_DEG = 12.0
_SEARCH_DEG, _SEARCH_STEP_DEG = 40.0, 1.0
_FINE_STEP_DEG = 0.25
_LEAST_POINTS = 60
_LEAST_VALID = 0.3
_CORRELATED = 4.0
"""Points on neighbouring rows err alike, and a surface that is sampled so coarsely is not known between its rows."""
_LEAST_CONTRAST = 4.0
"""Mean square distance at a wrong turn over that at the right one."""
_LEAST_MOVED_DEG = 1.0


@dataclass(frozen=True, slots=True)
class _Turn:
    angle_deg: float
    uncertainty_deg: float


def measure_table_by_object(rig: OpenRig, place: Place, cancelled: IsCancelled) -> AxisFinding | None:
    """Turn the object a little, and once round; None where it does not tell (no calibration, too few points, a symmetric shape).

    Parameters
    ----------
    place : where both cameras see the spot on it

    Raises
    ------
    DeviceError, Cancelled
    """
    if rig.calibration is None:
        return None
    began_deg = rig.motion.status().table_deg
    before = _view(rig, place, cancelled)
    if len(before) < _LEAST_POINTS:
        return None
    surface = LocalSurface(before)
    rest = np.sqrt(_mean_square(surface, before[::2], 0.0, 0.5) or np.inf)
    turned = _mean_square(surface, before[::2], _TURN_DEG, 0.5)
    if turned is not None and turned < _LEAST_CONTRAST * rest**2:
        return None
    limits = rig.config.limits.table_deg
    finding: AxisFinding | None = None
    small: _Turn | None = None
    try:
        for commanded in (_TURN_DEG, 360.0):
            if limits is not None and not limits[0] <= began_deg + commanded <= limits[1]:
                break
            rig.motion.rotate_to(began_deg + commanded)
            turn = _turn(surface, _view(rig, place, cancelled))
            if turn is None:
                break
            angle = turn.angle_deg
            if small is None:
                if abs(angle) < _LEAST_MOVED_DEG:
                    finding = AxisFinding("table", None)
                    break
                small = turn
                finding = AxisFinding("table", 1 if angle > 0 else -1, abs(angle) / commanded, turn.uncertainty_deg / commanded)
                continue
            expected, uncertain = commanded * small.angle_deg / _TURN_DEG, commanded * small.uncertainty_deg / _TURN_DEG
            angle += 360.0 * round((expected - angle) / 360.0)
            if abs(angle - expected) < 4 * uncertain < 120.0:
                finding = AxisFinding("table", 1 if angle > 0 else -1, abs(angle) / commanded, turn.uncertainty_deg / commanded)
    finally:
        rig.motion.laser(False)
    rig.motion.rotate_to(began_deg)
    return finding


def _view(rig: OpenRig, place: Place, cancelled: IsCancelled) -> Array:
    """Points (n, 3) mm of some rows over the object, in the table frame."""
    (x_low, x_high), (y_low, y_high) = rig.config.limits.x_deg, rig.config.limits.y_deg
    speed = min(_SPEED_DEG_S, rig.config.limits.sweep_speed_deg_s)
    begin, end = max(x_low, place[0] - _HALF_DEG), min(x_high, place[0] + _HALF_DEG)
    count = int(((end - begin) / speed + _SPARE_S) * min(rig.left.rate_hz, rig.right.rate_hz))
    pairs = []
    for number, row in enumerate(np.clip(np.array(_ROWS_DEG) + place[1], y_low, y_high).tolist()):
        if cancelled():
            raise Cancelled
        ends = (begin, end) if number % 2 == 0 else (end, begin)
        rig.motion.aim(ends[0], row)

        def along(target: Place = (ends[1], row)) -> None:
            rig.motion.sweep(*target, speed)
            rig.motion.wait_idle(4 * (end - begin) / speed + 5.0)

        runs = expose_run(rig, count, along, cancelled)
        left, right = runs["left"].spots, runs["right"].spots
        pairs += [(left[k], right[k]) for k in sorted(left.keys() & right.keys())]
    if not pairs or rig.calibration is None:
        return np.empty((0, 3))
    places = [np.array([[spot.x_px, spot.y_px] for spot in side]) for side in zip(*pairs, strict=True)]
    sigmas = [np.array([spot.standard_uncertainty_px for spot in side]) for side in zip(*pairs, strict=True)]
    found = Triangulator(rig.calibration).triangulate(*places, *sigmas)
    good = EpipolarGate(floor_px=0.5).accepts(found.epipolar_residual_px, *sigmas)
    return np.asarray(rig.calibration.rig_to_table().apply(found.points[good]), np.float64)


def _turn(surface: LocalSurface, points: Array) -> _Turn | None:
    """The turn about the table's axis that took the surface to the points; None where several are as good."""
    if len(points) < _LEAST_POINTS:
        return None
    angles = np.arange(-_SEARCH_DEG, _SEARCH_DEG + 0.5 * _SEARCH_STEP_DEG, _SEARCH_STEP_DEG)
    coarse = np.array([_mean_square(surface, points, -angle) or np.inf for angle in angles.tolist()])
    if not np.isfinite(coarse).any():
        return None
    best = float(angles[np.argmin(coarse)])
    fine = best + _FINE_STEP_DEG * np.arange(-6, 7)
    squares = np.array([_mean_square(surface, points, -angle) or np.inf for angle in fine.tolist()])
    if not np.isfinite(squares).all():
        return None
    curvature, slope, _ = np.polyfit(fine - best, squares, 2)
    if curvature <= 0:
        return None
    least = max(1e-6, float(np.min(squares)))
    uncertainty = _CORRELATED * float(np.sqrt(least / (len(points) * curvature)))
    away = np.abs(angles - best) >= 0.5 * _TURN_DEG
    if uncertainty > 0.2 * _TURN_DEG or np.min(coarse[away], initial=np.inf) < _LEAST_CONTRAST * least:
        return None
    return _Turn(best - 0.5 * float(slope / curvature), uncertainty)


def _mean_square(surface: LocalSurface, points: Array, turn_deg: float, apart_mm: float = 0.0) -> float | None:
    """Trimmed mean square distance, mm^2, of the points, turned, to the surface; None where too few lie over it."""
    distance = surface.distance(RigidTransform.about_z(turn_deg).apply(points), apart_mm)
    signed = distance.signed_mm[distance.valid]
    if len(signed) < _LEAST_VALID * len(points):
        return None
    squares = np.sort(signed**2)
    return float(squares[: max(1, int(0.9 * len(squares)))].mean())
