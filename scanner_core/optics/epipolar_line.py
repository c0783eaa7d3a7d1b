"""Where the spot of one camera can lie in the other: the picture of its ray, bent as the lens bends it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.camera_model import CameraModel

Array = NDArray[np.float64]

_NEAREST_MM, _FARTHEST_MM = 50.0, 10_000.0
_STEPS = 400
_BEYOND = 1.05
"""The lens model holds out to the corners of the picture; so much beyond them it may fold back into it."""


def epipolar_line(seen_by: CameraModel, shown_in: CameraModel, pixel: tuple[float, float]) -> Array:
    """The epipolar line (n, 2) px in `shown_in` of a pixel of `seen_by`, as a polyline that ends at the picture's border.

    (0, 2) where the ray stays out of the picture.
    """
    x, y = seen_by.normalize(np.array([pixel]))[0]
    depths = 1.0 / np.linspace(1 / _NEAREST_MM, 1 / _FARTHEST_MM, _STEPS)  # even steps in the picture, nearly
    along = np.c_[x * depths, y * depths, depths]
    points = (along - seen_by.translation) @ seen_by.rotation
    camera = points @ shown_in.rotation.T + shown_in.translation
    ahead = camera[:, 2] > _NEAREST_MM
    points, camera = points[ahead], camera[ahead]
    width, height = shown_in.size_px
    corners = shown_in.normalize(np.array([[0, 0], [width, 0], [0, height], [width, height]], np.float64))
    reach = _BEYOND * float(np.hypot(corners[:, 0], corners[:, 1]).max())
    sharp = np.hypot(camera[:, 0], camera[:, 1]) <= reach * camera[:, 2]
    if not sharp.any():
        return np.empty((0, 2))
    line = shown_in.project(points[sharp])
    inside = (line[:, 0] >= -0.5) & (line[:, 0] <= width - 0.5) & (line[:, 1] >= -0.5) & (line[:, 1] <= height - 0.5)
    rows = np.flatnonzero(inside)
    if not len(rows):
        return np.empty((0, 2))
    return np.asarray(line[rows[0] : rows[-1] + 1], np.float64)
