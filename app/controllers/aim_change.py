"""A change of what is set while aiming, which can be taken back."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QUndoCommand

from app.translation import QT_TRANSLATE_NOOP

if TYPE_CHECKING:
    from scanner_core.devices.aim_settings import AimSettings

_CHANGES = {
    "limits": QT_TRANSLATE_NOOP("aim", "Change limits of the spot's size"),
    "learned": QT_TRANSLATE_NOOP("aim", "Learn the spot's size"),
    "exposure": QT_TRANSLATE_NOOP("aim", "Automatic exposure"),
    "material": QT_TRANSLATE_NOOP("aim", "Choose material"),
}
_ONE_MOVE_S = 1.5
"""Steps of a key that follow each other so soon are one change."""


class AimChange(QUndoCommand):
    """Of the settings of one rig, whichever is open when it is taken back."""

    def __init__(self, put: Callable[[str, AimSettings], None], preset: str, before: AimSettings, after: AimSettings, what: str) -> None:
        super().__init__(QCoreApplication.translate("aim", _CHANGES[what]))
        self._put, self.preset, self._before, self.after, self._what = put, preset, before, after, what
        self.made_s = time.monotonic()

    def redo(self) -> None:
        self._put(self.preset, self.after)

    def undo(self) -> None:
        self._put(self.preset, self._before)

    def id(self) -> int:
        return 100 + list(_CHANGES).index(self._what)

    def mergeWith(self, other: QUndoCommand) -> bool:  # noqa: N802 - Qt's name
        if not isinstance(other, AimChange) or self._what != "limits" or other.preset != self.preset or other.made_s - self.made_s > _ONE_MOVE_S:
            return False
        self.after, self.made_s = other.after, other.made_s
        return True
