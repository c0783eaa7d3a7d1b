"""Surfaces that are read side by side are taken in the order in which they were asked for: Undo goes the same way back."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

from PySide6.QtGui import QUndoStack
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.comparison_draft import ComparisonDraft
from app.controllers.case import CaseController
from app.controllers.surface_reading import SurfaceReading


class _Later:
    """Threads that end when the test says so."""

    def __init__(self) -> None:
        self.done: dict[str, Callable[[Any], None]] = {}
        self.failed: dict[str, Callable[[Exception], None]] = {}

    def run(self, name: str, work: object, done: Callable[[Any], None], failed: Callable[[Exception], None]) -> None:
        self.done[name], self.failed[name] = done, failed


def _desk() -> tuple[SurfaceReading, _Later, Any, list[BaseException]]:
    told: list[BaseException] = []
    later, draft = _Later(), ComparisonDraft(QUndoStack())
    case = cast(CaseController, SimpleNamespace(path=None))
    return SurfaceReading(cast(Background, later), case, draft, told.append), later, draft, told


def test_the_one_that_was_asked_for_first_is_taken_first(application: QApplication) -> None:
    reading, later, draft, _ = _desk()
    reading.read("before", Path("a.stl"))
    reading.read("after", Path("b.stl"))
    later.done["read-after"]("b")
    assert draft.choice.after is None
    assert set(reading.reading) == {"before", "after"}
    later.done["read-before"]("a")
    taken = draft.choice
    assert (taken.before, taken.after) == ("a", "b")
    assert not reading.reading


def test_one_that_is_given_up_or_fails_holds_nobody_up(application: QApplication) -> None:
    reading, later, draft, told = _desk()
    reading.read("before", Path("a.stl"))
    reading.read("after", Path("b.stl"))
    later.done["read-after"]("b")
    reading.cancel("before")
    assert draft.choice.after == "b"
    later.done["read-before"]("a")
    assert draft.choice.before is None
    reading.read("before", Path("a.stl"))
    reading.read("after", Path("c.stl"))
    later.done["read-after"]("c")
    later.failed["read-before"](ValueError())
    assert (draft.choice.after, len(told)) == ("c", 1)
