"""Waiting with a running event loop.

Never with ``QTest.qWait``: it keeps Python's lock while it waits, so that every other thread stands still (a scan ran
ten times slower under it).
"""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget


def wait_ms(duration_ms: int) -> None:
    """Run the event loop for so long."""
    loop = QEventLoop()
    QTimer.singleShot(duration_ms, loop.quit)
    loop.exec()


def until(condition: Callable[[], object], timeout_s: float = 20.0, why: str = "") -> None:
    """Run the event loop until it is so."""
    deadline_s = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() > deadline_s:
            raise AssertionError(f"not within {timeout_s} s: {why or condition}")
        wait_ms(10)


def press(window: QWidget, key: Qt.Key) -> None:
    """Press a key of the window's actions.

    They belong to the active window, and without a window manager the display takes the focus from a window whose
    focused part is hidden.
    """
    window.activateWindow()
    until(window.isActiveWindow, 10, "the window is active")
    QTest.keyClick(window, key)
