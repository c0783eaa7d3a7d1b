"""Undo and redo in the order of what a person did: edits of the form on this side, edits of the open case in its file.

The case remembers its own, also over closing; the form's live until its values are replaced by those of a case, those of the
choice for a comparison as long as the program.  This remembers only which came when; of a case that was just opened everything
that it can take back comes after what was done here.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Literal

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoStack

from app.controllers.case import CaseController
from app.draft import Draft

_Source = Literal["form", "comparison", "settings", "case"]
_Stacked = Literal["form", "comparison", "settings"]


class UndoHistory(QObject):
    """`changed` when words or their being there have changed."""

    changed = Signal()

    def __init__(
        self, form: QUndoStack, comparison: QUndoStack, settings: QUndoStack, draft: Draft, case: CaseController, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._stacks: dict[_Stacked, QUndoStack] = {"form": form, "comparison": comparison, "settings": settings}
        self._draft, self._case = draft, case
        self._done: list[_Source] = []
        self._undone: list[_Source] = []
        self._index = {name: stack.index() for name, stack in self._stacks.items()}
        self._going = False
        for name, stack in self._stacks.items():
            stack.indexChanged.connect(partial(self._moved, name))
            stack.undoTextChanged.connect(self.changed)
            stack.redoTextChanged.connect(self.changed)
        case.stepped.connect(lambda: self._did("case"))
        case.opened.connect(self._another_case)
        case.edited.connect(self.changed)

    @property
    def undo_words(self) -> str | None:
        """What :meth:`undo` would take back, in the window's language; None when there is nothing."""
        return self._words(self._next_back(), QUndoStack.undoText, self._case.undo_words)

    @property
    def redo_words(self) -> str | None:
        """What :meth:`redo` would do again."""
        return self._words(self._next_forth(), QUndoStack.redoText, self._case.redo_words)

    def undo(self) -> None:
        self._step(self._done, self._undone, self._next_back(), forward=False)

    def redo(self) -> None:
        self._step(self._undone, self._done, self._next_forth(), forward=True)

    # -------------------------------------------------------------------------------- inside
    def _next_back(self) -> _Source | None:
        return self._next(self._done, QUndoStack.canUndo, self._case.undo_words)

    def _next_forth(self) -> _Source | None:
        return self._next(self._undone, QUndoStack.canRedo, self._case.redo_words)

    def _next(self, steps: list[_Source], can: Callable[[QUndoStack], bool], case_words: str | None) -> _Source | None:
        able: list[_Source] = ["case"] if case_words is not None else []
        able += [name for name, stack in self._stacks.items() if can(stack)]
        return next((source for source in reversed(steps) if source in able), able[0] if able else None)

    def _words(self, source: _Source | None, of_stack: Callable[[QUndoStack], str], case: str | None) -> str | None:
        if source is None:
            return None
        return QCoreApplication.translate("draft", case or "") if source == "case" else of_stack(self._stacks[source])

    def _step(self, taken: list[_Source], given: list[_Source], source: _Source | None, *, forward: bool) -> None:
        if source is None:
            return
        if source in taken:
            del taken[len(taken) - 1 - taken[::-1].index(source)]
        given.append(source)
        self._going = True
        if source == "case":
            (self._case.redo if forward else self._case.undo)()
        else:
            stack = self._stacks[source]
            (stack.redo if forward else stack.undo)()
        self._going = False
        self.changed.emit()

    def _moved(self, name: _Stacked, index: int) -> None:
        if index > self._index[name] and not self._going:
            self._did(name)
        self._index[name] = index

    def _did(self, source: _Source) -> None:
        self._done.append(source)
        if source == "case":
            self._draft.seal()
        self._undone.clear()
        self.changed.emit()

    def _another_case(self) -> None:
        """What was remembered of the case before is no longer to be had, nor is the form's when its values were replaced."""
        gone = [source for source, there in (("case", self._case.store is not None), ("form", self._stacks["form"].count() > 0)) if not there]
        for steps in (self._done, self._undone):
            steps[:] = [source for source in steps if source not in gone]
        self.changed.emit()
