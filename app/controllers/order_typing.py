"""What is typed into the fields of the open order becomes one edit of its case, not one a letter."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

_PAUSE_MS = 700
"""An edit is written when nothing was typed for so long."""


class OrderTyping(QObject):
    """Remembers one field of the order that was edited, until it is written."""

    def __init__(self, write: Callable[[str], None], parent: QObject) -> None:
        """`write` gets the field's name."""
        super().__init__(parent)
        self._write = write
        self._field: str | None = None
        self._pause = QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.timeout.connect(self.finish)

    def go_on(self, field: str) -> None:
        """Something was typed into a field."""
        if self._field not in (None, field):
            self.finish()
        self._field = field
        self._pause.start(_PAUSE_MS)

    def finish(self) -> None:
        """Write what was typed, if anything was."""
        field, self._field = self._field, None
        self._pause.stop()
        if field is not None:
            self._write(field)
