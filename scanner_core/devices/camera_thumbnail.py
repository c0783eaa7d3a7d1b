"""The small picture by which a person tells a camera."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

WIDTH_PX = 320


def camera_thumbnail(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A frame (H, W) uint8 no wider than `WIDTH_PX`."""
    height, width = image.shape
    if width <= WIDTH_PX:
        return image
    size = WIDTH_PX, max(1, round(height * WIDTH_PX / width))
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)
