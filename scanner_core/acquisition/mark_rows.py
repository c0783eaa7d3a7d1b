"""Which balls on the table's rim a table position shows, and the rows that the beam sweeps over them.

A ball is visited when beam and cameras look at it past the cylinder that holds the object.  The rows stay on its middle: a
camera looks at the flank of what the beam hits off the middle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.plan import Row
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.devices.rig import RigConfig, VolumeConfig
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

_BORDER_PX = 8.0
_MARGIN_MM = 1.0
_ROWS, _LEAST_ROWS = 12, 4
_MIDDLE = 0.65
"""Of the radius: how far rows go from the middle, to all sides."""


@dataclass(frozen=True, slots=True)
class Pattern:
    """Rows over a ball: where they lie above and below its middle, how far they go to the sides, and the step, all in mm."""

    rows_mm: tuple[float, ...]
    half_width_mm: float
    step_mm: float


def visiting(ball_radius_mm: float, spot_mm: float, balls: int) -> Pattern:
    """For `balls` whose places are known: a dozen rows for all of them, so that one that is seen alone tells as much as three.

    Steps of a spot's diameter: every point has a speckle of its own.
    """
    rows = max(_LEAST_ROWS, _ROWS // max(balls, 1))
    heights = tuple((ball_radius_mm * np.linspace(-_MIDDLE, _MIDDLE, rows)).tolist())
    return Pattern(heights, _MIDDLE * ball_radius_mm, max(spot_mm, ball_radius_mm / 9))


def searching(ball_radius_mm: float) -> Pattern:
    """For one that may be some millimetres beside its nominal place, under a beam that is not where its angles say."""
    reach, step = ball_radius_mm + 3.0, 0.45 * ball_radius_mm
    return Pattern(tuple(np.arange(-reach, reach + 1e-9, step).tolist()), reach, 0.5 * step)


def seen_marks(rig: RigConfig, calibration: StereoCalibration, centres: Array, table_deg: float, obstacle: VolumeConfig) -> list[int]:
    """Numbers of the balls at `centres` (n, 3) mm, object frame, that beam and cameras reach; `obstacle` holds the object."""
    places = RigidTransform.about_z(table_deg).apply(centres)
    to_table = calibration.rig_to_table()
    in_rig = to_table.inverse().apply(places)
    seen = np.ones(len(places), bool)
    eyes = [np.array(rig.laser.position_mm)]
    for camera in (calibration.left, calibration.right):
        pixels, size = camera.project(in_rig), np.array(camera.size_px)
        seen &= ((pixels > _BORDER_PX) & (pixels < size - 1 - _BORDER_PX)).all(axis=1)
        eyes.append(to_table.apply(camera.centre_mm()))
    x_deg, y_deg = beam_angles(rig.laser, places).T
    for angle, (low, high) in ((x_deg, rig.limits.x_deg), (y_deg, rig.limits.y_deg)):
        seen &= (angle > low) & (angle < high)
    for eye in eyes:
        seen &= ~_hidden(places, eye, obstacle.radius_mm + _MARGIN_MM, obstacle.height_mm + _MARGIN_MM)
    return [int(number) for number in np.flatnonzero(seen)]


def mark_rows(
    rig: RigConfig, laser: LaserConfig, places: Sequence[Array], pattern: Pattern, view: int, first_id: int, rate_hz: float
) -> tuple[Row, ...]:
    """Rows over balls at `places` (3,) mm, table frame, with the beam as `laser` says it lies; what is beyond the limits is left out."""
    rows: list[Row] = []
    for place in places:
        x_deg, y_deg = beam_angles(laser, place[None])[0].tolist()
        away = np.asarray(laser.position_mm) - place
        per_mm_x, per_mm_y = np.degrees(1.0 / float(np.hypot(away[0], away[1]))), np.degrees(1.0 / float(np.linalg.norm(away)))
        step = min(pattern.step_mm * per_mm_x, rig.limits.sweep_speed_deg_s / rate_hz)
        for height_mm in pattern.rows_mm:
            y = y_deg + height_mm * per_mm_y
            low = max(x_deg - pattern.half_width_mm * per_mm_x, rig.limits.x_deg[0])
            high = min(x_deg + pattern.half_width_mm * per_mm_x, rig.limits.x_deg[1])
            count = int((high - low) / step) + 1
            if count < 2 or not rig.limits.y_deg[0] <= y <= rig.limits.y_deg[1]:
                continue
            rows.append(Row(view, first_id, count, y, low, low + (count - 1) * step))
            first_id += count
    return tuple(rows)


def beam_of(rows: Sequence[Row], trigger_ids: NDArray[np.int64]) -> Array:
    """Where the beam was to point, (n, 2) degrees, at trigger ids (n,) of the rows."""
    firsts = np.array([row.first_id for row in rows])
    of = np.searchsorted(firsts, trigger_ids, side="right") - 1
    counts = np.array([row.count for row in rows])[of]
    low, high, y = (np.array([getattr(row, name) for row in rows])[of] for name in ("x_from_deg", "x_to_deg", "y_deg"))
    part = (trigger_ids - firsts[of]) / np.maximum(counts - 1, 1)
    angles: Array = np.c_[low + part * (high - low), y]
    return angles


def _hidden(places: Array, eye: Array, radius_mm: float, height_mm: float) -> NDArray[np.bool_]:
    """Whether an upright cylinder on the table stands between places (n, 3) and an eye (3,), both outside of it."""
    d = eye - places
    a = (d[:, :2] ** 2).sum(axis=1)
    b = (places[:, :2] * d[:, :2]).sum(axis=1)
    c = (places[:, :2] ** 2).sum(axis=1) - radius_mm**2
    inside = b * b - a * c
    with np.errstate(invalid="ignore"):
        enters = (-b - np.sqrt(np.maximum(inside, 0.0))) / a
    meets = (inside > 0) & (enters > 0) & (enters < 1)
    hidden: NDArray[np.bool_] = meets & (places[:, 2] + enters * d[:, 2] < height_mm)
    return hidden
