"""The plan of a scan as a bar: one segment a view, its state told by height, sign and colour."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from app.theme import look
from app.views.plan_words import view_tooltip, view_words
from scanner_core.acquisition.view_state import ViewProgress, ViewState

_HEIGHT = 26
_LOW, _SIGN = 5.0, 10
"""Height of a view to come, and of the sign over one that is not done well."""
_GAP_FROM = 4.0
"""Segments at least so wide stand apart."""
_SIGNS = {ViewState.TO_REDO: "↻", ViewState.WEAK: "!", ViewState.DOING: "▾"}


class PlanBar(QWidget):
    """Choose a segment with the pointer or with the arrow keys; its words stand in the tool tip and in the accessible name."""

    chosen = Signal(int)
    """Number of the view that is looked at from now on; -1 for none."""

    def __init__(self) -> None:
        super().__init__()
        self._views: tuple[ViewProgress, ...] = ()
        self._chosen = -1
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self._tell()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(120, _HEIGHT)

    @property
    def views(self) -> tuple[ViewProgress, ...]:
        return self._views

    @property
    def choice(self) -> ViewProgress | None:
        """The view that is looked at."""
        return self._views[self._chosen] if 0 <= self._chosen < len(self._views) else None

    def show_plan(self, views: Sequence[ViewProgress], planned: int = 0, now: int = -1) -> None:
        """These views; where they are not known yet, `planned` of which number `now` is being visited."""
        views = tuple(views) or tuple(
            ViewProgress(number, 0.0, ViewState.DOING if number == now else ViewState.DONE if number < now else ViewState.COMING)
            for number in range(planned)
        )
        if views != self._views:
            self._views = views
            self._tell()
            self.update()

    def choose(self, number: int) -> None:
        """Look at this one; -1 at none."""
        number = number if 0 <= number < len(self._views) else -1
        if number != self._chosen:
            self._chosen = number
            self._tell()
            self.update()
            self.chosen.emit(number)

    # -------------------------------------------------------------------------------- pointer and keys
    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        at = self._at(event.position().x())
        self.choose(-1 if at == self._chosen else at)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        last = len(self._views) - 1
        to = {
            Qt.Key.Key_Left: max(0, self._chosen - 1),
            Qt.Key.Key_Right: min(last, self._chosen + 1),
            Qt.Key.Key_Home: 0,
            Qt.Key.Key_End: last,
        }.get(Qt.Key(event.key()))
        if to is None or last < 0:
            super().keyPressEvent(event)
        else:
            self.choose(to)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() is QEvent.Type.ToolTip:
            at = self._at(event.pos().x())
            if at >= 0:
                QToolTip.showText(event.globalPos(), view_tooltip(self._views[at]), self)
            else:
                QToolTip.hideText()
            return True
        return super().event(event)

    def _at(self, x: float) -> int:
        return min(len(self._views) - 1, max(0, int(x / self.width() * len(self._views)))) if self._views else -1

    def _tell(self) -> None:
        done = sum(view.state is ViewState.DONE for view in self._views)
        name = self.tr("Plan: {done} of {count} views are done").format(done=done, count=len(self._views))
        self.setAccessibleName(name if self.choice is None else f"{name}. {view_words(self.choice)}")

    # -------------------------------------------------------------------------------- painting
    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            wide = self.width() / max(len(self._views), 1)
            gap = 2.0 if wide >= _GAP_FROM else 0.0
            font = painter.font()
            font.setPixelSize(_SIGN)
            font.setBold(True)
            painter.setFont(font)
            for place, view in enumerate(self._views):
                self._segment(painter, view, QRectF(place * wide, 0.0, wide - gap, float(_HEIGHT)))
            if self.hasFocus():
                painter.setPen(QPen(QColor(look.text), 1.0, Qt.PenStyle.DotLine))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawRect(self.rect().adjusted(0, 0, -1, -1))

    def _segment(self, painter: QPainter, view: ViewProgress, room: QRectF) -> None:
        full = QRectF(room.left(), room.top() + _SIGN, room.width(), room.height() - _SIGN)
        low = QRectF(full.left(), full.bottom() - _LOW, full.width(), _LOW)
        painter.setPen(Qt.PenStyle.NoPen)
        bad = view.state in (ViewState.TO_REDO, ViewState.WEAK)
        if view.state is ViewState.DONE:
            painter.fillRect(full, QColor(look.accent))
        elif bad:
            half = QRectF(full.left(), full.top() + full.height() / 2, full.width(), full.height() / 2)
            painter.fillRect(half, QColor(look.warning))
        else:
            painter.fillRect(low, QColor(look.edge))
        if view.state is ViewState.DOING and view.wanted:
            share = min(1.0, view.measured / view.wanted)
            painter.fillRect(QRectF(full.left(), full.bottom() - share * full.height(), full.width(), share * full.height()), QColor(look.accent))
            painter.setPen(QColor(look.edge))
            painter.drawRect(full.adjusted(0.5, 0.5, -0.5, -0.5))
        sign = _SIGNS.get(view.state)
        if sign is not None:
            painter.setPen(QColor(look.warning if bad else look.text))
            painter.drawText(QRectF(room.center().x() - 10, room.top() - 2, 20, _SIGN + 3), Qt.AlignmentFlag.AlignCenter, sign)
        if view is self.choice:
            painter.setPen(QPen(QColor(look.text), 1.6))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(full.adjusted(0.5, 0.5, -0.5, -0.5))
