"""A calibrated camera: the pinhole model with radial and tangential distortion (Brown 1971), as OpenCV has it."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class CameraModel:
    """Intrinsics and pose of one camera.

    Attributes
    ----------
    matrix : (3, 3), focal lengths and principal point in px; fx and fy are independent (pixels are not square)
    distortion : (5,), k1 k2 p1 p2 k3
    rotation, translation : camera = rotation @ rig + translation; (3, 3) and (3,) mm
    size_px : width and height
    """

    matrix: Array
    distortion: Array
    rotation: Array
    translation: Array
    size_px: tuple[int, int]

    def centre_mm(self) -> Array:
        """The projection centre in the rig frame, (3,) mm."""
        return np.asarray(-self.rotation.T @ self.translation, np.float64)

    def projection(self) -> Array:
        """(3, 4): rig frame in mm to normalized image coordinates."""
        return np.asarray(np.c_[self.rotation, self.translation], np.float64)

    def project(self, points: Array) -> Array:
        """Pixels (n, 2) of rig-frame points (n, 3) mm."""
        camera = points @ self.rotation.T + self.translation
        x, y = camera[:, 0] / camera[:, 2], camera[:, 1] / camera[:, 2]
        k1, k2, p1, p2, k3 = self.distortion
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
        yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
        pixels = np.c_[self.matrix[0, 0] * xd + self.matrix[0, 2], self.matrix[1, 1] * yd + self.matrix[1, 2]]
        return np.asarray(pixels, np.float64)

    def normalize(self, pixels: Array) -> Array:
        """Undistorted normalized image coordinates (n, 2) of pixels (n, 2)."""
        criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 20, 1e-10)
        points = np.ascontiguousarray(pixels, np.float64).reshape(-1, 1, 2)
        undistorted = cv2.undistortPoints(points, self.matrix, self.distortion, None, None, None, criteria)
        return np.asarray(undistorted, np.float64).reshape(-1, 2)
