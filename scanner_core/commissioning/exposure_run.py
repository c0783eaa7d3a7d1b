"""One run of exposures of both cameras while something moves: the spots by the number of their exposure."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.camera import Camera, Trigger
from scanner_core.errors import DeviceTimeoutError
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_detection import SpotDetector

_LEAD_S = 0.05
_SILENCE_S = 2.0
"""A camera that says nothing for so long, in real time, has failed."""
_POLL_S = 0.05
_FIRST_ID = 1


@dataclass(slots=True, eq=False)
class CameraRun:
    """What one camera delivered.

    Attributes
    ----------
    spots : by the number of the exposure, from 0
    times_s : middle of every exposure that came, by its number, on the rig's clock
    """

    spots: dict[int, Spot] = field(default_factory=dict)
    times_s: dict[int, float] = field(default_factory=dict)


def expose_run(rig: OpenRig, count: int, during: Callable[[], None], cancelled: IsCancelled) -> dict[str, CameraRun]:
    """Expose both cameras `count` times and do something meanwhile; by camera.

    Raises
    ------
    DeviceError
        What a camera or `during` reported; E-CAM-01 when a camera fell silent.  Cameras are at rest then.
    Cancelled
    """
    detector = SpotDetector(rig.config.spot)
    stop = threading.Event()
    readers = [_Reader(camera, detector, stop) for camera in (rig.left, rig.right)]
    trigger = Trigger(_FIRST_ID, count, rig.clock.now_s() + _LEAD_S)
    try:
        for reader in readers:
            reader.camera.start(trigger)
        for reader in readers:
            reader.thread.start()
        during()
        while any(reader.thread.is_alive() for reader in readers):
            if cancelled():
                raise Cancelled
            for reader in readers:
                if reader.thread.is_alive() and time.monotonic() - reader.heard_s > _SILENCE_S:
                    raise DeviceTimeoutError("E-CAM-01", camera=reader.camera.name, seconds=f"{_SILENCE_S:.0f}")
            readers[0].thread.join(_POLL_S)
            readers[1].thread.join(_POLL_S)
    finally:
        stop.set()
        for reader in readers:
            if reader.thread.ident is not None:
                reader.thread.join()
            else:
                list(reader.camera.frames(stop))  # it is armed, and a camera that nobody reads would hold the clock
    for reader in readers:
        if reader.fault is not None:
            raise reader.fault
    return {reader.camera.name: reader.run for reader in readers}


class _Reader:
    def __init__(self, camera: Camera, detector: SpotDetector, stop: threading.Event) -> None:
        self.camera, self._detector, self._stop = camera, detector, stop
        self.run = CameraRun()
        self.fault: Exception | None = None
        self.heard_s = time.monotonic()
        self.thread = threading.Thread(target=self._read, name=f"expose-{camera.name}")

    def _read(self) -> None:
        try:
            for frame in self.camera.frames(self._stop):
                self.heard_s = time.monotonic()
                number = frame.trigger_id - _FIRST_ID
                self.run.times_s[number] = frame.time_s
                seen = self._detector.detect(frame.image)
                if isinstance(seen, Spot):
                    self.run.spots[number] = seen
        except Exception as fault:  # told by who waits for this thread
            self.fault = fault
