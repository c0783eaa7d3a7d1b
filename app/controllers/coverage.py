"""Which places of the open case's surface are not as certain as wanted, and why, computed in the worker process; and which of them a
person accepts as they are."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.case import CaseController
from app.controllers.case_job import CaseJob
from app.controllers.place_pictures import PlacePictures
from app.translation import QT_TRANSLATE_NOOP
from app.views.surface import Surface
from scanner_core.jobs.progress import Cancelled

if TYPE_CHECKING:
    from pathlib import Path

    from scanner_core.case.store import CaseStore
    from scanner_core.coverage.accepted import AcceptedPlace
    from scanner_core.coverage.job import CaseCoverage

_ACCEPT, _TAKE_BACK = QT_TRANSLATE_NOOP("draft", "Accept a place as it is"), QT_TRANSLATE_NOOP("draft", "Do not accept a place")


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
        self._background, self._case, self._acquisition, self._tell = background, case, acquisition, tell
        self._job = CaseJob("coverage", "coverage", background, case)
        self._again = False
        self._wanted_um = 0.0
        self.found: CaseCoverage | None = None
        self.surface: Surface | None = None
        """That of `found`, ready to draw."""
        self.phase = ""
        self.pictures = PlacePictures(background, self)
        self.accepted: tuple[AcceptedPlace, ...] = ()
        """Places of the open case that a person accepts as they are."""
        self._of = self._content
        for signal in (case.meshed, acquisition.began, acquisition.ended):
            signal.connect(self.forget)
        case.opened.connect(self._look)
        case.stepped.connect(self._read_accepted)

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
        self._of = self._content
        self._job.start(self._request, _prepared, self._done, self._failed)
        self.changed.emit()

    def cancel(self) -> None:
        self._again = False
        self._job.cancel()

    def forget(self) -> None:
        """The case has another content."""
        self.cancel()
        self.found = self.surface = None
        self.pictures.forget()
        self.changed.emit()

    def is_accepted(self, number: int) -> bool:
        """Whether a place of the answer is accepted as it is."""
        from scanner_core.coverage.accepted import is_accepted

        return self.found is not None and is_accepted(self.accepted, self.found.report.places[number], self.found.mount)

    def accept(self, number: int) -> None:
        """Accept a place of the answer as it is, or no more; the case remembers it, and it can be undone."""
        from scanner_core.coverage.accepted import AcceptedPlace, accept, take_back

        if self.found is None:
            return
        report = self.found.report
        place = AcceptedPlace(report.places[number], report.wanted_um, self.found.mount)
        if self.is_accepted(number):
            self._case.change(partial(take_back, place=place, words=_TAKE_BACK))
        else:
            self._case.change(partial(accept, place=place, words=_ACCEPT))

    def drain(self) -> None:
        """For the pump: the newest progress."""
        progress = self._job.newest()
        if progress is not None and self.running and progress.phase != self.phase:
            self.phase = progress.phase
            self.changed.emit()

    def shutdown(self) -> None:
        self.pictures.shutdown()
        self._job.shutdown()

    # -------------------------------------------------------------------------------- inside
    def _look(self) -> None:
        """Another case, or the same one after undo: what is known stays as long as points and surface do."""
        if any(one is not other for one, other in zip(self._content, self._of, strict=True)):
            self.forget()
        self._read_accepted()

    @property
    def _content(self) -> tuple[object, ...]:
        return self._case.store, self._case.cloud, self._case.surface

    def _read_accepted(self) -> None:
        store = self._case.store
        if store is None:
            self._take_accepted(None, ())
        else:
            self._background.run("accepted-places", partial(_accepted, store), partial(self._take_accepted, store), lambda fault: None)

    def _take_accepted(self, store: CaseStore | None, accepted: tuple[AcceptedPlace, ...]) -> None:
        if store is self._case.store and accepted != self.accepted:
            self.accepted = accepted
            self.changed.emit()

    def _request(self, path: Path) -> object:
        from scanner_core.coverage.job import CoverageRequest

        return CoverageRequest(path, self._wanted_um)

    def _done(self, answer: tuple[CaseCoverage, Surface]) -> None:
        self.found, self.surface = answer
        self.pictures.draw(self.found.surface, self.found.report)
        self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        if self._again:
            self._again = False
            self.start(self._wanted_um)
            return
        self.changed.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)


def _accepted(store: CaseStore) -> tuple[AcceptedPlace, ...]:
    from scanner_core.coverage.accepted import accepted_places

    return accepted_places(store)


def _prepared(found: CaseCoverage) -> tuple[CaseCoverage, Surface]:
    return found, Surface.of(found.surface, growing=False)
