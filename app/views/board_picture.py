"""A camera's picture of the calibration board, with the corners that were found or the reason why there are none."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.palettes import DARK
from app.views.camera_preview import CameraPreview
from scanner_core.devices.camera import Frame

_RADIUS = 3.2
_AS_HIGH_AS_IT_FITS = 16_777_215
"""Qt's own bound, which PySide6 does not name."""


class BoardPicture(CameraPreview):
    """The newest look; zooms like every preview."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.setMaximumHeight(_AS_HIGH_AS_IT_FITS)
        self._corners_px: NDArray[np.float64] | None = None
        self.words = ""
        self._good = False

    def show_look(self, frame: Frame, corners_px: NDArray[np.float64] | None, words: str, *, good: bool) -> None:
        """A frame with corners (n, 2) px and a few words, which are large and amber when it is not `good`."""
        self._corners_px, self.words, self._good = corners_px, words, good
        self.setAccessibleDescription(words)
        self.show_frame(frame)

    def clear(self) -> None:
        self._corners_px, self.words = None, ""
        super().clear()

    def _overlay(self, painter: QPainter) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._corners_px is not None:
            painter.setPen(QPen(QColor(DARK.accent), 1.5))
            for x, y in self._corners_px:
                painter.drawEllipse(self._on_widget(float(x), float(y)), _RADIUS, _RADIUS)
        if self.words and not self._good:
            painter.save()
            self._pill(painter)
            painter.restore()

    def _caption(self, painter: QPainter) -> None:
        super()._caption(painter)
        if self.words and self._good:
            painter.setPen(QColor(DARK.good))
            painter.drawText(self.rect().adjusted(8, 5, -8, -5), Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop, self.words)

    def _pill(self, painter: QPainter) -> None:
        """What is wrong, on a dark ground in the middle below: it is read from where the board is held."""
        font = painter.font()
        font.setPixelSize(16)
        font.setBold(True)
        painter.setFont(font)
        width = min(painter.fontMetrics().horizontalAdvance(self.words) + 32, self.width() - 16)
        box = QRectF((self.width() - width) / 2, self.height() - 46, width, 34)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(16, 18, 20, 215))
        painter.drawRoundedRect(box, 17, 17)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QColor(DARK.warning))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.words)

    def _on_widget(self, x_px: float, y_px: float) -> QPointF:
        assert self._image is not None
        target = self._target()
        scale = target.width() / self._image.width()
        return QPointF(target.left() + (x_px + 0.5) * scale, target.top() + (y_px + 0.5) * scale)
