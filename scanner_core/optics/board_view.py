"""What one camera sees of the calibration board: its corners, or why there are none."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MIN_CORNERS = 12
"""Corners that a view needs: twice what its pose has unknowns, spread over more than one row."""


class BoardMissReason(Enum):
    """Why a frame shows no usable board."""

    TOO_DARK = "too_dark"
    TOO_BRIGHT = "too_bright"
    TOO_BLURRED = "too_blurred"
    NO_BOARD = "no_board"
    CUT = "cut"
    TOO_FEW_CORNERS = "too_few_corners"


@dataclass(frozen=True, slots=True, eq=False)
class BoardView:
    """Corners of a board seen by one camera.

    Attributes
    ----------
    ids : (n,) int64, rows of the target's `object_points`, ascending
    corners_px : (n, 2) float64; the centre of the first pixel is (0, 0)
    """

    ids: NDArray[np.int64]
    corners_px: Array


@dataclass(frozen=True, slots=True)
class BoardMiss:
    """No usable board, and why: an expected value, not an error."""

    reason: BoardMissReason
    corners: int = 0
