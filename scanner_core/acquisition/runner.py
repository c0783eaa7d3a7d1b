"""The scan as a state machine without Qt.

::

    IDLE -> PREPARING -> SCANNING <-> PAUSED -> FINISHING -> IDLE
                 |           |          |           ^
                 +-----------+----------+-> FAULT --+

PREPARING locates the object and makes the plan; SCANNING follows it and closes the turn; FINISHING registers the views.  The scan's thread
owns the controller: nobody else talks to it, but ``cancel`` stops it from any thread (laser off first).  Every end goes
through FINISHING and sets the finish reason exactly once, with counts that balance over the plan's trigger ids; a
teardown that fails cannot lose the end.
"""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.engine import EvaluatedPairs, StereoEngine
from scanner_core.acquisition.handover import LatestSlot, PointLog, Preview
from scanner_core.acquisition.health import HealthMonitor, HealthReport, Phase
from scanner_core.acquisition.keeping import Keeper
from scanner_core.acquisition.plan import PlanRequest, Row, ScanPlan, ViewPlan
from scanner_core.acquisition.planning import closing_plan, locating_plan, scan_plan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.acquisition.status import FinishReason, ScanCounts, ScanState, ScanStatus
from scanner_core.acquisition.sweep_exposure import exposed_for
from scanner_core.acquisition.tally import Tally
from scanner_core.acquisition.views import RegisteredViews, register_case
from scanner_core.case.store import CaseStore
from scanner_core.devices.motion import MotionStatus
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import AcquisitionError, CalibrationError, ImprontaError
from scanner_core.optics.spot_detection import SpotDetector

_STATUS_PERIOD_S = 0.2
_MOVE_DEADLINE_S = 30.0


@dataclass(frozen=True, slots=True, eq=False)
class ScanResult:
    """What a scan gave.

    Attributes
    ----------
    counts : over the plan; `located` over the coarse pass before it
    exposures : trigger ids that were exposed, of both passes
    wall_s, rig_s : duration on the wall and on the rig's clock, both passes, without the registration
    views : the registered cloud and its residuals, None when there was nothing to register
    health : what was noticed on the way
    """

    finish_reason: FinishReason
    counts: ScanCounts
    located: ScanCounts
    views_planned: int
    exposures: int
    wall_s: float
    rig_s: float
    scan_id: int | None
    views: RegisteredViews | None
    health: HealthReport
    error: ImprontaError | None


@dataclass(frozen=True, slots=True)
class _Pass:
    """One plan that is being followed: its record in the case, its counts, and where its points go."""

    scan_id: int
    plan: ScanPlan
    tally: Tally
    cloud: PointLog


