"""Where points appear in the picture of a camera, and which of them are in front."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_PER_CELL = 24.0
"""Points that a cell of the depth picture holds on average: so many that the front of a surface leaves hardly a cell empty."""
_LEAST_CELL_PX = 3.0
_RIM_PX = 30.0
_ENOUGH = 60_000
_STEEPEST = 2.0
"""A surface may fall away by this many cells within a cell ..."""
_THINNEST_MM = 1.5
"""... and by this much anyhow: nothing that is scanned is so thin."""


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """A camera's picture.

    Attributes
    ----------
    matrix : (4, 4), from the object frame, mm, to clip space: -1 to 1 across the picture, x to the right, y upwards
    width, height : of the picture, px; its places count from the upper left corner
    direction : (3,) unit, in which the camera looks
    """

    matrix: Array
    width: float
    height: float
    direction: Array

    def places(self, points: Array) -> Array:
        """(n, 2) px of points (n, 3) mm; NaN for those behind the eye."""
        clip = self.matrix[[0, 1, 3], :3] @ points.T + self.matrix[[0, 1, 3], 3:]
        found = np.empty((2, len(points)))  # column by column: half a million points are asked at every stroke of a brush
        with np.errstate(divide="ignore", invalid="ignore"):
            np.divide(clip[:2], clip[2], out=found)
        found[1] *= -1.0
        found += 1.0
        found *= np.array([[0.5 * self.width], [0.5 * self.height]])
        if (behind := clip[2] <= 1e-9).any():
            found[:, behind] = np.nan
        return found.T

    def mm_per_px(self, points: Array) -> float:
        """Of a pixel across the line of sight, in the middle of points (n, 3)."""
        middle = points.mean(axis=0)
        across = np.cross(self.direction, np.eye(3)[np.argmin(np.abs(self.direction))])
        ends = self.places(np.array([middle, middle + across / np.linalg.norm(across)]))
        return 1.0 / max(float(np.linalg.norm(ends[1] - ends[0])), 1e-9)

    def in_front(self, points: Array, places: Array | None = None, asked: Mask | None = None) -> Mask:
        """Which of points (n, 3) no others hide: a cloud hides what lies deeper than its foremost points.

        Parameters
        ----------
        places : of the points, where they are known
        asked : (n,) which are asked for; the others only hide
        """
        x, y = (self.places(points) if places is None else places).T
        shown: Mask = (x >= 0) & (x < self.width) & (y >= 0) & (y < self.height)
        at = np.flatnonzero(shown if asked is None else shown & asked)
        front = np.zeros(len(points), np.bool_)
        if not len(at):
            return front
        depth = points @ self.direction
        across, down = x[at], y[at]
        left, right = float(across.min()) - _RIM_PX, float(across.max()) + _RIM_PX  # or the cells at the border would be part of one
        top, bottom = float(down.min()) - _RIM_PX, float(down.max()) + _RIM_PX
        near = np.flatnonzero((x >= left) & (x <= right) & (y >= top) & (y <= bottom))
        stride = max(1, len(near) // _ENOUGH)  # so many tell where the front is as well as all of them
        near = near[::stride]
        cell = max(float(np.sqrt(_PER_CELL * (right - left) * (bottom - top) / len(near))), _LEAST_CELL_PX)
        wide, tall = int((right - left) / cell) + 1, int((bottom - top) / cell) + 1
        nearest = np.full(tall * wide, np.inf)
        np.minimum.at(nearest, _cells(x[near] - left, y[near] - top, cell, wide), depth[near])
        slack = _THINNEST_MM + _STEEPEST * cell * self.mm_per_px(points[near])
        front[at] = depth[at] <= nearest[_cells(across - left, down - top, cell, wide)] + slack
        return front


def _cells(across: Array, down: Array, cell: float, wide: int) -> NDArray[np.int32]:
    """Numbers of the cells of a grid that hold places."""
    return np.asarray((down / cell).astype(np.int32) * wide + (across / cell).astype(np.int32), np.int32)
