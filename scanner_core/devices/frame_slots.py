"""Frames of a camera that keeps its own time, counted into the planned exposures of a run.

The slot of a frame is its place in the run by its time.  Both cameras of a rig count from one origin, which is settled by
whichever of them delivers the first frame of the run: cameras that expose on the same edge then always agree about its
number, whatever their time stamps' jitter, and cameras that run freely are paired at most half a period apart.
"""

from __future__ import annotations

import math
import threading
from weakref import WeakKeyDictionary

from scanner_core.clock import Clock
from scanner_core.devices.camera import Trigger

JITTER = 0.25
"""How far, in periods, a frame may lie outside of its slot and still continue the count of the frame before it."""


def slot_of(time_s: float, start_s: float, rate_hz: float) -> int:
    """Number of the period of `rate_hz` that `time_s` falls into; period 0 begins at `start_s`."""
    return math.floor((time_s - start_s) * rate_hz)


class RunOrigin:
    """When a run really begins: settled once for both cameras of a rig, by the first of them that can tell.

    Parameters
    ----------
    clock : the rig's; cameras that share it belong together
    trigger : the run; both cameras are armed with the same object
    camera : name of the camera; one that is armed again begins a new run
    """

    def __init__(self, clock: Clock, trigger: Trigger, camera: str) -> None:
        self._shared = _join(clock, trigger, camera)

    def settle(self, time_s: float) -> float:
        """`time_s`, or what the other camera settled before."""
        return self._shared.settle(time_s)


class FrameSlots:
    """One camera's frames of one run of `rate_hz` planned exposures a second, the first no earlier than `start_s`.

    Cameras on one edge (not `free`) settle the origin by the first frame that counts.  Of cameras that run freely that would be
    too late: the other one's frame of the same slot may be half a period older, and gone.  So their first frame only settles
    that the run begins half a period after it; no frame of either is missing then.
    """

    def __init__(self, origin: RunOrigin, start_s: float, rate_hz: float, *, free: bool = False) -> None:
        self._origin, self._start_s, self._rate_hz, self._free = origin, start_s, rate_hz, free
        self._first: tuple[float, int] | None = None
        self._last: tuple[float, int] | None = None
        """Position and slot of the last frame."""

    def slot(self, time_s: float) -> int | None:
        """Slot of a frame whose middle of the exposure is `time_s`; None before the run begins.

        From its first frame on a camera counts by the time since then, rounded, so that jitter of less than half a period
        neither doubles nor skips a slot.  A camera that is a little faster or slower than `rate_hz` drifts to the border of two
        slots, where that would happen frame by frame; so a frame that follows its predecessor by whole periods goes on counting
        until it lies :data:`JITTER` periods outside of its slot: then one slot is doubled or skipped, and no more.
        """
        if self._first is None:
            # A frame in the middle of its slot: slots that begin no earlier than start_s hold no frame that was earlier.
            half_s = 0.5 / self._rate_hz
            if time_s < self._start_s + (0.0 if self._free else half_s):
                return None
            slot = slot_of(time_s, self._origin.settle(time_s + (half_s if self._free else -half_s)), self._rate_hz)
            if slot < 0:
                return None
            self._first = (time_s, slot)
        first_s, slot = self._first
        position = slot + (time_s - first_s) * self._rate_hz
        number = round(position)
        if self._last is not None:
            last_position, last = self._last
            following = last + round(position - last_position)
            if following > last and abs(position - following) < 0.5 + JITTER:
                number = following
        self._last = position, number
        return number


class _SharedOrigin:
    """A run's origin and the cameras that have joined it."""

    def __init__(self, trigger: Trigger) -> None:
        self.trigger = trigger
        self.cameras: set[str] = set()
        self._time_s: float | None = None
        self._lock = threading.Lock()

    def settle(self, time_s: float) -> float:
        with self._lock:
            if self._time_s is None:
                self._time_s = time_s
            return self._time_s


_origins: WeakKeyDictionary[Clock, _SharedOrigin] = WeakKeyDictionary()
_joining = threading.Lock()


def _join(clock: Clock, trigger: Trigger, camera: str) -> _SharedOrigin:
    with _joining:
        origin = _origins.get(clock)
        if origin is None or origin.trigger is not trigger or camera in origin.cameras:
            origin = _origins[clock] = _SharedOrigin(trigger)
        origin.cameras.add(camera)
        return origin
