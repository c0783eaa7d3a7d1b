"""What a person has set: changed one by one, undoable, on the disk at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from app.settings import Settings, save_settings
from app.translation import QT_TRANSLATE_NOOP

STEPS: Final[dict[str, str]] = {
    "theme": QT_TRANSLATE_NOOP("preferences", "change of the theme"),
    "language": QT_TRANSLATE_NOOP("preferences", "change of the language"),
    "scale_percent": QT_TRANSLATE_NOOP("preferences", "change of the size"),
    "case_folder": QT_TRANSLATE_NOOP("preferences", "another folder for cases"),
    "export_folder": QT_TRANSLATE_NOOP("preferences", "another folder for exports"),
    "name_template": QT_TRANSLATE_NOOP("preferences", "another pattern of file names"),
    "code_in_names": QT_TRANSLATE_NOOP("preferences", "patient's code in file names"),
    "live_surface": QT_TRANSLATE_NOOP("preferences", "surface while scanning"),
    "retry": QT_TRANSLATE_NOOP("preferences", "measuring weak places again"),
}
"""The settings that the page offers, and what undoing a change of one is called."""
ELSEWHERE: Final[dict[str, str]] = {"export_profiles": QT_TRANSLATE_NOOP("preferences", "change of the export profiles")}
"""The same of what is set on other pages; a reset leaves it."""
SCALES: Final = (100, 125, 150, 175, 200)


class Preferences(QObject):
    """``changed(name)`` after every change, whoever made it."""

    changed = Signal(str)

    def __init__(self, settings: Settings, file: Path, stack: QUndoStack, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.settings = settings
        self._file, self._stack = file, stack

    def edit(self, name: str, value: object) -> None:
        """A key of ``STEPS`` or ``ELSEWHERE`` gets another value."""
        if getattr(self.settings, name) != value:
            self._stack.push(_Change(QCoreApplication.translate("preferences", (STEPS | ELSEWHERE)[name]), {name: value}, self.settings, self._put))

    def reset(self) -> None:
        """All of ``STEPS`` as on the first day; one undo brings them back."""
        first = Settings()
        other = {name: getattr(first, name) for name in STEPS if getattr(first, name) != getattr(self.settings, name)}
        if other:
            self._stack.push(_Change(self.tr("reset of the settings"), other, self.settings, self._put))

    def keep(self) -> None:
        """Onto the disk."""
        save_settings(self.settings, self._file)

    def _put(self, values: Mapping[str, object]) -> None:
        for name, value in values.items():
            setattr(self.settings, name, value)
        self.keep()
        for name in values:
            self.changed.emit(name)


class _Change(QUndoCommand):
    def __init__(self, words: str, values: Mapping[str, object], settings: Settings, put: Callable[[Mapping[str, object]], None]) -> None:
        super().__init__(words)
        self._new, self._old = dict(values), {name: getattr(settings, name) for name in values}
        self._put = put

    def redo(self) -> None:
        self._put(self._new)

    def undo(self) -> None:
        self._put(self._old)
