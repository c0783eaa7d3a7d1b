"""Frames that are not one exposure: part of them is an older frame's, or nothing that a lens could have made."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

_ROWS = 8
"""Rows that are looked at, evenly spread."""
_ROUGH_DN = 40.0
"""Mean step between neighbouring pixels of a row beyond which it is no image; uniformly random bytes have 85, noise a few."""
_ALIVE_DN = 2
"""Range of a row that shows noise; of a dark, quiet row nothing can be said."""


class TornFrames:
    """One camera's memory of its last frame; for one thread.

    Two exposures never have the same noise, so a row that repeats the last frame's to the last digit is a copy.  A spot in
    such a frame may belong to another instant: the epipolar gate cannot tell where the beam sweeps along the epipolar lines.
    """

    def __init__(self) -> None:
        self._last: NDArray[np.uint8] | None = None

    def torn(self, image: NDArray[np.uint8]) -> bool:
        """Whether the next frame (H, W) uint8 is torn, or an old one again."""
        step = max(1, len(image) // _ROWS)
        rows = image[step // 2 :: step].copy()
        last, self._last = self._last, rows
        if float(cv2.absdiff(rows[:, 1:], rows[:, :-1]).mean(axis=1).max(initial=0.0)) > _ROUGH_DN:
            return True
        if last is None or last.shape != rows.shape:
            return False
        same = (rows == last).all(axis=1)
        return bool(same.any() and (np.ptp(rows[same], axis=1) >= _ALIVE_DN).any())
