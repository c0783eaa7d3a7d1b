"""The coarse surface that follows the live points during a scan, computed in a worker of its own that gives way to the scan.

One request is on its way at a time and it takes the newest points, so an older one never waits behind it.  Whatever goes
wrong ends the live surface of this scan with a note; the scan knows nothing of it.
"""

from __future__ import annotations

import threading
import time
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.views.holed_surface import HoledSurface
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.log_file import log_fault
from scanner_core.reconstruction.live_request import LiveSurface, LiveSurfaceRequest, NoSurfaceReason, NoSurfaceYet

if TYPE_CHECKING:
    from app.views.scene_view import SceneView
    from scanner_core.geometry.mesh import TriangleMesh
    from scanner_core.jobs.messages import JobEvent
    from scanner_core.jobs.worker import JobHandle, Worker

PERIOD_S = 0.5
"""From request to request at least."""


class LiveSurfaceController(QObject):
    """Watches the points of one 3D view while a scan runs."""

    changed = Signal()
    """There is a newer surface, or another reason why there is none."""

    def __init__(self, background: Background, acquisition: AcquisitionController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._acquisition = background, acquisition
        self._scene: SceneView | None = None
        self._worker: Worker | None = None
        self._starting = threading.Lock()
        self._closed = False
        self._job: JobHandle | None = None
        self._shown: LatestSlot[tuple[int, HoledSurface]] = LatestSlot()
        self._scan = 0  # counted on, so that an answer to an earlier scan is known as such
        self._asked = 0
        self._next_s = 0.0
        self._before: TriangleMesh | None = None
        self._wanted = self._allowed = True
        self.supported_area: float | None = None
        """Share of the surface that the points bear out, or None while there is no surface."""
        self.reason: NoSurfaceReason | None = None
        """Why the newest points made no surface."""
        self.failed = False
        """It has ended before its scan."""
        acquisition.began.connect(self._begin)
        acquisition.ended.connect(self._end)

    def watch(self, scene: SceneView) -> None:
        """The 3D view is there."""
        self._scene = scene

    def want(self, on: bool) -> None:
        """Whether a person wants to see it; nothing is computed when not."""
        self._wanted = on

    def allow(self, on: bool) -> None:
        """Whether the settings have it at all."""
        self._allowed = on

    @property
    def worker_pid(self) -> int | None:
        """The worker's process id, or None while there is none."""
        return None if self._worker is None else self._worker.pid

    def tick(self) -> None:
        """For the pump: show what is there, ask for what is due."""
        scene = self._scene
        if scene is None or scene.closed:
            return
        newest = self._shown.take()
        if newest is not None and newest[0] == self._scan:
            scene.show_live_surface(newest[1])
        self._ask(scene)

    def prepare(self) -> None:
        """Start the worker process where there is none yet; it stays for all further scans."""
        if self._worker is None:
            self._background.run("live-surface-start", self._start_worker)

    def shutdown(self) -> None:
        """Cancel what runs and end the worker; one that was still starting is waited for."""
        self._scene = None
        with self._starting:
            self._closed, worker = True, self._worker
        if worker is not None:
            worker.close()

    # -------------------------------------------------------------------------------- a scan begins and ends
    def _begin(self) -> None:
        self._scan += 1
        self._asked, self._before, self._job = 0, None, None
        self.supported_area, self.reason, self.failed = None, None, False
        self.prepare()
        self.changed.emit()

    def _end(self) -> None:
        if self._job is not None:
            self._job.cancel()
        self._scan += 1
        self.changed.emit()

    def _start_worker(self) -> None:
        from scanner_core.jobs.worker import Worker

        with self._starting:
            if self._worker is None and not self._closed:
                self._worker = Worker("live-surface", job="live-surface", gentle=True)

    # -------------------------------------------------------------------------------- request and answer
    def _ask(self, scene: SceneView) -> None:
        worker, count = self._worker, len(scene.cloud)
        if not (self._wanted and self._allowed) or self.failed or worker is None or worker.busy or not self._acquisition.running:
            return
        if count == self._asked or time.monotonic() < self._next_s:
            return
        self._asked, self._next_s = count, time.monotonic() + PERIOD_S
        points, towards = scene.cloud.live_points()
        request = LiveSurfaceRequest(points, towards, self._before)
        self._job = worker.submit("live-surface", request, partial(self._hear, self._scan))

    def _hear(self, scan: int, event: JobEvent) -> None:
        """In the worker's listener thread."""
        from scanner_core.jobs.messages import JobDone, JobFailed

        match event:
            case JobDone(LiveSurface() as surface):
                self._shown.put((scan, HoledSurface.of(surface.mesh)))
                self._background.post(partial(self._take, scan, surface))
            case JobDone(NoSurfaceYet(reason)):
                self._background.post(partial(self._take, scan, reason))
            case JobFailed(error):
                log_fault(error, "live surface")
                self._background.post(partial(self._take, scan, None))

    def _take(self, scan: int, answer: LiveSurface | NoSurfaceReason | None) -> None:
        """Back in the GUI thread; what is shown stays when the newest points make no surface."""
        if scan != self._scan:
            return
        if isinstance(answer, LiveSurface):
            self._before, self.supported_area, self.reason = answer.mesh, answer.supported_area, None
        else:
            self.reason, self.failed = answer, answer is None
        self.changed.emit()
