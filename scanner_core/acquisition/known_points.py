"""What an interrupted scan has measured already, and whether it is still true: some of it is measured again.

Between an interruption and its end a person may have lifted the object, bumped a camera or reset the controller, and the
rest of the plan would then be scanned onto a surface that is not there any more.  So the first and the last view that
hold enough points are visited again, by the very same beams, and what they find is compared with what they found before,
as the end of a turn is (:meth:`~scanner_core.acquisition.view_watch.ViewWatch.close_turn`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.live_points import LivePoints
from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.acquisition.view_motion import MIN_POINTS
from scanner_core.acquisition.view_watch import Closure
from scanner_core.case.points import triangulate_observations
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.view_directions import seen_from
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

CHECK_POINTS = 250
"""Points of a view that are measured again; coarse to fine, so they lie all over it."""
_SEEN_AGAIN = 0.5
"""Least share of the known points that give a point again; the rest may have been at the limit of a gate."""
_DEPTH_SIGMAS = 5.0
_DEPTH_MM = 0.05
"""What a depth may differ by beside its noise where the shape tells nothing more."""


@dataclass(frozen=True, slots=True, eq=False)
class KnownPoints:
    """Measured points of one scan in the order of their trigger ids.

    Attributes
    ----------
    points : (n, 3) mm, object frame, before any registration
    views : (n,) int32
    trigger_ids : (n,) int64
    """

    points: Array
    views: NDArray[np.int32]
    trigger_ids: NDArray[np.int64]

    @staticmethod
    def of_scan(store: CaseStore, scan_id: int, rig: RigConfig, calibration: StereoCalibration) -> KnownPoints:
        """What the case holds of a scan."""
        table = store.observations(scan_id)
        points = triangulate_observations(table, rig, calibration).cloud.points if len(table) else np.empty((0, 3))
        return KnownPoints(points, table.view, table.trigger_id)

    def __len__(self) -> int:
        return len(self.points)

    def live(self, table_deg: float) -> LivePoints:
        """Points of one view as a running scan shows them; their residuals and noise come once the scan is computed."""
        return LivePoints.of_view(self.points, table_deg, int(self.views[0]) if len(self) else 0)

    def of_view(self, view: int) -> KnownPoints:
        here = self.views == view
        return KnownPoints(self.points[here], self.views[here], self.trigger_ids[here])

    def views_to_check(self, count: int) -> list[int]:
        """The first and the last of `count` views that hold enough points; none when no view does."""
        enough = np.flatnonzero(np.bincount(self.views, minlength=count) >= MIN_POINTS).tolist()
        return sorted({enough[0], enough[-1]}) if enough else []


@dataclass(frozen=True, slots=True, eq=False)
class CheckPlan:
    """Rows of known views under new trigger ids.

    Attributes
    ----------
    begins : (rows, 2) first ids of the rows, now and before
    table_deg : (views,) of all views of the plan
    """

    plan: ScanPlan
    begins: NDArray[np.int64]
    table_deg: Array

    def known_ids(self, trigger_ids: NDArray[np.int64]) -> NDArray[np.int64]:
        """Trigger ids (n,) of the check as they were before."""
        row = np.searchsorted(self.begins[:, 0], trigger_ids, side="right") - 1
        before: NDArray[np.int64] = trigger_ids - self.begins[row, 0] + self.begins[row, 1]
        return before


def check_plan(plan: ScanPlan, known: KnownPoints, first_id: int) -> CheckPlan:
    """The rows of the views to check that hold known points, in the order of the plan."""
    views: list[ViewPlan] = []
    begins: list[tuple[int, int]] = []
    for number in known.views_to_check(len(plan.views)):
        rows: list[Row] = []
        for row in plan.views[number].rows:
            if not row.holds_any(known.trigger_ids):
                continue
            rows.append(replace(row, first_id=first_id))
            begins.append((first_id, row.first_id))
            first_id += row.count
        views.append(replace(plan.views[number], rows=tuple(rows), quota=min(CHECK_POINTS, len(known.of_view(number)))))
    return CheckPlan(ScanPlan(tuple(views), plan.sweep_speed_deg_s), np.array(begins, np.int64), np.array([view.table_deg for view in plan.views]))


@dataclass(frozen=True, slots=True)
class Agreement:
    """Whether known points were found where they were.

    Attributes
    ----------
    known, seen : known points that were aimed at again, and how many of them gave a point
    shift_um : the largest of the views, by which what was seen lies beside what is known
    agrees : the scan may go on
    """

    known: int
    seen: int
    shift_um: float
    agrees: bool


def agreement(
    known: KnownPoints, again: KnownPoints, exposed_again: NDArray[np.int64], check: CheckPlan, compare: Callable[[Array, Array], Closure]
) -> Agreement:
    """Judge the points that were measured again, view by view.

    Parameters
    ----------
    again : under the trigger ids of the check
    exposed_again : (m,) trigger ids of the check that were exposed
    compare : points again (n, 3) and before (n, 3) to their motion
    """
    aimed = int(np.isin(check.known_ids(exposed_again), known.trigger_ids).sum())
    _, seen, then = np.intersect1d(check.known_ids(again.trigger_ids), known.trigger_ids, assume_unique=True, return_indices=True)
    agrees = len(seen) >= _SEEN_AGAIN * aimed and len(seen) > 0
    shift_um = 0.0
    for view in np.unique(known.views[then]):
        here = known.views[then] == view
        points, before = again.points[seen[here]], known.points[then[here]]
        closure = compare(points, before)
        if np.isnan(closure.shift_um):
            depth_mm, limit_mm = _depth(points, before, float(check.table_deg[view]))
            shift_um, agrees = max(shift_um, 1e3 * depth_mm), agrees and depth_mm <= limit_mm
        else:
            shift_um, agrees = max(shift_um, closure.shift_um), agrees and closure.closes
    return Agreement(aimed, len(seen), float(shift_um), bool(agrees))


def _depth(points: Array, before: Array, table_deg: float) -> tuple[float, float]:
    """By how much points lie nearer or farther on the middle, and how much of that their noise may be, mm."""
    towards = seen_from(np.array([table_deg]))[0]
    along = (points - before) @ towards
    middle = float(np.median(along))
    spread = 1.4826 * float(np.median(np.abs(along - middle)))
    return abs(middle), _DEPTH_SIGMAS * 1.25 * spread / np.sqrt(len(along)) + _DEPTH_MM
