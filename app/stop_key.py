"""Esc stops the laser from wherever it is pressed: any page, a dialog, a menu, the open list of a combo box, a text field.

A shortcut belongs to one window and is out of reach while another one, or a popup, has the keyboard; this looks at every
key press of the application before anybody else does.  What Esc does otherwise (it closes the dialog or the list) it
still does, afterwards.  A menu or a list that is open takes the next click for itself, wherever it falls: a click at the
place of the stop button stops, too.
"""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

_SAME_PRESS_S = 0.05
"""One press passes several receivers; within this time it is the same one."""


class StopKey(QObject):
    """Installed on the application; calls `stop` once a press."""

    def __init__(self, stop: Callable[[], None], button: QWidget, parent: QObject | None = None) -> None:
        """`button` is the stop button, which calls `stop` by itself when a click reaches it."""
        super().__init__(parent)
        self._stop, self._button = stop, button
        self._pressed_s = -_SAME_PRESS_S

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        if event.type() == QEvent.Type.MouseButtonPress and isinstance(event, QMouseEvent):
            self._press(event)
            return False
        if event.type() not in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress) or not isinstance(event, QKeyEvent):
            return False
        if event.key() != Qt.Key.Key_Escape:
            return False
        if not event.isAutoRepeat():
            self._once()
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()  # no shortcut: the key goes on to whom it was pressed for
            return True
        return False

    def _press(self, event: QMouseEvent) -> None:
        place = self._button.mapFromGlobal(event.globalPosition().toPoint())
        if QApplication.activePopupWidget() is not None and self._button.isVisible() and self._button.rect().contains(place):
            self._once()

    def _once(self) -> None:
        now_s = time.monotonic()
        if now_s - self._pressed_s > _SAME_PRESS_S:
            self._stop()
        self._pressed_s = now_s
