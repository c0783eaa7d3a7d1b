"""What a scan does from the first move to the closed turn: locate the object, follow the plan or what is left of it, close the turn.

It runs in the scan's thread, which owns the controller; what it has come to may be read from any.
"""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from itertools import pairwise

import numpy as np

from scanner_core.acquisition.assessing import Assess
from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.error_driven import ErrorDriven
from scanner_core.acquisition.following import Pass, PlanFollower
from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.health import HealthMonitor, Phase
from scanner_core.acquisition.known_points import KnownPoints, agreement, check_plan
from scanner_core.acquisition.plan import PlanRequest, ScanPlan
from scanner_core.acquisition.planning import (
    CLOSING_POINTS,
    closing_plan,
    coarse_request,
    locating_plan,
    nearest_turn,
    scan_plan,
    table_angles_deg,
    turned,
)
from scanner_core.acquisition.resuming import resumption
from scanner_core.acquisition.retry import repetitions
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.status import FinishReason, ScanCounts, ScanState
from scanner_core.acquisition.tally import Tally
from scanner_core.acquisition.view_progress import PlanProgress
from scanner_core.case.decoding import MOST_VIEWS
from scanner_core.case.recovery import Interruption
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import AcquisitionError, DeviceError, UsageError
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.spot import MissReason

_REPEATED_DEG = 90.0
"""By which the table turns to a view that is repeated, on the average."""
_SAME_RATE = 0.01
"""How far apart the frame rates of the two cameras may be, of the rate."""


