"""A scan by a laser line: the table turns from view to view, and in each the line is swept over the object once.

It runs in the scan's thread, which owns the controller; what it has come to may be read from any.  A sweep is settled as a
whole (:mod:`~scanner_core.acquisition.line_engine`) and kept in the case at once, with all of its frames.
"""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.engine import DROPPED_FRAME
from scanner_core.acquisition.following import Pass
from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.line_engine import LineEngine, LinePoints
from scanner_core.acquisition.line_plan import LinePlanner
from scanner_core.acquisition.line_sweep import LineSweep, SweptFrame
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.acquisition.plan import PlanRequest, ScanPlan, ViewPlan
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.status import ScanCounts, ScanState
from scanner_core.acquisition.sweep_exposure import exposed_for
from scanner_core.acquisition.tally import Tally
from scanner_core.case.observation import LINE_FRAME, StereoObservation
from scanner_core.case.store import CaseStore
from scanner_core.case.stripes import MeasuredPlaces, RejectedPlaces
from scanner_core.devices.camera import Trigger
from scanner_core.devices.motion import MotionStatus
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import AcquisitionError
from scanner_core.optics.calibration import StereoCalibration

_STATUS_PERIOD_S = 0.2
_MOVE_DEADLINE_S = 60.0
_BEGINS_S = 0.02
"""Frames begin so many seconds after a sweep has begun to move."""