class ScanRunner:
    """One scan on an open rig into an open case.  Start it once; ``join`` before closing rig and case."""

    def __init__(self, rig: OpenRig, request: PlanRequest, store: CaseStore, *, on_end: Callable[[ScanResult], None] | None = None) -> None:
        """`on_end` is called once, in the scan's thread, when everything is at rest."""
        if rig.calibration is None:
            raise CalibrationError("E-CAL-02")
        self._rig, self._request, self._store, self._on_end = rig, request, store, on_end
        self.calibration = rig.calibration
        self._engine = StereoEngine(rig.calibration, rig.config.volume, rig.config.spot.floor_px)
        self.live_cloud = PointLog()
        self.previews: dict[str, LatestSlot[Preview]] = {"left": LatestSlot(), "right": LatestSlot()}
        self.result: ScanResult | None = None
        self._lock = threading.Lock()
        self._state = ScanState.IDLE
        self._paused = threading.Event()
        self._go_on = threading.Event()
        self._cancelled = threading.Event()
        self._tally = Tally(0, None, 0.0)
        self._located = ScanCounts()
        self._view = 0
        self._motion = rig.motion.status()
        self._asked_s = 0.0
        self._begin_s = self._end_s = rig.clock.now_s()
        self._exposures = 0
        self._scan_id: int | None = None
        self._keeper = Keeper(store)
        self._health = HealthMonitor(rig.calibration, rig.left.rate_hz)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="scan")

    # ------------------------------------------------------------------------------------------ commands
    def start(self) -> None:
        self._set_state(ScanState.PREPARING)
        self._thread.start()

    def pause(self) -> None:
        """Rest after the row that is being swept; the laser is dark meanwhile."""
        self._go_on.clear()
        self._paused.set()

    def resume(self) -> None:
        self._paused.clear()
        self._go_on.set()

    def cancel(self) -> None:
        """Laser off at once and end; what was measured is kept.  From any thread, also twice."""
        if not self._cancelled.is_set():
            self._cancelled.set()
            self._go_on.set()
            if self._thread.is_alive():
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
            state, result, motion = self._state, self.result, self._motion
            tally, view, end_s = self._tally, self._view, self._end_s
        running = state not in (ScanState.IDLE, ScanState.FINISHING)
        now_s = self._rig.clock.now_s() if running else end_s
        return ScanStatus(
            state=state,
            counts=tally.counts(),
            view=view,
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
        try:
            detector = SpotDetector(self._rig.config.spot)
            captures = [CaptureThread(camera, detector, self.previews[camera.name]) for camera in (self._rig.left, self._rig.right)]
            self._scan(captures[0], captures[1])
        except BaseException as fault:
            error = self._as_error(fault)
            self._darken()  # before anything that takes time
        steps: list[Callable[[], None]] = [capture.close for capture in captures]
        steps += [partial(self._rest, error is not None), self._keeper.keep]
        for step in steps:
            try:
                step()
            except BaseException as fault:
                error = error or self._as_error(fault)
        if error is not None:
            self._set_state(ScanState.FAULT)
        wall_s = time.monotonic() - wall_s
        self._set_state(ScanState.FINISHING)
        reason = FinishReason.FAILED if error else FinishReason.CANCELLED if self._cancelled.is_set() else FinishReason.COMPLETED
        try:
            if self._scan_id is not None:
                self._store.end_scan(self._scan_id, reason, self._tally.counts())
                for finding in self._health.findings:
                    self._store.audit(f"health {finding.code}", json.dumps(finding.as_dict()))
                if self._tally.measured and not isinstance(error, OSError):
                    views = register_case(self._store, self._scan_id, self._rig.config, self.calibration)
        except BaseException as fault:
            error = error or self._as_error(fault)
            reason = FinishReason.FAILED
        result = ScanResult(
            finish_reason=reason,
            counts=self._tally.counts(),
            located=self._located,
            views_planned=self._request.views,
            exposures=self._exposures,
            wall_s=wall_s,
            rig_s=self._end_s - self._begin_s,
            scan_id=self._scan_id,
            views=views,
            health=self._health.report(),
            error=error,
        )
        with self._lock:
            self.result = result
            self._state = ScanState.IDLE
        try:
            if self._on_end is not None:
                self._on_end(result)
        finally:
            self._ended.set()

    def _scan(self, left: CaptureThread, right: CaptureThread) -> None:
        rate_hz = self._rig.left.rate_hz
        located = locating_plan(self._rig.config, self._request, rate_hz, self._store.next_trigger_id())
        locate = self._begin("locate", located, None, self.live_cloud)
        self._tally = locate.tally
        self._follow(locate, left, right)
        self._located = self._tally.counts()
        self._end_pass(locate)
        hits = self._store.observations(locate.scan_id).trigger_id
        if not len(hits) and not self._cancelled.is_set():
            reasons = ", ".join(f"{name} {count}" for name, count in self._located.rejected.items())
            raise AcquisitionError("E-SCAN-01", planned=located.planned, reasons=reasons)
        if not len(hits):
            self._tally = Tally(0, None, self._rig.clock.now_s())
            return
        plan = scan_plan(self._rig.config, self._request, rate_hz, located, hits, self._store.next_trigger_id())
        scan = self._begin("scan", plan, self._request.points, self.live_cloud)
        self._tally, self._scan_id = scan.tally, scan.scan_id
        self._set_state(ScanState.SCANNING)
        self._follow(scan, left, right)
        if len(plan.views) > 1 and plan.views[0].rows and not self._cancelled.is_set():
            self._close_turn(plan, left, right)

    def _close_turn(self, plan: ScanPlan, left: CaptureThread, right: CaptureThread) -> None:
        """Measure some of the first view again, beside the counts of the scan."""
        closing = self._begin("closure", closing_plan(plan, self._store.next_trigger_id()), None, PointLog())
        self._follow(closing, left, right)
        self._end_pass(closing)
        if not self._cancelled.is_set():
            self._health.close_turn(self._ask().table_deg)

    def _begin(self, kind: Phase, plan: ScanPlan, wanted: int | None, cloud: PointLog) -> _Pass:
        calibration = self.calibration
        toml = dump_rig(self._rig.config.with_calibration(calibration))
        bare = dump_rig(self._rig.config.with_calibration(None))
        scan_id = self._store.begin_scan(kind, bare, calibration.identity(), toml, plan.as_dict())
        self._health.begin(plan, kind)
        return _Pass(scan_id, plan, Tally(plan.planned, wanted, self._rig.clock.now_s()), cloud)

    def _end_pass(self, run: _Pass) -> None:
        self._keeper.keep()
        finished = FinishReason.CANCELLED if self._cancelled.is_set() else FinishReason.COMPLETED
        self._store.end_scan(run.scan_id, finished, run.tally.counts())

    def _follow(self, run: _Pass, left: CaptureThread, right: CaptureThread) -> None:
        with exposed_for(self._rig, run.plan):
            self._follow_views(run, left, right)

    def _follow_views(self, run: _Pass, left: CaptureThread, right: CaptureThread) -> None:
        """Scan every view of a plan; a quota that a view could not fill is carried to the next."""
        owed = 0
        for number, view in enumerate(run.plan.views):
            if self._cancelled.is_set():
                break
            self._view = view.rows[0].view if view.rows else number
            self._rig.motion.rotate_to(view.table_deg)
            table_deg = self._ask().table_deg
            self._store.put_view(run.scan_id, number, table_deg)
            wanted = None if view.quota is None else view.quota + owed
            measured = self._scan_view(run, view, table_deg, wanted, left, right)
            owed = 0 if wanted is None else wanted - measured
            self._health.end_view(number, table_deg)
        self._keeper.keep()

    def _scan_view(self, run: _Pass, view: ViewPlan, table_deg: float, wanted: int | None, left: CaptureThread, right: CaptureThread) -> int:
        measured = 0
        for row in view.rows:
            self._rest_while_paused()
            if self._cancelled.is_set() or (wanted is not None and measured >= wanted):
                break
            self._rig.motion.aim(row.x_from_deg, row.y_deg)
            self._rig.motion.sweep(row.x_to_deg, row.y_deg, run.plan.sweep_speed_deg_s)
            at_rest = partial(self._rig.motion.wait_idle, _MOVE_DEADLINE_S)
            scan = RowScan(left, right, row, self._rig.clock.now_s(), self._cancelled, self._poll, at_rest)
            try:
                for pairs in scan.batches():
                    seen = self._engine.evaluate(pairs, row.view, table_deg)
                    if wanted is not None and measured + len(seen.points) >= wanted:
                        seen = seen.until(wanted - measured)
                        scan.stop()
                    measured += len(seen.points)
                    self._record(run, row, seen)
                    self._health.add(pairs, seen, row.view, table_deg)
                    if wanted is not None and measured >= wanted:
                        break
            finally:
                scan.finish()
            at_rest()
        return measured

    def _record(self, run: _Pass, row: Row, seen: EvaluatedPairs) -> None:
        self._exposures += len(seen.observations)
        run.cloud.append(seen.points, row.view)
        run.tally.add((observation.verdict for observation in seen.observations), self._rig.clock.now_s())
        self._keeper.add(run.scan_id, seen.observations)

    def _rest_while_paused(self) -> None:
        if not self._paused.is_set() or self._cancelled.is_set():
            return
        self._rig.motion.laser(False)
        before = self._state
        self._keeper.keep()
        self._set_state(ScanState.PAUSED)
        while not self._go_on.wait(_STATUS_PERIOD_S):
            self._poll()
        self._set_state(before)

    def _poll(self) -> None:
        if time.monotonic() - self._asked_s > _STATUS_PERIOD_S and not self._cancelled.is_set():
            self._ask()

    def _ask(self) -> MotionStatus:
        status = self._rig.motion.status()
        self._asked_s = time.monotonic()
        with self._lock:
            self._motion = status
        return status

    def _darken(self) -> None:
        with suppress(ImprontaError):  # what cannot be reached is told by :meth:`_rest`
            self._rig.motion.stop()

    def _rest(self, failed: bool) -> None:
        """Laser off and motion at rest, whatever happened."""
        self._end_s = self._rig.clock.now_s()
        if not failed and not self._cancelled.is_set():
            self._rig.motion.laser(False)
        else:
            self._rig.motion.stop()
            self._rig.motion.recover()
        self._ask()

    def _as_error(self, fault: BaseException) -> ImprontaError | None:
        if self._cancelled.is_set() and isinstance(fault, OSError):
            return None  # the controller's answer to the stop that was asked for
        if isinstance(fault, ImprontaError):
            return fault
        return AcquisitionError("E-SCAN-02", reason=f"{type(fault).__name__}: {fault}", case=self._store.path)

    def _set_state(self, state: ScanState) -> None:
        with self._lock:
            self._state = state
