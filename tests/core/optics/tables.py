"""A turntable without firmware."""

from __future__ import annotations

from scanner_core.devices.motion import MotionState, MotionStatus
from scanner_core.virtual.motion_state import MotionInstant


class Table:
    """The part of a motion controller that a calibration uses, and the mechanics behind it.

    It turns `gain` degrees for every degree that it is asked for and reports.
    """

    def __init__(self, gain: float = 1.0) -> None:
        self.gain = gain
        self.reported_deg = 0.0
        self.laser_on = True

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(0.0, 0.0, self.gain * self.reported_deg, 0.0)

    def laser(self, on: bool) -> None:
        self.laser_on = on

    def rotate_to(self, table_deg: float) -> None:
        self.reported_deg = table_deg

    def status(self) -> MotionStatus:
        return MotionStatus(MotionState.IDLE, 0.0, 0.0, self.reported_deg, 0.0, 0.0)

    def aim(self, x_deg: float, y_deg: float) -> None:
        raise AssertionError("a calibration does not aim")

    def sweep(self, x_deg: float, y_deg: float, speed_deg_s: float) -> None:
        raise AssertionError("a calibration does not sweep")

    def wait_idle(self, deadline_s: float) -> None:
        pass

    def home(self) -> None:
        raise AssertionError("a calibration does not home")

    def stop(self) -> None:
        self.laser_on = False

    def close(self) -> None:
        self.laser_on = False

    def __enter__(self) -> Table:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()
