"""Time, injected: the same code runs at the speed of the light and of the motors, or as fast as it can compute.

Real devices and a virtual rig at speed 1 or 5 live on a :class:`ScaledClock`.  At speed ``max`` they live on a
:class:`SteppedClock`, a small discrete-event simulation: whoever paces the rig (an armed camera) joins the clock,
and time jumps to the earliest wake-up as soon as all who joined are waiting.  A consumer that is still computing
therefore holds time still, no frame is lost to slowness, and a run gives the same result whatever the machine's load.
Who waits without having joined (a driver that waits for the end of a move) is woken in its turn but holds nobody up.
"""

from __future__ import annotations

import threading
import time
from typing import Literal, Protocol

Speed = Literal["max"] | float

_POLL_S = 0.05
"""How often a waiting thread looks at its stop flag, in real seconds."""


class Pacer(Protocol):
    """One who paces the clock, from the call of :meth:`Clock.pace` until ``close()``."""

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        """Wait until `time_s`; False when `stop` was set first, or the pacer was closed."""
        ...

    def close(self) -> None:
        """Pace no longer, and let go whoever waits; from any thread, may be called again."""
        ...


class Clock(Protocol):
    """Seconds since some origin, and ways to wait for them."""

    def now_s(self) -> float:
        """The current time in seconds; never goes back."""
        ...

    def sleep(self, duration_s: float) -> None:
        """Wait for `duration_s` seconds of this clock."""
        ...

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        """Wait until `time_s`, pacing nobody; False when `stop` was set first."""
        ...

    def pace(self) -> Pacer:
        """Join: from now on time does not pass the returned pacer unless it waits, whatever thread that is in."""
        ...


class ScaledClock:
    """Real time, `speed` times as fast.

    `origin_s` is the value of ``time.monotonic()`` (one clock for all processes of a machine) at which it shows 0; two
    processes that share it agree about the time.
    """

    def __init__(self, speed: float = 1.0, origin_s: float | None = None) -> None:
        self.speed = speed
        self.origin_s = time.monotonic() if origin_s is None else origin_s

    def now_s(self) -> float:
        return (time.monotonic() - self.origin_s) * self.speed

    def sleep(self, duration_s: float) -> None:
        time.sleep(max(0.0, duration_s) / self.speed)

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        left_s = max(0.0, (time_s - self.now_s()) / self.speed)
        if stop is not None:
            return not stop.wait(left_s)
        time.sleep(left_s)
        return True

    def pace(self) -> Pacer:
        return _FreePacer(self)


class _FreePacer:
    """Real time waits for nobody."""

    def __init__(self, clock: ScaledClock) -> None:
        self._clock = clock
        self._closed = threading.Event()

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        step_s = _POLL_S * self._clock.speed
        while not self._closed.is_set():
            if (now_s := self._clock.now_s()) + step_s >= time_s:
                return self._clock.wait_until(time_s, stop) and not self._closed.is_set()
            if not self._clock.wait_until(now_s + step_s, stop):
                return False
        return False

    def close(self) -> None:
        self._closed.set()


class SteppedClock:
    """Simulated time that jumps from event to event."""

    def __init__(self) -> None:
        self._now_s = 0.0
        self._changed = threading.Condition()
        self._pacers: set[object] = set()
        self._wake_ups: dict[object, float] = {}

    def now_s(self) -> float:
        with self._changed:
            return self._now_s

    def sleep(self, duration_s: float) -> None:
        self.wait_until(self.now_s() + max(0.0, duration_s))

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        return self._wait(object(), time_s, stop)

    def pace(self) -> Pacer:
        pacer = _SteppedPacer(self)
        with self._changed:
            self._pacers.add(pacer)
        return pacer

    def _wait(self, who: object, time_s: float, *ends: threading.Event | None) -> bool:
        """Until `time_s`; False when one of `ends` is set first."""
        with self._changed:
            if time_s > self._now_s:
                self._wake_ups[who] = time_s
                try:
                    self._advance()
                    while self._now_s < time_s:
                        if _any_set(ends):
                            return False
                        self._changed.wait(_POLL_S)
                        self._advance()
                finally:
                    del self._wake_ups[who]
        return not _any_set(ends)

    def _leave(self, pacer: object) -> None:
        with self._changed:
            self._pacers.discard(pacer)
            self._advance()

    def _advance(self) -> None:
        """Jump to the earliest wake-up if everybody who paces waits for a time still to come."""
        pending = {who: at for who, at in self._wake_ups.items() if at > self._now_s}
        if pending and self._pacers <= pending.keys():
            self._now_s = min(pending.values())
            self._changed.notify_all()


class _SteppedPacer:
    def __init__(self, clock: SteppedClock) -> None:
        self._clock = clock
        self._closed = threading.Event()

    def wait_until(self, time_s: float, stop: threading.Event | None = None) -> bool:
        return self._clock._wait(self, time_s, stop, self._closed)

    def close(self) -> None:
        self._closed.set()
        self._clock._leave(self)


def _any_set(events: tuple[threading.Event | None, ...]) -> bool:
    return any(event is not None and event.is_set() for event in events)


def make_clock(speed: Speed) -> Clock:
    """The clock for a virtual rig that runs at `speed` times real time, or as fast as it can (``"max"``)."""
    return SteppedClock() if speed == "max" else ScaledClock(float(speed))
