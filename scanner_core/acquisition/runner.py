"""The scan as a state machine without Qt.

::

    IDLE -> PREPARING -> SCANNING <-> PAUSED -> FINISHING -> IDLE
                 |           |          |           ^
                 +-----------+----------+-> FAULT --+

PREPARING locates the object and makes the plan, or measures known points of an interrupted scan again; SCANNING follows
the plan, or what of it is missing, and closes the turn; FINISHING registers the views.  The scan's thread owns the
controller: nobody else talks to it, but ``cancel`` stops it from any thread (laser off first).  Every end goes through
FINISHING and sets the finish reason exactly once, with counts that balance over the plan's trigger ids; a teardown that
fails cannot lose the end.
"""

from __future__ import annotations

import json
import logging
import threading
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict
from functools import partial

import numpy as np

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.engine import StereoEngine
from scanner_core.acquisition.following import Pass, PlanFollower
from scanner_core.acquisition.handover import LatestSlot, PointLog, Preview
from scanner_core.acquisition.health import HealthMonitor, Phase
from scanner_core.acquisition.known_points import KnownPoints, agreement, check_plan
from scanner_core.acquisition.plan import PlanRequest, ScanPlan
from scanner_core.acquisition.planning import closing_plan, locating_plan, scan_plan, table_angles_deg
from scanner_core.acquisition.resuming import expect_same_rig, resumption
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason, ScanCounts, ScanState, ScanStatus
from scanner_core.acquisition.tally import Tally
from scanner_core.acquisition.views import RegisteredViews, register_case
from scanner_core.case.recovery import Interruption
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import AcquisitionError, CalibrationError, DeviceError, ImprontaError, MotionStoppedError, StorageError, UsageError
from scanner_core.log_file import log_fault
from scanner_core.optics.spot import MissReason
from scanner_core.optics.spot_detection import SpotDetector

