"""What a camera sees, large: the spot with its ellipse, what else is bright with the reason why it is no spot, and the epipolar line."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPainterPath, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy

from app.palettes import DARK
from app.views.camera_preview import CameraPreview
from app.views.reasons import candidate_text
from scanner_core.acquisition.handover import Preview

if TYPE_CHECKING:
    from scanner_core.acquisition.live_look import LiveLook
    from scanner_core.optics.spot_candidates import SpotCandidate

_SIGMAS = 3.0
"""Of the ellipse: what it holds is 99 % of the light."""
_SMALLEST = 6.0
_LENS, _LENS_PX = 132.0, 20
"""Side of the magnifier on the screen, and in pixels of the camera."""
_STILL_PX = 4.0
"""A press that moves less is a click, which points; more drags the picture."""
_LABELS = 8
"""Reasons that are written out; more would hide the picture."""
_SHADE = QColor(16, 18, 20, 170)

_MOST_ZOOM = 24.0
_ZOOM = {"+": 1.5, "-": 1 / 1.5, "0": 0.0}
_JOG = {
    Qt.Key.Key_Left: ("x_deg", 1),
    Qt.Key.Key_Right: ("x_deg", -1),
    Qt.Key.Key_Up: ("y_deg", 1),
    Qt.Key.Key_Down: ("y_deg", -1),
    Qt.Key.Key_PageUp: ("table_deg", 1),
    Qt.Key.Key_PageDown: ("table_deg", -1),
}


class AimPicture(CameraPreview):
    """A click points the beam, arrow keys move it, Page Up and Page Down turn the table; Shift makes the step a fifth."""

    pointed = Signal(float, float)
    """The pixel that was clicked."""
    jogged = Signal(str, float)
    """Axis and number of steps."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self._candidates: tuple[SpotCandidate, ...] = ()
        self._line: NDArray[np.float64] = np.empty((0, 2))
        self._pressed: QPointF | None = None
        self.setMaximumHeight(16_777_215)
        self.setMinimumHeight(150)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip(
            self.tr("Click: bring the spot there. Arrow keys: move the beam. Page Up and Page Down: turn the table. Wheel, + and −: zoom.")
        )

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(640, 312)

    @property
    def reasons(self) -> list[tuple[float, float, str]]:
        """Where something is marked, px of the camera, and why it is no spot; nothing for the accepted one."""
        return [(candidate.x_px, candidate.y_px, candidate.reason) for candidate in self._candidates]

    def show_look(self, side: str, look: LiveLook, miss: str = "", advice: str = "") -> None:
        """The newest look at one side."""
        seen = look.looks[side]
        self._candidates = seen.candidates
        line = look.lines.get(side)
        self._line = np.empty((0, 2)) if line is None else line
        self.show_preview(Preview(look.frames[side], seen.seen), miss, advice)
        accepted = seen.accepted
        self._spot = None if accepted is None else accepted.spot
        text = self.tr("{camera}: {count} bright places, spot accepted") if accepted else self.tr("{camera}: {count} bright places, no spot accepted")
        self.setAccessibleDescription(text.format(camera=self._name, count=len(seen.candidates)))

    def clear(self) -> None:
        self._candidates, self._line = (), np.empty((0, 2))
        super().clear()

    def place_of(self, x_px: float, y_px: float) -> QPointF:
        """Where a pixel of the camera lies in this widget."""
        assert self._image is not None
        target = self._target()
        scale = target.width() / self._image.width()
        return QPointF(target.left() + (x_px + 0.5) * scale, target.top() + (y_px + 0.5) * scale)

    # -------------------------------------------------------------------------------- painting
    def _overlay(self, painter: QPainter) -> None:
        assert self._image is not None
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if len(self._line) > 1:
            painter.setPen(QPen(QColor(DARK.left_ear), 1.0, Qt.PenStyle.DashLine))
            painter.drawPolyline(QPolygonF([self.place_of(x, y) for x, y in self._line.tolist()]))
        taken: list[QRectF] = []
        rejected = [candidate for candidate in self._candidates if not candidate.accepted]
        for candidate in rejected:
            self._outline(painter, candidate, DARK.warning)
        for candidate in (candidate for candidate in self._candidates if candidate.accepted):
            self._outline(painter, candidate, DARK.accent)
            if self._zoom < 6:
                self._enlarged(painter, candidate)
        for candidate in rejected[:_LABELS]:
            self._label(painter, candidate, taken)

    def _enlarged(self, painter: QPainter, candidate: SpotCandidate) -> None:
        """The accepted spot pixel by pixel with its ellipse, in the lower corner that is farther from it."""
        assert self._image is not None
        side = min(_LENS, 0.45 * self.height())
        scale = side / _LENS_PX
        left = self.place_of(candidate.x_px, candidate.y_px).x() > self.width() / 2
        frame = QRectF(6 if left else self.width() - side - 6, self.height() - side - 6, side, side)
        source = QRectF(candidate.x_px + 0.5 - _LENS_PX / 2, candidate.y_px + 0.5 - _LENS_PX / 2, _LENS_PX, _LENS_PX)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
        painter.fillRect(frame, QColor(0, 0, 0))
        painter.drawImage(frame, self._image, source)
        painter.setPen(QColor(DARK.muted))
        painter.drawRect(frame)
        long, short, angle = candidate.ellipse()
        painter.translate(frame.center())
        painter.rotate(angle)
        painter.setPen(QPen(QColor(DARK.accent), 1.4))
        painter.drawEllipse(QPointF(0, 0), min(_SIGMAS * long * scale, side / 2), min(_SIGMAS * short * scale, side / 2))
        painter.restore()

    def _outline(self, painter: QPainter, candidate: SpotCandidate, colour: str) -> None:
        """Dotted for what was rejected: colour says it only sooner."""
        assert self._image is not None
        scale = self._target().width() / self._image.width()
        long, short, angle = candidate.ellipse()
        at = self.place_of(candidate.x_px, candidate.y_px)
        painter.save()
        painter.translate(at)
        painter.rotate(angle)
        style = Qt.PenStyle.SolidLine if candidate.accepted else Qt.PenStyle.DotLine
        painter.setPen(QPen(QColor(colour), 1.6, style))
        painter.drawEllipse(QPointF(0, 0), max(_SMALLEST, _SIGMAS * long * scale), max(_SMALLEST, _SIGMAS * short * scale))
        painter.restore()
        if candidate.accepted:
            painter.setPen(QPen(QColor(colour), 1.0))
            painter.drawLines([QLineF(at.x() - 3, at.y(), at.x() + 3, at.y()), QLineF(at.x(), at.y() - 3, at.x(), at.y() + 3)])

    def _label(self, painter: QPainter, candidate: SpotCandidate, taken: list[QRectF]) -> None:
        """The reason beside its place, moved down where another one stands already."""
        assert self._image is not None
        font = painter.font()
        font.setPixelSize(12)
        painter.setFont(font)
        text = candidate_text(candidate.reason, candidate.area_px)
        words = painter.fontMetrics()
        at = self.place_of(candidate.x_px, candidate.y_px)
        away = max(_SMALLEST, _SIGMAS * candidate.ellipse()[0] * self._target().width() / self._image.width())
        away = min(away, 60.0) + 5
        width, height = words.horizontalAdvance(text) + 10.0, words.height() + 4.0
        left = at.x() + away if at.x() + away + width < self.width() else at.x() - away - width
        box = QRectF(max(2.0, left), min(max(26.0, at.y() - height / 2), self.height() - height - 2), width, height)
        while any(box.intersects(other) for other in taken) and box.bottom() + height < self.height():
            box.translate(0, height)
        taken.append(box)
        path = QPainterPath()
        path.addRoundedRect(box, 3, 3)
        painter.fillPath(path, _SHADE)
        painter.setPen(QColor(DARK.warning))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def _caption(self, painter: QPainter) -> None:
        super()._caption(painter)
        if self.hasFocus():
            painter.setPen(QPen(QColor(DARK.accent), 2))
            painter.drawRect(self.rect().adjusted(1, 1, -2, -2))

    # -------------------------------------------------------------------------------- input
    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        super().mousePressEvent(event)
        self._pressed = event.position() if event.button() is Qt.MouseButton.LeftButton else None

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        super().mouseReleaseEvent(event)
        if self._pressed is None or self._image is None:
            return
        moved, self._pressed = event.position() - self._pressed, None
        if math.hypot(moved.x(), moved.y()) > _STILL_PX:
            return
        target = self._target()
        scale = target.width() / self._image.width()
        x, y = (event.position().x() - target.left()) / scale - 0.5, (event.position().y() - target.top()) / scale - 0.5
        if 0 <= x < self._image.width() and 0 <= y < self._image.height():
            self.pointed.emit(x, y)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        if event.text() in _ZOOM:
            self._zoom_to_spot(_ZOOM[event.text()])
            return
        move = _JOG.get(Qt.Key(event.key()))
        if move is None:
            super().keyPressEvent(event)
            return
        axis, sign = move
        self.jogged.emit(axis, sign * (0.2 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0))

    def _zoom_to_spot(self, factor: float) -> None:
        """About the accepted spot, or the middle of what is shown; a factor of 0 shows the whole picture."""
        self._zoom = min(_MOST_ZOOM, max(1.0, self._zoom * factor))
        if self._image is not None and self._spot is not None:
            self._middle = QPointF((self._spot.x_px + 0.5) / self._image.width(), (self._spot.y_px + 0.5) / self._image.height())
        self._keep_inside()

    def focusInEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        super().focusOutEvent(event)
        self.update()
