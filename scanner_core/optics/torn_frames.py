"""Frames that are not one exposure: part of them is an older frame's, or nothing that a lens could have made."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

_ROWS = 8
"""Rows that are looked at, evenly spread."""
_ROUGH_DN = 40.0
"""Mean step between neighbouring pixels of a row beyond which it is no image; uniformly random bytes have 85, noise a few."""
_ALIVE = 0.05
"""Least share of a row's pixels beside its median: a row that shows noise.  Of a clipped, dark one with a hot pixel nothing can be said."""
_OFTEN = 0.3
"""A camera of which more frames than that repeat rows is too quiet for its digits: its repetitions prove nothing."""
_MEMORY = 32
"""Frames over which that is averaged."""


class TornFrames:
    """One camera's memory of its last frame; for one thread.

    Two exposures never have the same noise, so a row that repeats the last frame's to the last digit is a copy.  A spot in
    such a frame may belong to another instant: the epipolar gate cannot tell where the beam sweeps along the epipolar lines.
    """

    def __init__(self) -> None:
        self._last: NDArray[np.uint8] | None = None
        self._repeating = 0.0

    def torn(self, image: NDArray[np.uint8]) -> bool:
        """Whether the next frame (H, W) uint8 is torn, or an old one again."""
        step = max(1, len(image) // _ROWS)
        rows = image[step // 2 :: step].copy()
        last, self._last = self._last, rows
        if float(cv2.absdiff(rows[:, 1:], rows[:, :-1]).mean(axis=1).max(initial=0.0)) > _ROUGH_DN:
            return True
        if last is None or last.shape != rows.shape:
            return False
        same = rows[(rows == last).all(axis=1)]
        repeats = bool(len(same)) and bool((_share_beside_median(same) >= _ALIVE).any())
        self._repeating += (repeats - self._repeating) / _MEMORY
        return repeats and self._repeating < _OFTEN


def _share_beside_median(rows: NDArray[np.uint8]) -> NDArray[np.float64]:
    share: NDArray[np.float64] = (rows != np.median(rows, axis=1, keepdims=True)).mean(axis=1)
    return share
