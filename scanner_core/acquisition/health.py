"""The health of a scan while it runs: an observer of the scan's thread that any thread may ask.

It sees pairs with their verdicts, the ends of views and the first view measured again, and turns them into findings:
sentences with a code, a place and a size.  It changes nothing about the scan.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import EvaluatedPairs, StereoPair
from scanner_core.acquisition.epipolar_watch import EpipolarWatch
from scanner_core.acquisition.finding import Finding
from scanner_core.acquisition.frame_watch import SIDES, FrameWatch
from scanner_core.acquisition.known_points import KnownPoints
from scanner_core.acquisition.plan import ScanPlan
from scanner_core.acquisition.view_watch import Closure, ViewStep, ViewWatch
from scanner_core.case.observation import MEASURED
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

Phase = Literal["locate", "scan", "check", "closure"]
"""The passes of a scan; ``check`` measures known points again before an interrupted scan goes on."""

_LARGE_SCATTER = 1.7
"""Scatter of the epipolar residuals over what the spots' uncertainties let expect."""


@dataclass(frozen=True, slots=True)
class HealthReport:
    """What was noticed so far.

    Attributes
    ----------
    findings : in the order of their first appearance
    epipolar_mean_px, epipolar_sd_px, epipolar_expected_sd_px : of `epipolar_points` residuals
    missing_frames : by camera
    views_compared : that could be laid on the earlier ones; the first never is
    closure : None while the turn has not been closed
    """

    findings: tuple[Finding, ...] = ()
    epipolar_mean_px: float = 0.0
    epipolar_sd_px: float = 0.0
    epipolar_expected_sd_px: float = 0.0
    epipolar_points: int = 0
    missing_frames: tuple[int, int] = (0, 0)
    views_compared: int = 0
    closure: Closure | None = None

    @property
    def closure_um(self) -> float | None:
        """By how much the turn did not close; None where nobody knows."""
        return None if self.closure is None or np.isnan(self.closure.shift_um) else self.closure.shift_um

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "findings": [finding.as_dict() for finding in self.findings],
            "epipolar": {
                "points": self.epipolar_points,
                "mean_px": round(self.epipolar_mean_px, 5),
                "sd_px": round(self.epipolar_sd_px, 5),
                "expected_sd_px": round(self.epipolar_expected_sd_px, 5),
            },
            "missing_frames": dict(zip(SIDES, self.missing_frames, strict=True)),
            "views_compared": self.views_compared,
            "closure": None if self.closure is None else self.closure.as_dict(),
        }


