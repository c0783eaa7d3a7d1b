"""How large the bright places are that the cameras see, and between which sizes one is taken for a spot; the limits are dragged."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Iterable

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.theme import look

_SMALLEST_PX, _LARGEST_PX = 1.0, 2000.0
_BINS = 44
_KEPT = 600
"""Bright places that are counted: about ten seconds of both cameras."""
_PERIOD_S = 0.2
"""Bars change no more often than this: nobody reads faster."""
_LOW, _HIGH = 0, 1
_RANGES = ((1, 100), (2, 100_000))
_GRIP = 9.0
_FOOT = 18
_TICKS = (1, 3, 10, 30, 100, 300, 1000)


class SizeHistogram(QWidget):
    """The axis is logarithmic.  Left and right move the chosen limit by a pixel (with Shift by a tenth of it), up and down choose it."""

    limited = Signal(int, int)
    """A person has moved a limit: smallest and largest area, px."""

    def __init__(self) -> None:
        super().__init__()
        self._sizes: deque[tuple[int, bool]] = deque(maxlen=_KEPT)
        self._limits: list[int] = [2, 600]
        self._chosen = _LOW
        self._gripped: int | None = None
        self._painted_s = 0.0
        self.setMinimumHeight(112)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setToolTip(self.tr("Drag a limit, or choose it with up and down and move it with left and right"))
        self._name()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(260, 118)

    @property
    def limits(self) -> tuple[int, int]:
        return self._limits[_LOW], self._limits[_HIGH]

    @property
    def counted(self) -> int:
        return len(self._sizes)

    def add(self, sizes: Iterable[tuple[int, bool]]) -> None:
        """Areas in pixels, and whether each was accepted."""
        before = len(self._sizes)
        self._sizes.extend(sizes)
        now_s = time.monotonic()
        if (self._sizes or before) and now_s - self._painted_s > _PERIOD_S:
            self._painted_s = now_s
            self.update()

    def clear(self) -> None:
        self._sizes.clear()
        self.update()

    def show_limits(self, min_area_px: int, max_area_px: int) -> None:
        """As they are used; while one is dragged the person knows better."""
        if self._gripped is None and self.limits != (min_area_px, max_area_px):
            self._limits = [min_area_px, max_area_px]
            self._name()
            self.update()

    def place_of(self, area_px: float) -> float:
        """Where an area lies, in this widget's pixels."""
        share = math.log(max(area_px, _SMALLEST_PX) / _SMALLEST_PX) / math.log(_LARGEST_PX / _SMALLEST_PX)
        return 6 + min(share, 1.0) * (self.width() - 12)

    # -------------------------------------------------------------------------------- painting
    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        ground = QRectF(0, 0, self.width(), self.height() - _FOOT)
        painter.fillRect(ground, QColor(look.ground))
        low, high = (self.place_of(limit) for limit in self._limits)
        painter.fillRect(QRectF(low, 0, high - low, ground.height()), QColor(look.accent_ground))
        self._bars(painter, ground)
        font = painter.font()
        font.setPixelSize(11)
        painter.setFont(font)
        painter.setPen(QColor(look.muted))
        for tick in _TICKS:
            x = self.place_of(tick)
            painter.drawText(QRectF(x - 20, ground.bottom() + 2, 40, _FOOT - 2), Qt.AlignmentFlag.AlignCenter, str(tick))
        for index, x in ((_LOW, low), (_HIGH, high)):
            self._handle(painter, index, x, ground)
        if not self._sizes:
            painter.setPen(QColor(look.muted))
            painter.drawText(ground, Qt.AlignmentFlag.AlignCenter, self.tr("Live shows how large spots are"))
        if self.hasFocus():
            painter.setPen(QPen(QColor(look.accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(ground.adjusted(1, 1, -1, -1))

    def _bars(self, painter: QPainter, ground: QRectF) -> None:
        """Accepted ones below, what was rejected upon them."""
        counts = [[0, 0] for _ in range(_BINS)]
        for area, accepted in self._sizes:
            share = (self.place_of(area) - 6) / max(self.width() - 12, 1)
            counts[min(int(share * _BINS), _BINS - 1)][0 if accepted else 1] += 1
        most = max((sum(pair) for pair in counts), default=0)
        if not most:
            return
        width = (self.width() - 12) / _BINS
        for number, (good, bad) in enumerate(counts):
            left, foot = 6 + number * width, ground.bottom()
            for count, colour in ((good, look.accent), (bad, look.warning)):
                height = (ground.height() - 8) * math.sqrt(count / most) if good == 0 or bad == 0 else (ground.height() - 8) * count / most
                painter.fillRect(QRectF(left, foot - height, width - 1, height), QColor(colour))
                foot -= height

    def _handle(self, painter: QPainter, index: int, x: float, ground: QRectF) -> None:
        colour = QColor(look.text if self.hasFocus() and index == self._chosen else look.edge)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(QPen(colour, 2))
        painter.drawLine(QPointF(x, 0), QPointF(x, ground.bottom()))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawPolygon(QPolygonF([QPointF(x - 6, 0), QPointF(x + 6, 0), QPointF(x, 9)]))

    # -------------------------------------------------------------------------------- input
    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        x = event.position().x()
        away = [abs(x - self.place_of(limit)) for limit in self._limits]
        nearest = _LOW if away[_LOW] <= away[_HIGH] else _HIGH
        if away[nearest] <= _GRIP:
            self._gripped = self._chosen = nearest
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        if self._gripped is not None:
            share = (event.position().x() - 6) / max(self.width() - 12, 1)
            self._move(self._gripped, round(_SMALLEST_PX * (_LARGEST_PX / _SMALLEST_PX) ** min(max(share, 0.0), 1.0)))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        if self._gripped is not None:
            self._gripped = None
            self.limited.emit(*self.limits)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        key, limit = event.key(), self._limits[self._chosen]
        if key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self._chosen = _HIGH if key == Qt.Key.Key_Up else _LOW
            self._name()
            self.update()
        elif key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            wide = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            step = max(1, round(0.1 * limit)) if wide else 1
            self._move(self._chosen, limit + (step if key == Qt.Key.Key_Right else -step))
            self.limited.emit(*self.limits)
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        super().focusOutEvent(event)
        self.update()

    def _move(self, index: int, area_px: int) -> None:
        """Within what the detector takes, and never past the other limit."""
        lowest, highest = _RANGES[index]
        area_px = min(max(area_px, lowest), highest)
        self._limits[index] = min(area_px, self._limits[_HIGH] - 1) if index == _LOW else max(area_px, self._limits[_LOW] + 1)
        self._name()
        self.update()

    def _name(self) -> None:
        chosen = self.tr("smallest size chosen") if self._chosen == _LOW else self.tr("largest size chosen")
        name = self.tr("Size of a spot: {low} to {high} pixels, {chosen}")
        self.setAccessibleName(name.format(low=self._limits[_LOW], high=self._limits[_HIGH], chosen=chosen))
