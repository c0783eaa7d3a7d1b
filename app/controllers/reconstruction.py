"""Points to mesh in the worker process: progress, the inflating surface, the ends that a person may ask for, and the result into its case.

A reconstruction belongs to the case of its points.  Meanwhile another case may be open, or a scan run: then nothing of it is
drawn, and its surface goes into its own file.  What is asked for meanwhile waits for its turn.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, cast

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.controllers.reconstruction_queue import ReconstructionQueue, WantedSurface, parameters_of
from app.draft import DraftValues
from app.views.surface import Surface
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.geometry.distance_histogram import DistanceHistogram
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.jobs.messages import JobEvent
    from scanner_core.jobs.worker import JobHandle, Worker
    from scanner_core.reconstruction.parameters import ReconstructionParameters
    from scanner_core.reconstruction.report import Reconstruction

PHASES = ("inflate", "refine", "smooth")


class ReconstructionController(QObject):
    """One reconstruction at a time, and those that wait."""

    changed = Signal()
    """Newer progress, or another order of what waits."""
    began = Signal()
    ended = Signal()
    """Over; the case will hold a new mesh if `succeeded`."""
    grown = Signal(object)
    """A :class:`Surface` of the unfinished mesh, while its case is the open one."""

    def __init__(self, background: Background, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._case, self._tell = background, case, tell
        self._cancelled, self._enough = threading.Event(), threading.Event()
        self._progress: LatestSlot[Progress] = LatestSlot()
        self._surfaces: LatestSlot[Surface] = LatestSlot()
        self._distances: LatestSlot[DistanceHistogram] = LatestSlot()
        self._starting = threading.Lock()
        self._worker: Worker | None = None
        self._job: JobHandle | None = None
        self._closed = False
        self._begun_s = self._phase_begun_s = 0.0
        self.queue = ReconstructionQueue()
        self.wanted: WantedSurface | None = None
        """What runs, or ran last."""
        self.running = False
        self.succeeded = False
        self.progress: Progress | None = None
        self.phase_seconds: dict[str, float] = {}
        self.shown_triangles: int | None = None
        self.distances: DistanceHistogram | None = None
        """Of the points from the newest surface for which it is known."""

    @property
    def cancelling(self) -> bool:
        return self.running and self._cancelled.is_set()

    @property
    def ending_early(self) -> bool:
        """A person is content with what there is, which is being finished."""
        return self.running and self._enough.is_set() and not self._cancelled.is_set()

    @property
    def mine(self) -> bool:
        """What runs are the points of the open case."""
        return self.running and self._path == self._case.path

    @property
    def waits(self) -> bool:
        """The points of the open case are in the queue."""
        return self._case.path is not None and self.queue.holds(self._case.path)

    def is_for(self, path: Path) -> bool:
        """A surface is being made for the case of that path, or waits for its turn."""
        return (self.running and self._path == path) or self.queue.holds(path)

    @property
    def phase_time_s(self) -> float:
        """How long the phase of `progress` lasts so far."""
        return time.monotonic() - self._phase_begun_s if self.running else 0.0

    @property
    def worker_pid(self) -> int | None:
        """The worker's process id, or None while there is none."""
        return None if self._worker is None else self._worker.pid

    @property
    def _path(self) -> Path | None:
        return None if self.wanted is None else self.wanted.path

    # -------------------------------------------------------------------------------- commands
    def start(self, values: DraftValues) -> bool:
        """Reconstruct the points of the open case, now or after those that were asked for before.

        The mesh goes into that case, whichever is open in the end.  False when there are no points, too many orders wait, or these
        points are on their way already.
        """
        cloud, path = self._case.cloud, self._case.path
        if cloud is None or self.mine or self._closed:
            return False
        if not self.queue.put(WantedSurface(path, cloud, self._case.source, values)):
            return False
        if self.running:
            self.changed.emit()
        else:
            self._next()
        return True

    def cancel(self) -> None:
        """Ask the worker to stop; it is replaced when it does not."""
        self._cancelled.set()
        if self._job is not None:
            self._job.cancel()
        self.changed.emit()

    def end_early(self) -> None:
        """Ask the worker to finish with the surface that there is."""
        self._enough.set()
        if self._job is not None:
            self._job.end_early()
        self.changed.emit()

    def drop(self, wanted: WantedSurface) -> None:
        """Take an order out of the queue."""
        self.queue.drop(wanted)
        self.changed.emit()

    def hurry(self, wanted: WantedSurface) -> None:
        """One place forward in the queue."""
        self.queue.hurry(wanted)
        self.changed.emit()

    def prewarm(self) -> None:
        """Start the worker process, so that the first reconstruction need not wait for its imports."""
        self._background.run("worker-start", self._ready_worker)

    def shutdown(self) -> None:
        """Cancel what runs and end the worker; a worker that was still starting is waited for."""
        self._closed = True
        self.queue.clear()
        self._cancelled.set()
        with self._starting:
            worker = self._worker
        if worker is not None:
            worker.close()

    # -------------------------------------------------------------------------------- pump
    def drain(self) -> None:
        """In the GUI thread: the newest progress and the newest surface."""
        surface, progress, distances = self._surfaces.take(), self._progress.take(), self._distances.take()
        if not self.running:
            return
        if surface is not None:
            self.shown_triangles = len(surface.mesh.triangles)
            if self.mine:
                self.grown.emit(surface)
        if distances is not None:
            self.distances = distances
        if progress is not None:
            now_s = time.monotonic()
            if self.progress is not None and progress.phase != self.progress.phase:
                self.phase_seconds[self.progress.phase] = now_s - self._phase_begun_s
                self._phase_begun_s = now_s
            self.progress = progress
            self.changed.emit()

    # -------------------------------------------------------------------------------- other threads
    def _submit(self, wanted: WantedSurface) -> None:
        from scanner_core.reconstruction.job import ReconstructionRequest

        parameters = parameters_of(wanted)
        job = self._ready_worker().submit("reconstruct", ReconstructionRequest(wanted.cloud, parameters), partial(self._hear, wanted, parameters))
        self._job = job
        if self._enough.is_set():
            job.end_early()
        if self._cancelled.is_set():
            job.cancel()

    def _ready_worker(self) -> Worker:
        from scanner_core.jobs.worker import Worker

        with self._starting:
            if self._worker is None:
                self._worker = Worker("reconstruction", gentle=True)
            return self._worker

    def _hear(self, wanted: WantedSurface, parameters: ReconstructionParameters, event: JobEvent) -> None:
        """In the worker's listener thread."""
        from scanner_core.jobs.messages import JobCancelled, JobDone, JobFailed, JobProgress

        match event:
            case JobProgress(progress):
                self._progress.put(progress)
                if progress.distances is not None:
                    self._distances.put(progress.distances)
                if progress.preview is not None:
                    self._surfaces.put(Surface.of(progress.preview, growing=True))
            case JobDone(result):
                self._background.post(partial(self._done, cast("Reconstruction", result), wanted, parameters))
            case JobCancelled():
                self._background.post(partial(self._failed, Cancelled()))
            case JobFailed(error):
                self._background.post(partial(self._failed, error))

    # -------------------------------------------------------------------------------- in the GUI thread
    def _next(self) -> None:
        """Begin with what waits longest, if anything does."""
        wanted = self.queue.take()
        if wanted is None or self._closed:
            return
        self.wanted, self.running, self.succeeded = wanted, True, False
        self.progress, self.phase_seconds, self.shown_triangles, self.distances, self._job = None, {}, None, None, None
        for slot in (self._progress, self._surfaces, self._distances):
            slot.take()  # the last one's
        self._cancelled.clear()
        self._enough.clear()
        self._begun_s = self._phase_begun_s = time.monotonic()
        self.began.emit()
        self._background.run("reconstruction-start", partial(self._submit, wanted), None, self._failed)

    def _done(self, result: Reconstruction, wanted: WantedSurface, parameters: ReconstructionParameters) -> None:
        report = result.report.as_dict()
        provenance = {"parameters": parameters.as_dict(), "report": report, "seed": parameters.seed, "stopped_early": report["stopped_early"]}
        self._case.keep_mesh(result.mesh, provenance | wanted.source, wanted.path)
        self._end(succeeded=True)

    def _failed(self, fault: Exception) -> None:
        self._end(succeeded=False)
        if not isinstance(fault, Cancelled):
            self._tell(fault)

    def _end(self, *, succeeded: bool) -> None:
        self.running, self.succeeded = False, succeeded
        self.ended.emit()
        self._next()
