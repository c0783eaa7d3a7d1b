"""Places of the laser line that both images show: what is kept of them, and from which their points can be computed again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class StripePairs:
    """n places, each a peak of one image and the place of the line on its epipolar line in the other.

    Attributes
    ----------
    left_px, right_px : (n, 2)
    by_right : (n,) bool: the peak is the right image's
    along_row : (n,) bool: of the peak, x was measured in a row; else y in a column
    own_px : (n,) standard uncertainty of the peak's measured coordinate
    other_px : (n,) standard uncertainty of the line's place across itself in the other image
    tangent_rad : (n,) direction of the line there
    """

    left_px: Array
    right_px: Array
    by_right: NDArray[np.bool_]
    along_row: NDArray[np.bool_]
    own_px: Array
    other_px: Array
    tangent_rad: Array

    def __len__(self) -> int:
        return len(self.own_px)

    def select(self, which: NDArray[np.bool_] | NDArray[np.int64]) -> StripePairs:
        """Those of a mask or of numbers."""
        return StripePairs(*(getattr(self, column.name)[which] for column in fields(self)))

    @staticmethod
    def none() -> StripePairs:
        """Of a frame without a line."""
        two, none, no = np.empty((0, 2)), np.empty(0), np.empty(0, np.bool_)
        return StripePairs(two, two, no, no, none, none, none)

    @staticmethod
    def joined(parts: Sequence[StripePairs]) -> StripePairs:
        """All of several."""
        return StripePairs(*(np.concatenate([getattr(part, column.name) for part in parts]) for column in fields(StripePairs)))
