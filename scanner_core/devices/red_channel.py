"""From the frame of a colour or monochrome camera to the image that is measured."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray


def red_channel(frame: NDArray[Any]) -> NDArray[np.uint8]:
    """The red channel of a frame as OpenCV gives it: (H, W, 3) or (H, W, 4) uint8 BGR, or (H, W) as it is.

    The laser is red.  On a colour camera it fills red up to 255 where the luminance Y = 0.30 R + 0.59 G + 0.11 B stands at
    about 90: in Y a clipped spot looks like an exposed one, and every automatic exposure would clip it.  What red costs is
    the chroma, which YUYV and MJPG carry at half the resolution; the printed board is grey, there red equals Y.  A monochrome
    camera gives three equal channels.

    Raises
    ------
    ValueError
        It is of another kind; the text says which.
    """
    if frame.dtype != np.uint8:
        raise ValueError(f"{8 * frame.dtype.itemsize} bits a pixel, 8 are needed")
    if frame.ndim == 2 and frame.shape[0] > 1:
        return frame
    if frame.ndim == 3 and frame.shape[2] == 1:
        return np.ascontiguousarray(frame[:, :, 0])
    if frame.ndim == 3 and frame.shape[2] in (3, 4):
        return np.asarray(cv2.extractChannel(frame, 2), np.uint8)
    raise ValueError(f"an array of shape {'x'.join(map(str, frame.shape))}, no image")
