"""A tree of axis-parallel boxes over many small things, walked for all of them at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_MOST_AT_ONCE = 2_000_000


class BoxTree:
    """A complete binary tree of bounding boxes; the leaves are the given boxes along a Morton curve (Morton 1966).

    Parameters
    ----------
    low, high : (n, 3) lowest and highest corners of the boxes, mm
    """

    def __init__(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> None:
        self.order = np.argsort(_morton(0.5 * (low + high)), kind="stable")
        self.depth = max(int(len(low) - 1).bit_length(), 0)
        size = 1 << self.depth
        lows = np.full((size, 3), np.inf)
        highs = np.full((size, 3), -np.inf)
        lows[: len(low)], highs[: len(low)] = low[self.order], high[self.order]
        self.levels = [(lows, highs)]  # from the leaves up to the root
        while len(lows) > 1:
            lows = np.minimum(lows[0::2], lows[1::2])
            highs = np.maximum(highs[0::2], highs[1::2])
            self.levels.append((lows, highs))
        self.levels.reverse()

    def overlapping_pairs(self) -> NDArray[np.int64]:
        """All pairs of different boxes that overlap or touch, (k, 2), the first index the smaller one."""
        # Pairs of nodes of one level wait in batches; a batch is replaced by the overlapping pairs of their children.
        waiting: list[tuple[int, NDArray[np.int64], NDArray[np.int64]]] = [(0, np.zeros(1, np.int64), np.zeros(1, np.int64))]
        found: list[NDArray[np.int64]] = []
        while waiting:
            level, a, b = waiting.pop()
            if level == self.depth:
                different = a != b
                found.append(np.column_stack([self.order[a[different]], self.order[b[different]]]))
                continue
            same = a == b
            left, right = 2 * a, 2 * b
            first = np.concatenate([left, left, left + 1, left[~same] + 1])
            second = np.concatenate([right, right + 1, right + 1, right[~same]])
            low, high = self.levels[level + 1]
            touching = np.ones(len(first), np.bool_)
            for axis in range(3):
                touching[touching] = low[first[touching], axis] <= high[second[touching], axis]
                touching[touching] = low[second[touching], axis] <= high[first[touching], axis]
            first, second = first[touching], second[touching]
            for begin in range(0, len(first), _MOST_AT_ONCE):
                waiting.append((level + 1, first[begin : begin + _MOST_AT_ONCE], second[begin : begin + _MOST_AT_ONCE]))
        pairs = np.concatenate(found) if found else np.empty((0, 2), np.int64)
        return np.sort(pairs, axis=1)

    def boxes_within(self, points: NDArray[np.float64], reach: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """All pairs of a point and a box no farther from it than its reach.

        Parameters
        ----------
        points : (n, 3) mm
        reach : (n,) mm

        Returns
        -------
        Indices of points, rising, and of boxes, each (k,).
        """
        squared = reach * reach * (1 + 1e-12)  # a box exactly at the reach is not lost to rounding
        which = np.arange(len(points))
        node = np.zeros(len(points), np.int64)
        for level in range(self.depth + 1):
            low, high = self.levels[level]
            distance = np.zeros(len(which))
            for axis in range(3):
                place = points[which, axis]
                outside = np.maximum(low[node, axis] - place, place - high[node, axis])
                np.maximum(outside, 0.0, out=outside)
                outside *= outside
                distance += outside
            near = distance <= squared[which]
            which, node = which[near], node[near]
            if level < self.depth:
                which = np.repeat(which, 2)
                node = np.repeat(2 * node, 2)
                node[1::2] += 1
        return which, self.order[node]


def _morton(points: NDArray[np.float64]) -> NDArray[np.uint64]:
    """Position of each point (n, 3) along a space-filling curve, 21 bits an axis."""
    if len(points) == 0:
        return np.empty(0, np.uint64)
    low = points.min(axis=0)
    extent = max(float((points.max(axis=0) - low).max()), 1e-300)
    cells = ((points - low) * (((1 << 21) - 1) / extent)).astype(np.uint64)
    code = np.zeros(len(points), np.uint64)
    for axis in range(3):
        code |= _spread(cells[:, axis]) << np.uint64(axis)
    return code


def _spread(value: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """Put two zero bits between the 21 bits of each value."""
    for shift, mask in ((32, 0x1F00000000FFFF), (16, 0x1F0000FF0000FF), (8, 0x100F00F00F00F00F), (4, 0x10C30C30C30C30C3), (2, 0x1249249249249249)):
        value = (value | (value << np.uint64(shift))) & np.uint64(mask)
    return value
