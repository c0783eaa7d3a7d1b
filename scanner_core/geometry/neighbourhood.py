"""Scattered points and their nearest neighbours: normals, density, and what is known of them at other places."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]

NEIGHBOURS = 12
"""The point itself among them."""


class Neighbourhood:
    """Points (n, 3) mm with the `NEIGHBOURS` nearest of each.  Nothing is known of fewer points than these."""

    def __init__(self, points: Array) -> None:
        self._points = points
        self._tree = cKDTree(points)
        self._distance: Array | None = None
        self._index: NDArray[np.int64] | None = None
        if len(points) >= NEIGHBOURS:
            self._distance, self._index = self._tree.query(points, NEIGHBOURS)

    def normals(self, towards: Array) -> Array:
        """Unit normals (n, 3).

        The normal is the direction of least spread of a point and its nearest neighbours (Hoppe et al., "Surface
        reconstruction from unorganized points", SIGGRAPH 1992), turned to the side of `towards` (n, 3), the direction from
        which the point was seen.  Fewer points than `NEIGHBOURS` keep `towards` itself.
        """
        if self._index is None:
            return towards.copy()
        about = self._points[self._index]
        about = about - about.mean(axis=1, keepdims=True)
        _, axes = np.linalg.eigh(about.transpose(0, 2, 1) @ about)
        normals: Array = axes[:, :, 0]
        away = np.einsum("ij,ij->i", normals, towards) < 0
        normals[away] *= -1
        return normals

    def density_per_mm2(self) -> Array:
        """Points (n,) on a square millimetre of the surface about each point; NaN where nothing is known.

        With k neighbours within the distance r of the farthest, (k - 1) / (pi r^2) is unbiased where the points lie evenly at
        random on a plane.
        """
        if self._distance is None:
            return np.full(len(self._points), np.nan)
        radius = np.maximum(self._distance[:, -1], 1e-6)
        return np.asarray((NEIGHBOURS - 2) / (np.pi * radius**2), np.float64)

    def nearest(self, points: Array) -> NDArray[np.int64]:
        """The number (m,) of the point that lies next to each of `points` (m, 3)."""
        return np.asarray(self._tree.query(points)[1], np.int64)
