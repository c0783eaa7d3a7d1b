"""Which way and how far the table turns, by the calibration board that lies on it; no calibration is needed.

A board that lies on the table moves within its own plane.  With H the homography from the board's plane (mm) to an image,
``inv(H before) H after`` is therefore the motion of the board in its own coordinates, a turn about the table's axis, whatever the
camera and wherever it stands (Hartley & Zisserman, Multiple View Geometry, ch. 2 and 8): its angle is the table's.  The board's
frame has z away from who looks at its face, so a table that turns counter-clockwise as seen from above turns it by negative angles.
A lens's distortion disturbs the homography by some tenths of a degree; with a calibration it is removed first.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.rig_findings import AxisFinding
from scanner_core.devices.camera import Camera
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.optics.board import DEFAULT_TARGET, CharucoTarget
from scanner_core.optics.board_detection import detect_board
from scanner_core.optics.board_view import BoardMiss

Array = NDArray[np.float64]

_TURNS_DEG = (10.0, 60.0, 200.0, 360.0)
"""Small ones first: what they tell says by how many whole turns the larger ones are ambiguous."""
_NOISE_DEG = 0.05
_DISTORTED_DEG = 0.3
"""Standard uncertainty of an angle, with and without a calibrated lens."""
_LEAST_MOVED_DEG = 1.0
_MOST_STRETCH = 0.1
"""Of a motion that is a turn in its own plane."""


def board_in_sight(rig: OpenRig) -> bool:
    """Whether a camera sees the calibration board.

    Raises
    ------
    DeviceError
    """
    return any(_homography(rig, camera, DEFAULT_TARGET) is not None for camera in (rig.left, rig.right))


def measure_table(rig: OpenRig, cancelled: IsCancelled, target: CharucoTarget = DEFAULT_TARGET) -> AxisFinding | None:
    """Turn the table once round, with the board on it; None where the board was not seen to turn in its own plane.

    Raises
    ------
    DeviceError, Cancelled
        The table stands where it stopped.
    """
    began_deg = rig.motion.status().table_deg
    limits = rig.config.limits.table_deg
    watching = next(((camera, h) for camera in (rig.left, rig.right) if (h := _homography(rig, camera, target)) is not None), None)
    if watching is None:
        return None
    camera, before = watching
    commanded, seen = [], []
    ratio: float | None = None
    for turn in _TURNS_DEG:
        if cancelled():
            raise Cancelled
        if limits is not None and not limits[0] <= began_deg + turn <= limits[1]:
            break
        rig.motion.rotate_to(began_deg + turn)
        after = _homography(rig, camera, target)
        angle = None if after is None else turned_deg(before, after)
        if angle is None:
            continue
        if ratio is not None:
            angle += 360.0 * round((ratio * turn - angle) / 360.0)
        commanded.append(turn)
        seen.append(angle)
        at, found = np.array(commanded), np.array(seen)
        ratio = float(at @ found / (at @ at))
    rig.motion.rotate_to(began_deg)
    if ratio is None or not seen:
        return None
    at, found = np.array(commanded), np.array(seen)
    if np.abs(found).max() < _LEAST_MOVED_DEG:
        return AxisFinding("table", None)
    rest = found - ratio * at
    noise = _NOISE_DEG if rig.calibration is not None else _DISTORTED_DEG
    noise = max(noise, float(np.sqrt((rest**2).sum() / max(1, len(at) - 1))))
    uncertainty = noise / float(np.sqrt(at @ at))
    linearity = float(np.abs(rest).max() / np.abs(found).max())
    return AxisFinding("table", 1 if ratio > 0 else -1, abs(ratio), uncertainty, linearity)


def turned_deg(before: Array, after: Array) -> float | None:
    """Angle of the table between two homographies (3, 3), counter-clockwise as seen from above, -180 to 180; None when it is no turn."""
    motion = np.linalg.solve(before, after)
    motion = motion / motion[2, 2]
    linear = motion[:2, :2]
    stretch = np.linalg.svd(linear, compute_uv=False)
    if np.linalg.det(linear) <= 0 or abs(stretch - 1).max() > _MOST_STRETCH:
        return None
    return -float(np.degrees(np.arctan2(linear[1, 0] - linear[0, 1], linear[0, 0] + linear[1, 1])))


def _homography(rig: OpenRig, camera: Camera, target: CharucoTarget) -> Array | None:
    """From the board's plane in mm to the image: to pixels, or with a calibration to undistorted normalized coordinates."""
    view = detect_board(camera.grab().image, target)
    if isinstance(view, BoardMiss):
        return None
    pixels = view.corners_px
    if rig.calibration is not None:
        pixels = (rig.calibration.left if camera.name == "left" else rig.calibration.right).normalize(pixels)
    homography, _ = cv2.findHomography(target.object_points[view.ids, :2], pixels, 0)
    return None if homography is None else np.asarray(homography, np.float64)