_SAME_RATE = 0.01
"""How far apart the frame rates of the two cameras may be, of the rate."""

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
        on_end: Callable[[ScanResult], None] | None = None,
    ) -> None:
        """A new scan, or the rest of one.

        Parameters
        ----------
        request : what is asked of a new scan
        mount : how the object stands, for a new scan
        interruption : the scan of this case to go on with; its own request and mount count then
        on_end : called once, in the scan's thread, when everything is at rest

        Raises
        ------
        CalibrationError
            E-CAL-02 the rig has none, E-CAL-06 it is not the one of the interrupted scan.
        AcquisitionError
            E-SCAN-05 the rig is another one.
        """
        if rig.calibration is None:
            raise CalibrationError("E-CAL-02")
        if interruption is not None:
            expect_same_rig(store, interruption, rig.config, rig.calibration)
        self._rig, self._store, self._on_end = rig, store, on_end
        self._request = request if interruption is None else interruption.request
        self._mount = mount if interruption is None else interruption.record.mount
        self._interruption = interruption
        self.calibration = rig.calibration
        self.live_cloud = PointLog()
        self.previews: dict[str, LatestSlot[Preview]] = {"left": LatestSlot(), "right": LatestSlot()}
        self.result: ScanResult | None = None
        self._control = ScanControl()
        self._lock = threading.Lock()
        self._tally = Tally(0, None, 0.0)
        self._located = ScanCounts()
        self._begin_s = self._end_s = rig.clock.now_s()
        self._scan_id: int | None = None
        self._open: Pass | None = None
        self._resumed: int | None = None
        self._health = HealthMonitor(rig.calibration, rig.left.rate_hz)
        engine = StereoEngine(rig.calibration, rig.config.volume, rig.config.spot.floor_px)
        self._follower = PlanFollower(rig, engine, store, self._health, self._control)
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
            state, result, tally, end_s = self._control.state, self.result, self._tally, self._end_s
        motion = self._follower.motion
        running = state not in (ScanState.IDLE, ScanState.FINISHING)
        now_s = self._rig.clock.now_s() if running else end_s
        return ScanStatus(
            state=state,
            counts=tally.counts(),
            view=self._follower.view,
            views=self._request.views,
            rate_hz=tally.rate_hz() if state is ScanState.SCANNING else 0.0,
            seconds=now_s - self._begin_s,
            seconds_left=tally.seconds_left(now_s) if state is ScanState.SCANNING else None,
            table_deg=motion.table_deg,
            laser_on=motion.laser_power > 0,
            findings=self._health.findings,
            finish_reason=None if result is None else result.finish_reason,
            error=None if result is None else result.error,
        )

    # ------------------------------------------------------------------------------------------ the scan's thread
    def _run(self) -> None:
        error: ImprontaError | None = None
        views: RegisteredViews | None = None
        wall_s = time.monotonic()
        captures: list[CaptureThread] = []
        begun = "begun" if self._interruption is None else "resumed"
        _log.info("scan %s: %d views, %d points wanted", begun, self._request.views, self._request.points)
        try:
            detector = SpotDetector(self._rig.config.spot)
            captures = [CaptureThread(camera, detector, self.previews[camera.name]) for camera in (self._rig.left, self._rig.right)]
            self._scan(captures[0], captures[1])
        except BaseException as fault:
            error = self._as_error(fault)
            self._darken()  # before anything that takes time
        steps: list[Callable[[], None]] = [capture.close for capture in captures]
        steps += [partial(self._rest, error is not None), self._follower.keep]
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
            if self._open is not None and self._open.scan_id != self._scan_id:  # a pass beside the scan did not come to its end
                self._store.end_scan(self._open.scan_id, reason, self._open.tally.counts())
            if self._scan_id is not None:
                for finding in self._health.findings:
                    self._store.audit(f"health {finding.code}", json.dumps(finding.as_dict()))
                if counts.measured and not isinstance(error, StorageError):
                    views = register_case(self._store, self._scan_id, self._rig.config, self.calibration)
                # Last: a scan that is killed before its views are registered must not count as complete.
                self._store.end_scan(self._scan_id, reason, counts)
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
            located=self._located,
            views_planned=self._request.views,
            exposures=self._follower.exposures,
            wall_s=wall_s,
            rig_s=self._end_s - self._begin_s,
            scan_id=self._scan_id,
            views=views,
            health=self._health.report(),
            resumed=self._resumed,
            error=error,
        )
        with self._lock:
            self.result = result
            self._control.enter(ScanState.IDLE)
        try:
            if self._on_end is not None:
                self._on_end(result)
        finally:
            self._ended.set()

    def _scan(self, left: CaptureThread, right: CaptureThread) -> None:
        rates_hz = self._rig.left.rate_hz, self._rig.right.rate_hz
        if abs(rates_hz[0] - rates_hz[1]) > _SAME_RATE * rates_hz[0]:  # one trigger id would be two instants
            raise DeviceError("E-CAM-16", left_hz=f"{rates_hz[0]:g}", right_hz=f"{rates_hz[1]:g}")
        interrupted = () if self._interruption is None else self._interruption.plan.views
        for table_deg in [view.table_deg for view in interrupted] or table_angles_deg(self._request.views):
            self._rig.motion.check_table(table_deg)  # not after most of the views
        # Whatever ended the scan before: dark, at rest, and where the rig's angles begin.
        self._rig.motion.recover()
        if self._rig.motion.needs_homing and not self._control.cancelled.is_set():
            self._rig.motion.home()
        if self._interruption is None or not self._go_on_with(self._interruption, left, right):
            self._scan_anew(left, right)

    def _scan_anew(self, left: CaptureThread, right: CaptureThread) -> None:
        rate_hz = self._rig.left.rate_hz
        located = locating_plan(self._rig.config, self._request, rate_hz, self._store.next_trigger_id())
        locate = self._begin("locate", located, None, self.live_cloud)
        self._tally = locate.tally
        self._follower.follow(locate, left, right)
        self._located = self._tally.counts()
        self._end_pass(locate)
        hits = self._store.observations(locate.scan_id).trigger_id
        if not len(hits) and not self._control.cancelled.is_set():
            raise _nothing_seen(self._located)
        if not len(hits):
            self._tally = Tally(0, None, self._rig.clock.now_s())
            return
        plan = scan_plan(self._rig.config, self._request, rate_hz, located, hits, self._store.next_trigger_id())
        scan = self._begin("scan", plan, self._request.points, self.live_cloud)
        self._tally, self._scan_id = scan.tally, scan.scan_id
        self._finish_plan(scan, plan, left, right)

    def _go_on_with(self, interruption: Interruption, left: CaptureThread, right: CaptureThread) -> bool:
        """Scan what an interrupted scan is missing, once known points were found where they were; False when it holds too few."""
        known = KnownPoints.of_scan(self._store, interruption.record.id, self._rig.config, self.calibration)
        rest = resumption(self._store, interruption, known)
        if rest is None:
            self._store.end_scan(interruption.record.id, FinishReason.CANCELLED, interruption.counts)
            return False
        self._scan_id, self._resumed = interruption.record.id, len(known)
        plan, wanted = interruption.plan, self._request.points
        self._tally = Tally(plan.planned, wanted, self._rig.clock.now_s(), rest.verdicts)
        self._health.recall(plan, known, rest.remaining.complete)
        self._find_again(plan, known, left, right)
        if self._control.cancelled.is_set():
            return True
        for view in np.unique(known.views).tolist():
            self.live_cloud.append(known.of_view(view).points, view)
        self._tally = Tally(plan.planned, wanted, self._rig.clock.now_s(), rest.verdicts)
        self._health.go_on()
        self._finish_plan(Pass(interruption.record.id, rest.remaining.plan, self._tally, self.live_cloud), plan, left, right)
        return True

    def _find_again(self, plan: ScanPlan, known: KnownPoints, left: CaptureThread, right: CaptureThread) -> None:
        """Measure known points again.

        Raises
        ------
        AcquisitionError
            E-SCAN-03: they are not where they were.
        """
        check = check_plan(plan, known, self._store.next_trigger_id())
        run = self._begin("check", check.plan, None, PointLog())
        self._follower.follow(run, left, right)
        self._end_pass(run)
        if self._control.cancelled.is_set():
            return
        again = KnownPoints.of_scan(self._store, run.scan_id, self._rig.config, self.calibration)
        found = agreement(known, again, self._store.exposed_ids(run.scan_id), check, self._health.compare)
        self._store.audit("known points measured again", json.dumps(asdict(found)))
        if not found.agrees:
            raise AcquisitionError("E-SCAN-03", seen=found.seen, known=found.known, shift_um=f"{found.shift_um:.0f}")

    def _finish_plan(self, run: Pass, plan: ScanPlan, left: CaptureThread, right: CaptureThread) -> None:
        """Follow `run`, the whole of `plan` or the rest of it, and close the turn."""
        self._control.enter(ScanState.SCANNING)
        self._follower.follow(run, left, right)
        if not self._tally.measured and not self._control.cancelled.is_set():
            raise _nothing_seen(self._tally.counts())
        if len(plan.views) > 1 and plan.views[0].rows and not self._control.cancelled.is_set():
            self._close_turn(plan, left, right)

    def _close_turn(self, plan: ScanPlan, left: CaptureThread, right: CaptureThread) -> None:
        """Measure some of the first view again, beside the counts of the scan."""
        table_deg = plan.views[0].table_deg + 360.0
        try:
            self._rig.motion.check_table(table_deg)
        except UsageError:  # a table that may not turn on for ever turns back
            table_deg -= 360.0
        closing = self._begin("closure", closing_plan(plan, self._store.next_trigger_id(), table_deg), None, PointLog())
        self._follower.follow(closing, left, right)
        self._end_pass(closing)
        if not self._control.cancelled.is_set():
            self._health.close_turn(self._follower.ask().table_deg)

    def _begin(self, kind: Phase, plan: ScanPlan, wanted: int | None, cloud: PointLog) -> Pass:
        calibration = self.calibration
        toml = dump_rig(self._rig.config.with_calibration(calibration))
        bare = dump_rig(self._rig.config.with_calibration(None))
        record = plan.as_dict() | {"request": asdict(self._request)}
        scan_id = self._store.begin_scan(kind, bare, calibration.identity(), toml, record, self._mount)
        self._health.begin(plan, kind)
        self._open = Pass(scan_id, plan, Tally(plan.planned, wanted, self._rig.clock.now_s()), cloud)
        return self._open

    def _end_pass(self, run: Pass) -> None:
        self._follower.keep()
        finished = FinishReason.CANCELLED if self._control.cancelled.is_set() else FinishReason.COMPLETED
        self._store.end_scan(run.scan_id, finished, run.tally.counts())
        self._open = None

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
        counts = self._tally.counts()
        if self._scan_id is None or not isinstance(error, StorageError):
            return counts
        try:
            return ScanCounts.of(counts.planned, self._store.verdict_counts(self._scan_id))
        except ImprontaError:
            return counts

    def _as_error(self, fault: BaseException) -> ImprontaError | None:
        if self._control.cancelled.is_set() and isinstance(fault, MotionStoppedError):
            return None  # the controller's answer to the stop that was asked for
        if isinstance(fault, ImprontaError):
            return fault
        details = "".join(traceback.format_exception(fault))
        return AcquisitionError("E-SCAN-02", reason=f"{type(fault).__name__}: {fault}", case=self._store.path, details=details)


def _nothing_seen(counts: ScanCounts) -> AcquisitionError:
    """Of a pass that gave no point."""
    if 2 * counts.rejected.get(MissReason.TOO_BRIGHT.value, 0) > sum(counts.rejected.values()):
        return AcquisitionError("E-SCAN-06", planned=counts.planned)
    reasons = ", ".join(f"{name} {count}" for name, count in counts.rejected.items())
    return AcquisitionError("E-SCAN-01", planned=counts.planned, reasons=reasons)


def _without_frames(error: BaseException | None) -> None:
    """A result outlives its scan, and an error's tracebacks hold every local of it: cameras, their rig, some 80 MB."""
    while error is not None:
        error.__traceback__ = None
        error = error.__cause__ or error.__context__
