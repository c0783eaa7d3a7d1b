"""Scanning where the error is: after a coarse pass, further passes go where the surface is not known as well as wanted.

::

    coarse pass -> surface so far -> its coverage -> next pass -> surface ... -> end

The plan of the scan grows: the case holds the views of a pass before the first of them is exposed.  Between two passes the
rig rests, dark, while the worker process computes; whoever ends the scan then does so at once.  Where no surface can be made of
the points so far, or the worker dies, what is left of the points is spread evenly: a scan never comes to nothing by that.
"""

from __future__ import annotations

import json
import logging
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.assessing import Assess, Assessment, AssessmentRequest
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.following import Pass, PlanFollower
from scanner_core.acquisition.passes import PassesEnd, PassKind, ScanPass, SteeringResult, SteeringStatus, counted, end_of, kept_passes
from scanner_core.acquisition.plan import PlanRequest, ScanPlan, ViewPlan
from scanner_core.acquisition.planning import even_views, may_stand, renumbered, turned
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.case.decoding import MOST_VIEWS
from scanner_core.case.store import CaseStore
from scanner_core.case.superseded import counting_spots
from scanner_core.errors import ImprontaError, UsageError
from scanner_core.jobs.progress import Cancelled
from scanner_core.optics.calibration import StereoCalibration

_LEAST_REST, _LEAST_POINTS = 0.01, 50
"""Share of the points, and points, that are worth another pass."""
_MARGIN, _LEAST_MARGIN = 0.8, 0.5
"""A pass is planned for so much less than the wanted uncertainty, and each further one for less again: it is there because the one
before it fell short of what it was to bring, and a pass of a few points costs as much computing as a large one."""
_FARTHEST_DEG = 720.0

_log = logging.getLogger("impronta")

Follow = Callable[[Pass], None]


@dataclass(frozen=True, slots=True, eq=False)
class _Step:
    """A pass to come."""

    kind: PassKind
    views: tuple[ViewPlan, ...]
    within_before: float | None = None
    within_predicted: float | None = None


