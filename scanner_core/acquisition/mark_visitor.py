"""Visits the marks on the table's rim: at the start of each view a few short rows over every ball that can be seen.

The scan's thread alone calls it.  What it measures goes into the case under records of its own, so the counts of the scan,
its points and its trigger ids know nothing of it.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.aim_correction import corrected_laser
from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.engine import StereoEngine
from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.mark_causes import Cause
from scanner_core.acquisition.mark_centres import MarkCentre, mark_centres, mark_points, nearest_mark
from scanner_core.acquisition.mark_findings import step_finding
from scanner_core.acquisition.mark_rows import Pattern, beam_of, mark_rows, searching, seen_marks, visiting
from scanner_core.acquisition.mark_visits import KIND, During, MarksReport, VisitPlan, recalled
from scanner_core.acquisition.mark_watch import MarkWatch
from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.acquisition.simultaneous import Counting, rows_in_step
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.acquisition.sweep_exposure import exposed_for
from scanner_core.case.observation import StereoObservation
from scanner_core.case.store import CaseStore
from scanner_core.devices.marks_config import MarksConfig
from scanner_core.devices.rig import VolumeConfig, dump_rig, parse_rig
from scanner_core.errors import AcquisitionError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

_MOVE_DEADLINE_S = 30.0
_ON_BALL = 1.3
"""Places for the correction of the aim lie within so many radii of a ball's centre."""
_LATEST = 1500
_WORDS: dict[Cause | None, str] = {
    Cause.TABLE: "as if the table had turned beside its reading",
    Cause.LEFT: "as if a camera had moved",
    Cause.RIGHT: "as if a camera had moved",
    Cause.SCALE: "as if the scale had changed",
}
_TALLER, _WIDER_MM = 1.05, 3.0
"""The object is a little larger than what a coarse pass has hit of it."""


