"""One timer drains everything that other threads have left for the window.

Other threads never emit signals: they leave values in slots, logs and queues, and the pump takes them out 30 times a
second.  A thousand signals a second would make the window stand still; a thousand points taken out at once do not.

Painting has a pace of its own.  A picture holds Python's lock while it is drawn, so on a machine without a graphics
card every picture stops the scan's threads: the next one comes no sooner than four times the time of the last.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import TypeVar

from PySide6.QtCore import QObject, Qt, QTimer

PERIOD_MS = 33
PAINT_SHARE = 4.0
"""From picture to picture at least this many times the time of the last one ..."""
LONGEST_PAUSE_S = 0.1
"""... but no longer than this: new points are seen within 200 ms."""
T = TypeVar("T")


class Pump(QObject):
    """Calls every `source` in the order of their registration, then every `painter`."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._sources: list[Callable[[], None]] = []
        self._painters: list[Callable[[], float]] = []
        self._paint_s = 0.0
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)

    def add_source(self, drain: Callable[[], None]) -> None:
        """`drain` takes out what is there and returns at once."""
        self._sources.append(drain)

    def add_painter(self, paint: Callable[[], float]) -> None:
        """`paint` asks for a picture if there is something new, and tells how many seconds the last one took."""
        self._painters.append(paint)

    def start(self) -> None:
        self._timer.start(PERIOD_MS)

    def stop(self) -> None:
        self._timer.stop()

    def drain(self) -> None:
        """Everything now; a source that fails is reported and the others still run."""
        for source in tuple(self._sources):
            _guarded(source)

    def _tick(self) -> None:
        self.drain()
        now_s = time.monotonic()
        if now_s >= self._paint_s:
            longest_s = max((_guarded(painter) or 0.0 for painter in tuple(self._painters)), default=0.0)
            self._paint_s = now_s + min(PAINT_SHARE * longest_s, LONGEST_PAUSE_S)
        self._timer.start(PERIOD_MS)


def _guarded(call: Callable[[], T]) -> T | None:
    """One failing source must not stop the others for good: its fault takes the way of every unexpected fault."""
    try:
        return call()
    except Exception as fault:  # the hook tells the person
        sys.excepthook(type(fault), fault, fault.__traceback__)
        return None
