"""The calibration board as two cameras see it at one instant."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.board_view import BoardView

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class StereoView:
    """The board in both cameras at one instant."""

    left: BoardView
    right: BoardView

    def common(self) -> tuple[NDArray[np.int64], Array, Array]:
        """Ids (n,) of the corners that both cameras see, and their pixels (n, 2) in the left and the right."""
        ids, at_left, at_right = np.intersect1d(self.left.ids, self.right.ids, assume_unique=True, return_indices=True)
        return ids, self.left.corners_px[at_left], self.right.corners_px[at_right]