class LineCourse:
    """The course of one scan by a line; its counts are over the places of the line that a camera has seen, and the frames that were lost.

    Attributes
    ----------
    tally : of the scan
    scan_id, plan : of the scan; None before it has begun.  The plan grows by a view when its turn comes
    open : the scan, while it has begun and not ended
    motion : the controller's newest report
    view : that is being swept
    exposures : frames so far
    steering, resumed, marks : None; a line's scan has no passes, is not resumed, and visits no marks
    """

    steering: None = None
    resumed: None = None
    marks: None = None

    def __init__(
        self, rig: OpenRig, calibration: StereoCalibration, store: CaseStore, request: PlanRequest, control: ScanControl, cloud: PointLog, mount: int
    ) -> None:
        if request.until_um is not None:
            raise AcquisitionError("E-LINE-01")
        self._rig, self._calibration, self._store, self._request = rig, calibration, store, request
        self._control, self._cloud, self._mount = control, cloud, mount
        self._engine = LineEngine(rig.config, calibration)
        self._asked_s = 0.0
        self.motion: MotionStatus = rig.motion.status()
        self.view = self.exposures = 0
        self.tally = Tally(0, request.points, rig.clock.now_s())
        self.located = ScanCounts()
        self.scan_id: int | None = None
        self.plan: ScanPlan | None = None
        self.open: Pass | None = None

    @property
    def views(self) -> int:
        """Table positions of the whole scan."""
        return self._request.views

    @property
    def closing(self) -> bool:
        """A line measures no view again."""
        return False

    def seconds_left(self, now_s: float) -> float | None:
        """From the pace so far, on the rig's clock."""
        return self.tally.seconds_left(now_s)

    def run(self) -> None:
        """The whole course; returns early when the scan is ended."""
        planner = LinePlanner(self._rig.config, self._request, self._rig.left.rate_hz)
        for table_deg in planner.table_deg:
            self._rig.motion.check_table(table_deg)
        self._rig.motion.recover()
        if self._rig.motion.needs_homing and not self._control.cancelled.is_set():
            self._rig.motion.home()
        self._control.enter(ScanState.SCANNING)
        lit_frames, next_id = 0, self._store.next_trigger_id()
        for number in range(self._request.views):
            self._rest_while_paused()
            if self._control.cancelled.is_set():
                return
            view = planner.view(number, next_id, self._cloud.since(0).points, lit_frames)
            next_id += view.rows[0].count
            lit_frames += self._sweep(view, self._planned(view))
        if not self.tally.measured:
            counts = self.tally.counts()
            reasons = ", ".join(f"{name} {count}" for name, count in counts.rejected.items()) or "no light"
            raise AcquisitionError("E-SCAN-01", planned=counts.planned, reasons=reasons)

    def keep(self) -> None:
        """Every sweep is kept as soon as it is settled: there is nothing left."""

    def ask(self) -> MotionStatus:
        """The controller's report now."""
        self.motion = self._rig.motion.status()
        self._asked_s = time.monotonic()
        return self.motion

    # ------------------------------------------------------------------------------------------ inner
    def _planned(self, view: ViewPlan) -> int:
        """Record the view before the first of its exposures; returns the scan's id."""
        if self.scan_id is None:
            assert view.sweep_speed_deg_s is not None
            self.plan = ScanPlan((view,), view.sweep_speed_deg_s)
            toml = dump_rig(self._rig.config.with_calibration(self._calibration))
            bare = dump_rig(self._rig.config.with_calibration(None))
            self.scan_id = self._store.begin_scan("scan", bare, self._calibration.identity(), toml, self._record(self.plan), self._mount)
            self.open = Pass(self.scan_id, self.plan, self.tally, self._cloud)
        else:
            assert self.plan is not None
            self.plan = self.plan.extended((view,))
            self._store.extend_plan(self.scan_id, self._record(self.plan))
        return self.scan_id

    def _record(self, plan: ScanPlan) -> dict[str, object]:
        return plan.as_dict() | {"request": asdict(self._request)}

    def _sweep(self, view: ViewPlan, scan_id: int) -> int:
        """Sweep a view and keep what it gave; returns the number of frames that gave points."""
        row, speed = view.rows[0], view.sweep_speed_deg_s
        assert speed is not None
        self.view = row.view
        motion = self._rig.motion
        motion.rotate_to(view.table_deg)
        table_deg = self.ask().table_deg
        self._store.put_view(scan_id, row.view, table_deg)
        with exposed_for(self._rig, ScanPlan((view,), speed)):
            motion.aim(row.x_from_deg, row.y_deg)
            motion.sweep(row.x_to_deg, row.y_deg, speed)
            trigger = Trigger(row.first_id, row.count, self._rig.clock.now_s() + _BEGINS_S)
            frames = LineSweep(self._rig.left, self._rig.right, trigger, self._control.cancelled, self._poll).frames()
        if not self._control.cancelled.is_set():
            motion.wait_idle(_MOVE_DEADLINE_S)  # raises when the beam went dark before its time: nothing of it is kept then
        return self._settle(frames, scan_id, row.view, table_deg)

    def _settle(self, frames: list[SweptFrame], scan_id: int, view: int, table_deg: float) -> int:
        whole = [(frame, frame.left, frame.right) for frame in frames if frame.left is not None and frame.right is not None]
        found = self._engine.evaluate([(left, right) for _, left, right in whole], table_deg)
        ids = np.array([frame.trigger_id for frame, _, _ in whole], np.int64)
        exposed = [
            StereoObservation(f.trigger_id, view, DROPPED_FRAME if f.left is None or f.right is None else LINE_FRAME, f.time_s, table_deg, None, None)
            for f in frames
        ]
        self._store.append_line(scan_id, exposed, *_places(found, ids))
        self.exposures += len(frames)
        self._cloud.append(LivePoints.of_view(found.points, table_deg, view, covariances=found.covariances))
        verdicts = Counter(found.verdicts)
        if lost := len(frames) - len(whole):
            verdicts[DROPPED_FRAME] += lost
        self.tally.extend(verdicts.total())
        self.tally.add(verdicts.elements(), self._rig.clock.now_s())
        return len(np.unique(found.frame))

    def _rest_while_paused(self) -> None:
        if not self._control.rest_wanted:
            return
        self._rig.motion.laser(False)
        self._control.enter(ScanState.PAUSED)
        while self._control.rest_wanted and not self._control.wait_to_go_on(_STATUS_PERIOD_S):
            self._poll()
        self._control.enter(ScanState.SCANNING)

    def _poll(self) -> None:
        if time.monotonic() - self._asked_s > _STATUS_PERIOD_S and not self._control.cancelled.is_set():
            self.ask()


def _places(found: LinePoints, ids: NDArray[np.int64]) -> tuple[MeasuredPlaces, RejectedPlaces]:
    """For the case, with trigger ids in place of the numbers of frames."""
    lost = found.rejected
    none = np.empty(0, np.int64)
    of = ids[found.frame] if len(ids) else none
    of_lost = ids[lost.frame] if len(ids) else none
    return MeasuredPlaces(of, found.number, found.pairs), RejectedPlaces(of_lost, lost.number, lost.in_right, lost.xy, lost.verdict)
