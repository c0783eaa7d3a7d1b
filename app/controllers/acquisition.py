"""A scan: borrows the rig, runs the core's runner on it, and hands points, previews and status to the views."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.case import CaseController
from app.controllers.rig import RigController
from scanner_core.acquisition.handover import Preview
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.status import ScanState, ScanStatus
from scanner_core.errors import ImprontaError, UsageError

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.acquisition.runner import ScanRunner
    from scanner_core.acquisition.scan_result import ScanResult
    from scanner_core.acquisition.view_state import ViewProgress
    from scanner_core.acquisition.views import RegisteredViews
    from scanner_core.case.store import CaseStore

_VIEWS_PERIOD_S = 0.2
MakeRunner = Callable[["OpenRig", "CaseStore"], "ScanRunner"]


class AcquisitionController(QObject):
    """One scan at a time."""

    changed = Signal()
    """There is a newer status."""
    began = Signal()
    """A scan starts: what is shown of the one before is stale."""
    ended = Signal()
    """The scan is over; `result` says how."""

    def __init__(
        self, background: Background, rig: RigController, case: CaseController, tell: Callable[[BaseException], None], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._background, self._rig, self._case, self._tell = background, rig, case, tell
        self._runner: ScanRunner | None = None
        self._made: ScanRunner | None = None
        """Begun in its thread, and not followed yet."""
        self._starting: threading.Thread | None = None
        self._wanted = False
        self._stopped = self._borrowed = False
        self.status: ScanStatus | None = None
        """Of the runner, with rate and time left in the person's own seconds."""
        self.views: tuple[ViewProgress, ...] = ()
        """Of the plan of the running scan, or of the one that has ended last; none of a laser line."""
        self._looked_s = self._began_s = 0.0
        self._calibration = ""  # its identity
        self.result: ScanResult | None = None
        self._taken = 0
        self._scanned: Path | None = None
        """The case that status, views and result belong to."""
        self._point_sinks: list[Callable[[LivePoints], None]] = []
        self._preview_sinks: list[Callable[[str, Preview], None]] = []
        case.opened.connect(self._forget_other)

    # -------------------------------------------------------------------------------- who wants to see it
    def add_point_sink(self, sink: Callable[[LivePoints], None]) -> None:
        """`sink(points)` gets every point once."""
        self._point_sinks.append(sink)

    def add_preview_sink(self, sink: Callable[[str, Preview], None]) -> None:
        """`sink(camera, preview)` gets the newest frames."""
        self._preview_sinks.append(sink)

    # -------------------------------------------------------------------------------- commands
    @property
    def running(self) -> bool:
        """From the start until the end was announced."""
        return self._wanted or self._runner is not None

    @property
    def _free(self) -> bool:
        """The rig is open, and nobody measures with it."""
        rig = self._rig.snapshot
        return rig.connected and not rig.busy and rig.calibrating is None

    @property
    def paused(self) -> bool:
        return self.status is not None and self.status.state is ScanState.PAUSED

    def start(self, request: PlanRequest) -> None:
        """Scan into the open case when nothing was scanned into it yet, else into a new one."""
        if self.running:
            return
        if self._rig.snapshot.calibrating is not None:
            what, do = "The rig is being calibrated", "wait for the end of it, or cancel it on the Rig page"
            self._tell(UsageError("E-USE-01", what=what, do=do))
            return
        if not self._rig.snapshot.connected:
            self._tell(UsageError("E-USE-01", what="The rig is not open yet", do="wait until the status line shows it, or choose it on the Rig page"))
            return
        if self._rig.snapshot.busy:  # the reference sphere is being measured
            self._tell(UsageError("E-USE-01", what="The rig is measuring", do="wait until that is done, or stop it first (Esc)"))
            return
        self._prepare()
        self._case.for_scan(lambda store: self._begin(store, partial(_new_scan, request)), self._no_case)

    def start_mount(self, request: PlanRequest) -> None:
        """Scan the object as it stands now into the open case, as another mount."""
        self._go_on(partial(_another_mount, request))

    def fill(self, until_um: float, points: int) -> None:
        """Go on with the newest scan of the open case until an uncertainty, with so many more points at most."""
        self._go_on(partial(_further, until_um, points))

    def measure_again(self, view: int) -> None:
        """Measure a view of the plan (from 0) once more: after the last one of a running scan, else at once."""
        if self._runner is not None:
            self._runner.measure_again(view)
        else:
            self._go_on(partial(_view_again, view))

    def resume(self, path: Path) -> None:
        """Go on with the interrupted scan of a case; known points are measured again first."""
        if self.running or not self._free:
            return
        self._prepare()
        self._case.open(path, lambda store: self._begin(store, _rest_of_scan), self._no_case)

    def _go_on(self, make: MakeRunner) -> None:
        """Scan into the open case."""
        store = self._case.store
        if self.running or store is None or not self._free:
            return
        self._prepare()
        self._begin(store, make)

    def _prepare(self) -> None:
        self._wanted, self._stopped = True, False
        self.status, self.result, self.views = None, None, ()
        self.began.emit()

    def pause_or_resume(self) -> None:
        if self._runner is not None:
            if self.paused or (self.status is not None and self.status.pausing):
                self._runner.resume()
            else:
                self._runner.pause()

    def stop(self) -> None:
        """Laser off at once and end the scan; what was measured is kept.  A scan that is about to begin does not.

        A scan that registers its views has nothing to do with the devices any more: they are stopped like an idle rig's.
        """
        self._stopped = True
        runner = self._runner
        if runner is None:
            return
        status = runner.status()
        if status.state is ScanState.FINISHING or status.finish_reason is not None:
            self._let_go()
            self._rig.laser_off()
        else:
            self._background.run("scan-stop", runner.cancel)

    def shutdown(self, timeout_s: float) -> bool:
        """End a running scan and wait for it, also one that is just beginning."""
        self._stopped = True
        if self._starting is not None:
            self._starting.join(timeout_s)
        runner = self._runner or self._made
        if runner is None:
            return True
        runner.cancel()
        return runner.join(timeout_s)

    # -------------------------------------------------------------------------------- pump
    def drain(self) -> None:
        """In the GUI thread: points, previews and the status since the last time."""
        runner = self._runner
        if runner is None:
            return
        self._drain_points(runner)
        for name, slot in runner.previews.items():
            preview = slot.take()
            if preview is not None:
                for sink in self._preview_sinks:
                    sink(name, preview)
        if time.monotonic() - self._looked_s >= _VIEWS_PERIOD_S:
            self._looked_s = time.monotonic()
            self.views = runner.views()
        status = self._in_own_seconds(runner.status())
        self.status = status
        self._rig.hear_owner()
        if status.state is ScanState.FINISHING:
            self._let_go()  # at rest: what is left is arithmetic, and somebody should go on asking the controller
        self.changed.emit()
        if status.finish_reason is not None and runner.join(0.0):
            self._finish(runner)

    def _drain_points(self, runner: ScanRunner) -> None:
        points = runner.live_cloud.since(self._taken)
        if not len(points):
            return
        self._taken += len(points)
        for sink in self._point_sinks:
            sink(points)

    # -------------------------------------------------------------------------------- inside
    def _forget_other(self) -> None:
        """Of another order neither figures nor views may be told, nor a view measured again."""
        if not self.running and self._case.path != self._scanned:
            self.status, self.result, self.views, self._scanned = None, None, (), None
            self.changed.emit()

    def _begin(self, store: CaseStore, make: MakeRunner) -> None:
        """`make` the scan, off the GUI thread, and follow it."""
        if self._stopped:  # while the case was made
            self._no_case()
            return
        rig = self._rig.borrow()
        if rig is None:
            self._no_case()
            self._tell(UsageError("E-USE-01", what="The rig is not open yet", do="wait until the status line shows it"))
            return
        self._borrowed, self._scanned = True, store.path
        self._calibration = "" if rig.calibration is None else rig.calibration.identity()
        self._starting = self._background.run("scan-start", lambda: self._started(make, rig, store), self._follow, self._not_started)

    def _started(self, make: MakeRunner, rig: OpenRig, store: CaseStore) -> ScanRunner:
        """In a thread of its own."""
        import_module("scanner_core.case.processing")  # for the end of the scan, which the window's own thread tells of
        self._rig.settle()
        rig.concern(store)
        runner = make(rig, store)
        runner.start()
        self._made = runner
        return runner

    def _let_go(self) -> None:
        if self._borrowed:
            self._borrowed = False
            self._rig.give_back()

    def _follow(self, runner: ScanRunner) -> None:
        self._runner, self._made, self._wanted, self._taken = runner, None, False, 0
        self._began_s = time.monotonic()
        if self._stopped:  # meanwhile
            self.stop()
        self.drain()

    def _in_own_seconds(self, status: ScanStatus) -> ScanStatus:
        """A virtual rig's clock may run faster than the one on the wall."""
        own_s = max(time.monotonic() - self._began_s, 1e-3)
        speed = status.seconds / own_s
        if speed < 1e-3:
            return status
        left = None if status.seconds_left is None else status.seconds_left / speed
        return replace(status, rate_hz=status.rate_hz * speed, seconds=own_s, seconds_left=left)

    def _not_started(self, fault: Exception) -> None:
        self._let_go()
        self._no_case()
        self._tell(fault)

    def _no_case(self, _fault: Exception | None = None) -> None:
        """It did not begin after all; the reason has been told."""
        self._wanted = False
        self.changed.emit()
        self.ended.emit()

    def _finish(self, runner: ScanRunner) -> None:
        self._drain_points(runner)
        self._runner = None
        self.result, self.views = runner.result, runner.views()
        self._let_go()
        if self.result is not None and self.result.views is not None:
            self._case.take_cloud(self.result.views.cloud, _source(self.result, self.result.views, self._calibration))
        self.changed.emit()
        self.ended.emit()
        if self.status is not None and isinstance(self.status.error, ImprontaError):
            self._tell(self.status.error)


