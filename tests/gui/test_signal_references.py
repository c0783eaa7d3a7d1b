"""A PySide6 that loses a reference with every signal would abort the program after some minutes of scanning."""

from __future__ import annotations

import sys

from PySide6.QtCore import QObject, Signal


class Emitter(QObject):
    changed = Signal()
    switched = Signal(bool)


def test_emitting_keeps_the_references_of_true() -> None:
    emitter = Emitter()
    received: list[bool] = []
    emitter.switched.connect(received.append)
    before = sys.getrefcount(True)
    for _ in range(200):
        emitter.changed.emit()
        emitter.switched.emit(True)
    received_count = len(received)
    received.clear()
    assert received_count == 200
    assert abs(sys.getrefcount(True) - before) < 20
