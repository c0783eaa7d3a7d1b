"""Everything behind the Compare page."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtGui import QUndoStack

from app.background import Background
from app.comparison_draft import ComparisonDraft
from app.controllers.case import CaseController
from app.controllers.comparison import ComparisonController
from app.controllers.comparison_report import ComparisonReport
from app.controllers.marked_tooth import MarkedTooth
from app.controllers.point_picking import PointPicking
from app.controllers.surface_reading import SurfaceReading
from app.settings import Settings


class Comparing(QObject):
    """The choice and one controller an activity."""

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
        self.draft = ComparisonDraft(stack, self)
        self.reading = SurfaceReading(background, case, self.draft, tell, self)
        self.answers = ComparisonController(background, self.draft, tell, self)
        self.points = PointPicking(background, self.draft, tell, self)
        self.tooth = MarkedTooth(background, self.draft, self.answers, tell, self)
        self.report = ComparisonReport(background, settings, tell, self)
        self.answers.answered.connect(self.report.forget)

    def drain(self) -> None:
        """In the GUI thread, for the pump."""
        self.answers.drain()
        self.report.drain()

    def shutdown(self) -> None:
        """Stop what runs; the worker process ends."""
        self.report.cancel()
        self.answers.shutdown()
