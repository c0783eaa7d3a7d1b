"""One device of the rig: what state it is in, what it is, how it is set, and what is wrong with it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QWidget

from app.faults import sentence_of
from app.views.parts import Lamp, label, row
from scanner_core.errors import ImprontaError

_CAPTION = 124


class DeviceRow(QWidget):
    """A line, and below it as many as there is to say."""

    def __init__(self, caption: str, *buttons: QPushButton) -> None:
        super().__init__()
        self._caption = caption
        self.lamp = Lamp()
        self._detail = label("", "muted", selectable=True)
        self._settings = label("", "faint", wrap=True, selectable=True)
        self._refused = label("", "bad", wrap=True)
        self._fault = label("", "notice", wrap=True, selectable=True)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(18)
        self._grid.setVerticalSpacing(3)
        self._grid.setColumnMinimumWidth(0, _CAPTION)
        self._grid.setColumnStretch(2, 1)
        self._grid.addWidget(label(caption, "muted"), 0, 0)
        self._grid.addWidget(self.lamp, 0, 1)
        self._grid.addWidget(self._detail, 0, 2, Qt.AlignmentFlag.AlignRight)
        for line, part in enumerate((self._settings, self._refused, self._fault), 1):
            self._grid.addWidget(part, line, 1, 1, 2)
            part.hide()
        self._grid.addLayout(row(*buttons, 1, spacing=10), 4, 1, 1, 2)

    def show_state(self, mood: str, words: str) -> None:
        """The lamp."""
        self.lamp.show_state(mood, words)
        self.setAccessibleName(f"{self._caption}: {words}")

    def show_device(self, detail: str, settings: str = "", refused: tuple[str, ...] = (), tip: str = "") -> None:
        """What it is, how it is set, and what it did not take."""
        self._detail.setText(detail)
        self._detail.setToolTip(tip)
        _say(self._settings, settings)
        _say(self._refused, "\n".join(refused))

    def show_fault(self, fault: ImprontaError | None, after: str = "") -> None:
        """What is wrong and what to do; `after` says what the program does about it."""
        what, do = ("", "") if fault is None else sentence_of(fault)
        _say(self._fault, "\n".join(part for part in (what, f"{do} {after}".strip()) if part))

    @property
    def state(self) -> str:
        return self.lamp.text

    @property
    def texts(self) -> tuple[str, str, str, str]:
        """What it is, how it is set, what was refused, what is wrong."""
        return self._detail.text(), self._settings.text(), self._refused.text(), self._fault.text()


def _say(shown: QLabel, text: str) -> None:
    shown.setText(text)
    shown.setVisible(bool(text))
