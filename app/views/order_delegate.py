"""How a line of the worklist looks: thumbnail, number, side, type and code on the left, state and age on the right."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPainter, QPalette, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from app.theme import drawing, look, look_of
from app.views import format as fmt
from app.views.order_model import ORDER, RUNNING, OrderModel
from app.views.order_words import kind_word, side_word, state_of
from scanner_core.case.case_glance import CaseGlance

HEIGHT = 66
_PICTURE = QSize(72, 54)
_MARGIN, _GAP = 14, 12
_SIGN = 16
_SIDES = {"left": "left_ear", "right": "right_ear"}


class OrderDelegate(QStyledItemDelegate):
    """Paints; computes nothing."""

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QSize:  # noqa: N802 - Qt's name
        return QSize(320, HEIGHT)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> None:
        told, running = index.data(ORDER), bool(index.data(RUNNING))
        if not isinstance(told, CaseGlance):
            return
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._ground(painter, option)
        inner = option.rect.adjusted(_MARGIN, 0, -_MARGIN, 0)
        frame = QRect(inner.left(), inner.center().y() - _PICTURE.height() // 2, _PICTURE.width(), _PICTURE.height())
        self._picture(painter, frame, told, index)
        words = inner.adjusted(_PICTURE.width() + _GAP, 0, 0, 0)
        upper, lower = QRect(words.left(), words.top() + 9, words.width(), 24), QRect(words.left(), words.top() + 34, words.width(), 22)
        left = self._state(painter, upper, told, running, option.font)
        bold = QFont(option.font)
        bold.setPixelSize(15)
        bold.setWeight(QFont.Weight.DemiBold)
        number = told.order.number or told.path.stem
        _write(painter, upper.adjusted(0, 0, left - upper.right() - _GAP, 0), number, bold, look.text)
        age = fmt.ago(told.changed)
        _write(painter, lower, age, option.font, look.muted, right=True)
        rest = lower.adjusted(0, 0, -QFontMetrics(option.font).horizontalAdvance(age) - _GAP, 0)
        at = self._badge(painter, rest, told.order.side, option.font)
        kind = "  ·  ".join(part for part in (kind_word(told.order.type), told.order.patient_code) if part)
        _write(painter, rest.adjusted(at, 0, 0, 0), kind, option.font, look.muted)
        painter.restore()

    def _ground(self, painter: QPainter, option: QStyleOptionViewItem) -> None:
        state = option.state
        if state & QStyle.StateFlag.State_Selected:
            painter.fillRect(option.rect, QColor(look.raised))
            painter.fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), QColor(look.accent))
        elif state & QStyle.StateFlag.State_MouseOver:
            painter.fillRect(option.rect, QColor(look.hovered))
        painter.setPen(QPen(QColor(look.seam), 1))
        painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight())
        if state & QStyle.StateFlag.State_HasFocus and option.palette.currentColorGroup() == QPalette.ColorGroup.Active:
            painter.setPen(QPen(QColor(look.accent), 1))
            painter.drawRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -1.5))

    def _picture(self, painter: QPainter, frame: QRect, told: CaseGlance, index: QModelIndex | QPersistentModelIndex) -> None:
        model = index.model()
        image = model.image(told) if isinstance(model, OrderModel) else None
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(look.ground))
        painter.drawRoundedRect(frame, 4, 4)
        if image is not None:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(frame.adjusted(3, 2, -3, -2), image)
            return
        sign = QSize(26, 26)
        name = "ear" if told.order.type == "ear" else "arch" if told.order.type.startswith("arch") else "specimen"
        painter.setOpacity(0.55)
        painter.drawPixmap(frame.center().x() - 12, frame.center().y() - 12, drawing(name, "faint", sign))
        painter.setOpacity(1.0)

    def _state(self, painter: QPainter, line: QRect, told: CaseGlance, running: bool, font: QFont) -> int:
        """At the right end of the line; where it begins."""
        word, sign, colour = state_of(told, running=running)
        width = QFontMetrics(font).horizontalAdvance(word)
        left = line.right() - width - _SIGN - 7
        painter.drawPixmap(left, line.center().y() - _SIGN // 2 + 1, drawing(sign, colour, QSize(_SIGN, _SIGN)))
        _write(painter, line, word, font, look_of(colour), right=True)
        return left

    def _badge(self, painter: QPainter, line: QRect, side: str, font: QFont) -> int:
        """The side as a word in an outline of its colour; how much of the line it takes."""
        word = side_word(side)
        if not word:
            return 0
        bold = QFont(font)
        bold.setPixelSize(12)
        bold.setWeight(QFont.Weight.DemiBold)
        colour = QColor(look_of(_SIDES[side])) if side in _SIDES else QColor(look.text)
        frame = QRectF(line.left() + 0.5, line.center().y() - 9.5, QFontMetrics(bold).horizontalAdvance(word) + 14, 20)
        painter.setPen(QPen(colour, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(frame, 4, 4)
        _write(painter, frame.toRect(), word, bold, colour.name(), centred=True)
        return round(frame.width()) + 9


def _write(painter: QPainter, place: QRect, text: str, font: QFont, colour: str, *, right: bool = False, centred: bool = False) -> None:
    """One line, cut with dots where there is no room."""
    painter.setFont(font)
    painter.setPen(QColor(colour))
    across = Qt.AlignmentFlag.AlignHCenter if centred else Qt.AlignmentFlag.AlignRight if right else Qt.AlignmentFlag.AlignLeft
    cut = QFontMetrics(font).elidedText(text, Qt.TextElideMode.ElideRight, max(place.width(), 0) + 1)
    painter.drawText(place, across | Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextSingleLine, cut)
