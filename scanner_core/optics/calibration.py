"""The result of calibrating a rig: two cameras and the turntable's axis."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.camera_model import CameraModel

Array = NDArray[np.float64]

VALID_DAYS = 30.0
"""How long a calibration is trusted unless the rig says otherwise: mounts creep, and somebody will have leant on one."""


@dataclass(frozen=True, slots=True, eq=False)
class TurntableAxis:
    """Where the table turns, in the rig frame.

    Attributes
    ----------
    origin : (3,) mm, where the axis meets the table's surface
    direction : (3,) unit vector, up
    angle_rms_deg, position_rms_um : residuals of the fit
    """

    origin: Array
    direction: Array
    angle_rms_deg: float = 0.0
    position_rms_um: float = 0.0


@dataclass(frozen=True, slots=True)
class ScaleReference:
    """What the calibration's millimetres rest on.

    Attributes
    ----------
    source : ``bar`` (a certified length before the cameras), ``print`` (a length measured on the print with a caliper),
        or ``none`` (the board's nominal size was believed)
    length_mm : the known length, 0 without one
    uncertainty_ppm : standard uncertainty of all lengths that comes from it
    print_scale : size of the board as measured over its nominal size; 1 without a known length
    held_out_ppm : relative error of the known length where it took no part, and its standard uncertainty; None unless a bar was shown
    """

    source: str
    length_mm: float
    uncertainty_ppm: float
    print_scale: float
    held_out_ppm: tuple[float, float] | None = None

    @property
    def verified(self) -> bool:
        return self.source == "bar"


@dataclass(frozen=True, slots=True, eq=False)
class StereoCalibration:
    """All that is needed to turn two centroids and a table angle into a point.

    Attributes
    ----------
    left, right : the cameras; the rig frame is the left camera's frame
    turntable : the table's axis
    date : ISO 8601
    views : stereo views used in the fit
    reprojection_rms_px : of the fit
    held_out_rms_um : error on board corners that were not used in the fit
    scale : what the lengths rest on, or None in calibrations that did not say
    modes : (k, 30), or None; a square root of the covariance of the parameters: the sum over the rows of their outer
        products, in the order fx, fy, cx, cy, k1, k2, p1, p2, k3 of the left camera, the same of the right, rotation vector
        (rad) and translation (mm) of the right camera, origin (mm) and direction of the axis; see
        :mod:`scanner_core.optics.calibration_uncertainty`
    valid_days : how long it may be used
    """

    left: CameraModel
    right: CameraModel
    turntable: TurntableAxis
    date: str
    views: int
    reprojection_rms_px: float
    held_out_rms_um: float
    scale: ScaleReference | None = None
    modes: Array | None = None
    valid_days: float = VALID_DAYS

    def rig_to_table(self) -> RigidTransform:
        """Rig frame to table frame (the object frame when the table stands at 0 degrees)."""
        z = self.turntable.direction / np.linalg.norm(self.turntable.direction)
        middle = 0.5 * (self.left.centre_mm() + self.right.centre_mm()) - self.turntable.origin
        x = middle - (middle @ z) * z
        x /= np.linalg.norm(x)
        rotation = np.stack([x, np.cross(z, x), z])
        return RigidTransform(rotation, -rotation @ self.turntable.origin)

    def rig_to_object(self, table_deg: float) -> RigidTransform:
        """Rig frame to object frame when the table stands at `table_deg`."""
        return RigidTransform.about_z(-table_deg) @ self.rig_to_table()

    def identity(self) -> str:
        """A short hash of everything that changes a measured point or its uncertainty: the calibration's id in case and rig files."""
        digest = hashlib.sha256()
        for camera in (self.left, self.right):
            for part in (camera.matrix, camera.distortion, camera.rotation, camera.translation):
                digest.update(np.ascontiguousarray(part, np.float64).tobytes())
        digest.update(np.ascontiguousarray(np.r_[self.turntable.origin, self.turntable.direction], np.float64).tobytes())
        if self.modes is not None:
            digest.update(np.ascontiguousarray(self.modes, np.float64).tobytes())
        return digest.hexdigest()[:16]
