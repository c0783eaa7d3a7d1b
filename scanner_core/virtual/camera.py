"""A camera of the virtual rig: it delivers rendered frames at the pace of the rig's clock."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from typing import Protocol, Self

import numpy as np
from numpy.typing import NDArray

from scanner_core.clock import Clock, Pacer
from scanner_core.devices.camera import CameraReport, Frame, Trigger
from scanner_core.devices.camera_config import TriggerSource
from scanner_core.errors import DeviceClosedError, DeviceLostError, DeviceTimeoutError
from scanner_core.virtual.disturbed import Disturbed

BUFFER_FRAMES = 16
"""Exposures that the camera holds for a slow reader; older ones are lost."""
GRAB_S = 2.0
"""After which a single frame that does not come is given up."""
_POLL_S = 0.05


class Exposer(Protocol):
    """The rig as a camera needs it: the image of an exposure that has ended, and its noise key."""

    def image(self, index: int, start_s: float, exposure_ms: float, gain: float, key: int) -> NDArray[np.uint8]: ...


class VirtualCamera:
    """See :class:`~scanner_core.devices.camera.Camera`.

    Exposure k of a run begins at ``start_s + k / rate``; its frame is there when it ends.  The camera joins the clock when
    it is armed and leaves it after the last frame, when the run is stopped and when it is closed.  A reader that falls
    behind by more than :data:`BUFFER_FRAMES` loses the oldest frames; `dropped` counts them.  Frames leave the camera
    `transfer_frames` at a time, as the driver of a fast camera hands them over.  `disturbed` knows what befalls it.
    """

    def __init__(
        self,
        name: str,
        index: int,
        size_px: tuple[int, int],
        rate_hz: float,
        exposure_ms: float,
        clock: Clock,
        exposer: Exposer,
        transfer_frames: int = 1,
        disturbed: Disturbed | None = None,
    ) -> None:
        self._name, self._index, self._size_px, self._rate_hz = name, index, size_px, rate_hz
        self._exposure_ms, self._gain_db = exposure_ms, 0.0
        self._clock, self._exposer = clock, exposer
        self._transfer_frames = transfer_frames
        self._disturbed = disturbed
        self._lock = threading.Lock()
        self._run: tuple[Trigger, Pacer, int] | None = None
        self._runs = 0
        self._grabs = 0
        self._last: NDArray[np.uint8] | None = None
        self._closed = threading.Event()
        self.dropped = 0

    @property
    def name(self) -> str:
        return self._name

    @property
    def size_px(self) -> tuple[int, int]:
        return self._size_px

    @property
    def rate_hz(self) -> float:
        return self._rate_hz

    @property
    def exposure_ms(self) -> float:
        return self._exposure_ms

    @exposure_ms.setter
    def exposure_ms(self, value: float) -> None:
        self._ensure_open()
        self._exposure_ms = float(np.clip(value, 0.01, 1e3 / self._rate_hz))

    @property
    def gain_db(self) -> float:
        return self._gain_db

    @gain_db.setter
    def gain_db(self, value: float) -> None:
        self._ensure_open()
        self._gain_db = float(np.clip(value, 0.0, 24.0))

    def start(self, trigger: Trigger) -> None:
        self._ensure_open()
        with self._lock:
            self._end_run()
            self._runs += 1
            self._run = (trigger, self._clock.pace(), self._runs)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        self._ensure_open()
        with self._lock:
            run = self._run
        if run is None:
            return
        trigger, pacer, number = run
        try:
            k = there = 0
            delay_s = 0.0
            while k < trigger.count:
                exposure_s = 1e-3 * self._exposure_ms
                start_s = trigger.start_s + k / self._rate_hz
                if k >= there:
                    there = min(k + self._transfer_frames, trigger.count)
                    last_s = trigger.start_s + (there - 1) / self._rate_hz
                    delay_s = self._delay_s(last_s)
                    if not pacer.wait_until(last_s + exposure_s + max(0.0, self._late_s(last_s)) + delay_s, stop):
                        break
                if stop.is_set() or self._closed.is_set():
                    break
                self._ensure_plugged(start_s + exposure_s)
                if self._stalled(start_s + exposure_s):
                    pacer.close()  # time goes on without it
                    while not (stop.wait(_POLL_S) or self._closed.is_set()):
                        continue
                    break
                behind = int((self._clock.now_s() - start_s - exposure_s - delay_s) * self._rate_hz + 1e-6)
                room = BUFFER_FRAMES + self._transfer_frames - 1
                if behind >= room:
                    lost = min(behind - room + 1, trigger.count - k)
                    self.dropped += lost
                    k += lost
                    continue
                trigger_id, key = trigger.first_id + k, (number << 40) + trigger.first_id + k
                k += 1
                if self._disturbed is not None and self._disturbed.drops(self._index, start_s, key):
                    self.dropped += 1
                    continue
                yield self._frame(start_s, trigger_id, key)
        finally:
            with self._lock:
                if self._run is run:
                    self._end_run()
        self._ensure_open()

    def grab(self) -> Frame:
        self._ensure_open()
        self._grabs += 1
        start_s = self._clock.now_s()
        if self._stalled(start_s):
            self._clock.wait_until(start_s + GRAB_S)
            raise DeviceTimeoutError("E-CAM-01", camera=self._name, seconds=f"{GRAB_S:.0f}")
        self._clock.wait_until(start_s + 1e-3 * self._exposure_ms)
        return self._frame(start_s, self._grabs, (1 << 60) + self._grabs)

    def report(self) -> CameraReport:
        self._ensure_open()
        return CameraReport(
            driver="virtual",
            id=f"virtual:{self._name}",
            model="camera of the virtual rig",
            size_px=self._size_px,
            rate_hz=self._rate_hz,
            pixel_format="Mono8",
            exposure_ms=self._exposure_ms,
            gain_db=self._gain_db,
            trigger=TriggerSource.SOFTWARE,
            dropped=self.dropped,
        )

    def close(self) -> None:
        with self._lock:
            self._end_run()
            self._closed.set()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _frame(self, start_s: float, trigger_id: int, key: int) -> Frame:
        gain = 10 ** (self._gain_db / 20)
        late_s = self._late_s(start_s)
        image = self._exposer.image(self._index, start_s + late_s, self._exposure_ms, gain, key)
        if self._disturbed is not None and self._disturbed.tears(self._index, start_s, key):
            self._tear(image, key)
        self._last = image
        stamped_s = 0.0 if self._disturbed is None or not self._disturbed.stamped(self._index, start_s) else late_s
        return Frame(image, trigger_id, start_s + stamped_s + 0.5e-3 * self._exposure_ms, self._name)

    def _tear(self, image: NDArray[np.uint8], key: int) -> None:
        """Below its middle it shows the frame before, or what happened to stand in the driver's memory."""
        below = image[image.shape[0] // 2 :]
        if key & 1 and self._last is not None:
            below[:] = self._last[image.shape[0] // 2 :]
        else:
            below[:] = np.random.default_rng(key).integers(0, 256, below.shape, np.uint8)

    def _delay_s(self, start_s: float) -> float:
        return 0.0 if self._disturbed is None else self._disturbed.delay_s(self._index, start_s)

    def _stalled(self, time_s: float) -> bool:
        return self._disturbed is not None and self._disturbed.stalled(self._index, time_s)

    def _late_s(self, start_s: float) -> float:
        return 0.0 if self._disturbed is None else self._disturbed.late_s(self._index, start_s, 1.0 / self._rate_hz)

    def _end_run(self) -> None:
        """With the lock held."""
        if self._run is not None:
            self._run[1].close()
            self._run = None

    def _ensure_open(self) -> None:
        if self._closed.is_set():
            raise DeviceClosedError("E-CAM-03", camera=self._name)
        self._ensure_plugged(self._clock.now_s())

    def _ensure_plugged(self, time_s: float) -> None:
        if self._disturbed is not None and self._disturbed.unplugged(self._index, time_s):
            raise DeviceLostError("E-CAM-02", camera=self._name)
