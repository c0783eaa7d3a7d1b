"""From the frame of a colour or monochrome camera to the image that is measured."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray


def luminance(frame: NDArray[Any]) -> NDArray[np.uint8] | None:
    """The luminance Y = 0.30 R + 0.59 G + 0.11 B of a frame, (H, W) uint8; None of a broken JPEG.

    `frame` is (H, W, 3) or (H, W, 4) uint8 BGR, (H, W) as it is, or (1, n) the bytes of a JPEG, of which Y alone is decoded.

    The laser is red, and in the red channel its spot is three times as bright.  But YUYV and MJPG carry colour at half the
    resolution, and nobody knows where between the pixels: the spot moves by 0.03 to 0.1 px against the printed board, which
    has no colour, and scatters twice as much (tests/bench/cameras/compressed_spots.py: 0.08 px against 0.036 at MJPG 85).  Y
    is what the camera sends for every pixel.  Its price: red clips where Y stands at 90.  In a monochrome camera they are equal.

    Raises
    ------
    ValueError
        The frame is of another kind; the text says which.
    """
    if frame.dtype != np.uint8:
        raise ValueError(f"{8 * frame.dtype.itemsize} bits a pixel, 8 are needed")
    if frame.ndim == 2 and frame.shape[0] == 1:
        decoded = cv2.imdecode(frame, cv2.IMREAD_GRAYSCALE)
        return None if decoded is None else np.asarray(decoded, np.uint8)
    if frame.ndim == 2:
        return frame
    if frame.ndim == 3 and frame.shape[2] == 1:
        return np.ascontiguousarray(frame[:, :, 0])
    if frame.ndim == 3 and frame.shape[2] in (3, 4):
        return np.asarray(cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY if frame.shape[2] == 3 else cv2.COLOR_BGRA2GRAY), np.uint8)
    raise ValueError(f"an array of shape {'x'.join(map(str, frame.shape))}, no image")
