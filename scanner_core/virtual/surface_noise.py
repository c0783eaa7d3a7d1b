"""Random fields that are fixed to a place in space: what repeats where the beam comes back to the same spot."""

from __future__ import annotations

from math import floor

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_ROWS = 1 << 14


class SpatialNoise:
    """Independent standard normal fields with a correlation length, the same for the same seed and place.

    Normal variates hang at the nodes of a cubic lattice (Perlin's value noise, hashed); between them they are weighted
    trilinearly and scaled so that the variance is 1 everywhere.
    """

    def __init__(self, seed: int, fields: int, cell_mm: float) -> None:
        self._nodes = np.random.default_rng([seed, 0x5EED]).standard_normal((_ROWS, fields))
        self._per_mm = 1.0 / cell_mm

    def at(self, x: float, y: float, z: float) -> Array:
        """The fields (fields,) at a place in the object frame, mm."""
        x, y, z = x * self._per_mm, y * self._per_mm, z * self._per_mm
        i, j, k = floor(x), floor(y), floor(z)
        u, v, w = x - i, y - j, z - k
        rows, weights = [], []
        for a, wa in ((i, 1 - u), (i + 1, u)):
            for b, wb in ((j, 1 - v), (j + 1, v)):
                for c, wc in ((k, 1 - w), (k + 1, w)):
                    rows.append((a * 73856093 ^ b * 19349663 ^ c * 83492791) % _ROWS)
                    weights.append(wa * wb * wc)
        weight = np.array(weights)
        mixed: Array = weight @ self._nodes[rows] / np.sqrt(weight @ weight)
        return mixed

    def at_many(self, places: Array) -> Array:
        """The fields (n, fields) at places (n, 3) in the object frame, mm; the same as one by one."""
        scaled = places * self._per_mm
        low = np.floor(scaled)
        part, low = scaled - low, low.astype(np.int64)
        mixed = np.zeros((len(places), self._nodes.shape[1]))
        squares = np.zeros(len(places))
        for corner in np.indices((2, 2, 2)).reshape(3, -1).T:
            weight = np.where(corner, part, 1 - part).prod(axis=1)
            a, b, c = (low + corner).T
            mixed += weight[:, None] * self._nodes[(a * 73856093 ^ b * 19349663 ^ c * 83492791) % _ROWS]
            squares += weight**2
        return np.asarray(mixed / np.sqrt(squares)[:, None], np.float64)
