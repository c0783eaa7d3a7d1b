"""Two surfaces compared in a worker process: what is asked for, progress, cancel, and the answers that are there."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, cast

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.comparison_draft import ComparisonChoice, ComparisonDraft
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.jobs.messages import JobEvent
    from scanner_core.jobs.worker import JobHandle, Worker

_KEPT = 8
"""Answers that undo and redo find again at once."""


class ComparisonController(QObject):
    """One comparison at a time; the newest question counts.

    A question is asked by itself as soon as there are two surfaces, and again after every edit of what is measured; a painted
    region only when it is asked for (:meth:`start`), since it is painted in many strokes.  Another jaw or threshold only tells
    the same measurement in other terms, at once.  The worker process is started with the first surface: not everybody compares.
    """

    changed = Signal()
    """Newer progress, or another state."""
    answered = Signal()
    """`comparison` is another one, or none."""

    def __init__(self, background: Background, draft: ComparisonDraft, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._draft, self._tell = background, draft, tell
        self._progress: LatestSlot[Progress] = LatestSlot()
        self._starting = threading.Lock()
        self._worker: Worker | None = None
        self._job: JobHandle | None = None
        self._asked: ComparisonChoice | None = None  # what the worker works on
        self._stopped: ComparisonChoice | None = None  # what a person did not want to wait for
        self._answers: list[tuple[ComparisonChoice, Comparison]] = []
        self._closed = False
        self.comparison: Comparison | None = None
        """The newest answer for the two surfaces."""
        self.current = False
        """Whether what is chosen now is measured by it."""
        self.progress: Progress | None = None
        self.fault: Exception | None = None
        """Why the present question has no answer."""
        draft.changed.connect(self._look)

    @property
    def running(self) -> bool:
        return self._asked is not None

    @property
    def settled(self) -> bool:
        """The answer is that to what is chosen now, and in its terms."""
        return self.current and self.comparison is not None and self.comparison.parameters == self._draft.choice.parameters

    @property
    def cancelling(self) -> bool:
        return self._asked is not None and self._asked is self._stopped

    @property
    def worker_pid(self) -> int | None:
        """The worker's process id, or None while there is none."""
        return None if self._worker is None else self._worker.pid

    # -------------------------------------------------------------------------------- commands
    def start(self) -> None:
        """Ask what is chosen now, though a person has stopped it before, or it has failed."""
        self._stopped, self.fault = None, None
        choice = self._draft.choice
        if not self.running and choice.ready and not self.current:
            self._submit(choice)
        self.changed.emit()

    def cancel(self) -> None:
        """The present question is not to be answered; the answer before it stays."""
        self._stopped = self._asked
        if self._job is not None:
            self._job.cancel()
        self.changed.emit()

    def prewarm(self) -> None:
        """Start the worker process, so that the first comparison need not wait for its imports."""
        if self._worker is None:
            self._background.run("comparison-worker-start", self._ready_worker)

    def shutdown(self) -> None:
        """Cancel what runs and end the worker; one that was still starting is waited for."""
        self._closed = True
        with self._starting:
            worker = self._worker
        if worker is not None:
            worker.close()

    def drain(self) -> None:
        """In the GUI thread, for the pump: the newest progress."""
        progress = self._progress.take()
        if progress is not None and self.running:
            self.progress = progress
            self.changed.emit()

    # -------------------------------------------------------------------------------- questions
    def _look(self) -> None:
        """The choice is another: find its answer, or ask for it."""
        choice = self._draft.choice
        known = next((answer for question, answer in self._answers if question.same_question(choice)), None)
        pair = next((answer for question, answer in reversed(self._answers) if question.same_pair(choice)), None)
        self.current = known is not None
        shown = self._in_terms(choice, known) if known is not None else self.comparison if self._of_pair(choice) else pair
        if self._stopped is not None and not self._stopped.same_question(choice):
            self._stopped = None
        self.fault = None
        if self._asked is not None and not self._asked.same_question(choice) and self._job is not None:
            self._job.cancel()
        if shown is not self.comparison:
            self.comparison = shown
            self.answered.emit()
        self._ask()
        self.changed.emit()

    def _in_terms(self, choice: ComparisonChoice, known: Comparison) -> Comparison:
        """The measurement in the terms that are chosen; as it was told last until that is done."""
        if known.parameters == choice.parameters:
            return known
        shown = self.comparison
        told = shown if shown is not None and shown.alignment is known.alignment else known
        if told.parameters != choice.parameters:
            self._background.run("comparison-terms", partial(_with_terms, known, choice.parameters), partial(self._told, known))
        return told

    def _told(self, known: Comparison, comparison: Comparison) -> None:
        shown = self.comparison
        if self.current and shown is not None and shown.alignment is known.alignment and comparison.parameters == self._draft.choice.parameters:
            self.comparison = comparison
            self.answered.emit()
            self.changed.emit()

    def _of_pair(self, choice: ComparisonChoice) -> bool:
        shown = self.comparison
        return (
            shown is not None
            and choice.before is not None
            and choice.after is not None
            and (shown.before is choice.before.surface and shown.after is choice.after.surface)
        )

    def _ask(self) -> None:
        choice = self._draft.choice
        if choice.before is not None or choice.after is not None:
            self.prewarm()
        if self.running or self.current or not choice.ready or self._stopped is not None or choice.frame is Frame.MASK:
            return
        self._submit(choice)

    def _submit(self, choice: ComparisonChoice) -> None:
        self._progress.take()  # of the job before
        self._asked, self._job, self.progress = choice, None, None
        self._background.run("comparison-start", lambda: self._send(choice), None, partial(self._failed, choice))

    # -------------------------------------------------------------------------------- other threads
    def _send(self, choice: ComparisonChoice) -> None:
        from scanner_core.comparison.compare import CompareRequest

        assert choice.before is not None
        assert choice.after is not None
        mask = choice.mask if choice.frame is Frame.MASK else None
        request = CompareRequest(choice.before.surface, choice.after.surface, choice.parameters, mask, choice.start)
        self._job = self._ready_worker().submit("compare", request, partial(self._hear, choice))
        if not self._draft.choice.same_question(choice) or self.cancelling:
            self._job.cancel()

    def _ready_worker(self) -> Worker:
        from scanner_core.jobs.worker import Worker

        with self._starting:
            if self._worker is None:
                self._worker = Worker("comparison")
            worker = self._worker
        if self._closed:
            worker.close()
        return worker

    def _hear(self, choice: ComparisonChoice, event: JobEvent) -> None:
        """In the worker's listener thread."""
        from scanner_core.jobs.messages import JobCancelled, JobDone, JobFailed, JobProgress

        match event:
            case JobProgress(progress):
                self._progress.put(progress)
            case JobDone(result):
                try:
                    answer = _whole(cast("Comparison", result))
                except Exception as fault:  # the question has ended, whatever came of it
                    self._background.post(partial(self._failed, choice, fault))
                else:
                    self._background.post(partial(self._done, choice, answer))
            case JobCancelled():
                self._background.post(partial(self._failed, choice, Cancelled()))
            case JobFailed(error):
                self._background.post(partial(self._failed, choice, error))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _done(self, choice: ComparisonChoice, result: Comparison) -> None:
        assert choice.before is not None
        assert choice.after is not None
        # The surfaces came back as copies: one of each is enough.
        answer = replace(result, before=choice.before.surface, after=choice.after.surface, mask=choice.mask if choice.frame is Frame.MASK else None)
        self._answers = [*self._answers, (choice, answer)][-_KEPT:]
        self._asked = self._job = None
        self._look()

    def _failed(self, choice: ComparisonChoice, fault: Exception) -> None:
        self._asked = self._job = None
        wanted = self._draft.choice.same_question(choice)
        if not isinstance(fault, Cancelled) and wanted:
            self._stopped, self.fault = self._draft.choice, fault
            self._tell(fault)
        self._ask()
        self.changed.emit()


def _whole(comparison: Comparison) -> Comparison:
    return _with_null_level(_with_terms(comparison, comparison.parameters))


def _with_terms(comparison: Comparison, parameters: ComparisonParameters) -> Comparison:
    from scanner_core.comparison.compare import with_terms

    return with_terms(comparison, parameters)


def _with_null_level(comparison: Comparison) -> Comparison:
    """With the level that two scans of one model have reached on the rig of these cases, when that was measured."""
    from scanner_core.comparison.null_comparison import carried_levels, with_null_level

    surfaces = (comparison.after, comparison.before)
    told = next((surface.origin for surface in surfaces if surface.origin.get("null_levels")), {})
    date, rig = told.get("calibration_date"), told.get("rig")
    return with_null_level(
        comparison,
        carried_levels(*surfaces),
        calibration_date=date if isinstance(date, str) else None,
        rig=rig if isinstance(rig, str) else None,
    )
