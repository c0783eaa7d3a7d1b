"""Where to point the beam.

The mover is open-loop: the cameras measure where the spot is, so the nominal geometry of the rig file only has to be
good enough to cover the object.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.laser_config import LaserConfig

Array = NDArray[np.float64]


def beam_angles(laser: LaserConfig, points: Array) -> Array:
    """Pan X and tilt Y in degrees, (n, 2), that point the beam at table-frame points (n, 3) mm.

    X is the difference of azimuth and Y of elevation from the direction to the laser's target.
    """
    position = np.array(laser.position_mm)
    azimuth, elevation = _angles(points - position)
    azimuth0, elevation0 = _angles((np.array(laser.target_mm) - position)[None])
    pan = (azimuth - azimuth0 + 180) % 360 - 180
    angles: Array = np.c_[pan, elevation - elevation0]
    return angles


def beam_directions(laser: LaserConfig, angles_deg: Array) -> Array:
    """Unit vectors (n, 3) of the beam in the table frame at pan X and tilt Y, (n, 2): the reverse of :func:`beam_angles`."""
    azimuth0, elevation0 = _angles((np.array(laser.target_mm) - np.array(laser.position_mm))[None])
    azimuth, elevation = np.radians(azimuth0 + angles_deg[:, 0]), np.radians(elevation0 + angles_deg[:, 1])
    return np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)], axis=1)


def cylinder_outline(radius_mm: float, height_mm: float) -> Array:
    """Points (n, 3) mm on the surface of a cylinder that stands on the middle of the table."""
    turn = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    ring = np.c_[radius_mm * np.cos(turn), radius_mm * np.sin(turn)]
    return np.concatenate([np.c_[ring, np.full(len(ring), z)] for z in np.linspace(0, height_mm, 9)])


def row_range(angles: Array, y_deg: float, half_step_deg: float) -> tuple[float, float] | None:
    """Lowest and highest pan of the convex outline `angles` (n, 2) within `half_step_deg` of a row, or None."""
    near = np.abs(angles[:, 1] - y_deg) <= half_step_deg
    if near.sum() < 2:
        return None
    return float(angles[near, 0].min()), float(angles[near, 0].max())


def _angles(directions: Array) -> tuple[Array, Array]:
    azimuth = np.degrees(np.arctan2(directions[:, 1], directions[:, 0]))
    elevation = np.degrees(np.arctan2(directions[:, 2], np.hypot(directions[:, 0], directions[:, 1])))
    return azimuth, elevation
