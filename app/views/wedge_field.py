"""Where a barcode reader types: a number and Enter.  What is typed also filters the list below."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent
from PySide6.QtWidgets import QLineEdit

from app.theme import icon


class WedgeField(QLineEdit):
    """`entered(number)` on Enter; `down` to go into the list."""

    entered = Signal(str)
    down = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setPlaceholderText(self.tr("Scan or type an order number"))
        self.setAccessibleName(self.tr("Order number, by barcode or keys"))
        self.setMinimumHeight(44)
        self.setTextMargins(4, 0, 6, 0)
        self.setClearButtonEnabled(True)
        font = self.font()
        font.setPixelSize(16)
        self.setFont(font)
        self.addAction(QAction(icon("barcode", "muted"), "", self), QLineEdit.ActionPosition.LeadingPosition)

    @property
    def number(self) -> str:
        """What was typed, without what a reader puts around it."""
        return "".join(sign for sign in self.text() if sign.isprintable()).strip()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if self.number:
                self.entered.emit(self.number)
        elif event.key() == Qt.Key.Key_Down:
            self.down.emit()
        else:
            super().keyPressEvent(event)
