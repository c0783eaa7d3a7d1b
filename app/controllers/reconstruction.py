"""Points to mesh in the worker process: progress, the inflating surface, cancel, and the result into the case."""

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
from app.draft import DraftValues
from app.views.surface import Surface
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.geometry.point_cloud import PointCloud
    from scanner_core.jobs.messages import JobEvent
    from scanner_core.jobs.worker import JobHandle, Worker
    from scanner_core.reconstruction.parameters import ReconstructionParameters
    from scanner_core.reconstruction.report import Reconstruction

PHASES = ("inflate", "refine", "smooth")
LEAST_TRIANGLES = 200


class ReconstructionController(QObject):
    """One reconstruction at a time."""

    changed = Signal()
    """Newer progress."""
    began = Signal()
    ended = Signal()
    """Over; the case holds a new mesh unless it was cancelled or failed."""
    grown = Signal(object)
    """A :class:`Surface` of the unfinished mesh, while its case is the open one."""

    def __init__(self, background: Background, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._case, self._tell = background, case, tell
        self._cancelled = threading.Event()
        self._progress: LatestSlot[Progress] = LatestSlot()
        self._surfaces: LatestSlot[Surface] = LatestSlot()
        self._starting = threading.Lock()
        self._worker: Worker | None = None
        self._job: JobHandle | None = None
        self._phase_begun_s = 0.0
        self._path: Path | None = None  # of the case whose points they are
        self._source: dict[str, object] = {}
        self.running = False
        self.progress: Progress | None = None
        self.phase_seconds: dict[str, float] = {}
        self.shown_triangles: int | None = None

    @property
    def cancelling(self) -> bool:
        return self.running and self._cancelled.is_set()

    @property
    def worker_pid(self) -> int | None:
        """The worker's process id, or None while there is none."""
        return None if self._worker is None else self._worker.pid

    # -------------------------------------------------------------------------------- commands
    def start(self, values: DraftValues) -> None:
        """Reconstruct the points of the open case; the mesh goes into that case, whichever is open in the end."""
        cloud = self._case.cloud
        if self.running or cloud is None:
            return
        self.running, self.progress, self.phase_seconds, self.shown_triangles, self._job = True, None, {}, None, None
        self._path, self._source = self._case.path, self._case.source
        self._cancelled.clear()
        self._phase_begun_s = time.monotonic()
        self.began.emit()
        self._background.run("reconstruction-start", lambda: self._submit(cloud, values), None, self._failed)

    def cancel(self) -> None:
        """Ask the worker to stop; it is replaced when it does not."""
        self._cancelled.set()
        if self._job is not None:
            self._job.cancel()
        self.changed.emit()

    def prewarm(self) -> None:
        """Start the worker process, so that the first reconstruction need not wait for its imports."""
        self._background.run("worker-start", self._ready_worker)

    def shutdown(self) -> None:
        """Cancel what runs and end the worker; a worker that was still starting is waited for."""
        self._cancelled.set()
        with self._starting:
            worker = self._worker
        if worker is not None:
            worker.close()

    # -------------------------------------------------------------------------------- pump
    def drain(self) -> None:
        """In the GUI thread: the newest progress and the newest surface."""
        surface, progress = self._surfaces.take(), self._progress.take()
        if not self.running:
            return
        if surface is not None:
            self.shown_triangles = len(surface.mesh.triangles)
            if self._path == self._case.path:
                self.grown.emit(surface)
        if progress is not None:
            now_s = time.monotonic()
            if self.progress is not None and progress.phase != self.progress.phase:
                self.phase_seconds[self.progress.phase] = now_s - self._phase_begun_s
                self._phase_begun_s = now_s
            self.progress = progress
            self.changed.emit()

    # -------------------------------------------------------------------------------- other threads
    def _submit(self, cloud: PointCloud, values: DraftValues) -> None:
        from scanner_core.reconstruction.job import ReconstructionRequest
        from scanner_core.reconstruction.parameters import ReconstructionParameters

        tolerance_um = float(values.tolerance_um) if values.tolerance_um else None
        triangles = max(LEAST_TRIANGLES, values.triangles) if values.triangles and tolerance_um is None else None
        parameters = ReconstructionParameters(triangles=triangles, tolerance_um=tolerance_um, table_mm=_table_mm(self._source))
        self._job = self._ready_worker().submit("reconstruct", ReconstructionRequest(cloud, parameters), partial(self._hear, parameters))
        if self._cancelled.is_set():
            self._job.cancel()

    def _ready_worker(self) -> Worker:
        from scanner_core.jobs.worker import Worker

        with self._starting:
            if self._worker is None:
                self._worker = Worker("reconstruction")
            return self._worker

    def _hear(self, parameters: ReconstructionParameters, event: JobEvent) -> None:
        """In the worker's listener thread."""
        from scanner_core.jobs.messages import JobCancelled, JobDone, JobFailed, JobProgress

        match event:
            case JobProgress(progress):
                self._progress.put(progress)
                if progress.preview is not None:
                    self._surfaces.put(Surface.of(progress.preview, growing=True))
            case JobDone(result):
                self._background.post(partial(self._done, cast("Reconstruction", result), parameters))
            case JobCancelled():
                self._background.post(partial(self._failed, Cancelled()))
            case JobFailed(error):
                self._background.post(partial(self._failed, error))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _done(self, result: Reconstruction, parameters: ReconstructionParameters) -> None:
        self.running = False
        provenance = {"parameters": parameters.as_dict(), "report": result.report.as_dict(), "seed": parameters.seed}
        self._case.keep_mesh(result.mesh, provenance | self._source, self._path)
        self.ended.emit()

    def _failed(self, fault: Exception) -> None:
        self.running = False
        self.ended.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)


def _table_mm(source: dict[str, object]) -> float | None:
    """Height of the table that the object stands on; None when it was also seen in another mount, which shows its base."""
    processing = source.get("processing")
    mounts = processing.get("mounts") if isinstance(processing, dict) else None
    return None if isinstance(mounts, list) and len(mounts) > 1 else 0.0
