"""A job of the worker process on the open case: on a copy of it, because the file itself is this program's."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from app.background import Background
from app.controllers.case import CaseController
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.case.snapshot import CaseSnapshot
    from scanner_core.case.store import CaseStore
    from scanner_core.jobs.messages import JobEvent
    from scanner_core.jobs.worker import JobHandle, Worker

T = TypeVar("T")


class CaseJob:
    """One job at a time, in a worker of its own that starts when it is first needed."""

    def __init__(self, name: str, job: str, background: Background, case: CaseController) -> None:
        """`job` is a name of :data:`scanner_core.jobs.registry.JOBS`."""
        self._name, self._job_name, self._background, self._case = name, job, background, case
        self._worker: Worker | None = None
        self._starting = threading.Lock()
        self._closed = False
        self._turn = 0
        self._handle: JobHandle | None = None
        self._progress: LatestSlot[Progress] = LatestSlot()
        self.running = False

    def start(
        self,
        request: Callable[[Path], object],
        prepare: Callable[[Any], T],
        done: Callable[[T], None],
        failed: Callable[[Exception], None],
    ) -> None:
        """Run on the case as it stands now; `request` is made for the copy.

        Then `prepare` makes of the result, off the GUI thread, what `done` gets in it; or `failed` gets the fault, which is
        :class:`Cancelled` when it was cancelled.
        """
        store = self._case.store
        if self.running or store is None:
            return
        self.running, self._handle = True, None
        self._turn += 1
        turn = self._turn
        end = partial(self._end, turn, failed)
        hear = partial(self._hear, prepare, partial(self._finish, turn, done, failed), end)
        self._background.run(f"{self._name}-start", partial(self._submit, turn, store, request, hear), None, end)

    def cancel(self) -> None:
        """Harmless when nothing runs."""
        if self.running:
            self._turn += 1
            if self._handle is not None:
                self._handle.cancel()

    def newest(self) -> Progress | None:
        """Progress since the last time."""
        return self._progress.take()

    def shutdown(self) -> None:
        """Cancel what runs and end the worker."""
        self.cancel()
        with self._starting:
            self._closed, worker = True, self._worker
        if worker is not None:
            worker.close()

    # -------------------------------------------------------------------------------- other threads
    def _submit(self, turn: int, store: CaseStore, request: Callable[[Path], object], hear: Callable[[CaseSnapshot, JobEvent], None]) -> None:
        from scanner_core.case.snapshot import CaseSnapshot

        snapshot = CaseSnapshot(store)
        try:
            worker = self._ready_worker()
            if worker is None or turn != self._turn:
                raise Cancelled
            self._handle = worker.submit(self._job_name, request(snapshot.path), partial(hear, snapshot))
        except BaseException:
            snapshot.close()
            raise
        if turn != self._turn:
            self._handle.cancel()

    def _ready_worker(self) -> Worker | None:
        from scanner_core.jobs.worker import Worker

        with self._starting:
            if self._worker is None and not self._closed:
                self._worker = Worker(self._name, job=self._job_name)
            return None if self._closed else self._worker

    def _hear(
        self, prepare: Callable[[Any], T], done: Callable[[T], None], failed: Callable[[Exception], None], snapshot: CaseSnapshot, event: JobEvent
    ) -> None:
        """In the worker's listener thread."""
        from scanner_core.jobs.messages import JobCancelled, JobDone, JobFailed, JobProgress

        if isinstance(event, JobProgress):
            self._progress.put(event.progress)
            return
        snapshot.close()
        match event:
            case JobDone(result):
                self._background.post(partial(done, prepare(result)))
            case JobFailed(error):
                self._background.post(partial(failed, error))
            case JobCancelled():
                self._background.post(partial(failed, Cancelled()))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _finish(self, turn: int, done: Callable[[T], None], failed: Callable[[Exception], None], answer: T) -> None:
        self.running = False
        if turn == self._turn:
            done(answer)
        else:
            failed(Cancelled())

    def _end(self, turn: int, failed: Callable[[Exception], None], fault: Exception) -> None:
        self.running = False
        failed(fault if turn == self._turn else Cancelled())