def _source(result: ScanResult, views: RegisteredViews, calibration: str) -> dict[str, object]:
    """What the points of a scan that has just ended are computed from: as scanned."""
    from scanner_core.case.processing import ProcessedCase, Processing

    scans = () if result.scan_id is None else (result.scan_id,)
    return ProcessedCase(Processing(scans=scans), views.cloud, result.counts, (calibration,), (views.noise,), False, None).provenance()


def _new_scan(request: PlanRequest, rig: OpenRig, store: CaseStore) -> ScanRunner:
    from scanner_core.acquisition.runner import ScanRunner

    return ScanRunner(rig, request, store)


def _another_mount(request: PlanRequest, rig: OpenRig, store: CaseStore) -> ScanRunner:
    from scanner_core.acquisition.runner import ScanRunner

    return ScanRunner(rig, request, store, mount=store.next_mount())


def _rest_of_scan(rig: OpenRig, store: CaseStore) -> ScanRunner:
    from scanner_core.acquisition.runner import ScanRunner
    from scanner_core.case.recovery import interruption
    from scanner_core.errors import AcquisitionError

    interrupted = interruption(store)
    if interrupted is None:
        raise AcquisitionError("E-SCAN-04", path=store.path)
    return ScanRunner(rig, interrupted.request, store, interruption=interrupted)


def _view_again(view: int, rig: OpenRig, store: CaseStore) -> ScanRunner:
    from scanner_core.case.reopening import reopen_view

    reopen_view(store, view)
    return _rest_of_scan(rig, store)


def _further(until_um: float, points: int, rig: OpenRig, store: CaseStore) -> ScanRunner:
    from scanner_core.case.reopening import reopen

    reopen(store, until_um, points)
    return _rest_of_scan(rig, store)
