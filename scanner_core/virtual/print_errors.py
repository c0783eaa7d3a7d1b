"""What is wrong with the virtual calibration board: no print is where it should be, and no sheet is flat.

The program knows nothing of it; it limits a calibration as it does in reality.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.board import CharucoTarget

Array = NDArray[np.float64]
Image = NDArray[np.float32]

_GRID = (5, 6)


@dataclass(frozen=True, slots=True)
class BoardFaults:
    """How a board differs from its drawing.

    With u, v from -1 to 1 across the board its face stands out towards the viewer by

        bow (1 - 0.7 u^2 - 0.3 v^2) + twist u v + a smooth uneven field of `uneven_um` rms.

    Attributes
    ----------
    bow_mm : how far the middle stands out over the corners; more along the rows than along the columns
    twist_mm : how far two opposite corners stand out, and the other two stand back
    uneven_um : rms of what is left of a sheet on a plate; it varies over a few squares
    scale : size of the print over its nominal size, the same in x and y
    print_um : rms of the ink's place along each axis; it varies over a few squares
    seed : of the two irregular fields: which board it is
    """

    bow_mm: float = 0.3
    twist_mm: float = 0.12
    uneven_um: float = 15.0
    scale: float = 1.002
    print_um: float = 8.0
    seed: int = 20031


TYPICAL = BoardFaults()
"""A sheet from an office printer, glued to a plate that is not quite flat."""
FAULTLESS = BoardFaults(0.0, 0.0, 0.0, 1.0, 0.0)
"""A certified plate."""


class PrintErrors:
    """A board's own, fixed errors in its own frame.

    A mark that should be at (x, y, 0) mm is at ``(x + dx, y + dy, -bulge)``.
    """

    def __init__(self, target: CharucoTarget, faults: BoardFaults = TYPICAL) -> None:
        self.faults = faults
        self._size = np.array(target.size_mm)
        coarse = np.random.default_rng(faults.seed).standard_normal((*_GRID, 3))
        coarse *= 1e-3 * np.array([faults.print_um, faults.print_um, faults.uneven_um]) / coarse.std(axis=(0, 1))
        self._step = 1.0  # mm between the nodes of the field once it is filled in
        width, height = (int(np.ceil(s / self._step)) + 1 for s in self._size)
        self._field = cv2.resize((coarse - coarse.mean(axis=(0, 1))).astype(np.float32), (width, height), interpolation=cv2.INTER_CUBIC)

    def at(self, x: Image, y: Image) -> tuple[Image, Image, Image]:
        """dx, dy and bulge in mm at places of the board in mm (2D arrays); beyond its border they go on as there."""
        faults = self.faults
        across = np.clip(2 * x / np.float32(self._size[0]) - 1, -1, 1)
        down = np.clip(2 * y / np.float32(self._size[1]) - 1, -1, 1)
        grown = 0.5 * np.float32(faults.scale - 1) * self._size.astype(np.float32)
        bulge = np.float32(faults.bow_mm) * (1 - np.float32(0.7) * across * across - np.float32(0.3) * down * down)
        bulge += np.float32(faults.twist_mm) * across * down
        dx, dy = grown[0] * across, grown[1] * down
        if faults.print_um or faults.uneven_um:
            step = np.float32(self._step)
            field = cv2.remap(self._field, x / step, y / step, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
            dx, dy, bulge = dx + field[..., 0], dy + field[..., 1], bulge + field[..., 2]
        return dx, dy, bulge

    def lowest_mm(self) -> float:
        """How far the lowest point of the face stands back behind z = 0 (negative) or out of it: there it touches a table."""
        x, y = np.meshgrid(*(np.linspace(0, size, 25, dtype=np.float32) for size in self._size))
        return float(self.at(x, y)[2].min())

    def marks(self, points: Array) -> Array:
        """Where marks that should be at `points` (n, 3) mm of the board's frame really are, (n, 3) mm."""
        dx, dy, bulge = self.at(points[None, :, 0].astype(np.float32), points[None, :, 1].astype(np.float32))
        return points + np.stack([dx[0], dy[0], -bulge[0]], axis=1).astype(np.float64)
