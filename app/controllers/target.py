"""The calibration board as a page to print: the file that ``impronta target`` writes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.background import Background


class TargetController(QObject):
    """Writes off the GUI thread; `written` with the path, or a sentence in the banner; `changed` at begin and end."""

    changed = Signal()
    written = Signal(str)

    def __init__(self, background: Background, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._tell = background, tell
        self.busy = False

    def write(self, path: Path, *, replace: bool) -> None:
        """An existing file only with `replace`."""
        self.busy = True
        self.changed.emit()

        def work() -> str:
            from scanner_core.files import replaced_when_whole
            from scanner_core.optics.board import DEFAULT_TARGET
            from scanner_core.optics.printable_target import write_target

            with replaced_when_whole(path, force=replace) as partial:
                write_target(partial, DEFAULT_TARGET)
            return str(path)

        self._background.run("target", work, self._done, self._failed)

    def _done(self, path: str) -> None:
        self.busy = False
        self.changed.emit()
        self.written.emit(path)

    def _failed(self, fault: Exception) -> None:
        self.busy = False
        self.changed.emit()
        self._tell(fault)
