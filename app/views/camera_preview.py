"""What a camera sees, with the spot marked and shown enlarged."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QMouseEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.palettes import DARK
from app.views import format as fmt
from scanner_core.acquisition.handover import Preview
from scanner_core.devices.camera import Frame
from scanner_core.optics.spot import Spot

LENS_PX = 24
"""Side of the square of pixels that the magnifier shows."""
_LIFT = 0.6
"""Gamma that makes the dark object just visible behind the spot."""
_MOST_ZOOM = 24.0
_FULL_SCALE_DN = 255.0
"""Of 8 bits; the module of the core that names it brings OpenCV."""


class CameraPreview(QWidget):
    """The newest frame; the wheel zooms, dragging moves, a double click shows all again."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self._name = name
        self._image: QImage | None = None
        self._pixels: NDArray[np.uint8] | None = None
        self._spot: Spot | None = None
        self._miss = self._advice = ""
        self._waiting = self.tr("no picture yet")
        self._zoom = 1.0
        self._middle = QPointF(0.5, 0.5)
        self._grip: QPointF | None = None
        tints = [round(255 * (value / 255) ** _LIFT) for value in range(256)]
        self._colours = [QColor(t, t, t).rgb() for t in tints]
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumHeight(92)
        self.setMaximumHeight(134)
        self.setToolTip(self.tr("Wheel: zoom. Drag: move. Double click: whole picture."))
        self.setAccessibleName(name)
        self.setMouseTracking(False)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(264, 128)

    @property
    def zoom(self) -> float:
        return self._zoom

    @property
    def spot(self) -> Spot | None:
        return self._spot

    @property
    def advice(self) -> str:
        """What is said about the spot, or nothing."""
        return self._advice

    def show_preview(self, preview: Preview, miss: str = "", advice: str = "") -> None:
        """A new frame; `miss` says why it holds no spot, `advice` what would make the spot a better one."""
        self._spot = preview.seen if isinstance(preview.seen, Spot) else None
        self._miss, self._advice = miss, advice
        self._put(preview.frame)

    def hush(self) -> None:
        """Say nothing more of the frame that is shown."""
        self._miss = self._advice = ""
        self.update()

    def show_frame(self, frame: Frame) -> None:
        """A frame in which nobody looked for a spot."""
        self._spot, self._miss, self._advice = None, "", ""
        self._put(frame)

    def _put(self, frame: Frame) -> None:
        self._pixels = np.ascontiguousarray(frame.image)  # kept: QImage does not copy
        height, width = self._pixels.shape
        self._image = QImage(self._pixels.data, width, height, width, QImage.Format.Format_Indexed8)
        self._image.setColorTable(self._colours)
        self.update()

    @property
    def waiting(self) -> str:
        """What stands in place of a picture."""
        return self._waiting

    def wait_for_measurement(self, replayed: bool) -> None:
        """A recording shows its pictures only to what measures them."""
        self._waiting = self.tr("recorded: shown while it is measured") if replayed else self.tr("no picture yet")
        self.update()

    def clear(self) -> None:
        self._image = self._pixels = self._spot = None
        self._miss = self._advice = ""
        self.update()

    # -------------------------------------------------------------------------------- painting
    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:  # ends it whatever happens: a painter that lives on crashes the window
            self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        painter.fillRect(self.rect(), QColor(DARK.ground))
        if self._image is None:
            painter.setPen(QColor(DARK.muted))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self._waiting)
        else:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self._zoom < 4)
            painter.drawImage(self._target(), self._image)
            self._overlay(painter)
        self._caption(painter)
        painter.setPen(QColor(DARK.seam))
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))

    def _overlay(self, painter: QPainter) -> None:
        """What is drawn upon the picture."""
        if self._spot is not None:
            self._mark(painter, self._spot)

    def _target(self) -> QRectF:
        """Where the whole image lies in widget coordinates."""
        assert self._image is not None
        scale = min(self.width() / self._image.width(), self.height() / self._image.height()) * self._zoom
        width, height = self._image.width() * scale, self._image.height() * scale
        return QRectF(self.width() / 2 - self._middle.x() * width, self.height() / 2 - self._middle.y() * height, width, height)

    def _mark(self, painter: QPainter, spot: Spot) -> None:
        assert self._image is not None
        target = self._target()
        scale = target.width() / self._image.width()
        at = QPointF(target.left() + (spot.x_px + 0.5) * scale, target.top() + (spot.y_px + 0.5) * scale)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(DARK.accent), 1.4))
        reach = max(7.0, 4 * spot.sigma_x_px * scale)
        painter.drawEllipse(at, reach, reach)
        if self._zoom < 3:
            self._lens(painter, (spot.x_px, spot.y_px), at)

    def _lens(self, painter: QPainter, place_px: tuple[float, float], at: QPointF) -> None:
        """The spot's surroundings, pixel by pixel, in the corner that is farther from it."""
        assert self._image is not None
        side = min(64.0, 0.52 * self.height())
        left = at.x() > self.width() / 2
        frame = QRectF(6 if left else self.width() - side - 6, self.height() - side - 6, side, side)
        source = QRectF(place_px[0] + 0.5 - LENS_PX / 2, place_px[1] + 0.5 - LENS_PX / 2, LENS_PX, LENS_PX)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
        painter.fillRect(frame, QColor(0, 0, 0))
        painter.drawImage(frame, self._image, source)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(QColor(DARK.muted))
        painter.drawRect(frame)

    def _caption(self, painter: QPainter) -> None:
        font = painter.font()
        font.setPixelSize(12)
        painter.setFont(font)
        area, sizes = self.rect().adjusted(8, 5, -8, -5), ""
        if self._spot is not None:
            sizes = self.tr("σ {x} × {y} px · peak {peak} %").format(
                x=fmt.decimal(self._spot.sigma_x_px, 2),
                y=fmt.decimal(self._spot.sigma_y_px, 2),
                peak=fmt.percent(self._spot.peak_dn / _FULL_SCALE_DN),
            )
        words = painter.fontMetrics()
        line = 18 if words.horizontalAdvance(self._name) + words.horizontalAdvance(sizes) + 12 > area.width() else 0
        painter.fillRect(0, 0, self.width(), 24 + line + (18 if self._advice else 0), QColor(16, 18, 20, 150))
        painter.setPen(QColor(DARK.text))
        painter.drawText(area, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop, self._name)
        area.translate(0, line)
        if self._spot is not None:
            painter.setPen(QColor(DARK.muted))
            painter.drawText(area, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop, sizes)
        elif self._miss:
            painter.setPen(QColor(DARK.warning))
            painter.drawText(area, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop, self._miss)
        if self._advice:
            painter.setPen(QColor(DARK.warning))
            advice = painter.fontMetrics().elidedText(self._advice, Qt.TextElideMode.ElideRight, area.width())
            painter.drawText(area.adjusted(0, 18, 0, 0), Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop, advice)

    # -------------------------------------------------------------------------------- zoom
    def wheelEvent(self, event: QWheelEvent) -> None:  # noqa: N802 - Qt's name
        if self._image is None or not event.angleDelta().y():
            return
        before = self._target()
        at = event.position()
        share = QPointF((at.x() - before.left()) / before.width(), (at.y() - before.top()) / before.height())
        self._zoom = min(_MOST_ZOOM, max(1.0, self._zoom * 1.2 ** (event.angleDelta().y() / 120)))
        after = self._target()
        self._middle += QPointF(
            (share.x() * after.width() + after.left() - at.x()) / after.width(), (share.y() * after.height() + after.top() - at.y()) / after.height()
        )
        self._keep_inside()
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        self._grip = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        if self._grip is not None and self._image is not None:
            target = self._target()
            moved = event.position() - self._grip
            self._middle -= QPointF(moved.x() / target.width(), moved.y() / target.height())
            self._grip = event.position()
            self._keep_inside()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        self._grip = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        self._zoom, self._middle = 1.0, QPointF(0.5, 0.5)
        self.update()

    def _keep_inside(self) -> None:
        half = 0.5 / self._zoom
        self._middle = QPointF(min(1 - half, max(half, self._middle.x())), min(1 - half, max(half, self._middle.y())))
        self.update()
