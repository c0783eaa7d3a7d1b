"""A box along the axes of the object frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scanner_core.editing.sight import Array, Mask


@dataclass(frozen=True, slots=True, eq=False)
class CropBox:
    """Between two corners (3,) mm."""

    low: Array
    high: Array

    @classmethod
    def around(cls, points: Array) -> CropBox:
        """The smallest that holds points (n, 3) mm."""
        return cls(points.min(axis=0), points.max(axis=0))

    def holds(self, points: Array) -> Mask:
        """Which of points (n, 3) mm lie within, its faces included."""
        inside = np.ones(len(points), np.bool_)
        for axis in range(3):
            inside &= (points[:, axis] >= self.low[axis]) & (points[:, axis] <= self.high[axis])
        return inside

    def corners(self) -> Array:
        """(8, 3) mm, x the quickest."""
        return np.array([(x, y, z) for z in (self.low[2], self.high[2]) for y in (self.low[1], self.high[1]) for x in (self.low[0], self.high[0])])
