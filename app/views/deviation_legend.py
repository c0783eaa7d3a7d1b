"""What the colours of the map mean: bands, grey within the level of detection, threshold, hatch, and the value under the pointer."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.theme import look
from app.views import format as fmt
from app.views.comparison_words import fine_millimetres
from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART, THRESHOLD_LINE, WITHIN_LEVEL, DeviationScale

_SIDE, _BAR_TOP, _BAR = 26.0, 22.0, 14.0
_HEIGHT = 92


class DeviationLegend(QWidget):
    """A stepped scale that lies; empty until there is one."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scale: DeviationScale | None = None
        self._threshold_um: float | None = None
        self._value_um: float | None = None
        self.setMinimumSize(300, _HEIGHT)
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        policy.setRetainSizeWhenHidden(True)  # the picture above it keeps its size where no map is shown
        self.setSizePolicy(policy)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(420, _HEIGHT)

    def show_scale(self, scale: DeviationScale | None) -> None:
        self._scale = scale
        self.update()

    def set_threshold_um(self, threshold_um: float | None) -> None:
        """The line of the map when it is not the scale's own."""
        self._threshold_um = threshold_um
        self.update()

    def show_value(self, value_um: float | None) -> None:
        """Of the point under the pointer."""
        if value_um != self._value_um:
            self._value_um = value_um
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        if self._scale is None:
            return
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint(painter, self._scale)

    def _paint(self, painter: QPainter, scale: DeviationScale) -> None:
        font = painter.font()
        font.setPixelSize(12)
        painter.setFont(font)
        metrics = QFontMetricsF(font)
        bar = QRectF(_SIDE, _BAR_TOP, self.width() - 2 * _SIDE, _BAR)

        def at(um: float) -> float:
            return bar.left() + bar.width() * (min(max(um, -scale.limit_um), scale.limit_um) / scale.limit_um + 1) / 2

        painter.setPen(QColor(look.muted))
        painter.drawText(QPointF(bar.left(), 14), self.tr("− inward"))
        word = self.tr("outward +")
        painter.drawText(QPointF(bar.right() - metrics.horizontalAdvance(word), 14), word)
        unit = self.tr("after against before, mm")
        painter.drawText(QPointF(bar.center().x() - metrics.horizontalAdvance(unit) / 2, 14), unit)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        edges = scale.edges_um
        for low, high, colour in zip(edges[:-1], edges[1:], scale.band_colours, strict=True):
            painter.fillRect(QRectF(at(low), bar.top(), at(high) - at(low) + 0.5, bar.height()), QColor(*(int(value) for value in colour)))
        grey = QRectF(at(-scale.level_um), bar.top(), at(scale.level_um) - at(-scale.level_um), bar.height())
        painter.fillRect(grey, QColor(*WITHIN_LEVEL))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        threshold = scale.threshold_um if self._threshold_um is None else self._threshold_um
        if 0 < threshold <= scale.limit_um:
            for sign in (-1, 1):
                x = at(sign * threshold)
                painter.setPen(QPen(QColor(look.text), 3.2))
                painter.drawLine(QPointF(x, bar.top() - 3), QPointF(x, bar.bottom() + 3))
                painter.setPen(QPen(QColor(*THRESHOLD_LINE), 1.6))
                painter.drawLine(QPointF(x, bar.top() - 3), QPointF(x, bar.bottom() + 3))
        painter.setPen(QColor(look.text))
        free = bar.left() - 100.0
        for um, text in scale.ticks():
            width = metrics.horizontalAdvance(text)
            if at(um) - width / 2 > free + 4:
                painter.drawText(QPointF(at(um) - width / 2, bar.bottom() + 15), text)
                free = at(um) + width / 2
        self._paint_key(painter, metrics, scale, threshold)
        if self._value_um is not None:
            x = at(self._value_um)
            painter.setPen(QPen(QColor(*THRESHOLD_LINE), 1))
            painter.setBrush(QColor(look.text))
            painter.drawPolygon(QPolygonF([QPointF(x, bar.top() + 2), QPointF(x - 5, bar.top() - 7), QPointF(x + 5, bar.top() - 7)]))

    def _paint_key(self, painter: QPainter, metrics: QFontMetricsF, scale: DeviationScale, threshold: float) -> None:
        """Grey, line and hatch with their words."""
        top = _BAR_TOP + _BAR + 28
        words = (
            self.tr("within ±{mm} mm: not detectable").format(mm=fine_millimetres(scale.level_um)),
            self.tr("±{mm} mm").format(mm=fmt.decimal(threshold / 1000, 2)),
            self.tr("no counterpart"),
        )
        x = _SIDE
        for i, word in enumerate(words):
            box = QRectF(x, top, 18, 12)
            if i == 0:
                painter.fillRect(box, QColor(*WITHIN_LEVEL))
            elif i == 1:
                painter.fillRect(box, QColor(*(int(value) for value in scale.band_colours[scale.steps])))
                painter.setPen(QPen(QColor(*THRESHOLD_LINE), 1.8))
                painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()))
            else:
                _hatch(painter, box)
            painter.setPen(QPen(QColor(look.faint), 1))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(box)
            painter.setPen(QColor(look.muted))
            painter.drawText(QPointF(box.right() + 6, box.bottom() - 1), word)
            x = box.right() + 6 + metrics.horizontalAdvance(word) + 16


def _hatch(painter: QPainter, box: QRectF) -> None:
    """As the surface has it where there is no counterpart."""
    painter.save()
    painter.setClipRect(box)
    painter.fillRect(box, QColor(*NO_COUNTERPART))
    painter.setPen(QPen(QColor(*HATCH), 1.7))
    for offset in range(-12, 30, 5):
        painter.drawLine(QPointF(box.left() + offset, box.top()), QPointF(box.left() + offset + 12, box.bottom()))
    painter.restore()
