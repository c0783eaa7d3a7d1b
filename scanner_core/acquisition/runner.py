"""The scan as a state machine without Qt.

::

    IDLE -> PREPARING -> SCANNING <-> PAUSED -> FINISHING -> IDLE
                 |           |          |           ^
                 +-----------+----------+-> FAULT --+

PREPARING locates the object and makes the plan, or measures known points of an interrupted scan again; SCANNING follows
the plan, or what of it is missing, and closes the turn (:mod:`~scanner_core.acquisition.scan_course`); FINISHING registers
the views.  The scan's thread owns the controller: nobody else talks to it, but ``cancel`` stops it from any thread (laser
off first).  Every end goes through FINISHING and sets the finish reason exactly once, with counts that balance over the
plan's trigger ids; a teardown that fails cannot lose the end.
"""

from __future__ import annotations

import json
import logging
import threading
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from functools import partial

from scanner_core.acquisition.assessing import Assess, Assessor
from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.engine import StereoEngine
from scanner_core.acquisition.following import PlanFollower
from scanner_core.acquisition.handover import LatestSlot, PointLog, Preview
from scanner_core.acquisition.health import HealthMonitor
from scanner_core.acquisition.line_course import LineCourse
from scanner_core.acquisition.mark_visitor import MarkVisitor
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.resuming import expect_same_rig
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.scan_course import ScanCourse
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanCounts, ScanState, ScanStatus
from scanner_core.acquisition.view_state import ViewProgress
from scanner_core.acquisition.views import RegisteredViews, register_case
from scanner_core.case.recovery import Interruption
from scanner_core.case.store import CaseStore
from scanner_core.errors import AcquisitionError, CalibrationError, DeviceError, ImprontaError, MotionStoppedError, StorageError
from scanner_core.log_file import log_fault
from scanner_core.optics.spot_detection import SpotDetector

_log = logging.getLogger("impronta")


