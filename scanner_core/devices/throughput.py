"""How many frames a second a camera really delivers."""

from __future__ import annotations

import threading

from scanner_core.clock import Clock
from scanner_core.devices.camera import Camera, Trigger
from scanner_core.jobs.progress import Cancelled, IsCancelled

_LEAD_S = 0.1


def throughput(camera: Camera, seconds: float, *, clock: Clock, cancelled: IsCancelled) -> float:
    """Frames a second over a run of about `seconds`, for a camera of any driver that is open and not armed.

    It is told by the frames' own times, so a slow reader does not count against the camera but frames that it lost do.

    Raises
    ------
    DeviceError
        What the camera reports.
    Cancelled
        Within 0.5 s.
    """
    count = max(2, round(seconds * camera.rate_hz))
    stop = threading.Event()
    watch = threading.Thread(target=_watch, args=(cancelled, stop), name="throughput-cancel")
    trigger = Trigger(0, count, clock.now_s() + _LEAD_S)
    camera.start(trigger)
    watch.start()
    try:
        times = [frame.time_s for frame in camera.frames(stop)]
        stopped = stop.is_set()
    finally:
        stop.set()
        watch.join()
    if stopped:
        raise Cancelled
    return (len(times) - 1) / (times[-1] - times[0]) if len(times) > 1 else 0.0


def _watch(cancelled: IsCancelled, stop: threading.Event) -> None:
    """Frames that do not come must not keep a person waiting."""
    while not stop.wait(0.1):
        if cancelled():
            stop.set()
