"""The plane at which an object is cut off from what it stands on: the table, or the flat rim of an impression."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scanner_core.editing.sight import Array, Mask

_LAYER_MM = 0.2
_LOWEST_FRACTION = 0.1
"""Of the points, that may lie lower than the layer: one higher up is the object's own."""
_TIMES = 3.0
"""A layer is flat when it holds so many times the points of an ordinary one."""
_STEEPEST_DEG = 12.0
_THICKEST_MM = 0.4
_MARGIN_MM = 0.3
"""Above what was found, so that nothing of it is left."""


@dataclass(frozen=True, slots=True, eq=False)
class BasePlane:
    """A plane that is nearly level.

    Attributes
    ----------
    middle : (2,) mm, x and y about which it is tilted
    height_mm : z there
    tilt_x_deg, tilt_y_deg : how much it rises along x and along y
    """

    middle: Array
    height_mm: float
    tilt_x_deg: float = 0.0
    tilt_y_deg: float = 0.0

    @property
    def slopes(self) -> Array:
        """(2,) mm that it rises per mm along x and y."""
        return np.tan(np.radians([self.tilt_x_deg, self.tilt_y_deg]))

    def heights(self, places: Array) -> Array:
        """z (n,) mm of the plane at x and y (n, 2) mm."""
        return np.asarray(self.height_mm + (places - self.middle) @ self.slopes)

    def below(self, points: Array) -> Mask:
        """Which of points (n, 3) mm lie lower than it."""
        return np.asarray(points[:, 2] < self.heights(points[:, :2]))


def find_base(points: Array) -> BasePlane:
    """The upper side of what points (n, 3) mm stand on: of the flat layer that is densest in their lower part, or just above their lowest.

    A layer is one of 0.2 mm; that of a table or a rim holds several times the points of one that only cuts through walls.
    """
    middle = 0.5 * (points[:, :2].min(axis=0) + points[:, :2].max(axis=0))
    low, high = (float(value) for value in np.percentile(points[:, 2], (0.1, 99.9)))
    layers = max(int(np.ceil((high - low) / _LAYER_MM)), 1)
    held, edges = np.histogram(points[:, 2], layers, (low, low + layers * _LAYER_MM))
    lowest = BasePlane(middle, low + _MARGIN_MM)
    lower = held[: max(int(np.searchsorted(np.cumsum(held), _LOWEST_FRACTION * len(points))) + 1, 1)]
    peak = int(lower.argmax())
    if layers < 5 or lower[peak] < _TIMES * np.median(held):
        return lowest
    centre = 0.5 * (edges[peak] + edges[peak + 1])
    slopes, height, spread = np.zeros(2), centre, 2.0 * _LAYER_MM
    for _ in range(12):  # a tilted layer spreads over several: fit, take what lies near, fit again
        away = points[:, 2] - height - (points[:, :2] - middle) @ slopes
        near = points[np.abs(away) <= spread]
        design = np.column_stack([near[:, :2] - middle, np.ones(len(near))])
        solution, *_ = np.linalg.lstsq(design, near[:, 2], rcond=None)
        slopes, height = solution[:2], float(solution[2])
        rest = near[:, 2] - height - (near[:, :2] - middle) @ slopes
        spread = float(np.clip(3.0 * 1.4826 * np.median(np.abs(rest)), 0.1, _THICKEST_MM))
    tilts = np.degrees(np.arctan(slopes))
    if np.abs(tilts).max() > _STEEPEST_DEG:
        return lowest
    return BasePlane(middle, height + max(spread, _MARGIN_MM), float(tilts[0]), float(tilts[1]))
