"""The result of calibrating a rig: two cameras and the turntable's axis."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.camera_model import CameraModel

Array = NDArray[np.float64]


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
    """

    left: CameraModel
    right: CameraModel
    turntable: TurntableAxis
    date: str
    views: int
    reprojection_rms_px: float
    held_out_rms_um: float
    notes: dict[str, float] = field(default_factory=dict)

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
        """A short hash of everything that changes a measured point: the calibration's id in case and rig files."""
        digest = hashlib.sha256()
        for camera in (self.left, self.right):
            for part in (camera.matrix, camera.distortion, camera.rotation, camera.translation):
                digest.update(np.ascontiguousarray(part, np.float64).tobytes())
        digest.update(np.ascontiguousarray(np.r_[self.turntable.origin, self.turntable.direction], np.float64).tobytes())
        return digest.hexdigest()[:16]
