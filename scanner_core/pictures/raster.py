"""A picture of a surface in parallel projection, computed here: a report or a thumbnail must not depend on a display or on OpenGL."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_CANDIDATES = 4_000_000
"""Pairs of triangle and pixel that are examined at once; bounds the memory."""


@dataclass(frozen=True, slots=True, eq=False)
class Raster:
    """Which point of which triangle every pixel shows; row 0 is at the top.

    Attributes
    ----------
    triangle : (h, w) int64, -1 where nothing is seen
    weights : (h, w, 3) of the triangle's corners, barycentric
    depth : (h, w) mm towards the eye, -inf where nothing is seen
    """

    triangle: NDArray[np.int64]
    weights: Array
    depth: Array

    @property
    def seen(self) -> NDArray[np.bool_]:
        """(h, w), whether the pixel shows the surface."""
        return np.asarray(self.triangle >= 0, np.bool_)

    def sampled(self, triangles: NDArray[np.int64], values: Array) -> Array:
        """Values of vertices (v,) or (v, k) interpolated for every pixel that shows the surface, (n,) or (n, k); NaN spreads over its triangles."""
        seen = self.seen
        corners = values[triangles[self.triangle[seen]]]
        return np.asarray(np.einsum("nc,nc...->n...", self.weights[seen], corners), np.float64)


def rasterized(points: Array, triangles: NDArray[np.int64], pixel_mm: float, width: int, height: int, centre: Array) -> Raster:
    """The nearest surface for every pixel.

    Parameters
    ----------
    points : (v, 3) mm: right, up, towards the eye
    triangles : (t, 3), seen from both sides
    pixel_mm : edge of a pixel
    centre : (2,) mm, the point (right, up) that is shown in the middle
    """
    place = np.column_stack(
        [(points[:, 0] - centre[0]) / pixel_mm + 0.5 * width - 0.5, 0.5 * height - 0.5 - (points[:, 1] - centre[1]) / pixel_mm, points[:, 2]]
    )
    corners = np.take(place, triangles, axis=0)
    low = np.clip(np.ceil(corners[:, :, :2].min(axis=1)), 0, [width, height]).astype(np.int64)
    high = np.clip(np.floor(corners[:, :, :2].max(axis=1)), -1, [width - 1, height - 1]).astype(np.int64)
    size = np.maximum(high - low + 1, 0)
    count = size[:, 0] * size[:, 1]
    planes, flat = _planes(corners)
    count[flat] = 0
    picture = Raster(np.full(width * height, -1, np.int64), np.zeros((width * height, 3)), np.full(width * height, -np.inf))
    some = np.flatnonzero(count)
    ends = np.cumsum(count[some])
    start = 0
    while start < len(some):
        reached = ends[start - 1] if start else 0
        stop = max(int(np.searchsorted(ends, reached + _CANDIDATES, side="right")), start + 1)
        _fill(picture, some[start:stop], planes, low, size, width)
        start = stop
    return Raster(picture.triangle.reshape(height, width), picture.weights.reshape(height, width, 3), picture.depth.reshape(height, width))


def _planes(corners: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Weight of the second and of the third corner and the depth as functions ``p[0] x + p[1] y + p[2]`` of the pixel,
    (3, 3, t), and which triangles are seen edge-on."""
    a, b, c = (corners[:, i] for i in range(3))
    b, c = b - a, c - a
    twice = b[:, 0] * c[:, 1] - b[:, 1] * c[:, 0]
    flat = np.abs(twice) < 1e-12
    twice = np.where(flat, 1.0, twice)
    second = np.stack([c[:, 1], -c[:, 0], c[:, 0] * a[:, 1] - c[:, 1] * a[:, 0]]) / twice
    third = np.stack([-b[:, 1], b[:, 0], b[:, 1] * a[:, 0] - b[:, 0] * a[:, 1]]) / twice
    depth = second * b[:, 2] + third * c[:, 2]
    depth[2] += a[:, 2]
    return np.stack([second, third, depth]), flat


def _fill(picture: Raster, chosen: NDArray[np.int64], planes: Array, low: NDArray[np.int64], size: NDArray[np.int64], width: int) -> None:
    """Put the chosen triangles into the picture, whose pixels lie one row after the other, where they are nearer than what is there."""
    count = size[chosen, 0] * size[chosen, 1]
    number = np.repeat(chosen, count)
    within = np.arange(len(number)) - np.repeat(np.cumsum(count) - count, count)
    row, column = np.divmod(within, np.repeat(size[chosen, 0], count))
    column += np.repeat(low[chosen, 0], count)
    row += np.repeat(low[chosen, 1], count)

    def value(which: int, pairs: NDArray[np.int64] | slice) -> Array:
        p = planes[which]
        return np.asarray(p[0, number[pairs]] * column[pairs] + p[1, number[pairs]] * row[pairs] + p[2, number[pairs]], np.float64)

    second = value(0, slice(None))
    inside = np.flatnonzero((second >= -1e-9) & (second <= 1 + 1e-9))
    second, third = second[inside], value(1, inside)
    kept = (third >= -1e-9) & (second + third <= 1 + 1e-9)
    inside, second, third = inside[kept], second[kept], third[kept]
    near, pixel = value(2, inside), row[inside] * width + column[inside]
    np.maximum.at(picture.depth, pixel, near)
    best = near == picture.depth[pixel]
    at = pixel[best]
    picture.triangle[at] = number[inside[best]]
    picture.weights[at] = np.column_stack([1 - second - third, second, third])[best]
