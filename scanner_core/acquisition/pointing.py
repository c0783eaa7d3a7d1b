"""Brings the spot to a place in a camera's picture, by what that camera sees: neither calibration nor the beam's geometry is needed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.exposing import light
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.optics.spot import Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector

Array = NDArray[np.float64]

NEAR_PX = 2.0
_PROBE_DEG = 0.4
_LONGEST_DEG = 6.0
"""A step: what was learned of the surface here says little of it farther away."""
_STEPS = 8
_HEIGHTS = (0.12, 0.08, 0.2, 0.05, 0.3, 0.45, 0.6)
"""Of the volume, above the middle of the table: an impression is low, a model high."""


def point_at(rig: OpenRig, side: str, pixel: tuple[float, float], cancelled: IsCancelled = lambda: False) -> float | None:
    """How far from the pixel the spot has come to lie, px; None when the camera sees no spot to begin with.  The laser stays lit.

    The way is the secant method of Broyden (Math. Comp. 19, 1965) after one small step along each axis.  Where the spot gets out of
    sight (behind the object, beside it) the last step is halved; it rests at the nearest place that was seen.

    Raises
    ------
    DeviceError, Cancelled
    """
    detector, camera = SpotDetector(rig.config.spot), rig.left if side == "left" else rig.right
    limits = np.array([rig.config.limits.x_deg, rig.config.limits.y_deg])
    target = np.array(pixel)

    def seen_at(place: Array) -> Array | None:
        if cancelled():
            raise Cancelled
        light(rig, (float(place[0]), float(place[1])))
        return _place_of(detector.detect(camera.grab().image))

    status = rig.motion.status()
    place = np.array([status.x_deg, status.y_deg])
    here = seen_at(place)
    if here is None:
        return None
    slope = np.zeros((2, 2))
    for axis in (0, 1):
        for step in (_PROBE_DEG, -_PROBE_DEG):
            there = place.copy()
            there[axis] = np.clip(place[axis] + step, *limits[axis])
            moved = seen_at(there)
            if moved is not None and there[axis] != place[axis]:
                slope[:, axis] = (moved - here) / (there[axis] - place[axis])
                break
    for _ in range(_STEPS):
        if np.hypot(*(target - here)) < NEAR_PX or abs(np.linalg.det(slope)) < 1e-9:
            break
        step_deg = np.linalg.solve(slope, target - here)
        step_deg *= min(1.0, _LONGEST_DEG / max(float(np.hypot(*step_deg)), 1e-12))
        there, moved = place, None
        for _ in range(3):
            there = np.clip(place + step_deg, limits[:, 0], limits[:, 1])
            moved = seen_at(there)
            if moved is not None:
                break
            step_deg /= 2
        taken = there - place
        if moved is None or not taken.any():
            break
        slope += np.outer(moved - here - slope @ taken, taken) / float(taken @ taken)
        if np.hypot(*(target - moved)) >= np.hypot(*(target - here)):
            break
        place, here = there, moved
    light(rig, (float(place[0]), float(place[1])))
    return float(np.hypot(*(target - here)))


def _place_of(seen: Spot | SpotMiss) -> Array | None:
    if isinstance(seen, SpotMiss):
        return None
    return np.array([seen.x_px, seen.y_px])


def find_object(rig: OpenRig, cancelled: IsCancelled = lambda: False) -> bool:
    """Light the laser and look where it is; where not both cameras see the spot, try the places about which objects stand.

    The laser stays lit, at the first place that both see, or where it was.

    Raises
    ------
    DeviceError, Cancelled
    """
    detector, status = SpotDetector(rig.config.spot), rig.motion.status()
    here = status.x_deg, status.y_deg
    volume = rig.config.volume
    up = np.array([[0.0, 0.0, share * volume.height_mm] for share in _HEIGHTS])
    towards = [(float(x), float(y)) for x, y in beam_angles(rig.config.laser, up)]
    for place in (here, *towards):
        if cancelled():
            raise Cancelled
        if not all(low <= value <= high for value, (low, high) in zip(place, (rig.config.limits.x_deg, rig.config.limits.y_deg), strict=True)):
            continue
        light(rig, place)
        if all(isinstance(detector.detect(camera.grab().image), Spot) for camera in (rig.left, rig.right)):
            return True
    light(rig, here)
    return False
