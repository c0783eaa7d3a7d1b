"""What is wrong with the virtual calibration board: no print is where it should be, and no sheet is flat.

The program knows nothing of it; it limits a calibration as it does in reality.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.board import CharucoTarget

Array = NDArray[np.float64]
Image = NDArray[np.float32]

PRINT_UM = 8.0
"""rms of the ink's place along each axis; it varies over a few squares."""
BOW_UM = 20.0
"""How far the middle stands out towards the viewer over the corners: a stiff board, not a sheet of paper."""

_GRID = (5, 6)
_SEED = 20031


class PrintErrors:
    """A board's own, fixed errors in its own frame.

    A mark that should be at (x, y, 0) mm is at ``(x + dx, y + dy, -bulge)``.
    """

    def __init__(self, target: CharucoTarget) -> None:
        self._size = np.array(target.size_mm)
        rng = np.random.default_rng(_SEED)
        coarse = rng.standard_normal((*_GRID, 2))
        coarse *= 1e-3 * PRINT_UM / coarse.std(axis=(0, 1))
        self._step = 1.0  # mm between the nodes of the field once it is filled in
        width, height = (int(np.ceil(s / self._step)) + 1 for s in self._size)
        self._field = cv2.resize((coarse - coarse.mean(axis=(0, 1))).astype(np.float32), (width, height), interpolation=cv2.INTER_CUBIC)

    def at(self, x: Image, y: Image) -> tuple[Image, Image, Image]:
        """dx, dy and bulge in mm at places of the board in mm (2D arrays); beyond its border they go on as there."""
        field = cv2.remap(self._field, x / np.float32(self._step), y / np.float32(self._step), cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        across = np.clip(2 * x / np.float32(self._size[0]) - 1, -1, 1)
        down = np.clip(2 * y / np.float32(self._size[1]) - 1, -1, 1)
        bulge = np.float32(1e-3 * BOW_UM) * (1 - 0.5 * (across * across + down * down))
        return np.asarray(field[..., 0], np.float32), np.asarray(field[..., 1], np.float32), bulge

    def marks(self, points: Array) -> Array:
        """Where marks that should be at `points` (n, 3) mm of the board's frame really are, (n, 3) mm."""
        dx, dy, bulge = self.at(points[None, :, 0].astype(np.float32), points[None, :, 1].astype(np.float32))
        return points + np.stack([dx[0], dy[0], -bulge[0]], axis=1).astype(np.float64)
