"""Where the beam really starts and points, from places that it lit: the rig file knows it to a few millimetres only.

Bundle of rays: pivot and direction at X0 Y0 are moved so that the angles which were commanded point at the places that were
measured; a prior keeps what a few places do not tell.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.devices.laser_config import LaserConfig

Array = NDArray[np.float64]

_PRIOR_MM = 3.0
_AIM_DEG = 0.03
"""What the sweep's start and a spot's own size leave."""
_ROUNDS = 4
_STEP_MM = 0.1


def corrected_laser(laser: LaserConfig, places: Array, angles_deg: Array) -> LaserConfig:
    """The laser as it lit places (n, 3) mm of the table frame under commanded angles (n, 2) degrees."""
    moved = np.zeros(6)
    for _ in range(_ROUNDS):
        base = beam_angles(_moved(laser, moved), places)
        residual = ((angles_deg - base) / _AIM_DEG).ravel()
        jacobian = np.stack(
            [((beam_angles(_moved(laser, moved + step), places) - base) / (_AIM_DEG * _STEP_MM)).ravel() for step in _STEP_MM * np.eye(6)], axis=1
        )
        normal = jacobian.T @ jacobian + np.eye(6) / _PRIOR_MM**2
        moved = moved + np.linalg.solve(normal, jacobian.T @ residual - moved / _PRIOR_MM**2)
    return _moved(laser, moved)


def _moved(laser: LaserConfig, by: Array) -> LaserConfig:
    x, y, z = (np.array(laser.position_mm) + by[:3]).tolist()
    u, v, w = (np.array(laser.target_mm) + by[3:]).tolist()
    return replace(laser, position_mm=(x, y, z), target_mm=(u, v, w))
