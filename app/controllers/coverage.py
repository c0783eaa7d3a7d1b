"""Which places of the open case's surface are not as certain as wanted, and why; computed in the worker process."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.case import CaseController
from app.controllers.case_job import CaseJob
from app.views.surface import Surface
from scanner_core.jobs.progress import Cancelled

if TYPE_CHECKING:
    from pathlib import Path

    from scanner_core.coverage.job import CaseCoverage


class CoverageController(QObject):
    """One answer at a time, to the newest content of the case."""

    changed = Signal()
    """It began, it ended, or what was known is stale."""

    def __init__(
        self,
        background: Background,
        case: CaseController,
        acquisition: AcquisitionController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._case, self._acquisition, self._tell = case, acquisition, tell
        self._job = CaseJob("coverage", "coverage", background, case)
        self._again = False
        self._wanted_um = 0.0
        self.found: CaseCoverage | None = None
        self.surface: Surface | None = None
        """That of `found`, ready to draw."""
        self.phase = ""
        for signal in (case.opened, case.meshed, acquisition.began, acquisition.ended):
            signal.connect(self.forget)

    @property
    def running(self) -> bool:
        return self._job.running

    @property
    def able(self) -> bool:
        """There are points to ask about."""
        return self._case.store is not None and self._case.cloud is not None and not self._acquisition.running

    def start(self, wanted_um: float) -> None:
        """Find it out; a question that is on its way is given up for this one."""
        self._wanted_um = wanted_um
        if not self.able:
            return
        if self._job.running:
            self._again = True
            self._job.cancel()
            return
        self.phase = ""
        self._job.start(self._request, _prepared, self._done, self._failed)
        self.changed.emit()

    def cancel(self) -> None:
        self._again = False
        self._job.cancel()

    def forget(self) -> None:
        """The case has another content."""
        self.cancel()
        self.found = self.surface = None
        self.changed.emit()

    def drain(self) -> None:
        """For the pump: the newest progress."""
        progress = self._job.newest()
        if progress is not None and self.running and progress.phase != self.phase:
            self.phase = progress.phase
            self.changed.emit()

    def shutdown(self) -> None:
        self._job.shutdown()

    # -------------------------------------------------------------------------------- inside
    def _request(self, path: Path) -> object:
        from scanner_core.coverage.job import CoverageRequest

        return CoverageRequest(path, self._wanted_um)

    def _done(self, answer: tuple[CaseCoverage, Surface]) -> None:
        self.found, self.surface = answer
        self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        if self._again:
            self._again = False
            self.start(self._wanted_um)
            return
        self.changed.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)


def _prepared(found: CaseCoverage) -> tuple[CaseCoverage, Surface]:
    return found, Surface.of(found.surface, growing=False)
