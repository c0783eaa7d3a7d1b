"""How far the points lie from the surface, live: a histogram on a logarithmic axis that never moves, with half and 95 of 100 marked.

One colour for all bars; the two marks differ in their dash and are named, so that nothing hangs on a hue.
"""

from __future__ import annotations

from math import log

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.theme import look
from app.views import format as fmt
from scanner_core.geometry.distance_histogram import LEAST_UM, MOST_UM

_TICKS_UM = (1.0, 10.0, 100.0, 1000.0, 10_000.0)
_HEIGHT, _HEAD, _FOOT = 118, 17, 16
_TEXT_PX = 11


class DistanceChart(QWidget):
    """Empty until there are distances."""

    def __init__(self) -> None:
        super().__init__()
        self._counts: tuple[int, ...] = ()
        self._median_um = self._p95_um = 0.0
        self.setFixedHeight(_HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(self.tr("Distance of the points from the surface"))
        self.setToolTip(self.tr("Half of the points are nearer to the surface than the first mark, 95 of 100 nearer than the second."))

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(260, _HEIGHT)

    def show_distances(self, counts: tuple[int, ...], median_um: float, p95_um: float) -> None:
        """Points in each class from 1 µm to 10 mm; none empties the chart."""
        if (counts, median_um, p95_um) == (self._counts, self._median_um, self._p95_um):
            return
        self._counts, self._median_um, self._p95_um = counts, median_um, p95_um
        said = self.tr("Half of the points are within {median} of the surface, 95 of 100 within {p95}.")
        self.setAccessibleDescription(said.format(median=_length(median_um), p95=_length(p95_um)) if counts else "")
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            font = painter.font()
            font.setPixelSize(_TEXT_PX)
            painter.setFont(font)
            plot = QRectF(0.5, _HEAD, self.width() - 1, self.height() - _HEAD - _FOOT)
            self._paint_axis(painter, plot)
            if self._counts:
                self._paint_bars(painter, plot)
                self._paint_marks(painter, plot)

    def _paint_axis(self, painter: QPainter, plot: QRectF) -> None:
        metrics = QFontMetricsF(painter.font())
        words = ("1 µm", "10 µm", "100 µm", "1 mm", "10 mm")
        for value, word in zip(_TICKS_UM, words, strict=True):
            at = _place(value, plot)
            painter.setPen(QPen(QColor(look.seam), 1))
            painter.drawLine(QPointF(at, plot.top()), QPointF(at, plot.bottom()))
            wide = metrics.horizontalAdvance(word)
            painter.setPen(QColor(look.muted))
            painter.drawText(QPointF(min(max(at - wide / 2, 0.0), self.width() - wide), self.height() - 3.0), word)
        painter.setPen(QPen(QColor(look.muted), 1))
        painter.drawLine(plot.bottomLeft(), plot.bottomRight())

    def _paint_bars(self, painter: QPainter, plot: QRectF) -> None:
        step, most = plot.width() / len(self._counts), max(self._counts)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(look.accent))
        for number, count in enumerate(self._counts):
            high = (plot.height() - 3) * count / max(most, 1)
            painter.drawRect(QRectF(plot.left() + number * step + 0.5, plot.bottom() - high, max(step - 1.0, 1.0), high))

    def _paint_marks(self, painter: QPainter, plot: QRectF) -> None:
        """Half of the points to the left of the first, 95 of 100 to the left of the second; its words outwards where there is room."""
        metrics = QFontMetricsF(painter.font())
        marks = (
            (self._median_um, Qt.PenStyle.SolidLine, self.tr("half {length}")),
            (self._p95_um, Qt.PenStyle.DashLine, self.tr("95 % {length}")),
        )
        places = [_place(value, plot) for value, _, _ in marks]
        said = [words.format(length=_length(value)) for value, _, words in marks]
        wide = [metrics.horizontalAdvance(words) for words in said]
        second = min(max(places[1] + 4, 0.0), self.width() - wide[1])
        first = min(max(places[0] - wide[0] - 4, 0.0), second - wide[0] - 8)
        if first < 0:
            first, second = 0.0, max(second, wide[0] + 8)
        for at, left, words, (_, dash, _) in zip(places, (first, second), said, marks, strict=True):
            line = QPointF(at, _HEAD - 3.0), QPointF(at, plot.bottom())
            painter.setPen(QPen(QColor(look.panel), 4))  # so that the mark is seen on the bars too
            painter.drawLine(*line)
            painter.setPen(QPen(QColor(look.text), 1.5, dash))
            painter.drawLine(*line)
            painter.setPen(QColor(look.text))
            painter.drawText(QPointF(left, 11.0), words)


def _length(value_um: float) -> str:
    """7.3 µm, 240 µm, 1.2 mm."""
    return f"{fmt.micrometres(value_um)} µm" if value_um < 1000 else f"{fmt.decimal(value_um / 1000, 1)} mm"


def _place(value_um: float, plot: QRectF) -> float:
    """Where a distance lies on the axis, px."""
    share = log(min(max(value_um, LEAST_UM), MOST_UM) / LEAST_UM) / log(MOST_UM / LEAST_UM)
    return plot.left() + share * plot.width()
