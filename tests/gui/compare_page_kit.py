"""What the tests of the Compare page share: an empty page, files dropped on it, and the wait for an answer."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from app.comparison_draft import ComparisonChoice
from app.program import Program
from app.views.compare_page import ComparePage
from tests.gui.compare_pair import PairFiles
from tests.gui.waiting import until, wait_ms

_loaded: dict[PairFiles, ComparisonChoice] = {}


def with_worker(program: Program) -> Program:
    """With the worker that compares: it stays."""
    answers = program.services.comparing.answers
    answers.prewarm()
    until(lambda: answers.worker_pid is not None, 60, "the worker")
    return program


def empty_page(program: Program) -> ComparePage:
    """The page as it is before the first surface."""
    comparing = program.services.comparing
    comparing.answers.cancel()
    until(lambda: not comparing.answers.running and not comparing.reading.reading, 60, "an idle page")
    program.compare_stack.clear()
    comparing.draft.put(ComparisonChoice())
    program.window.banner.dismiss()
    program.window.show_page("compare")
    found = program.window.pages["compare"]
    assert isinstance(found, ComparePage)
    return found


def drop(page: ComparePage, paths: list[Path], place: QPoint) -> None:
    """As from a file manager."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    buttons, keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(page, QDragEnterEvent(place, Qt.DropAction.CopyAction, data, buttons, keys))
    QApplication.sendEvent(page, QDropEvent(QPointF(place), Qt.DropAction.CopyAction, data, buttons, keys))


def answered(program: Program) -> None:
    answers, banner = program.services.comparing.answers, program.window.banner
    until(lambda: answers.current or banner.text, 120, "the comparison")
    assert banner.text == ""


def load(program: Program, page: ComparePage, files: PairFiles) -> None:
    """Both surfaces; those of a test before, whose answer is known, when there are any."""
    draft = program.services.comparing.draft
    if files in _loaded:
        draft.edit("before", before=_loaded[files].before)
        draft.edit("after", after=_loaded[files].after)
    else:
        page.take_files([files.before, files.after], None)
    answered(program)
    _loaded[files] = draft.choice
    until(lambda: page.scene is not None and page.picture.drawn, 60, "the 3D view")
    wait_ms(50)
