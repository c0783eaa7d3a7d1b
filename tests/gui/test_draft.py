from __future__ import annotations

from PySide6.QtGui import QUndoStack
from PySide6.QtWidgets import QApplication

from app.draft import Draft, DraftValues, first_order


def test_edits_are_undone_and_typing_in_one_field_is_one_step(application: QApplication) -> None:
    stack = QUndoStack()
    draft = Draft(stack)
    told: list[str] = []
    draft.changed.connect(told.append)
    for text in ("2", "20", "2026"):
        draft.edit("order", text)
    draft.edit("side", "right")
    draft.edit("views", 12)
    assert stack.count() == 3
    stack.undo()
    stack.undo()
    assert draft.values == DraftValues(order="2026")
    stack.undo()
    assert draft.values == DraftValues()
    stack.redo()
    assert draft.values.order == "2026"
    assert told == ["order"] * 3 + ["side", "views", "views", "side", "order", "order"]


def test_an_edit_that_changes_nothing_is_no_step(application: QApplication) -> None:
    stack = QUndoStack()
    Draft(stack).edit("views", DraftValues().views)
    assert stack.count() == 0


def test_loading_a_case_leaves_nothing_to_undo(application: QApplication) -> None:
    stack = QUndoStack()
    draft = Draft(stack)
    draft.edit("views", 3)
    draft.load(DraftValues(order="A-7"))
    assert not stack.canUndo()
    assert draft.values.order == "A-7"


def test_the_first_start_has_a_sample_order_and_later_ones_count_on() -> None:
    assert first_order("").order
    assert first_order("2026-0142").order == "2026-0143"
    assert first_order("A-099").order == "A-100"
