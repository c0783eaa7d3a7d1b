"""Which planned measurement a frame of a free-running camera shows: told by its time."""

from __future__ import annotations

import math

from scanner_core.devices.camera import Trigger

JITTER = 0.25
"""How far, in periods, a frame may lie outside of its slot and still continue the count of the frame before it."""


class FrameSlots:
    """Counts the frames of one run into its trigger ids.

    Slot k of a run lasts from ``start_s + k / rate_hz`` for one period; a frame belongs to the slot in which the middle of
    its exposure lies.  A camera whose frames fall near the border of two slots would, with the jitter of its time stamps,
    skip one slot and fill the next twice: so a frame that follows its predecessor by a whole number of periods continues
    the count as long as it lies within :data:`JITTER` periods of that slot.  A camera that is a little faster or slower
    than `rate_hz` drifts out of that and is counted anew: a slot stays empty, or a frame is left out.
    """

    def __init__(self, trigger: Trigger, rate_hz: float) -> None:
        self._trigger, self._rate_hz = trigger, rate_hz
        self._last = -1
        self._last_position: float | None = None
        self.missing = 0
        """Slots that were passed over so far."""

    def trigger_id(self, time_s: float) -> int | None:
        """The id of the frame whose exposure has its middle at `time_s`; None of one that fits into no slot of the run."""
        position = (time_s - self._trigger.start_s) * self._rate_hz
        slot = self._slot(position)
        if slot <= self._last:  # before the run, twice in a slot, or an old frame again
            return None
        self.missing += min(slot, self._trigger.count) - self._last - 1
        self._last, self._last_position = slot, position
        return self._trigger.first_id + slot if slot < self._trigger.count else None

    @property
    def ended(self) -> bool:
        """Whether no slot is left."""
        return self._last >= self._trigger.count - 1

    def _slot(self, position: float) -> int:
        if self._last_position is not None:
            following = self._last + round(position - self._last_position)
            if following > self._last and -JITTER <= position - following <= 1.0 + JITTER:
                return following
        return math.floor(position)
