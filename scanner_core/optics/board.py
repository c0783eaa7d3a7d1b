"""The calibration target: a ChArUco board (chessboard with ArUco markers in its white squares)."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class CharucoTarget:
    """A printed board, described by what must agree between print and program.

    The board's own frame is OpenCV's: origin at the top left corner of the first square, +x along the row of
    `columns` squares, +y down the `rows`, +z into the board (away from who looks at its face).

    Attributes
    ----------
    columns, rows : number of squares along x and y
    square_mm, marker_mm : edge lengths as measured on the print
    dictionary : OpenCV's number of the marker dictionary
    first_marker : the dictionary's number of the first marker; boards that must not be taken for each other share none
    """

    columns: int = 9
    rows: int = 7
    square_mm: float = 25.0
    marker_mm: float = 18.0
    dictionary: int = cv2.aruco.DICT_4X4_50
    first_marker: int = 0

    @property
    def size_mm(self) -> tuple[float, float]:
        """Width and height of the chessboard, without a margin."""
        return self.columns * self.square_mm, self.rows * self.square_mm

    @property
    def object_points(self) -> NDArray[np.float64]:
        """The inner corners in the board's frame, ((columns - 1) (rows - 1), 3) mm; a corner's row is its ChArUco id."""
        x, y = np.meshgrid(np.arange(1, self.columns), np.arange(1, self.rows))
        return np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1).astype(np.float64) * np.float64(self.square_mm)

    def board(self) -> cv2.aruco.CharucoBoard:
        """OpenCV's description of the same board."""
        dictionary = cv2.aruco.getPredefinedDictionary(self.dictionary)
        ids = self.first_marker + np.arange(self.columns * self.rows // 2, dtype=np.int32)
        return cv2.aruco.CharucoBoard((self.columns, self.rows), self.square_mm, self.marker_mm, dictionary, ids)


DEFAULT_TARGET = CharucoTarget()
"""The board that is shipped as a printable page and that the virtual rig shows."""


@dataclass(frozen=True, slots=True)
class LengthBar:
    """A plate with marks at two places whose distance is certified: what tells a print's scale.

    The marks are chessboard corners with markers of the same dictionary as the board's (so that no two can be
    confused, by the dictionary's own Hamming distance) but with numbers that the board does not use.  Its two groups
    are the corners of the first and of the last two columns; only the distance of their middles is used, not the
    drawing.

    Attributes
    ----------
    plate : what is on it, nominally
    length_mm, uncertainty_mm : certified distance of the middles of both groups, and its standard uncertainty
    """

    plate: CharucoTarget = CharucoTarget(columns=9, rows=4, first_marker=31)
    length_mm: float = 150.0
    uncertainty_mm: float = 0.005

    def groups(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Rows of the plate's `object_points` that belong to the first and to the second group."""
        column = np.arange((self.plate.columns - 1) * (self.plate.rows - 1)) % (self.plate.columns - 1)
        return np.flatnonzero(column < 2), np.flatnonzero(column >= self.plate.columns - 3)


DEFAULT_BAR = LengthBar()
"""150.000 mm, certified to 0.010 mm (k = 2)."""