class ScanCourse:
    """The course of one scan.

    Attributes
    ----------
    tally : of the pass whose counts count
    located : counts of the coarse look at where the object is
    scan_id, plan : of the scan itself; None before the object was located
    open : the pass that has begun and not ended, beside the scan or the scan itself
    resumed : points that were there before; None when nothing was resumed
    steering : of an error-driven scan
    closing : the first view is being measured again, after the turn
    progress : what has become of the views of the scan's plan
    """

    def __init__(
        self,
        rig: OpenRig,
        calibration: StereoCalibration,
        store: CaseStore,
        request: PlanRequest,
        interruption: Interruption | None,
        control: ScanControl,
        health: HealthMonitor,
        follower: PlanFollower,
        cloud: PointLog,
        mount: int,
    ) -> None:
        self._mount = mount
        self._rig, self._calibration, self._store = rig, calibration, store
        self._request = request
        self._first = request if request.until_um is None else coarse_request(request)
        self._interruption = interruption
        self._control, self._health, self._follower, self._cloud = control, health, follower, cloud
        self._captures: tuple[CaptureThread, CaptureThread] | None = None
        self.tally = Tally(0, None, 0.0)
        self.located = ScanCounts()
        self.scan_id: int | None = None
        self.plan: ScanPlan | None = None
        self.open: Pass | None = None
        self.resumed: int | None = None
        self.steering: ErrorDriven | None = None
        self.closing = False
        self.progress = PlanProgress(request.retry and request.until_um is None)

    @property
    def views(self) -> int:
        """Table positions of the plan so far."""
        steered = None if self.steering is None else self.steering.views
        return steered or (self._first.views if self.plan is None else len(self.plan.views))

    def seconds_left(self, now_s: float) -> float | None:
        """From the pace so far, on the rig's clock, with the repetitions that are foreseen and the closure."""
        run, plan = self.open, self.plan
        closed = run.tally.measured if self.closing and run is not None and run.scan_id != self.scan_id else 0
        pace = self.tally.seconds_a_point(now_s, closed)
        if plan is None or pace is None:
            return None
        sweeping_s, turning_s = pace
        repeated, views = self.progress.lacking
        points, degrees = max(self.tally.lacking, repeated), _REPEATED_DEG * views
        if len(plan.views) > 1:
            points += max(0, min(CLOSING_POINTS, plan.views[0].quota or CLOSING_POINTS) - closed)
        if self.steering is not None:  # its views to come are not known yet
            return points * (sweeping_s + turning_s)
        if not self.closing:
            to_come = [view.table_deg for view in plan.views[self._follower.view + 1 :]]
            stops = [self._follower.motion.table_deg, *to_come, plan.views[0].table_deg + 360.0]
            degrees += sum(abs(to_deg - from_deg) for from_deg, to_deg in pairwise(stops))
        return points * sweeping_s + self._follower.seconds_to_turn(degrees)

    def run(self, left: CaptureThread, right: CaptureThread, assess: Assess | None) -> None:
        """The whole course; returns early when the scan is ended.

        Parameters
        ----------
        assess : for an error-driven scan, which needs one
        """
        rates_hz = self._rig.left.rate_hz, self._rig.right.rate_hz
        if abs(rates_hz[0] - rates_hz[1]) > _SAME_RATE * rates_hz[0]:  # one trigger id would be two instants
            raise DeviceError("E-CAM-16", left_hz=f"{rates_hz[0]:g}", right_hz=f"{rates_hz[1]:g}")
        self._captures = left, right
        interruption = self._interruption
        if self._request.until_um is not None and assess is not None:
            passes = () if interruption is None else interruption.passes
            self.steering = ErrorDriven(self._rig, self._calibration, self._store, self._request, self._control, self._follower, assess, passes)
        interrupted = () if interruption is None else interruption.plan.views
        for table_deg in [view.table_deg for view in interrupted] or table_angles_deg(self._first.views):
            self._rig.motion.check_table(table_deg)  # not after most of the views
        # Whatever ended the scan before: dark, at rest, and where the rig's angles begin.
        self._rig.motion.recover()
        if self._rig.motion.needs_homing and not self._control.cancelled.is_set():
            self._rig.motion.home()
        if interruption is None or not self._go_on_with(interruption):
            self._scan_anew()

    # ------------------------------------------------------------------------------------------ inner
    def _scan_anew(self) -> None:
        rate_hz = self._rig.left.rate_hz
        located = locating_plan(self._rig.config, self._first, rate_hz, self._store.next_trigger_id())
        locate = self._begin("locate", located, None, self._cloud)
        self.tally = locate.tally
        self._follow(locate)
        self.located = self.tally.counts()
        self._end(locate)
        hits = self._store.observations(locate.scan_id).trigger_id
        if not len(hits) and not self._control.cancelled.is_set():
            raise _nothing_seen(self.located)
        if not len(hits):
            self.tally = Tally(0, None, self._rig.clock.now_s())
            return
        plan = scan_plan(self._rig.config, self._first, rate_hz, located, hits, self._store.next_trigger_id())
        scan = replace(self._begin("scan", plan, self._request.points, self._cloud), progress=self.progress)
        self.progress.follow(plan)
        self.tally, self.scan_id, self.plan = scan.tally, scan.scan_id, plan
        self._finish(scan, plan)

    def _go_on_with(self, interruption: Interruption) -> bool:
        """Scan what an interrupted scan is missing, once known points were found where they were; False when it holds too few."""
        known = KnownPoints.of_scan(self._store, interruption.record.id, self._rig.config, self._calibration)
        rest = resumption(self._store, interruption, known)
        if rest is None:
            self._store.end_scan(interruption.record.id, FinishReason.CANCELLED, interruption.counts)
            return False
        self.scan_id, self.resumed = interruption.record.id, len(known)
        plan = interruption.plan
        wanted = self._request.points
        self.plan = plan
        self.progress.follow(plan)
        exposed = self._store.exposures(self.scan_id)
        self.progress.recall(zip(exposed.trigger_id.tolist(), exposed.verdict, strict=True), rest.remaining.complete)
        again = [view for view in range(rest.remaining.complete) if self.progress.will_repeat(view)]
        rest = resumption(self._store, interruption, known, again) or rest
        self.tally = Tally(plan.planned, wanted, self._rig.clock.now_s(), rest.verdicts)
        self._health.recall(plan, known, rest.remaining.complete)
        if self._follower.marks is not None:
            self._follower.marks.begin_check(interruption.record.id)
        self._find_again(plan, known)
        if self._control.cancelled.is_set():
            return True
        for view in np.unique(known.views).tolist():
            self._cloud.append(known.of_view(view).live(plan.views[view].table_deg))
        if self.steering is not None:
            self.steering.recall(np.bincount(known.views, minlength=len(plan.views)))
        self.tally = Tally(plan.planned, wanted, self._rig.clock.now_s(), rest.verdicts)
        if self.steering is None:
            self.tally.want(sum(view.quota or 0 for view in rest.remaining.plan.views if view.rows))
        self._health.go_on()
        self._finish(Pass(interruption.record.id, plan, self.tally, self._cloud, self.progress), rest.remaining.plan)
        return True

    def _find_again(self, plan: ScanPlan, known: KnownPoints) -> None:
        """Measure known points again.

        Raises
        ------
        AcquisitionError
            E-SCAN-03: they are not where they were; E-MARK-01: the marks on the table's rim are not.
        """
        check = check_plan(plan, known, self._store.next_trigger_id())
        run = self._begin("check", check.plan, None, PointLog())
        self._follow(run)
        self._end(run)
        if self._control.cancelled.is_set():
            return
        again = KnownPoints.of_scan(self._store, run.scan_id, self._rig.config, self._calibration)
        found = agreement(known, again, self._store.exposed_ids(run.scan_id), check, self._health.compare)
        self._store.audit("known points measured again", json.dumps(asdict(found)))
        if not found.agrees:
            raise AcquisitionError("E-SCAN-03", seen=found.seen, known=found.known, shift_um=f"{found.shift_um:.0f}")

    def _finish(self, whole: Pass, rest: ScanPlan) -> None:
        """Follow what is left of a plan, and what an error-driven scan adds to it, and close the turn."""
        self._control.enter(ScanState.SCANNING)
        if self.steering is None:
            self._follow_scan(replace(whole, plan=rest))
        else:
            whole = replace(whole, plan=self.steering.follow(whole, rest, self._follow_scan))
        plan = self.plan = self._repeat(whole)
        if len(plan.views) > 1 and plan.views[0].rows and not self._control.cancelled.is_set():
            self._close_turn(plan)

    def _repeat(self, whole: Pass) -> ScanPlan:
        """Measure once more what is weak and what a person wants; returns the plan as it has grown."""
        while not self._control.cancelled.is_set():
            counts, weak = self.progress.take_weak()
            asked = {view for view in self._control.take_asked() if view < len(counts) and counts[view].plan.repeats is None}
            if not weak and not asked:
                break
            views = repetitions(counts, weak, asked, self._store.next_trigger_id(), MOST_VIEWS - len(counts))
            if not views:
                break
            views = turned(views, self._follower.ask().table_deg, self._may_turn)
            if self.steering is not None:
                whole = self.steering.repeat(whole, views, self._follow_scan)
                continue
            plan = self.plan = whole.plan.extended(views)
            self._store.extend_plan(whole.scan_id, plan.as_dict() | {"request": asdict(self._request)})
            self.progress.follow(plan)
            whole.tally.extend(sum(row.count for view in views for row in view.rows))
            whole.tally.want(sum(view.quota or 0 for view in views))
            self._follow_scan(replace(whole, plan=replace(plan, views=views)))
            whole = replace(whole, plan=plan)
        return whole.plan

    def _follow_scan(self, run: Pass) -> None:
        self._health.expect(run.plan)
        if self._follower.marks is not None:
            self._follower.marks.begin(run.scan_id, run.cloud)
        self._follow(run)
        if not run.tally.measured and not self._control.cancelled.is_set():
            raise _nothing_seen(run.tally.counts())

    def _close_turn(self, plan: ScanPlan) -> None:
        """Measure some of the first view again, beside the counts of the scan."""
        at_deg = self._follower.ask().table_deg
        # Beyond where the turn began: lost steps add up on the way round.  A table that may not turn on for ever turns back.
        table_deg = nearest_turn(plan.views[0].table_deg, max(at_deg, plan.views[0].table_deg + 180.0), self._may_turn)
        self.closing = True
        closing = self._begin("closure", closing_plan(plan, self._store.next_trigger_id(), table_deg), None, PointLog())
        self._follow(closing)
        self._end(closing)
        if not self._control.cancelled.is_set():
            self._health.close_turn(self._follower.ask().table_deg)

    def _may_turn(self, table_deg: float) -> bool:
        try:
            self._rig.motion.check_table(table_deg)
        except UsageError:
            return False
        return True

    def _follow(self, run: Pass) -> None:
        assert self._captures is not None
        self._follower.follow(run, *self._captures)

    def _begin(self, kind: Phase, plan: ScanPlan, wanted: int | None, cloud: PointLog) -> Pass:
        calibration = self._calibration
        toml = dump_rig(self._rig.config.with_calibration(calibration))
        bare = dump_rig(self._rig.config.with_calibration(None))
        record = plan.as_dict() | {"request": asdict(self._request)}
        if kind == "scan" and self.steering is not None:
            record["passes"] = self.steering.coarse(plan)
        scan_id = self._store.begin_scan(kind, bare, calibration.identity(), toml, record, self._mount)
        self._health.begin(plan, kind)
        self.open = Pass(scan_id, plan, Tally(plan.planned, wanted, self._rig.clock.now_s()), cloud)
        return self.open

    def _end(self, run: Pass) -> None:
        self._follower.keep()
        finished = FinishReason.CANCELLED if self._control.cancelled.is_set() else FinishReason.COMPLETED
        self._store.end_scan(run.scan_id, finished, run.tally.counts())
        self.open = None


def _nothing_seen(counts: ScanCounts) -> AcquisitionError:
    """Of a pass that gave no point."""
    if 2 * counts.rejected.get(MissReason.TOO_BRIGHT.value, 0) > sum(counts.rejected.values()):
        return AcquisitionError("E-SCAN-06", planned=counts.planned)
    reasons = ", ".join(f"{name} {count}" for name, count in counts.rejected.items())
    return AcquisitionError("E-SCAN-01", planned=counts.planned, reasons=reasons)
