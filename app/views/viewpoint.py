"""Where things of the scene appear in the picture, and what lies behind a place of the picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonMath import vtkMatrix4x4

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Viewpoint:
    """A camera together with the rectangle that its picture fills, in the widget's own pixels (y down).

    Attributes
    ----------
    matrix, inverse : (4, 4), from the scene to -1..1 (depth too) and back
    left, top, width, height : of the picture
    eye, direction : (3,) of the camera
    """

    matrix: Array
    inverse: Array
    left: float
    top: float
    width: float
    height: float
    eye: Array
    direction: Array

    @classmethod
    def of(cls, camera: Any, left: float, top: float, width: float, height: float) -> Viewpoint:
        forward = camera.GetCompositeProjectionTransformMatrix(width / max(height, 1.0), -1.0, 1.0)
        back = vtkMatrix4x4()
        vtkMatrix4x4.Invert(forward, back)
        matrix, inverse = (np.array([[m.GetElement(i, j) for j in range(4)] for i in range(4)]) for m in (forward, back))
        return cls(matrix, inverse, left, top, width, height, np.array(camera.GetPosition()), np.array(camera.GetDirectionOfProjection()))

    def project(self, points: Array) -> Array:
        """(n, 2) pixels of points (n, 3) mm."""
        clip = points @ self.matrix[:, :3].T + self.matrix[:, 3]
        flat = clip[:, :2] / np.where(np.abs(clip[:, 3:]) < 1e-12, 1e-12, clip[:, 3:])
        return np.column_stack([self.left + 0.5 * self.width * (1 + flat[:, 0]), self.top + 0.5 * self.height * (1 - flat[:, 1])])

    def ray(self, x: float, y: float) -> tuple[Array, Array]:
        """The line of sight through a pixel: its ends on the nearest and the farthest plane of the picture, each (3,) mm."""
        near, far = self.back(np.array([[x, y], [x, y]]), np.array([-1.0, 1.0]))
        return near, far

    def back(self, places: Array, depths: Array | float) -> Array:
        """Points (n, 3) mm at pixels (n, 2) and depths -1 (nearest plane) to 1 (farthest)."""
        flat = np.empty((len(places), 4))
        flat[:, 0] = 2 * (places[:, 0] - self.left) / self.width - 1
        flat[:, 1] = 1 - 2 * (places[:, 1] - self.top) / self.height
        flat[:, 2], flat[:, 3] = depths, 1.0
        ends = flat @ self.inverse.T
        return np.asarray(ends[:, :3] / ends[:, 3:], np.float64)

    def ahead(self, points: Array) -> NDArray[np.bool_]:
        """Which of points (n, 3) mm lie before the eye and not behind it."""
        return np.asarray(points @ self.matrix[3, :3] + self.matrix[3, 3] > 1e-6)

    def near(self, points: Array) -> Array:
        """Where (n, 3) mm the lines of sight to points (n, 3) mm begin: on the nearest plane of the picture."""
        return self.back(self.project(points), -1.0)

    def within(self, places: Array) -> NDArray[np.bool_]:
        """Which of pixels (n, 2) the picture holds."""
        low = np.array([self.left, self.top])
        return np.asarray(((places >= low) & (places < low + np.array([self.width, self.height]))).all(axis=1))

    def contains(self, x: float, y: float) -> bool:
        return bool(self.within(np.array([[x, y]]))[0])

    def pixels_per_mm(self, at: Array) -> float:
        """How many pixels a millimetre across the line of sight takes at a point (3,)."""
        across = np.cross(self.direction, [0.0, 0.0, 1.0] if abs(self.direction[2]) < 0.9 else [1.0, 0.0, 0.0])
        across /= np.sqrt(across @ across)
        ends = self.project(np.array([at, at + across]))
        return float(np.hypot(*(ends[1] - ends[0])))
