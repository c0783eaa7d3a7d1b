"""Where the beam really turns, from the points that a scan measured.

The rig file's pivot is nominal, and millimetres wrong; a scan's own points tell it to hundredths, because the plan says where the
beam was told to point at each of them.  With it the beam is as good as a third camera: a spot that only one camera saw has a
place, too (rendered scans: 0.02 mm).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from scanner_core.acquisition.aiming import beam_angles, beam_directions
from scanner_core.devices.laser_config import LaserConfig

Array = NDArray[np.float64]

_LEAST_POINTS = 200
"""Fewer do not tell five numbers reliably: the rig file's stay."""
_USED = 2000
_SCALE_MM = 0.1
"""Residuals beyond are of wrong pairs and weigh less and less."""


@dataclass(frozen=True, slots=True, eq=False)
class BeamFit:
    """The beam as it is.

    Attributes
    ----------
    laser : pivot and target such that :func:`beam_angles` gives what the mover is told
    scatter_mm : rms over the two directions across the beam of what is left
    """

    laser: LaserConfig
    scatter_mm: float


def fit_beam(nominal: LaserConfig, points: Array, told_deg: Array) -> BeamFit | None:
    """The beam of points (n, 3) mm, table frame, that were lit when the mover was told (n, 2) degrees; None for too few."""
    if len(points) < _LEAST_POINTS:
        return None
    every = slice(None, None, -(-len(points) // _USED))
    points, told_deg = points[every], told_deg[every]
    distance = np.linalg.norm(points - np.array(nominal.position_mm), axis=1)[:, None]

    def residuals(change: Array) -> Array:
        moved = _changed(nominal, change)
        across = np.radians(beam_angles(moved, points) - told_deg) * distance
        across[:, 0] *= np.cos(np.radians(told_deg[:, 1]))
        return np.asarray(across.ravel(), np.float64)

    found = least_squares(residuals, np.zeros(5), loss="soft_l1", f_scale=_SCALE_MM, x_scale=np.array([1.0, 1.0, 1.0, 0.1, 0.1]))
    left_over = residuals(found.x)
    return BeamFit(_changed(nominal, found.x), 1.4826 * float(np.median(np.abs(left_over))))


def _changed(nominal: LaserConfig, change: Array) -> LaserConfig:
    """The pivot moved by (3,) mm and its zero direction turned by (2,) degrees."""
    position = np.array(nominal.position_mm) + change[:3]
    away = float(np.linalg.norm(np.subtract(nominal.target_mm, nominal.position_mm)))
    x, y, z = (position + away * beam_directions(nominal, change[None, 3:])[0]).tolist()
    u, v, w = position.tolist()
    return replace(nominal, position_mm=(u, v, w), target_mm=(x, y, z))