class ErrorDriven:
    """The passes of one scan.  The scan's thread calls it; :meth:`status` may be asked from any."""

    def __init__(
        self,
        rig: OpenRig,
        calibration: StereoCalibration,
        store: CaseStore,
        request: PlanRequest,
        control: ScanControl,
        follower: PlanFollower,
        assess: Assess,
        passes: tuple[ScanPass, ...] = (),
    ) -> None:
        """`passes` are those of an interrupted scan."""
        assert request.until_um is not None
        self._rig, self._calibration, self._store, self._request = rig, calibration, store, request
        self._control, self._follower, self._assess = control, follower, assess
        self._wanted_um = request.until_um
        self._passes = list(passes)
        self._at = max(0, len(passes) - 1)
        self._computing = False
        self._computing_s = 0.0
        self._end: PassesEnd | None = None
        self._assessment: Assessment | None = None
        self._refused: ImprontaError | None = None

    @property
    def views(self) -> int:
        """Of all passes so far."""
        return sum(one.views for one in self._passes)

    def status(self) -> SteeringStatus:
        """Where the scan is."""
        passes = self._passes
        now = passes[self._at] if passes else None
        return SteeringStatus(
            wanted_um=self._wanted_um,
            number=self._at + 1,
            computing=self._computing,
            within=None if now is None else now.within_before if now.within_after is None else now.within_after,
            within_predicted=None if now is None else now.within_predicted,
        )

    def result(self) -> SteeringResult:
        """What came of it."""
        found = self._assessment
        return SteeringResult(
            wanted_um=self._wanted_um,
            passes=tuple(self._passes),
            end=self._end,
            coverage=None if found is None else found.coverage,
            remount=None if found is None else found.next.remount,
            refused=self._refused,
            computing_s=self._computing_s,
        )

    # ------------------------------------------------------------------------------------------ in the scan's thread
    def coarse(self, plan: ScanPlan) -> list[dict[str, object]]:
        """The first pass; returns what the case keeps of it beside the plan."""
        self._passes = [_scan_pass(_Step("coarse", plan.views), 0)]
        return kept_passes(self._passes)

    def recall(self, measured: NDArray[np.int64]) -> None:
        """An interrupted scan has measured so many points in each view, (views,)."""
        self._passes = counted(self._passes, measured)

    def follow(self, whole: Pass, rest: ScanPlan, follow: Follow) -> ScanPlan:
        """Follow what is left of a plan, pass by pass, and let the plan grow until there is an end; returns the whole of it.

        Parameters
        ----------
        rest : the plan of `whole`; views that are done have no rows
        """
        for number, one in enumerate(self._passes):
            self._follow(number, whole, rest.views[one.first_view : one.first_view + one.views], follow)
        while not self._control.cancelled.is_set():
            step = self._next(whole)
            if step is None:
                break
            whole = self._extended(whole, step)
            self._follow(len(self._passes) - 1, whole, whole.plan.views[self._passes[-1].first_view :], follow)
        self._store.audit("error-driven scan", json.dumps(self.result().as_dict()))
        return whole.plan

    def repeat(self, whole: Pass, views: tuple[ViewPlan, ...], follow: Follow) -> Pass:
        """Measure views once more, beside the passes that are steered; returns the scan with them."""
        whole = self._extended(whole, _Step("repeated", views))
        self._follow(len(self._passes) - 1, whole, whole.plan.views[self._passes[-1].first_view :], follow)
        return whole

    # ------------------------------------------------------------------------------------------ inner
    def _follow(self, number: int, whole: Pass, views: tuple[ViewPlan, ...], follow: Follow) -> None:
        if self._control.cancelled.is_set() or not any(view.rows for view in views):
            return
        self._at = number
        begin_s, before = self._rig.clock.now_s(), whole.tally.measured
        try:
            follow(replace(whole, plan=replace(whole.plan, views=views)))
        finally:
            one, took_s = self._passes[number], self._rig.clock.now_s() - begin_s
            self._passes[number] = replace(one, points=one.points + whole.tally.measured - before, seconds=one.seconds + took_s)

    def _next(self, whole: Pass) -> _Step | None:
        """What to do after the passes so far; None at the end."""
        rest, room = self._request.points - whole.tally.measured, MOST_VIEWS - len(whole.plan.views)
        found = self._assessed(whole, rest)
        if found is None:
            return None
        if isinstance(found, ImprontaError):
            _log.info("no surface to steer by: %s", found)
            fallen_back, self._refused = self._refused is not None, found
            self._end = PassesEnd.UNIFORM if fallen_back else PassesEnd.POINTS_SPENT
            if fallen_back or self._spent(rest):
                return None
            views = self._evenly(whole, rest)[:room]
            self._end = None if views else PassesEnd.VIEWS_SPENT
            return _Step("uniform", views) if views else None
        self._assessment = found
        self._passes[-1] = replace(self._passes[-1], within_after=found.within)
        self._end = end_of(self._passes, found.within, self._spent(rest), len(found.next.views), room)
        if self._refused is not None:
            self._end = PassesEnd.UNIFORM
        return None if self._end is not None else _Step("steered", found.next.views[:room], found.within, found.within_predicted)

    def _spent(self, rest: int) -> bool:
        return rest < max(_LEAST_REST * self._request.points, _LEAST_POINTS)

    def _assessed(self, whole: Pass, rest: int) -> Assessment | ImprontaError | None:
        """None when the scan was ended meanwhile."""
        self._rig.motion.laser(False)
        self._follower.ask()
        self._follower.keep()
        begin_s = time.monotonic()
        request = AssessmentRequest(
            table=counting_spots(self._store, whole.scan_id),
            plan=whole.plan,
            exposed=self._store.exposures(whole.scan_id),
            rig=self._rig.config,
            calibration=self._calibration,
            rate_hz=self._rig.left.rate_hz,
            wanted_um=self._wanted_um,
            aim_um=self._wanted_um * max(_MARGIN ** len(self._passes), _LEAST_MARGIN),
            budget_points=max(rest, 0),
            first_view=len(whole.plan.views),
            first_id=self._store.next_trigger_id(),
            passes=tuple(self._passes),
            last=self._refused is not None or self._spent(rest),
        )
        self._computing = True
        try:
            return self._assess(request, self._follower.rests)
        except Cancelled:
            return None
        finally:
            self._computing = False
            self._computing_s += time.monotonic() - begin_s

    def _evenly(self, whole: Pass, rest: int) -> tuple[ViewPlan, ...]:
        """The points that are left, over the whole object, as it was located."""
        located = [scan for scan in self._store.scans() if scan.kind == "locate" and scan.id < whole.scan_id][-1]
        first = len(whole.plan.views)
        views = even_views(
            self._rig.config,
            replace(self._request, points=rest),
            self._rig.left.rate_hz,
            ScanPlan.from_dict(located.plan),
            self._store.observations(located.id).trigger_id,
            first,
            self._store.next_trigger_id(),
        )
        return renumbered([view for view in views if may_stand(self._rig.config.limits, view.table_deg)], first)

    def _extended(self, whole: Pass, step: _Step) -> Pass:
        """The plan with the pass in it; the case knows of it before anything is exposed."""
        views = turned(step.views, self._follower.motion.table_deg, self._may_turn)
        plan = whole.plan.extended(views)
        passes = [*self._passes, _scan_pass(replace(step, views=views), len(whole.plan.views))]
        self._store.extend_plan(whole.scan_id, plan.as_dict() | {"request": asdict(self._request), "passes": kept_passes(passes)})
        self._passes = passes  # now: a pass that the case could not take is none
        if whole.progress is not None:
            whole.progress.follow(plan)
        whole.tally.extend(sum(row.count for view in views for row in view.rows))
        return replace(whole, plan=plan)

    def _may_turn(self, table_deg: float) -> bool:
        try:
            self._rig.motion.check_table(table_deg)
        except UsageError:
            return False
        return abs(table_deg) <= _FARTHEST_DEG


def _scan_pass(step: _Step, first_view: int) -> ScanPass:
    wanted = sum(view.quota if view.quota is not None else sum(row.count for row in view.rows) for view in step.views)
    return ScanPass(step.kind, first_view, len(step.views), wanted, within_before=step.within_before, within_predicted=step.within_predicted)
