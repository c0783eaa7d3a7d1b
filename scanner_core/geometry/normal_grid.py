"""Mean normals in cells of a grid: a guess of the normal of a new point in microseconds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.floating]

_BITS, _HALF = 21, 1 << 20
"""Of each coordinate in the key of a cell."""


class NormalGrid:
    """Of points (n, 3) mm with unit normals (n, 3), in cells of `cell_mm`."""

    def __init__(self, points: Array, normals: Array, cell_mm: float) -> None:
        self._cell_mm = cell_mm
        self._keys, place = np.unique(self._cells(points), return_inverse=True)
        sums = np.stack([np.bincount(place, normals[:, axis], len(self._keys)) for axis in range(3)], axis=1)
        self._normals = sums / np.maximum(np.sqrt((sums**2).sum(axis=1, keepdims=True)), 1e-9)

    def at(self, points: Array, towards: Array) -> NDArray[np.float32]:
        """(m, 3) of the cells of points (m, 3); `towards` (m, 3) where a cell is empty or its normal shows away from it."""
        normals = np.array(towards, np.float32)
        if len(self._keys) and len(points):
            keys = self._cells(points)
            place = np.minimum(np.searchsorted(self._keys, keys), len(self._keys) - 1)
            found = self._normals[place]
            good = (self._keys[place] == keys) & (np.einsum("ij,ij->i", found, towards) > 0)
            normals[good] = found[good]
        return normals

    def _cells(self, points: Array) -> NDArray[np.int64]:
        x, y, z = (np.clip(np.floor(points / self._cell_mm), -_HALF, _HALF - 1).astype(np.int64) + _HALF).T
        return np.asarray((x << 2 * _BITS) | (y << _BITS) | z, np.int64)
