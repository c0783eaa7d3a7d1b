"""Follows a plan on the open rig: table, beam, cameras, and what was seen into the case.

The scan's thread alone calls it, and with it owns the controller; the snapshots that it keeps may be read from any.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from functools import partial

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.engine import EvaluatedPairs, StereoEngine
from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.health import HealthMonitor
from scanner_core.acquisition.keeping import Keeper
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.acquisition.mark_findings import mark_findings
from scanner_core.acquisition.mark_visitor import MarkVisitor
from scanner_core.acquisition.plan import ScanPlan, ViewPlan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.acquisition.simultaneous import Counting, rows_in_step
from scanner_core.acquisition.status import ScanState
from scanner_core.acquisition.sweep_exposure import exposed_for
from scanner_core.acquisition.tally import Tally
from scanner_core.acquisition.view_progress import PlanProgress
from scanner_core.case.store import CaseStore
from scanner_core.devices.motion import MotionStatus

_STATUS_PERIOD_S = 0.2
_MOVE_DEADLINE_S = 30.0
_A_TURN_DEG = 1.0


@dataclass(frozen=True, slots=True)
class Pass:
    """One plan that is being followed: its record in the case, its counts, where its points go, and what becomes of its views."""

    scan_id: int
    plan: ScanPlan
    tally: Tally
    cloud: PointLog
    progress: PlanProgress | None = None


class PlanFollower:
    """The passes of one scan."""

    def __init__(self, rig: OpenRig, engine: StereoEngine, store: CaseStore, health: HealthMonitor, control: ScanControl) -> None:
        self._rig, self._engine, self._store, self._health, self._control = rig, engine, store, health, control
        self._keeper = Keeper(store)
        self._counting = Counting.of(rig.left.report().trigger, rig.right.report().trigger)
        self._asked_s = 0.0
        self._turns = 0.0, 0.0
        self.motion: MotionStatus = rig.motion.status()
        """The controller's newest report."""
        self.view = 0
        self.exposures = 0
        self.marks: MarkVisitor | None = None
        """Who looks at the marks on the table's rim at the start of each view."""

    def follow(self, run: Pass, left: CaptureThread, right: CaptureThread) -> None:
        """Scan every view of a plan that has rows; a quota that a view could not fill is carried to the next, if the view is not to be repeated."""
        with exposed_for(self._rig, run.plan):
            owed = 0
            for view in run.plan.views:
                if self._control.cancelled.is_set():
                    break
                if not view.rows:
                    continue
                self._rest_while_paused(run.tally)  # before the table turns and the marks are lit
                if self._control.cancelled.is_set():
                    break
                self.view = view.rows[0].view
                if run.progress is not None:
                    run.progress.begin(self.view)
                begin_s, from_deg = self._rig.clock.now_s(), self.motion.table_deg
                self._rig.motion.rotate_to(view.table_deg)
                table_deg = self.ask().table_deg
                self._store.put_view(run.scan_id, self.view, table_deg)
                self._visit_marks(table_deg, left, right)
                self._turned(run.tally, abs(table_deg - from_deg), self._rig.clock.now_s() - begin_s)
                wanted = None if view.quota is None else view.quota + owed
                measured = self._scan_view(run, view, table_deg, wanted, left, right)
                self._health.end_view(self.view, table_deg)
                if run.progress is not None and not self._control.cancelled.is_set():
                    run.progress.end(self.view, self._health.findings)
                again = run.progress is not None and run.progress.will_repeat(self.view)
                owed = 0 if wanted is None or again else wanted - measured
        self.keep()

    def keep(self) -> None:
        """Write to the case what it does not hold yet."""
        self._keeper.keep()

    def ask(self) -> MotionStatus:
        """The controller's report now."""
        self.motion = self._rig.motion.status()
        self._asked_s = time.monotonic()
        return self.motion

    def rests(self) -> bool:
        """While the rig rests: go on asking the controller; True when the scan was ended."""
        self._poll()
        return self._control.cancelled.is_set()

    def seconds_to_turn(self, degrees: float) -> float:
        """For the table, with what comes before the first row of a view, as it took so far; on the rig's clock."""
        turned_s, turned_deg = self._turns
        return turned_s / turned_deg * degrees if turned_deg else 0.0

    # ------------------------------------------------------------------------------------------ inner
    def _turned(self, tally: Tally, degrees: float, seconds: float) -> None:
        tally.turned(seconds)
        if degrees >= _A_TURN_DEG:
            self._turns = self._turns[0] + seconds, self._turns[1] + degrees

    def _visit_marks(self, table_deg: float, left: CaptureThread, right: CaptureThread) -> None:
        if self.marks is not None and self.marks.visit(self.view, table_deg, left, right, self._poll):
            self._health.tell(mark_findings(self.marks.watch))

    def _scan_view(self, run: Pass, view: ViewPlan, table_deg: float, wanted: int | None, left: CaptureThread, right: CaptureThread) -> int:
        measured = 0
        for row in view.rows:
            self._rest_while_paused(run.tally)
            if self._control.cancelled.is_set() or (wanted is not None and measured >= wanted):
                break
            self._rig.motion.aim(row.x_from_deg, row.y_deg)
            self._rig.motion.sweep(row.x_to_deg, row.y_deg, view.sweep_speed_deg_s or run.plan.sweep_speed_deg_s)
            at_rest = partial(self._rig.motion.wait_idle, _MOVE_DEADLINE_S)
            scan = RowScan(left, right, row, self._rig.clock.now_s(), self._control.cancelled, self._poll, at_rest)
            try:
                for pairs in rows_in_step(scan.batches(), self._rig.left.rate_hz, self._counting):
                    seen = self._engine.evaluate(pairs, row.view, table_deg)
                    if wanted is not None and measured + len(seen.points) >= wanted:
                        seen = seen.until(wanted - measured)
                        scan.stop()
                    measured += len(seen.points)
                    self._record(run, table_deg, seen)
                    self._health.add(pairs, seen, row.view, table_deg)
                    if wanted is not None and measured >= wanted:
                        break
            finally:
                scan.finish()
            at_rest()
        return measured

    def _record(self, run: Pass, table_deg: float, seen: EvaluatedPairs) -> None:
        self.exposures += len(seen.observations)
        run.cloud.append(LivePoints.of_view(seen.points, table_deg, self.view, seen.point_sigmas, seen.covariances))
        run.tally.add((observation.verdict for observation in seen.observations), self._rig.clock.now_s())
        if run.progress is not None:
            run.progress.add([(observation.trigger_id, observation.verdict) for observation in seen.observations])
        self._keeper.add(run.scan_id, seen.observations)

    def _rest_while_paused(self, tally: Tally) -> None:
        if not self._control.rest_wanted:
            return
        self._rig.motion.laser(False)
        self.ask()  # so that nobody is told of a pause and of light
        before, begin_s = self._control.state, self._rig.clock.now_s()
        self.keep()
        self._control.enter(ScanState.PAUSED)
        while self._control.rest_wanted and not self._control.wait_to_go_on(_STATUS_PERIOD_S):
            self._poll()
        self._control.enter(before)
        tally.rested(self._rig.clock.now_s() - begin_s)

    def _poll(self) -> None:
        if time.monotonic() - self._asked_s > _STATUS_PERIOD_S and not self._control.cancelled.is_set():
            self.ask()
