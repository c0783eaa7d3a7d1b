"""A rig with known numbers, for the tests of the optics."""

from __future__ import annotations

import numpy as np

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration, TurntableAxis
from scanner_core.optics.camera_model import CameraModel

DISTANCE_MM = 435.0


def known_rig(half_angle_deg: float = 36.5, elevation_deg: float = 30.0) -> StereoCalibration:
    """Two cameras of the published kind, `DISTANCE_MM` from the table's centre, which lies on both optical axes."""
    matrix = np.array([[850.0, 0.0, 301.5], [0.0, 545.0, 146.5], [0.0, 0.0, 1.0]])
    centre = np.array([0.0, 0.0, DISTANCE_MM])
    e = np.radians(elevation_deg)
    up = np.array([0.0, -np.cos(e), -np.sin(e)])  # the left camera looks down by the elevation
    turn = RigidTransform.from_vector(np.radians(-2 * half_angle_deg) * up, np.zeros(3)).rotation
    return StereoCalibration(
        left=CameraModel(matrix, np.array([-0.08, 0.02, 0.0005, -0.0004, 0.0]), np.eye(3), np.zeros(3), (604, 294)),
        right=CameraModel(matrix * [[1.01], [0.99], [1.0]], np.array([-0.07, 0.01, -0.0003, 0.0002, 0.0]), turn, centre - turn @ centre, (604, 294)),
        turntable=TurntableAxis(centre, up),
        date="2026-01-01",
        views=20,
        reprojection_rms_px=0.1,
        held_out_rms_um=20.0,
    )
