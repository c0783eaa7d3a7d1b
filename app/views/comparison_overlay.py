"""What lies over the 3D view of a comparison as flat drawing: names, ranks, curtain, brush, lasso, landmarks.

Drawn by Qt and not by VTK: it keeps its size at every zoom, is sharp at every pixel ratio, and follows the pointer
without a new picture of the scene.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from app.theme import look

_HANDLE = QRectF(-15, -15, 30, 30)


@dataclass(frozen=True, slots=True)
class Tag:
    """A word at a place: `at` is what it belongs to, `spot` where it is written, both in pixels."""

    text: str
    at: QPointF
    spot: QPointF
    chosen: bool = False
    key: int = 0


class ComparisonOverlay(QWidget):
    """Transparent for the mouse; the scene tells it what to draw."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.captions: list[tuple[QRectF, str, Qt.AlignmentFlag]] = []
        """Names of the pictures: a rectangle, the word, and the side of the rectangle on which it stands."""
        self.keys: list[tuple[str, str]] = []
        """Colours of lines and what they are."""
        self.seam_x: float | None = None
        """A line between two pictures."""
        self.curtain_x: float | None = None
        self.tags: list[Tag] = []
        self.points: list[QPointF] = []
        self.brush: tuple[QPointF, float, bool] | None = None
        """Middle, radius in pixels, and whether it erases."""
        self.lasso: list[QPointF] = []
        self.twin: QPointF | None = None
        """The pointer's place in the other of two pictures."""
        self.sides: list[tuple[QPointF, str]] = []
        """Letters for the patient's right and left."""
        self.bar: tuple[float, str] | None = None
        """A true length: pixels and its words."""
        self.readout: tuple[QPointF, str] | None = None
        """What is written beside the pointer."""

    def tag_at(self, place: QPointF) -> int | None:
        """The key of the tag under the pointer."""
        return next((tag.key for tag in self.tags if tag.key and _box(tag).contains(place)), None)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint_curtain(painter)
            self._paint_captions(painter)
            self._paint_keys(painter)
            self._paint_measures(painter)
            self._paint_landmarks(painter)
            for tag in self.tags:
                _paint_tag(painter, tag)
            self._paint_tool(painter)

    def _paint_curtain(self, painter: QPainter) -> None:
        if self.seam_x is not None:
            painter.setPen(QPen(QColor(look.ground), 2))
            painter.drawLine(QPointF(self.seam_x, 0), QPointF(self.seam_x, self.height()))
        if self.curtain_x is None:
            return
        x = self.curtain_x
        for colour, width in ((look.ground, 4.0), (look.text, 1.6)):
            painter.setPen(QPen(QColor(colour), width))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
        middle = QPointF(x, 0.5 * self.height())
        painter.setPen(QPen(QColor(look.ground), 1.5))
        painter.setBrush(QColor(look.text))
        painter.drawEllipse(_HANDLE.translated(middle))
        painter.setPen(QPen(QColor(look.ground), 2.2, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for side in (-1, 1):
            painter.drawPolyline([middle + QPointF(side * dx, dy) for dx, dy in ((4.0, -5.0), (9.0, 0.0), (4.0, 5.0))])

    def _paint_captions(self, painter: QPainter) -> None:
        font = QFont(painter.font())
        font.setWeight(QFont.Weight.DemiBold)
        painter.setFont(font)
        for rectangle, word, side in self.captions:
            size = painter.fontMetrics().size(0, word)
            box = QRectF(0, 0, size.width() + 18, size.height() + 8)
            box.moveTop(rectangle.top() + 12)
            if side == Qt.AlignmentFlag.AlignRight:
                box.moveRight(rectangle.right() - 12)
            else:
                box.moveLeft(rectangle.left() + 12)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(_glass())
            painter.drawRoundedRect(box, 5, 5)
            painter.setPen(QColor(look.text))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)

    def _paint_keys(self, painter: QPainter) -> None:
        top = self.height() - 14.0 - 22.0 * len(self.keys)
        width = max((painter.fontMetrics().horizontalAdvance(word) for _, word in self.keys), default=0)
        if self.keys:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(_glass())
            painter.drawRoundedRect(QRectF(12, top - 4, width + 48, 22.0 * len(self.keys) + 8), 5, 5)
        for i, (colour, word) in enumerate(self.keys):
            middle = top + 22.0 * i + 11
            painter.setPen(QPen(QColor(colour), 3))
            painter.drawLine(QPointF(20, middle), QPointF(42, middle))
            painter.setPen(QColor(look.text))
            painter.drawText(QRectF(50, middle - 11, width + 8, 22), Qt.AlignmentFlag.AlignVCenter, word)

    def _paint_measures(self, painter: QPainter) -> None:
        for place, word in self.sides:
            box = QRectF(place.x() - 12, place.y() - 12, 24, 24)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(_glass())
            painter.drawRoundedRect(box, 5, 5)
            painter.setPen(QColor(look.text))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)
        if self.bar is None:
            return
        length, word = self.bar
        end = QPointF(self.width() - 18, self.height() - 18)
        start = end - QPointF(length, 0)
        painter.setPen(QPen(QColor(look.text), 1.6))
        painter.drawPolyline([start - QPointF(0, 5), start, end, end - QPointF(0, 5)])
        painter.drawText(QRectF(start.x(), end.y() - 26, length, 18), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextDontClip, word)

    def _paint_landmarks(self, painter: QPainter) -> None:
        painter.setPen(QPen(QColor(look.ground), 1.5))
        painter.setBrush(QColor(look.text))
        for point in self.points:
            painter.drawEllipse(point, 4.5, 4.5)

    def _paint_tool(self, painter: QPainter) -> None:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if self.brush is not None:
            middle, radius, erases = self.brush
            for colour, width in ((look.ground, 3.5), (look.muted if erases else look.accent, 1.8)):
                painter.setPen(QPen(QColor(colour), width, Qt.PenStyle.DashLine if erases else Qt.PenStyle.SolidLine))
                painter.drawEllipse(middle, radius, radius)
        if len(self.lasso) > 1:
            fill = QColor(look.accent)
            fill.setAlpha(40)
            painter.setBrush(fill)
            painter.setPen(QPen(QColor(look.accent), 1.8))
            painter.drawPolygon(QPolygonF(self.lasso))
        if self.twin is not None:
            for colour, width in ((look.ground, 4.0), (look.text, 1.6)):
                painter.setPen(QPen(QColor(colour), width))
                painter.drawLine(self.twin - QPointF(9, 0), self.twin + QPointF(9, 0))
                painter.drawLine(self.twin - QPointF(0, 9), self.twin + QPointF(0, 9))
        if self.readout is not None:
            place, word = self.readout
            size = painter.fontMetrics().size(0, word)
            box = QRectF(place.x() + 16, place.y() + 14, size.width() + 16, size.height() + 8)
            if box.right() > self.width():
                box.moveRight(place.x() - 10)
            if box.bottom() > self.height():
                box.moveBottom(place.y() - 10)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(_glass())
            painter.drawRoundedRect(box, 5, 5)
            painter.setPen(QColor(look.text))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)


def _glass() -> QColor:
    colour = QColor(look.ground)
    colour.setAlpha(215)
    return colour


def _box(tag: Tag) -> QRectF:
    width = max(22.0, 9.0 * len(tag.text) + 6.0)
    return QRectF(tag.spot.x() - width / 2, tag.spot.y() - 11, width, 22)


def _paint_tag(painter: QPainter, tag: Tag) -> None:
    font = QFont(painter.font())
    font.setWeight(QFont.Weight.DemiBold)
    painter.setFont(font)
    if tag.at != tag.spot:
        for colour, width in ((look.ground, 3.5), (look.text, 1.2)):
            painter.setPen(QPen(QColor(colour), width))
            painter.drawLine(tag.at, tag.spot)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(look.text))
        painter.drawEllipse(tag.at, 2.5, 2.5)
    painter.setPen(QPen(QColor(look.text if tag.chosen else look.seam), 1.2))
    painter.setBrush(QColor(look.accent) if tag.chosen else _glass())
    box = _box(tag)
    painter.drawRoundedRect(box, 11, 11)
    painter.setPen(QColor(look.ground if tag.chosen else look.text))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, tag.text)