class ScanRunner:
    """One scan on an open rig into an open case.  Start it once; ``join`` before closing rig and case."""

    def __init__(
        self,
        rig: OpenRig,
        request: PlanRequest,
        store: CaseStore,
        *,
        mount: int = 0,
        interruption: Interruption | None = None,
        assess: Assess | None = None,
        on_end: Callable[[ScanResult], None] | None = None,
    ) -> None:
        """A new scan, or the rest of one.

        Parameters
        ----------
        request : what is asked of a new scan
        mount : how the object stands, for a new scan
        interruption : the scan of this case to go on with; its own request and mount count then
        assess : computes the next pass of an error-driven scan; None for a worker process of its own
        on_end : called once, in the scan's thread, when everything is at rest

        Raises
        ------
        CalibrationError
            E-CAL-02 the rig has none, E-CAL-06 it is not the one of the interrupted scan.
        AcquisitionError
            E-SCAN-05 the rig is another one; of a laser line E-LINE-01 until an uncertainty, E-LINE-03 to be resumed.
        """
        if rig.calibration is None:
            raise CalibrationError("E-CAL-02")
        if interruption is not None:
            expect_same_rig(store, interruption, rig.config, rig.calibration)
        self._rig, self._store, self._on_end = rig, store, on_end
        self._request = request if interruption is None else interruption.request
        mount = mount if interruption is None else interruption.record.mount
        self._resumes, self._assess = interruption is not None, assess
        self.calibration = rig.calibration
        self.live_cloud = PointLog()
        self.previews: dict[str, LatestSlot[Preview]] = {"left": LatestSlot(), "right": LatestSlot()}
        self.result: ScanResult | None = None
        self._control = ScanControl()
        self._lock = threading.Lock()
        self._begin_s = self._end_s = rig.clock.now_s()
        self._health = HealthMonitor(rig.calibration, rig.left.rate_hz)
        self._follower: PlanFollower | LineCourse
        self._course: ScanCourse | LineCourse
        if rig.config.laser.is_line:
            if interruption is not None:
                raise AcquisitionError("E-LINE-03", path=store.path)
            line = LineCourse(rig, rig.calibration, store, self._request, self._control, self.live_cloud, mount)
            self._follower = self._course = line
        else:
            engine = StereoEngine(rig.calibration, rig.config.volume, rig.config.spot.floor_px)
            self._follower = follower = PlanFollower(rig, engine, store, self._health, self._control)
            if (marks := rig.config.marks) is not None:
                follower.marks = MarkVisitor(rig, marks, rig.calibration, store, self._control)
            self._course = ScanCourse(
                rig, rig.calibration, store, self._request, interruption, self._control, self._health, follower, self.live_cloud, mount
            )
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="scan")

    # ------------------------------------------------------------------------------------------ commands
    def start(self) -> None:
        self._control.enter(ScanState.PREPARING)
        self._thread.start()

    def pause(self) -> None:
        """Rest after the row that is being swept; the laser is dark meanwhile."""
        self._control.pause()

    def resume(self) -> None:
        self._control.resume()

    def measure_again(self, view: int) -> None:
        """Measure a view of the plan (from 0) once more, after its last one; without effect on a laser line, and once that is over."""
        self._control.ask_again(view)

    def views(self) -> tuple[ViewProgress, ...]:
        """What has become of the views of the plan so far; from any thread.  None before there is a plan, and of a laser line."""
        if isinstance(self._course, LineCourse):
            return ()
        return self._course.progress.views(() if self._course.closing else self._control.asked_again)  # too late to be done in this scan

    def cancel(self) -> None:
        """Laser off at once and end; what was measured is kept.  From any thread, also twice."""
        if self._control.cancel() and self._control.state not in (ScanState.IDLE, ScanState.FINISHING):
            with suppress(DeviceError):  # the scan's own thread meets the same fault, and tells it
                self._rig.motion.stop()

    def join(self, timeout_s: float | None = None) -> bool:
        """Wait for the end; True when the scan is over."""
        if self._thread.ident is None:
            return True
        # An interrupt in the middle of Thread.join makes Python 3.11 take the thread for dead: wait for the event first.
        if self._ended.wait(timeout_s):
            self._thread.join()
        return self._ended.is_set()

    def status(self) -> ScanStatus:
        """A snapshot; from any thread, takes no time."""
        with self._lock:
            state, result, tally, end_s = self._control.state, self.result, self._course.tally, self._end_s
        motion = self._follower.motion
        running = state not in (ScanState.IDLE, ScanState.FINISHING)
        now_s = self._rig.clock.now_s() if running else end_s
        return ScanStatus(
            state=state,
            counts=tally.counts(),
            view=self._follower.view,
            views=self._course.views,
            rate_hz=tally.rate_hz() if state is ScanState.SCANNING else 0.0,
            seconds=now_s - self._begin_s,
            seconds_left=self._course.seconds_left(now_s) if state is ScanState.SCANNING else None,
            table_deg=motion.table_deg,
            laser_on=motion.laser_power > 0,
            pausing=self._control.rest_wanted and state is not ScanState.PAUSED and running,
            closing=self._course.closing,
            repeats=self._repeated(),
            steering=None if self._course.steering is None else self._course.steering.status(),
            findings=self._health.findings,
            finish_reason=None if result is None else result.finish_reason,
            error=None if result is None else result.error,
        )

    def _repeated(self) -> int | None:
        """The view that is being measured once more."""
        plan, view = self._course.plan, self._follower.view
        return plan.views[view].repeats if plan is not None and view < len(plan.views) and not self._course.closing else None

    # ------------------------------------------------------------------------------------------ the scan's thread
    def _run(self) -> None:
        error: ImprontaError | None = None
        views: RegisteredViews | None = None
        wall_s = time.monotonic()
        captures: list[CaptureThread] = []
        assessor: Assessor | None = None
        begun = "resumed" if self._resumes else "begun"
        _log.info("scan %s: %d views, %d points wanted", begun, self._request.views, self._request.points)
        try:
            if self._request.until_um is not None and self._assess is None:
                assessor = Assessor()  # now: it is warm by the time that it is needed
            if isinstance(self._course, LineCourse):
                self._course.run()
            else:
                detector = SpotDetector(self._rig.config.spot)
                captures = [CaptureThread(camera, detector, self.previews[camera.name]) for camera in (self._rig.left, self._rig.right)]
                self._course.run(captures[0], captures[1], self._assess or assessor)
        except BaseException as fault:
            error = self._as_error(fault)
            self._darken()  # before anything that takes time
        steps: list[Callable[[], None]] = [capture.close for capture in captures]
        steps += [partial(self._rest, error is not None), self._follower.keep]
        steps += [] if assessor is None else [assessor.close]
        for step in steps:
            try:
                step()
            except BaseException as fault:
                error = error or self._as_error(fault)
        if error is not None:
            self._control.enter(ScanState.FAULT)
        wall_s = time.monotonic() - wall_s
        reason = FinishReason.FAILED if error else FinishReason.CANCELLED if self._control.cancelled.is_set() else FinishReason.COMPLETED
        self._control.enter(ScanState.FINISHING)
        counts = self._kept(error)
        try:
            beside, scan_id = self._course.open, self._course.scan_id
            if beside is not None and beside.scan_id != scan_id:  # it did not come to its end
                self._store.end_scan(beside.scan_id, reason, beside.tally.counts())
            if scan_id is not None:
                for finding in self._health.findings:
                    self._store.audit(f"health {finding.code}", json.dumps(finding.as_dict()))
                if self._follower.marks is not None and (marks := self._follower.marks.report()) is not None:
                    self._store.audit("marks", json.dumps(marks.as_dict()))
                if counts.measured and not isinstance(error, StorageError):
                    views = register_case(self._store, scan_id, self._rig.config, self.calibration, self._health.closure_um)
                # Last: a scan that is killed before its views are registered must not count as complete.
                self._store.end_scan(scan_id, reason, counts)
        except BaseException as fault:
            error = error or self._as_error(fault)
            reason = FinishReason.FAILED
        told = "scan %s: %d planned, %d measured, %s rejected, %d skipped, %d findings, %.1f s"
        findings = len(self._health.findings)
        _log.info(told, reason.value, counts.planned, counts.measured, counts.rejected or "none", counts.skipped, findings, wall_s)
        if error is not None:
            log_fault(error, "scan")
        _without_frames(error)
        result = ScanResult(
            finish_reason=reason,
            counts=counts,
            located=self._course.located,
            views_planned=self._course.views,
            exposures=self._follower.exposures,
            wall_s=wall_s,
            rig_s=self._end_s - self._begin_s,
            scan_id=self._course.scan_id,
            views=views,
            health=self._health.report(),
            resumed=self._course.resumed,
            steering=None if self._course.steering is None else self._course.steering.result(),
            error=error,
            laser=self._rig.config.laser.shape,
            marks=None if self._follower.marks is None else self._follower.marks.report(),
            plan=self.views(),
        )
        with self._lock:
            self.result = result
            self._control.enter(ScanState.IDLE)
        try:
            if self._on_end is not None:
                self._on_end(result)
        finally:
            self._ended.set()

    def _darken(self) -> None:
        with suppress(ImprontaError):  # what cannot be reached is told by :meth:`_rest`
            self._rig.motion.stop()

    def _rest(self, failed: bool) -> None:
        """Laser off and motion at rest, whatever happened."""
        self._end_s = self._rig.clock.now_s()
        if not failed and not self._control.cancelled.is_set():
            self._rig.motion.laser(False)
        else:
            self._rig.motion.stop()
            self._rig.motion.recover()
        self._follower.ask()

    def _kept(self, error: ImprontaError | None) -> ScanCounts:
        """The counts; where the case could not take everything, of what it holds."""
        counts, scan_id = self._course.tally.counts(), self._course.scan_id
        if scan_id is None or not isinstance(error, StorageError):
            return counts
        try:
            return ScanCounts.of(counts.planned, self._store.verdict_counts(scan_id))
        except ImprontaError:
            return counts

    def _as_error(self, fault: BaseException) -> ImprontaError | None:
        if self._control.cancelled.is_set() and isinstance(fault, MotionStoppedError):
            return None  # the controller's answer to the stop that was asked for
        if isinstance(fault, ImprontaError):
            return fault
        details = "".join(traceback.format_exception(fault))
        return AcquisitionError("E-SCAN-02", reason=f"{type(fault).__name__}: {fault}", case=self._store.path, details=details)


def _without_frames(error: BaseException | None) -> None:
    """A result outlives its scan, and an error's tracebacks hold every local of it: cameras, their rig, some 80 MB."""
    while error is not None:
        error.__traceback__ = None
        error = error.__cause__ or error.__context__
