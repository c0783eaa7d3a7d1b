"""When the frames of a Basler camera were exposed, on the rig's clock."""

from __future__ import annotations

from scanner_core.clock import Clock
from scanner_core.devices.basler_features import BaslerFeatures
from scanner_core.devices.basler_stream import BaslerFrame
from scanner_core.devices.tick_clock import TickClock

_READINGS = 5
_FURTHEST_S = 10.0
"""A frame arrives no later than this after its exposure has begun."""


class BaslerTimes:
    """The camera's counter on the rig's clock, and what stands in for it.

    A frame is stamped with the camera's counter when its exposure begins; the counter is read at the start of every run.
    A camera whose counter cannot be read is bounded by the arrival of its frames: their times are late by readout and
    transfer.  One that stamps nothing (the SDK's emulation) is counted by the numbers of its frames while it runs freely,
    and by their arrival where it is triggered.

    Parameters
    ----------
    free_hz : its rate while it runs freely; None where it is triggered
    """

    def __init__(self, features: BaslerFeatures, clock: Clock, free_hz: float | None) -> None:
        self._features, self._clock, self._free_hz = features, clock, free_hz
        self._counter = TickClock(features.number("GevTimestampTickFrequency") or 1e9)
        self._readable = False
        self._numbers: TickClock | None = None

    def begin(self) -> None:
        """A run begins: read the counter, the quickest of a few readings."""
        self._numbers = None if self._free_hz is None else TickClock(self._free_hz)
        best: tuple[float, float, float] | None = None
        for _ in range(_READINGS):
            before_s = self._clock.now_s()
            if not self._features.execute("TimestampLatch", "GevTimestampControlLatch"):
                return
            after_s = self._clock.now_s()
            ticks = self._features.number("TimestampLatchValue", "GevTimestampValue")
            if ticks is not None and (best is None or after_s - before_s < best[0]):
                best = (after_s - before_s, ticks, 0.5 * (before_s + after_s))
        if best is not None:
            self._counter.read(best[1], best[2])
            self._readable = True

    def begun_s(self, frame: BaslerFrame, exposure_s: float) -> float:
        """When the exposure of a frame began."""
        latest_s = frame.arrived_s - exposure_s
        if self.stamped(frame):
            return self._counter.time_s(frame.ticks)
        if frame.ticks and not self._readable:
            return self._counter.not_after(frame.ticks, latest_s)
        if self._numbers is not None and frame.number is not None:
            return self._numbers.not_after(frame.number, latest_s)
        return latest_s

    def stamped(self, frame: BaslerFrame) -> bool:
        """Whether the camera itself tells when; a stamp far from the arrival is of another counter than the one that was read."""
        return self._readable and frame.ticks > 0 and abs(frame.arrived_s - self._counter.time_s(frame.ticks)) < _FURTHEST_S
