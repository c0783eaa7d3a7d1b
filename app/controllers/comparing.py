"""Everything behind the Compare page."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from app.background import Background
from app.comparison_draft import ComparisonDraft
from app.controllers.case import CaseController
from app.controllers.comparison import ComparisonController
from app.controllers.comparison_report import ComparisonReport
from app.controllers.kept_comparisons import KeptComparisons
from app.controllers.marked_tooth import MarkedTooth
from app.controllers.point_picking import PointPicking
from app.controllers.surface_reading import SurfaceReading
from app.settings import Settings
from scanner_core.comparison.comparison import Comparison

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore


class Comparing(QObject):
    """The choice and one controller an activity."""

    kept = Signal()
    """`keepable` is another."""

    def __init__(
        self,
        background: Background,
        settings: Settings,
        stack: QUndoStack,
        case: CaseController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._case, self.tell = case, tell
        self._kept: Comparison | None = None
        self.draft = ComparisonDraft(stack, self)
        self.reading = SurfaceReading(background, case, self.draft, tell, self)
        self.answers = ComparisonController(background, self.draft, tell, self)
        self.points = PointPicking(background, self.draft, tell, self)
        self.tooth = MarkedTooth(background, self.draft, self.answers, tell, self)
        self.report = ComparisonReport(background, settings, tell, self)
        self.keeping = KeptComparisons(background, case, tell, self)
        self.answers.answered.connect(self.report.forget)
        case.opened.connect(self._forget_kept)

    @property
    def keepable(self) -> bool:
        """The surface after is the open case's, and this answer is not kept in it yet."""
        choice, comparison = self.draft.choice, self.answers.comparison
        if choice.after is None or comparison is None or not self.answers.settled or comparison is self._kept:
            return False
        path = self._case.path
        return path is not None and choice.after.path is None and choice.after.surface.origin.get("path") == str(path)

    def keep(self) -> None:
        """Keep the answer in the open case: an edit of it, undone like every other."""
        comparison = self.answers.comparison
        if comparison is None or not self.keepable:
            return
        self._kept = comparison
        self._case.change(partial(_keep, comparison=comparison), failed=self._not_kept)
        self.kept.emit()

    def _forget_kept(self) -> None:
        """Another case, or undone in this one."""
        self._kept = None
        self.kept.emit()

    def _not_kept(self, fault: Exception) -> None:
        self._kept = None
        self.tell(fault)
        self.kept.emit()

    def drain(self) -> None:
        """In the GUI thread, for the pump."""
        self.answers.drain()
        self.report.drain()

    def shutdown(self) -> None:
        """Stop what runs; the worker process ends."""
        self.report.cancel()
        self.answers.shutdown()


def _keep(store: CaseStore, comparison: Comparison) -> int:
    from scanner_core.comparison.keeping import keep_comparison

    return keep_comparison(store, comparison)
