"""Points to mesh in the worker process: progress, the inflating surface, cancel, and the result into the case."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.draft import DraftValues
from app.views.surface import Surface
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.reconstruction.pipeline import Reconstruction

    from scanner_core.geometry.point_cloud import PointCloud

PHASES = ("inflate", "refine", "smooth")
_PREVIEW_PERIOD_S = 0.2
LEAST_TRIANGLES = 200


class ReconstructionController(QObject):
    """One reconstruction at a time."""

    changed = Signal()
    """Newer progress."""
    began = Signal()
    ended = Signal()
    """Over; the case holds a new mesh unless it was cancelled or failed."""
    grown = Signal(object)
    """A :class:`Surface` of the unfinished mesh."""

    def __init__(
        self, background: Background, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._background, self._case, self._tell = background, case, tell
        self._cancelled = threading.Event()
        self._progress: LatestSlot[Progress] = LatestSlot()
        self._surfaces: LatestSlot[Surface] = LatestSlot()
        self._drawn_s = 0.0
        self._phase_begun_s = 0.0
        self.running = False
        self.progress: Progress | None = None
        self.phase_seconds: dict[str, float] = {}
        self.shown_triangles: int | None = None

    @property
    def cancelling(self) -> bool:
        return self.running and self._cancelled.is_set()

    # -------------------------------------------------------------------------------- commands
    def start(self, values: DraftValues) -> None:
        """Reconstruct the points of the open case."""
        cloud = self._case.cloud
        if self.running or cloud is None:
            return
        self.running, self.progress, self.phase_seconds, self.shown_triangles = True, None, {}, None
        self._cancelled.clear()
        self._phase_begun_s = time.monotonic()
        self.began.emit()
        self._background.run("reconstruction", lambda: self._work(cloud, values), self._done, self._failed)

    def cancel(self) -> None:
        """Ask the worker to stop; it is replaced when it does not."""
        self._cancelled.set()
        self.changed.emit()

    def shutdown(self) -> None:
        """Cancel what runs and end the worker."""
        self._cancelled.set()

    # -------------------------------------------------------------------------------- pump
    def drain(self) -> None:
        """In the GUI thread: the newest progress and the newest surface."""
        surface, progress = self._surfaces.take(), self._progress.take()
        if not self.running:
            return
        if surface is not None:
            self.shown_triangles = len(surface.mesh.triangles)
            self.grown.emit(surface)
        if progress is not None:
            now_s = time.monotonic()
            if self.progress is not None and progress.phase != self.progress.phase:
                self.phase_seconds[self.progress.phase] = now_s - self._phase_begun_s
                self._phase_begun_s = now_s
            self.progress = progress
            self.changed.emit()

    # -------------------------------------------------------------------------------- the job's thread
    def _work(self, cloud: PointCloud, values: DraftValues) -> tuple[Reconstruction, dict[str, object]]:
        from scanner_core.reconstruction.pipeline import Reconstruction
        from scanner_core.reconstruction.request import ReconstructionRequest

        from scanner_core.jobs.worker import run_in_worker
        from scanner_core.reconstruction.parameters import ReconstructionParameters

        tolerance_um = float(values.tolerance_um) if values.tolerance_um else None
        triangles = max(LEAST_TRIANGLES, values.triangles) if values.triangles and tolerance_um is None else None
        parameters = ReconstructionParameters(triangles=triangles, tolerance_um=tolerance_um)
        result = run_in_worker("reconstruct", ReconstructionRequest(cloud, parameters), progress=self._hear, cancelled=self._cancelled.is_set)
        if not isinstance(result, Reconstruction):
            raise TypeError(f"the worker answered with {type(result).__name__}")
        return result, {"parameters": parameters.as_dict(), "report": result.report.as_dict(), "seed": parameters.seed}

    def _hear(self, progress: Progress) -> None:
        self._progress.put(progress)
        now_s = time.monotonic()
        if progress.preview is not None and now_s - self._drawn_s >= _PREVIEW_PERIOD_S:
            self._drawn_s = now_s
            self._surfaces.put(Surface.of(progress.preview, growing=True))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _done(self, result: tuple[Reconstruction, dict[str, object]]) -> None:
        self.running = False
        self._case.keep_mesh(result[0].mesh, result[1])
        self.ended.emit()

    def _failed(self, fault: Exception) -> None:
        self.running = False
        self.ended.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)