class HealthMonitor:
    """One scan's health.  One thread feeds it; :meth:`report` and :attr:`findings` may be read from any."""

    def __init__(self, calibration: StereoCalibration, rate_hz: float) -> None:
        self._lock = threading.Lock()
        self._findings: dict[object, Finding] = {}
        self._frames = FrameWatch(rate_hz)
        self._residuals = EpipolarWatch(calibration.left.size_px[0])
        self._views = ViewWatch(calibration.held_out_rms_um)
        self._closure: Closure | None = None
        self._missing = (0, 0)
        self._spread = (0.0, 0.0, 0.0)
        self._phase: Phase = "locate"
        self._first_id = self._later = 0
        self._first: dict[int, Array] = {}
        self._again: dict[int, Array] = {}

    # ------------------------------------------------------------------------------------------ from any thread
    @property
    def findings(self) -> tuple[Finding, ...]:
        with self._lock:
            return tuple(self._findings.values())

    @property
    def closure_um(self) -> float | None:
        """See :attr:`HealthReport.closure_um`."""
        return self.report().closure_um

    def report(self) -> HealthReport:
        with self._lock:
            findings, points, compared = tuple(self._findings.values()), self._residuals.count, self._views.compared
            return HealthReport(findings, *self._spread, points, self._missing, compared, self._closure)

    # ------------------------------------------------------------------------------------------ from the scan's thread
    def begin(self, plan: ScanPlan, phase: Phase) -> None:
        """A pass begins; while it locates, most of the volume is empty."""
        self._phase = phase
        if phase == "closure":
            self._later = plan.views[0].rows[0].first_id - self._first_id
        elif phase != "check" and plan.views[0].rows:
            self._first_id = plan.views[0].rows[0].first_id
            self._first.clear()
        self.expect(plan)

    def expect(self, plan: ScanPlan) -> None:
        """What is swept next, of the pass that has begun."""
        rows = [row.count for view in plan.views for row in view.rows]
        if rows:
            self._frames.expect_light(2 * plan.planned // len(plan.views) if self._phase == "locate" else max(200, 4 * max(rows)))

    def add(self, pairs: Sequence[StereoPair], seen: EvaluatedPairs, view: int, table_deg: float) -> None:
        """A batch of pairs as it was evaluated; `seen` may end before `pairs`, where a quota was reached."""
        shown = -1 if self._phase == "locate" else view
        for finding in self._frames.add(pairs, shown, table_deg):
            self._tell(finding, finding.code, finding.fields.get("camera"))
        self._judge_residuals(seen, shown, table_deg)
        if self._phase == "scan":
            self._views.add(seen.points)
        if self._phase == "closure" or (self._phase != "check" and view == 0):
            ids = [o.trigger_id for o in seen.observations if o.verdict == MEASURED]
            (self._again if self._phase == "closure" else self._first).update(zip(ids, seen.points, strict=True))
        with self._lock:
            self._spread, self._missing = self._residuals.spread_px(), self._frames.missing()

    def end_view(self, view: int, table_deg: float) -> None:
        """All rows of a view are done."""
        if self._phase == "scan" and self._views.end_view(view, table_deg) and not self._out_of_step:
            for step in self._views.steps:
                self._tell(_moved(step), "step", step.view)

    def recall(self, plan: ScanPlan, known: KnownPoints, complete: int) -> None:
        """What an earlier run of the same plan has measured; its first `complete` views are done."""
        self.begin(plan, "scan")
        for number, planned in enumerate(plan.views):
            self._views.add(known.of_view(number).points)
            if number < complete:
                self._views.end_view(number, planned.table_deg)
        first = known.of_view(0)
        self._first = dict(zip(first.trigger_ids.tolist(), first.points, strict=True))

    def tell(self, findings: Iterable[tuple[Finding, tuple[object, ...]]]) -> None:
        """What another watch has found, each with the key under which a later one replaces it."""
        if not self._out_of_step:
            for finding, key in findings:
                self._tell(finding, *key)

    def go_on(self) -> None:
        """The known points were measured again: what comes now belongs to the scan."""
        self._phase = "scan"

    def compare(self, again: Array, before: Array) -> Closure:
        """Points (n, 3) mm measured again against the same beams' points `before` (n, 3), object frame."""
        return self._views.close_turn(again, before)

    def close_turn(self, table_deg: float) -> None:
        """The first view has been measured again: compare what the same beams have found."""
        shared = [i for i in self._again if i - self._later in self._first]
        again = np.array([self._again[i] for i in shared]).reshape(-1, 3)
        closure = self._views.close_turn(again, np.array([self._first[i - self._later] for i in shared]).reshape(-1, 3))
        with self._lock:
            self._closure = closure
        if self._out_of_step:
            return
        if not closure.closes and not closure.lost_steps:
            fields: dict[str, object] = {"shift_um": f"{closure.shift_um:.0f}"}
            self._tell(Finding("H-VIEW-04", "warning", fields, -1, table_deg, -1, closure.shift_um, "um"), "closure")
        elif not closure.judged:
            self._tell(Finding("H-TAB-02", "info", {"reason": closure.reason}, 0, table_deg), "closure")
        elif closure.lost_steps:
            where = "" if closure.jumped_between_deg is None else _since(*closure.jumped_between_deg)
            fields = {"turn_deg": f"{closure.turn_deg:.3f}", "where": where}
            details: dict[str, object] = {"uncertainty_deg": round(closure.turn_uncertainty_deg, 4), "jumped_at_deg": closure.jumped_at_deg}
            details["jumped_between_deg"] = None if closure.jumped_between_deg is None else list(closure.jumped_between_deg)
            step = next((step for step in self._views.steps if step.cause == "table"), None)
            key = ("closure",) if step is None else ("step", step.view)  # the same loss, now measured better
            self._tell(Finding("H-TAB-01", "warning", fields, -1, table_deg, -1, closure.turn_deg, "deg", details), *key)

    # ------------------------------------------------------------------------------------------ inner
    @property
    def _out_of_step(self) -> bool:
        """The cameras do not expose together: what the points seem to do afterwards is nobody's motion."""
        return any(finding.code.startswith("H-SYN") for finding in self._findings.values())

    def _judge_residuals(self, seen: EvaluatedPairs, view: int, table_deg: float) -> None:
        known = np.flatnonzero(np.isfinite(seen.residual_px))
        if not len(known):
            return
        observations = [seen.observations[i] for i in known]
        left = np.array([[o.left.x_px, o.left.y_px] for o in observations if o.left is not None])
        right = np.array([[o.right.x_px, o.right.y_px] for o in observations if o.right is not None])
        ids = np.array([o.trigger_id for o in observations], np.int64)
        step = self._residuals.add(ids, left, right, seen.residual_px[known], seen.expected_px[known])
        where = "while the object was located" if view < 0 else f"view {view + 1}, table at {table_deg:.1f} deg"
        if step is not None:
            fields: dict[str, object] = {"shift_px": f"{step.image_shift_px:.2f}", "where": where, "points": step.points}
            finding = Finding("H-EPI-01", "warning", fields, view, table_deg, step.trigger_id, step.image_shift_px, "px", {"points": step.points})
            self._tell(finding, "bump", step.trigger_id)
        if self._residuals.scatter > _LARGE_SCATTER:
            _, sd, expected = self._residuals.spread_px()
            fields = {"sd_px": f"{sd:.2f}", "expected_px": f"{expected:.2f}", "where": where}
            self._tell(Finding("H-EPI-02", "warning", fields, view, table_deg, int(ids[-1]), sd, "px"), "scatter")

    def _tell(self, finding: Finding, *key: object) -> None:
        """Add a finding, or renew its figures where it began."""
        with self._lock:
            first = self._findings.get(key)
            if first is not None:
                finding = replace(finding, trigger_id=first.trigger_id)
                if finding.view != -1:
                    finding = replace(finding, view=first.view, table_deg=first.table_deg)
            self._findings[key] = finding


def _moved(step: ViewStep) -> Finding:
    """The sentence of a view that lies beside the earlier ones."""
    fields: dict[str, object] = {"table_deg": f"{step.table_deg:.1f}", "shift_um": f"{step.shift_um:.0f}", "direction": _direction(step.shift_mm)}
    shift_um = [round(1e3 * component, 1) for component in step.shift_mm]
    details: dict[str, object] = {"shift_um": shift_um, "cause": step.cause, "chi_square": round(step.significance, 1)}
    if step.cause == "table":
        fields = {"turn_deg": f"{step.turn_deg:.2f}", "where": f", since the view at {step.table_deg:.1f} deg"}
        return Finding("H-TAB-01", "warning", fields, step.view, step.table_deg, -1, step.turn_deg, "deg", details)
    code = {"camera": "H-VIEW-02", "object": "H-VIEW-03"}.get(step.cause, "H-VIEW-01")
    return Finding(code, "warning", fields, step.view, step.table_deg, -1, step.shift_um, "um", details)


def _since(earliest_deg: float, latest_deg: float) -> str:
    if earliest_deg == latest_deg:
        return f", since the view at {earliest_deg:.1f} deg"
    return f", since a view between {earliest_deg:.1f} and {latest_deg:.1f} deg"


def _direction(shift_mm: tuple[float, float, float]) -> str:
    """In words, by the largest component."""
    axis = int(np.argmax(np.abs(shift_mm)))
    ways = (("towards the cameras", "away from the cameras"), ("to the right", "to the left"), ("up", "down"))
    return ways[axis][shift_mm[axis] < 0]
