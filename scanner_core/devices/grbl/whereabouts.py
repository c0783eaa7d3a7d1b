"""Where the board says that it is, and what that is worth."""

from __future__ import annotations

import math
import time

from scanner_core.clock import Clock
from scanner_core.devices.grbl.axes import TABLE, Axes, Target, X, Y
from scanner_core.devices.grbl.lines import Report
from scanner_core.devices.motion import MotionState, MotionStatus


class Whereabouts:
    """The last position, from reports and from moves that were answered for; degrees of the board's work coordinates.

    `known` is False once the board may have lost its position, `homed` True once it has found its reference.
    """

    def __init__(self, axes: Axes, clock: Clock) -> None:
        self._axes, self._clock = axes, clock
        self.known, self.homed = True, False
        self.newest: MotionStatus | None = None
        """The last report; from any thread."""
        self.last: MotionStatus | None = None
        """The last report, or what a move made of it since."""
        self._settled = dict.fromkeys((X, Y, TABLE), False)
        self.heard_offset = False
        self._doubted: tuple[float, ...] | None = None

    def here(self) -> dict[int, float]:
        """Degrees by axis; nan where nothing is known."""
        last = self.last
        return dict(zip((X, Y, TABLE), (last.x_deg, last.y_deg, last.table_deg) if last else (math.nan,) * 3, strict=True))

    def delta(self, target: Target) -> dict[int, float]:
        here = self.here()
        return {axis: value - here[axis] if math.isfinite(here[axis]) else 0.0 for axis, value in target.items()}

    def detour(self, target: Target) -> dict[int, float] | None:
        """See :meth:`~scanner_core.devices.grbl.axes.Axes.detour`."""
        return self._axes.detour(self.here(), self._settled, target)

    def understood(self, report: Report) -> MotionStatus:
        """A report in degrees.  A position that it leaves out is the last one."""
        self._hear_offset(report)
        position, offset = report.position, self._axes.work_offset
        if position is not None and not report.is_work_position and len(offset) == len(position):
            position = tuple(value - shift for value, shift in zip(position, offset, strict=True))
        if position is None or len(position) < self._axes.count:
            x_deg, y_deg, table_deg = self.here().values()
        else:
            x_deg, y_deg, table_deg = self._axes.degrees(position)
        return MotionStatus(report.state, x_deg, y_deg, table_deg, report.laser_power or 0.0, self._clock.now_s(), time.monotonic())

    def _hear_offset(self, report: Report) -> None:
        """Another work offset is believed when it comes twice: it would shift every position after it, and noise makes digits."""
        if report.work_offset is not None:
            self.heard_offset = True
            heard = report.work_offset if any(report.work_offset) else ()
            if heard == self._doubted:
                self._axes.work_offset = heard
            self._doubted = None if heard == self._axes.work_offset else heard

    @property
    def doubts_offset(self) -> bool:
        """A work offset came once that was not the one before."""
        return self._doubted is not None

    def reported(self, report: Report) -> MotionStatus:
        """Take a report for what is true."""
        self.newest = self.last = self.understood(report)
        return self.newest

    def arrived(self, target: Target) -> None:
        """A move to `target` was answered for; play is taken out of axes that went up far enough."""
        here = self.here()
        for axis, value in target.items():
            climb = value - here[axis]
            self._settled[axis] = climb >= self._axes.approach(axis) or (self._settled[axis] and climb >= 0.0)
        here |= target
        if self.last is not None:
            self.last = MotionStatus(self.last.state, here[X], here[Y], here[TABLE], 0.0, self._clock.now_s())

    def disturb(self) -> None:
        """Something moved the axes otherwise, or may have: nobody knows on which side of its play they rest."""
        self._settled = dict.fromkeys(self._settled, False)

    def lose(self) -> None:
        """The board may no longer know where it is."""
        self.known = self.homed = False
        self.disturb()

    def same_place(self, a: MotionStatus, b: MotionStatus | None) -> bool:
        """Also where neither knows the place."""
        pairs = [] if b is None else [(a.x_deg, b.x_deg), (a.y_deg, b.y_deg), (a.table_deg, b.table_deg)]
        return bool(pairs) and not any(
            abs(p - q) > self._axes.same_place_deg(axis) or math.isnan(p) != math.isnan(q) for axis, (p, q) in enumerate(pairs)
        )

    def resting(self, said: MotionStatus, *before: MotionStatus | None) -> bool:
        """Whether a report can be believed at once: it moves, or rests where it was expected."""
        return said.state is not MotionState.IDLE or any(self.same_place(said, place) for place in before)
