"""The scan as a state machine without Qt.

::

    IDLE -> PREPARING -> SCANNING <-> PAUSED -> FINISHING -> IDLE
                 |           |          |           ^
                 +-----------+----------+-> FAULT --+

PREPARING locates the object and makes the plan; SCANNING follows it; FINISHING registers the views.  The scan's thread
owns the controller: nobody else talks to it, but ``cancel`` stops it from any thread (laser off first).  Every end goes
through FINISHING and sets the finish reason exactly once, with counts that balance over the plan's trigger ids; a
teardown that fails cannot lose the end.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.engine import StereoEngine
from scanner_core.acquisition.handover import LatestSlot, PointLog, Preview
from scanner_core.acquisition.plan import PlanRequest, Row, ScanPlan, ViewPlan
from scanner_core.acquisition.planning import locating_plan, scan_plan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.acquisition.status import FinishReason, ScanCounts, ScanState, ScanStatus
from scanner_core.acquisition.tally import Tally
from scanner_core.acquisition.views import RegisteredViews, register_case
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.store import CaseStore
from scanner_core.devices.motion import MotionStatus
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import AcquisitionError, CalibrationError, ImprontaError
from scanner_core.optics.spot_detection import SpotDetector

_STATUS_PERIOD_S = 0.2
_KEEP_PERIOD_S = 0.5
_KEEP_COUNT = 500
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
    error: ImprontaError | None


class ScanRunner:
    """One scan on an open rig into an open case.  Start it once; ``join`` before closing rig and case."""

    def __init__(self, rig: OpenRig, request: PlanRequest, store: CaseStore, *, on_end: Callable[[ScanResult], None] | None = None) -> None:
        """`on_end` is called once, in the scan's thread, when everything is at rest."""
        if rig.calibration is None:
            raise CalibrationError("E-CAL-02")
        self._rig, self._request, self._store, self._on_end = rig, request, store, on_end
        self._calibration = rig.calibration
        self._engine = StereoEngine(rig.calibration, rig.config.volume)
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
        self._unkept: list[StereoObservation] = []
        self._kept_s = time.monotonic()
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
        steps: list[Callable[[], None]] = [capture.close for capture in captures]
        steps += [partial(self._rest, error is not None), self._keep]
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
                if self._tally.measured and not isinstance(error, OSError):
                    views = register_case(self._store, self._scan_id, self._calibration)
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
        self._tally = Tally(located.planned, None, self._rig.clock.now_s())
        locate_id = self._begin("locate", located)
        self._follow(located, locate_id, left, right)
        self._located = self._tally.counts()
        finished = FinishReason.CANCELLED if self._cancelled.is_set() else FinishReason.COMPLETED
        self._store.end_scan(locate_id, finished, self._located)
        hits = self._store.observations(locate_id).trigger_id
        if not len(hits) and not self._cancelled.is_set():
            reasons = ", ".join(f"{name} {count}" for name, count in self._located.rejected.items())
            raise AcquisitionError("E-SCAN-01", planned=located.planned, reasons=reasons)
        if not len(hits):
            self._tally = Tally(0, None, self._rig.clock.now_s())
            return
        plan = scan_plan(self._rig.config, self._request, rate_hz, located, hits, self._store.next_trigger_id())
        self._tally = Tally(plan.planned, self._request.points, self._rig.clock.now_s())
        self._scan_id = self._begin("scan", plan)
        self._set_state(ScanState.SCANNING)
        self._follow(plan, self._scan_id, left, right)

    def _begin(self, kind: str, plan: ScanPlan) -> int:
        calibration = self._calibration
        toml = dump_rig(self._rig.config.with_calibration(calibration))
        bare = dump_rig(self._rig.config.with_calibration(None))
        return self._store.begin_scan(kind, bare, calibration.identity(), toml, plan.as_dict())

    def _follow(self, plan: ScanPlan, scan_id: int, left: CaptureThread, right: CaptureThread) -> None:
        """Scan every view of a plan; a quota that a view could not fill is carried to the next."""
        owed = 0
        for number, view in enumerate(plan.views):
            if self._cancelled.is_set():
                break
            self._view = number
            self._rig.motion.rotate_to(view.table_deg)
            table_deg = self._ask().table_deg
            self._store.put_view(scan_id, number, table_deg)
            wanted = None if view.quota is None else view.quota + owed
            measured = self._scan_view(view, plan.sweep_speed_deg_s, table_deg, scan_id, wanted, left, right)
            owed = 0 if wanted is None else wanted - measured
        self._keep()

    def _scan_view(
        self, view: ViewPlan, speed_deg_s: float, table_deg: float, scan_id: int, wanted: int | None, left: CaptureThread, right: CaptureThread
    ) -> int:
        measured = 0
        for row in view.rows:
            self._rest_while_paused()
            if self._cancelled.is_set() or (wanted is not None and measured >= wanted):
                break
            self._rig.motion.aim(row.x_from_deg, row.y_deg)
            self._rig.motion.sweep(row.x_to_deg, row.y_deg, speed_deg_s)
            scan = RowScan(left, right, row, self._rig.clock.now_s(), self._cancelled, self._poll)
            try:
                for pairs in scan.batches():
                    seen = self._engine.evaluate(pairs, row.view, table_deg)
                    observations, points = seen.observations, seen.points
                    if wanted is not None and measured + len(points) >= wanted:
                        observations, points = _until(observations, points, wanted - measured)
                        scan.stop()
                    measured += len(points)
                    self._record(scan_id, row, observations, points)
                    if wanted is not None and measured >= wanted:
                        break
            finally:
                scan.finish()
            self._rig.motion.wait_idle(_MOVE_DEADLINE_S)
        return measured

    def _record(self, scan_id: int, row: Row, observations: list[StereoObservation], points: NDArray[np.float64]) -> None:
        self._exposures += len(observations)
        self.live_cloud.append(points, row.view)
        self._unkept += observations
        self._tally.add((seen.verdict for seen in observations), self._rig.clock.now_s())
        self._keep_id = scan_id
        if len(self._unkept) >= _KEEP_COUNT or time.monotonic() - self._kept_s > _KEEP_PERIOD_S:
            self._keep()

    def _keep(self) -> None:
        """Write to the case what it does not hold yet."""
        if self._unkept:
            self._store.append(self._keep_id, self._unkept)
            self._unkept = []
        self._kept_s = time.monotonic()

    def _rest_while_paused(self) -> None:
        if not self._paused.is_set() or self._cancelled.is_set():
            return
        self._rig.motion.laser(False)
        before = self._state
        self._keep()
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


def _until(observations: list[StereoObservation], points: NDArray[np.float64], wanted: int) -> tuple[list[StereoObservation], NDArray[np.float64]]:
    """The observations up to the one that gives the last wanted point."""
    found = 0
    for i, seen in enumerate(observations):
        found += seen.verdict == MEASURED
        if found == wanted:
            return observations[: i + 1], points[:wanted]
    return observations, points
