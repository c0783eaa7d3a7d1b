"""Which fields of a camera's image the board has covered."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.theme import look
from scanner_core.optics.board_watch import FIELDS

_GAP = 2.0


class CoverageMap(QWidget):
    """Six rows of eight fields, filled as they are covered."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self._name = name
        self._covered = np.zeros(FIELDS, bool)
        self._shape = 0.5
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self._tell()

    def hasHeightForWidth(self) -> bool:  # noqa: N802 - Qt's name
        return True

    def heightForWidth(self, width: int) -> int:  # noqa: N802 - Qt's name
        return round(width * self._shape)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(200, self.heightForWidth(200))

    @property
    def covered(self) -> NDArray[np.bool_]:
        return self._covered

    def show_covered(self, covered: NDArray[np.bool_], size_px: tuple[int, int]) -> None:
        """(6, 8) fields of an image of `size_px`, width and height."""
        shape = size_px[1] / size_px[0]
        if shape != self._shape:
            self._shape = shape
            self.updateGeometry()
        if not np.array_equal(covered, self._covered):
            self._covered = covered
            self._tell()
            self.update()

    def _tell(self) -> None:
        count = np.count_nonzero(self._covered)
        self.setToolTip(self.tr("{n} of {count} fields covered").format(n=count, count=self._covered.size))
        self.setAccessibleName(f"{self._name}: {self.toolTip()}")

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        rows, columns = self._covered.shape
        width, height = self.width() / columns, self.height() / rows
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for row in range(rows):
                for column in range(columns):
                    field = QRectF(column * width, row * height, width - _GAP, height - _GAP)
                    painter.fillRect(field, QColor(look.accent if self._covered[row, column] else look.raised))