class MarkVisitor:
    """The visits of one scan.  `watch` is what they say."""

    def __init__(self, rig: OpenRig, marks: MarksConfig, calibration: StereoCalibration, store: CaseStore, control: ScanControl) -> None:
        self._rig, self._marks, self._calibration, self._store, self._control = rig, marks, calibration, store, control
        config = rig.config
        around = VolumeConfig(marks.radius_mm + marks.diameter_mm, max(config.volume.height_mm, marks.height_mm + marks.diameter_mm))
        self._engine = StereoEngine(calibration, around, config.spot.floor_px)
        self._counting = Counting.of(rig.left.report().trigger, rig.right.report().trigger)
        self._laser = config.laser
        self._lit: tuple[Array, Array] = (np.empty((0, 3)), np.empty((0, 2)))
        self._obstacle = config.volume
        self._scan_id: int | None = None
        self._during: During = "scan"
        self.watch = MarkWatch(marks, calibration)
        self.exposures = 0
        self.rig_s = 0.0
        """Of the rig's clock, in all visits and searches."""

    # ------------------------------------------------------------------------------------------ the runner
    def begin(self, scan_id: int, cloud: PointLog, during: During = "scan") -> None:
        """From now on :meth:`visit` is for this scan; `cloud` shows how large the object is."""
        self._scan_id, self._during = scan_id, during
        points = cloud.since(0).points
        if len(points):
            radius_mm = float(np.quantile(np.hypot(points[:, 0], points[:, 1]), 0.999)) + _WIDER_MM
            height_mm = _TALLER * float(np.quantile(points[:, 2], 0.999)) + _WIDER_MM
            volume = self._rig.config.volume
            self._obstacle = VolumeConfig(min(radius_mm, volume.radius_mm), min(height_mm, volume.height_mm))

    def begin_check(self, scan_id: int) -> None:
        """From now on :meth:`visit` compares with the visits of an interrupted scan; a scan that made none is not compared."""
        rig = parse_rig(self._store.rig_toml(scan_id), str(self._store.path))
        before = recalled(self._store, scan_id, rig, self._calibration) if rig.marks == self._marks else None
        if before is not None and before.visits:
            self.watch = before
            self.begin(scan_id, PointLog(), "check")

    def report(self) -> MarksReport | None:
        """The check value of the scan; None when no mark was seen."""
        return MarksReport.of(self.watch, self._marks.distances_mm is not None) if self.watch.visits else None

    # ------------------------------------------------------------------------------------------ the follower
    def visit(self, view: int, table_deg: float, left: CaptureThread, right: CaptureThread, poll: Callable[[], None]) -> bool:
        """Look at every mark that the table's position shows; True when the watch has something new to tell.

        Raises
        ------
        AcquisitionError
            E-MARK-01: before an interrupted scan goes on they do not lie where they were.
        """
        seen = self._look(view, table_deg, left, right, poll)
        if seen is None or self._control.cancelled.is_set():
            return False
        if self._during == "check":
            self._compare(table_deg, seen[1])
            return False
        return self.watch.add_visit(view, table_deg, *seen)

    # ------------------------------------------------------------------------------------------ inner
    def _look(
        self, view: int, table_deg: float, left: CaptureThread, right: CaptureThread, poll: Callable[[], None]
    ) -> tuple[list[int], list[MarkCentre]] | None:
        if self._scan_id is None:
            return None
        begin_s = self._rig.clock.now_s()
        try:
            places = self.watch.expected_mm(table_deg)
            wanted = seen_marks(self._rig.config, self._calibration, RigidTransform.about_z(-table_deg).apply(places), table_deg, self._obstacle)
            if not wanted:
                return [], []
            radius = self._marks.ball_radius_mm
            sweep = partial(self._visit, view=view, table_deg=table_deg, left=left, right=right, poll=poll)
            if not len(self._lit[0]):
                places = self._found(places, sweep(wanted, places, searching(radius), "search"), table_deg)
            once = visiting(radius, self._rig.config.laser.spot_diameter_mm, len(wanted))
            centres = sweep(wanted, places, once, self._during)
            if not centres and not self._control.cancelled.is_set():  # all of them elsewhere: it may be the table, by more than a ball
                places = self._found(places, sweep(wanted, places, searching(radius), "search"), table_deg)
                centres = sweep(wanted, places, once, self._during)
            return wanted, centres
        finally:
            self.rig_s += self._rig.clock.now_s() - begin_s

    def _compare(self, table_deg: float, centres: Sequence[MarkCentre]) -> None:
        step = self.watch.compare(table_deg, centres)
        seen = ", ".join(str(centre.number + 1) for centre in centres)
        if step is None:
            self._store.audit("marks visited again", f"table at {table_deg:.1f} deg: marks {seen or 'none'} seen, where they were")
            return
        finding = step_finding(step)
        self._store.audit("marks visited again", json.dumps(finding.as_dict()))
        raise AcquisitionError("E-MARK-01", shift_um=f"{step.shift_um:.0f}", cause=_WORDS.get(step.cause, "as if table, cameras or marks had moved"))

    def _found(self, places: Array, centres: Sequence[MarkCentre], table_deg: float) -> Array:
        """Places (3, 3) mm, table frame, with those of the balls that a search has found."""
        turn, places = RigidTransform.about_z(table_deg), places.copy()
        for centre in centres:
            places[centre.number] = turn.apply(centre.centre[None])[0]
        return places

    def _visit(
        self,
        wanted: Sequence[int],
        places: Array,
        pattern: Pattern,
        during: During,
        *,
        view: int,
        table_deg: float,
        left: CaptureThread,
        right: CaptureThread,
        poll: Callable[[], None],
    ) -> list[MarkCentre]:
        """Rows over balls at `places` (3, 3) mm, table frame, under a record of their own."""
        config, rate_hz = self._rig.config, self._rig.left.rate_hz
        order = sorted(wanted, key=lambda number: -float(places[number, 1]))  # from one side to the other
        rows = mark_rows(config, self._laser, [places[number] for number in order], pattern, view, self._store.next_trigger_id(), rate_hz)
        if not rows or self._scan_id is None:
            return []
        steps = [(row.x_to_deg - row.x_from_deg) / (row.count - 1) for row in rows]
        plan = ScanPlan((ViewPlan(table_deg, rows),), max(steps) * rate_hz)
        bare, whole = (dump_rig(config.with_calibration(c)) for c in (None, self._calibration))
        about = VisitPlan(self._scan_id, during, view, tuple(sorted(wanted)))
        scan_id = self._store.begin_scan(KIND, bare, self._calibration.identity(), whole, plan.as_dict() | {KIND: about.as_dict()})
        self._store.put_view(scan_id, view, table_deg)
        observations: list[StereoObservation] = []
        try:
            with exposed_for(self._rig, plan):
                for row, step in zip(rows, steps, strict=True):
                    if self._control.cancelled.is_set():
                        break
                    observations += self._sweep(row, step * rate_hz, table_deg, left, right, poll)
        finally:
            self.exposures += len(observations)
            self._store.append(scan_id, observations)
        reason = FinishReason.CANCELLED if self._control.cancelled.is_set() else FinishReason.COMPLETED
        self._store.end_scan(scan_id, reason, ScanCounts.of(plan.planned, self._store.verdict_counts(scan_id)))
        table = self._store.observations(scan_id)
        centres = mark_centres(table, config, self._calibration)
        if centres:
            points, _ = mark_points(table, config, self._calibration)
            self._learn(rows, table.trigger_id, points, centres, table_deg)
        return centres

    def _sweep(
        self, row: Row, speed_deg_s: float, table_deg: float, left: CaptureThread, right: CaptureThread, poll: Callable[[], None]
    ) -> list[StereoObservation]:
        self._rig.motion.aim(row.x_from_deg, row.y_deg)
        self._rig.motion.sweep(row.x_to_deg, row.y_deg, speed_deg_s)
        at_rest = partial(self._rig.motion.wait_idle, _MOVE_DEADLINE_S)
        scan = RowScan(left, right, row, self._rig.clock.now_s(), self._control.cancelled, poll, at_rest)
        observations: list[StereoObservation] = []
        try:
            for pairs in rows_in_step(scan.batches(), self._rig.left.rate_hz, self._counting):
                observations += self._engine.evaluate(pairs, row.view, table_deg).observations
        finally:
            scan.finish()
        at_rest()
        return observations

    def _learn(self, rows: Sequence[Row], trigger_ids: NDArray[np.int64], points: Array, centres: Sequence[MarkCentre], table_deg: float) -> None:
        """Where the beam lies, from what it hit of the balls."""
        known = {centre.number: centre.centre for centre in centres}
        of = nearest_mark(self._marks, points)
        limit_mm = _ON_BALL * self._marks.ball_radius_mm
        on_ball = np.array([number in known and np.linalg.norm(p - known[number]) < limit_mm for number, p in zip(of.tolist(), points, strict=True)])
        places = RigidTransform.about_z(table_deg).apply(points[on_ball])
        angles = beam_of(rows, trigger_ids[on_ball])
        self._lit = np.concatenate([self._lit[0], places])[-_LATEST:], np.concatenate([self._lit[1], angles])[-_LATEST:]
        self._laser = corrected_laser(self._rig.config.laser, *self._lit)
