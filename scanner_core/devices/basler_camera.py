"""Basler cameras (USB3 and GigE) through the SDK pypylon, which is the extra ``impronta[basler]``.

With a software trigger exposure k of a run is commanded at its planned time of the rig's clock, in both cameras together
(:mod:`~scanner_core.devices.basler_commands`).  A camera that runs freely or on the edges of a trigger line is counted into the
planned exposures by the times of its frames (:mod:`~scanner_core.devices.frame_slots`, :mod:`~scanner_core.devices.basler_times`).
Lost and incomplete frames are gaps, told by the camera's own frame numbers and counted.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from scanner_core.clock import Clock
from scanner_core.devices.basler_commands import CommandedCamera, join_run
from scanner_core.devices.basler_features import BaslerFeatures
from scanner_core.devices.basler_sdk import DRIVER, BaslerSdk, as_device_error, load_sdk, open_device
from scanner_core.devices.basler_settings import apply, exposure_ms, gain_db, possible_hz, select_trigger, set_exposure_ms, set_gain_db
from scanner_core.devices.basler_stream import BaslerFrame, BaslerStream
from scanner_core.devices.basler_times import BaslerTimes
from scanner_core.devices.camera import CameraReport, Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.frame_slots import FrameSlots, RunOrigin
from scanner_core.errors import DeviceClosedError, DeviceError, DeviceTimeoutError

SILENCE_S = 2.0
"""A camera that owes a frame for so long has failed; real time, beyond period and exposure."""
_ANSWER_S = 0.5
"""After its last exposure a run is over when nothing more came for so long."""
_POLL_S = 0.1
_LAST_SLOTS = 2
"""A run that lacks so few frames at its end is over when their time is."""


def open_basler(config: CameraConfig, clock: Clock) -> BaslerCamera:
    """Open the camera with the serial number `config.id` and set it.

    Raises
    ------
    DeviceError
        E-CAM-05 in use, E-CAM-06 not permitted, E-CAM-07 not there, E-CAM-08 wrong format, E-CAM-10 it does not open, E-CAM-12 no SDK,
        E-CAM-31 no such trigger line.
    """
    sdk = load_sdk()
    device = open_device(sdk, config)
    try:
        with as_device_error(sdk, device, config.name):
            return BaslerCamera(config, clock, sdk, device)
    except BaseException:
        _release(sdk, device)
        raise


@dataclass(frozen=True, slots=True, eq=False)
class _Run:
    """A run that the camera is armed for."""

    trigger: Trigger
    origin: RunOrigin
    commands: CommandedCamera | None


class BaslerCamera:
    """See :class:`~scanner_core.devices.camera.Camera`; made by :func:`open_basler`, of an open `device` of the SDK."""

    def __init__(self, config: CameraConfig, clock: Clock, sdk: BaslerSdk, device: Any) -> None:
        self._config, self._clock, self._sdk, self._device = config, clock, sdk, device
        self._features = BaslerFeatures(sdk, device)
        self._settings = apply(self._features, config)
        self._exposure_ms, self._gain_db = exposure_ms(self._features), gain_db(self._features)
        self._stream = BaslerStream(sdk, device, config.name, self._settings.size_px, clock)
        self._times = BaslerTimes(self._features, clock, self.rate_hz if config.trigger is TriggerSource.FREE else None)
        self._model = str(device.GetDeviceInfo().GetModelName())
        self._lock = threading.RLock()
        self._run: _Run | None = None
        self._closed = threading.Event()
        self._grabs = 0
        self._dropped = 0

    @property
    def name(self) -> str:
        return self._config.name

    @property
    def size_px(self) -> tuple[int, int]:
        return self._settings.size_px

    @property
    def rate_hz(self) -> float:
        return self._settings.rate_hz

    @property
    def exposure_ms(self) -> float:
        return self._exposure_ms

    @exposure_ms.setter
    def exposure_ms(self, value: float) -> None:
        with self._told():
            self._exposure_ms = set_exposure_ms(self._features, value, [])

    @property
    def gain_db(self) -> float:
        return self._gain_db

    @gain_db.setter
    def gain_db(self, value: float) -> None:
        with self._told():
            self._gain_db = set_gain_db(self._features, value, [])

    def start(self, trigger: Trigger) -> None:
        with self._told(), self._lock:
            self._end_run()
            self._times.begin()
            self._stream.begin()
            commands = join_run(self._clock, trigger, self.rate_hz, self.name, self._stream) if self._commanded else None
            self._run = _Run(trigger, RunOrigin(self._clock, trigger, self.name), commands)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        self._ensure_open()
        with self._lock:
            run = self._run
        if run is None:
            return
        try:
            with self._told():
                if run.commands is None:
                    yield from self._counted_frames(run, stop)
                else:
                    yield from self._commanded_frames(run, run.commands, stop)
        finally:
            with self._lock, suppress(DeviceError):  # what befell the camera is on its way already, or met by the next call
                if self._run is run:
                    self._end_run()
        self._ensure_open()

    def grab(self) -> Frame:
        with self._told(), self._lock:
            self._end_run()
            hardware = self._config.trigger is TriggerSource.HARDWARE
            if hardware:
                select_trigger(self._features, "Software")
            try:
                self._times.begin()
                self._stream.begin()
                commanded_s: float | None = None
                if self._commanded or hardware:
                    if not self._stream.await_ready(SILENCE_S):
                        raise self._silent()
                    commanded_s = self._clock.now_s()
                    self._stream.command()
                end_s = time.monotonic() + self._patience_s
                while (frame := self._stream.read(end_s - time.monotonic(), self._closed.is_set)) is not None:
                    if frame.image is not None:
                        self._grabs += 1
                        begun_s = self._begun_s(frame) if commanded_s is None else self._commanded_s(frame, commanded_s, self._closed)
                        return self._frame(frame.image, self._grabs, begun_s)
            finally:
                with suppress(DeviceError):
                    self._stream.end()
                    if hardware:
                        select_trigger(self._features, self._config.trigger_line)
            raise self._silent()

    def report(self) -> CameraReport:
        with self._told():
            return CameraReport(
                driver=DRIVER,
                id=self._config.id,
                model=self._model,
                size_px=self.size_px,
                rate_hz=possible_hz(self._features) or self.rate_hz,
                pixel_format=self._features.text("PixelFormat") or "",
                exposure_ms=exposure_ms(self._features),
                gain_db=gain_db(self._features),
                trigger=self._config.trigger,
                refused=self._settings.refused,
                dropped=self._dropped,
            )

    def close(self) -> None:
        if not self._closed.is_set():
            self._closed.set()
            with suppress(DeviceError):
                self._stream.end()  # wakes whoever waits for a frame and holds the lock
            with self._lock:
                self._end_run()
                _release(self._sdk, self._device)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    # ------------------------------------------------------------------------------------------ inner
    @property
    def _commanded(self) -> bool:
        return self._config.trigger is TriggerSource.SOFTWARE

    def _commanded_frames(self, run: _Run, commands: CommandedCamera, stop: threading.Event) -> Iterator[Frame]:
        commands.begin()
        heard_s = time.monotonic()
        while not (commands.ended and commands.unanswered == 0):
            frame = self._stream.read(_POLL_S, lambda: stop.is_set() or self._closed.is_set())
            if stop.is_set() or self._closed.is_set():
                return
            if commands.error is not None:
                raise commands.error
            if frame is None:
                silence_s = time.monotonic() - heard_s
                if self._clock.now_s() < run.trigger.start_s:
                    heard_s = time.monotonic()
                elif commands.ended and silence_s > _ANSWER_S + 1e-3 * self._exposure_ms:
                    break
                elif silence_s > self._patience_s:
                    raise self._silent()
                continue
            heard_s = time.monotonic()
            answer = commands.answer(frame.number)
            if answer is None:
                continue
            lost, place, commanded_s = answer
            self._dropped += lost + (frame.image is None)
            if frame.image is not None:
                begun_s = self._commanded_s(frame, commanded_s, stop)
                yield self._frame(frame.image, run.trigger.first_id + place, begun_s)
        self._dropped += commands.unanswered

    def _counted_frames(self, run: _Run, stop: threading.Event) -> Iterator[Frame]:
        slots = FrameSlots(run.origin, run.trigger.start_s, self.rate_hz, free=self._config.trigger is TriggerSource.FREE)
        last: tuple[int, float] | None = None
        heard_s = time.monotonic()
        number: int | None = None
        while True:
            frame = self._stream.read(_POLL_S, lambda: stop.is_set() or self._closed.is_set())
            if stop.is_set() or self._closed.is_set():
                return
            if frame is None:
                if self._clock.now_s() < run.trigger.start_s:
                    heard_s = time.monotonic()
                elif last is not None and self._over(run, *last):
                    return
                elif time.monotonic() - heard_s > self._patience_s:
                    raise self._silent()
                continue
            heard_s = time.monotonic()
            if number is not None and frame.number is not None:
                self._dropped += frame.number - number - 1
            number = frame.number
            if frame.image is None:
                self._dropped += 1
                continue
            begun_s = self._begun_s(frame)
            slot = slots.slot(begun_s + 0.5e-3 * self._exposure_ms)
            if slot is None or (last is not None and slot <= last[0]):
                continue
            if slot >= run.trigger.count:
                return
            last = (slot, begun_s)
            yield self._frame(frame.image, run.trigger.first_id + slot, begun_s)
            if slot == run.trigger.count - 1:
                return

    def _over(self, run: _Run, slot: int, begun_s: float) -> bool:
        """Whether the time of the last slots is past."""
        lacking = run.trigger.count - 1 - slot
        return lacking <= _LAST_SLOTS and self._clock.now_s() > begun_s + (lacking + 1) / self.rate_hz + _ANSWER_S

    def _commanded_s(self, frame: BaslerFrame, commanded_s: float, stop: threading.Event) -> float:
        """When the exposure of a commanded frame began; in simulated time it takes its time too."""
        if self._times.stamped(frame):
            return self._begun_s(frame)
        self._clock.wait_until(commanded_s + 1e-3 * self._exposure_ms, stop)
        return commanded_s

    def _begun_s(self, frame: BaslerFrame) -> float:
        return self._times.begun_s(frame, 1e-3 * self._exposure_ms)

    def _frame(self, image: NDArray[np.uint8], trigger_id: int, begun_s: float) -> Frame:
        return Frame(image, trigger_id, begun_s + 0.5e-3 * self._exposure_ms, self.name)

    @property
    def _patience_s(self) -> float:
        return SILENCE_S + 1e-3 * self._exposure_ms + 1.0 / self.rate_hz

    def _silent(self) -> DeviceError:
        if self._closed.is_set():
            return DeviceClosedError("E-CAM-03", camera=self.name)
        seconds = f"{self._patience_s:.0f}"
        if self._config.trigger is TriggerSource.HARDWARE and self._run is not None:
            return DeviceTimeoutError("E-CAM-13", camera=self.name, line=self._config.trigger_line, seconds=seconds)
        return DeviceTimeoutError("E-CAM-01", camera=self.name, seconds=seconds)

    def _end_run(self) -> None:
        """With the lock held."""
        if self._run is not None:
            commands, self._run = self._run.commands, None
            if commands is not None:
                commands.leave()
                self._dropped += commands.skipped
            self._stream.end()

    @contextmanager
    def _told(self) -> Iterator[None]:
        self._ensure_open()
        try:
            with as_device_error(self._sdk, self._device, self.name):
                yield
        except DeviceError:
            self._ensure_open()  # what fails because the camera was closed meanwhile
            raise

    def _ensure_open(self) -> None:
        if self._closed.is_set():
            raise DeviceClosedError("E-CAM-03", camera=self.name)


def _release(sdk: BaslerSdk, device: Any) -> None:
    """Whatever state it is in."""
    for step in (device.StopGrabbing, device.Close, device.DestroyDevice):
        with suppress(sdk.genicam.GenericException):
            step()
