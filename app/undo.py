"""Undo and redo in the order of what a person did: edits of the form on this side, edits of the open case in its file.

The case remembers its own, also over closing; the form's live as long as the program.  This remembers only which came
when; of a case that was just opened everything that it can take back comes after what was done here.
"""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoStack

from app.controllers.case import CaseController
from app.draft import Draft

_Source = Literal["form", "case"]


class UndoHistory(QObject):
    """`changed` when words or their being there have changed."""

    changed = Signal()

    def __init__(self, stack: QUndoStack, draft: Draft, case: CaseController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stack, self._draft, self._case = stack, draft, case
        self._done: list[_Source] = []
        self._undone: list[_Source] = []
        self._index = stack.index()
        self._going = False
        stack.indexChanged.connect(self._form_moved)
        case.stepped.connect(lambda: self._did("case"))
        case.opened.connect(self._another_case)
        for signal in (case.edited, stack.undoTextChanged, stack.redoTextChanged):
            signal.connect(self.changed)

    @property
    def undo_words(self) -> str | None:
        """What :meth:`undo` would take back, in the window's language; None when there is nothing."""
        return self._words(self._next(self._done, self._stack.canUndo(), self._case.undo_words), self._stack.undoText(), self._case.undo_words)

    @property
    def redo_words(self) -> str | None:
        """What :meth:`redo` would do again."""
        return self._words(self._next(self._undone, self._stack.canRedo(), self._case.redo_words), self._stack.redoText(), self._case.redo_words)

    def undo(self) -> None:
        self._step(self._done, self._undone, self._next(self._done, self._stack.canUndo(), self._case.undo_words), forward=False)

    def redo(self) -> None:
        self._step(self._undone, self._done, self._next(self._undone, self._stack.canRedo(), self._case.redo_words), forward=True)

    # -------------------------------------------------------------------------------- inside
    @staticmethod
    def _next(steps: list[_Source], form_can: bool, case_words: str | None) -> _Source | None:
        able: dict[_Source, bool] = {"form": form_can, "case": case_words is not None}
        known = next((source for source in reversed(steps) if able[source]), None)
        return known or ("case" if able["case"] else "form" if able["form"] else None)

    @staticmethod
    def _words(source: _Source | None, form: str, case: str | None) -> str | None:
        if source == "form":
            return form
        return None if source is None else QCoreApplication.translate("draft", case or "")

    def _step(self, taken: list[_Source], given: list[_Source], source: _Source | None, *, forward: bool) -> None:
        if source is None:
            return
        if source in taken:
            del taken[len(taken) - 1 - taken[::-1].index(source)]
        given.append(source)
        self._going = True
        if source == "form":
            (self._stack.redo if forward else self._stack.undo)()
        else:
            (self._case.redo if forward else self._case.undo)()
        self._going = False
        self.changed.emit()

    def _form_moved(self, index: int) -> None:
        if index > self._index and not self._going:
            self._did("form")
        self._index = index

    def _did(self, source: _Source) -> None:
        self._done.append(source)
        if source == "case":
            self._draft.seal()
        self._undone.clear()
        self.changed.emit()

    def _another_case(self) -> None:
        """What was remembered of the case before is no longer to be had, nor is the form's when its values were replaced."""
        gone = [source for source, there in (("case", self._case.store is not None), ("form", self._stack.count() > 0)) if not there]
        for steps in (self._done, self._undone):
            steps[:] = [source for source in steps if source not in gone]
        self.changed.emit()
