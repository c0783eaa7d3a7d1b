"""What a person draws on the picture: an outline, or the path of a round brush."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.editing.sight import Array, Mask, Sight

_MOST_PX = 8192.0
_AROUND_PX = 30.0
"""Round a place, to see what is in front there."""


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """A polygon (k, 2) px, closed by itself; where it crosses itself, what lies inside an even number of times is outside."""

    corners: Array

    @classmethod
    def box(cls, start: Array, end: Array) -> Outline:
        """The rectangle between two corners (2,) px."""
        (left, top), (right, bottom) = np.minimum(start, end), np.maximum(start, end)
        return cls(np.array([(left, top), (right, top), (right, bottom), (left, bottom)], np.float64))

    def holds(self, places: Array) -> Mask:
        """Which of places (n, 2) px lie within; exact, also along the edges."""
        inside = np.zeros(len(places), np.bool_)
        if len(self.corners) < 3:
            return inside
        low, high = self.corners.min(axis=0), self.corners.max(axis=0)
        near = _between(places, low, high)
        if not len(near):
            return inside
        # The picture of the polygon tells of all but the pixels along its edges; those are counted out one by one.
        scale = min(1.0, _MOST_PX / float(max((high - low).max(), 1.0)))
        corners = (self.corners - low) * scale + 2.0
        size = np.ceil((high - low) * scale).astype(int)[::-1] + 5
        filled, edge = np.zeros((2, *size.tolist()), np.uint8)
        drawn = np.rint(corners).astype(np.int32).reshape(1, -1, 2)
        cv2.fillPoly(filled, drawn, 1)
        cv2.polylines(edge, drawn, isClosed=True, color=1, thickness=3)
        columns, rows = ((places.T[:, near] - low[:, None]) * scale + 2.5).astype(np.int64)
        pixels = rows * size[1] + columns
        inside[near] = filled.ravel()[pixels] > 0
        doubtful = near[edge.ravel()[pixels] > 0]
        inside[doubtful] = crossings(self.corners, places[doubtful]) % 2 == 1
        return inside


@dataclass(frozen=True, slots=True, eq=False)
class BrushStroke:
    """A disc that went along a path (k, 2) px."""

    path: Array
    radius_px: float

    def holds(self, places: Array) -> Mask:
        """Which of places (n, 2) px the disc covered."""
        inside = np.zeros(len(places), np.bool_)
        if not len(self.path):
            return inside
        low, high = self.path.min(axis=0) - self.radius_px, self.path.max(axis=0) + self.radius_px
        near = _between(places, low, high)
        ends = self.path if len(self.path) > 1 else np.repeat(self.path, 2, axis=0)
        for start, end in pairwise(ends):
            along = end - start
            away = places[near] - start
            share = np.clip(away @ along / max(float(along @ along), 1e-12), 0.0, 1.0)
            covered = ((away - share[:, None] * along) ** 2).sum(axis=1) <= self.radius_px**2
            inside[near[covered]] = True
            near = near[~covered]
        return inside


def selected(points: Array, sight: Sight, region: Outline | BrushStroke, *, through: bool, places: Array | None = None) -> Mask:
    """Points (n, 3) mm that a region of the picture holds; without `through` only those that no others hide.

    Parameters
    ----------
    places : (n, 2) px of the points, where they are known
    """
    places = sight.places(points) if places is None else places
    held = region.holds(places)
    if through or not held.any():
        return held
    return sight.in_front(points, places, held)


def nearest_in_front(points: Array, sight: Sight, place: Array, within_px: float) -> int | None:
    """The point (of n, 3) that a person means by a place (2,) px: of those in front the nearest to it; None where there is none so near."""
    places = sight.places(points)
    near = np.zeros(len(points), np.bool_)
    near[_between(places, place - within_px - _AROUND_PX, place + within_px + _AROUND_PX)] = True
    front = np.flatnonzero(sight.in_front(points, places, near))
    if not len(front):
        return None
    away = ((places[front] - place) ** 2).sum(axis=1)
    return int(front[away.argmin()]) if away.min() <= within_px**2 else None


def _between(places: Array, low: Array, high: Array) -> NDArray[np.int64]:
    """Indices of the places (n, 2) in a rectangle."""
    x, y = places.T
    return np.flatnonzero((x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1]))


def crossings(corners: Array, places: Array) -> NDArray[np.int64]:
    """How many edges of a polygon (k, 2) a line from each of the places (n, 2) to the right crosses."""
    count = np.zeros(len(places), np.int64)
    x, y = places.T
    for (x0, y0), (x1, y1) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        spans = (y0 <= y) != (y1 <= y)
        way = (y - y0) * (x1 - x0) - (x - x0) * (y1 - y0)  # without a quotient, which a nearly level edge would make infinite
        count += spans & (way > 0 if y1 > y0 else way < 0)
    return count
