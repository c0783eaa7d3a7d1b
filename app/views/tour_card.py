"""The tour of the first run: a small card beside what it speaks of, in nobody's way; any other click is the program's as always."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QFrame, QVBoxLayout, QWidget

from app.theme import look
from app.views.parts import button, give_role, label, row

_WIDTH = 310
_GAP = 16
_RING = 4


@dataclass(frozen=True, slots=True)
class TourStep:
    """One step: `target` answers the widget it is about, or None while that is not shown."""

    title: str
    text: str
    target: Callable[[], QWidget | None]


class TourCard(QFrame):
    """Lies over the window's content without taking the keyboard; it ends with Esc, its own button, or after the last step."""

    ended = Signal()

    def __init__(self, content: QWidget, steps: Sequence[TourStep]) -> None:
        super().__init__(content)
        self._content, self._steps, self._place = content, steps, 0
        self._ring = _Ring(content)
        self.setProperty("role", "card")
        self.setFixedWidth(_WIDTH)
        self.setAccessibleName(self.tr("Tour"))
        self._title = label("", "strong", wrap=True)
        self._text = label("", wrap=True)
        self._count = label("", "faint")
        self.skip = button(self.tr("End the tour"), "quiet-link", self.end)
        self.back = button(self.tr("Back"), "", lambda: self.go(-1))
        self.next = button("", "", lambda: self.go(1))
        for part in (self.skip, self.back, self.next):
            part.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        box = QVBoxLayout(self)
        box.setContentsMargins(16, 14, 16, 12)
        box.setSpacing(8)
        head = row(self._title, self._count, spacing=8)
        head.setStretch(0, 1)
        box.addLayout(head)
        box.addWidget(self._text)
        box.addSpacing(2)
        box.addLayout(row(self.skip, 1, self.back, self.next))
        content.installEventFilter(self)
        self.show_step()

    def go(self, by: int) -> None:
        """On, or back; past the last step it ends."""
        if self._place + by >= len(self._steps):
            self.end()
            return
        self._place = max(0, self._place + by)
        self.show_step()

    def end(self) -> None:
        """It is over; may be called again."""
        if not self.isHidden() or not self._ring.isHidden():
            self.hide()
            self._ring.hide()
            self.ended.emit()

    @property
    def step(self) -> TourStep:
        return self._steps[self._place]

    def show_step(self) -> None:
        """The words of the step, and the card where its target is now."""
        last = self._place == len(self._steps) - 1
        self._title.setText(self.step.title)
        self._text.setText(self.step.text)
        self._count.setText(self.tr("{n} of {all}").format(n=self._place + 1, all=len(self._steps)))
        self.back.setVisible(self._place > 0)
        self.next.setText(self.tr("Done") if last else self.tr("Next"))
        give_role(self.next, "primary" if last else "")
        self.show()
        self.move_to_target()

    def move_to_target(self) -> None:
        """Beside the target: right of it, else left, above or below, within the window; in a corner while it is not shown."""
        target = self.step.target()
        shown = target is not None and target.isVisible()
        self._ring.setVisible(shown)
        layout = self.layout()
        if layout is not None:
            layout.activate()
            self.setFixedHeight(layout.heightForWidth(_WIDTH))
        room = self._content.rect().adjusted(_GAP, _GAP, -_GAP, -_GAP)
        place = QPoint(room.right() - self.width(), room.bottom() - self.height())
        if shown and target is not None:
            around = QRect(target.mapTo(self._content, QPoint(0, 0)), target.size())
            self._ring.setGeometry(around.adjusted(-_RING, -_RING, _RING, _RING))
            self._ring.raise_()
            level = around.center().y() - self.height() // 2
            middle = around.center().x() - self.width() // 2
            places = (
                QPoint(around.right() + _GAP, level),
                QPoint(around.left() - _GAP - self.width(), level),
                QPoint(middle, around.top() - _GAP - self.height()),
                QPoint(middle, around.bottom() + _GAP),
            )
            sizes = [self._within(QRect(at, self.size()), room) for at in places]
            place = next((box for box in sizes if not box.intersects(around)), sizes[0]).topLeft()
        self.move(place)
        self.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        if event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest) and not self.isHidden():
            self.move_to_target()
        return False

    @staticmethod
    def _within(box: QRect, room: QRect) -> QRect:
        box.moveLeft(max(room.left(), min(box.left(), room.right() - box.width())))
        box.moveTop(max(room.top(), min(box.top(), room.bottom() - box.height())))
        return box


class _Ring(QWidget):
    """Round the target; takes no click."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(QColor(look.accent), 2))
            painter.drawRoundedRect(self.rect().adjusted(1, 1, -1, -1), 8, 8)
