"""A camera that shows again what was recorded, at the pace of the rig's clock."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Self

from scanner_core.clock import Clock, Pacer
from scanner_core.devices.camera import CameraReport, Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.recording import INDEX, is_recording, read_recording
from scanner_core.devices.replay_source import FrameSource, RecordedFrames, SourceFrame, image_folder, video_file
from scanner_core.errors import DeviceClosedError, DeviceError

STOP_S = 3.0
"""A run that had been stopped when it was recorded is to be stopped again within so many seconds of real time."""
_POLL_S = 0.05
_SHORTEST_MS, _MOST_DB = 0.01, 24.0


def open_replay(config: CameraConfig, clock: Clock) -> ReplayCamera:
    """The camera ``driver = "replay"`` of a rig file.

    Its id is a folder that was recorded (of the rig, or of this camera), a folder of images, or a video file.

    Raises
    ------
    DeviceError
        E-CAM-20.
    """
    path = Path(config.id)
    if is_recording(path):
        source: FrameSource = RecordedFrames(read_recording(path / config.name), config.name)
    elif (path / INDEX).is_file():
        source = RecordedFrames(read_recording(path), config.name)
    elif path.is_dir():
        source = image_folder(path, config.rate_hz, config.name)
    elif path.is_file():
        source = video_file(path, config.name)
    else:
        raise DeviceError("E-CAM-20", path=path, reason="there is no such folder or file")
    return ReplayCamera(config, source, clock)


class ReplayCamera:
    """See :class:`~scanner_core.devices.camera.Camera`.

    A frame comes when its exposure would have ended, counted from the start of the run, and a slow reader loses none.  It bears
    the time that it was recorded at, so that what is measured again is the same to the last bit.  Where the source holds
    nothing for what is asked for, E-CAM-21 is raised; never do other frames come instead.
    """

    def __init__(self, config: CameraConfig, source: FrameSource, clock: Clock) -> None:
        self._name, self._id = config.name, config.id
        self._source, self._clock = source, clock
        self._exposure_ms = self._gain_db = 0.0
        self._lock = threading.Lock()
        self._run: tuple[Trigger, Pacer, Iterator[SourceFrame]] | None = None
        self._closed = threading.Event()
        self.exposure_ms, self.gain_db = config.exposure_ms, config.gain_db

    @property
    def name(self) -> str:
        return self._name

    @property
    def size_px(self) -> tuple[int, int]:
        return self._source.size_px

    @property
    def rate_hz(self) -> float:
        return self._source.rate_hz

    @property
    def exposure_ms(self) -> float:
        return self._exposure_ms

    @exposure_ms.setter
    def exposure_ms(self, value: float) -> None:
        self._ensure_open()
        settled = self._source.settled("exposure_ms", float(value))
        self._exposure_ms = min(max(float(value), _SHORTEST_MS), 1e3 / self.rate_hz) if settled is None else settled

    @property
    def gain_db(self) -> float:
        return self._gain_db

    @gain_db.setter
    def gain_db(self, value: float) -> None:
        self._ensure_open()
        settled = self._source.settled("gain_db", float(value))
        self._gain_db = min(max(float(value), 0.0), _MOST_DB) if settled is None else settled

    def start(self, trigger: Trigger) -> None:
        self._ensure_open()
        with self._lock:
            self._end_run()
            frames = self._source.run(trigger, self._exposure_ms, self._gain_db)
            self._run = (trigger, self._clock.pace(), frames)

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        self._ensure_open()
        with self._lock:
            run = self._run
        if run is None:
            return
        trigger, pacer, frames = run
        try:
            for frame in frames:
                if not pacer.wait_until(trigger.start_s + frame.offset_s + 0.5e-3 * self._exposure_ms, stop):
                    break
                yield self._frame(frame, trigger.start_s)
        except DeviceError as fault:
            if fault.code != "E-CAM-21":
                raise
            pacer.close()  # time goes on: it must not stand still for a run that is over
            if not self._stopped_soon(stop):
                raise
        finally:
            with self._lock:
                if self._run is run:
                    self._end_run()
        self._ensure_open()

    def grab(self) -> Frame:
        self._ensure_open()
        frame = self._source.single(self._exposure_ms, self._gain_db)
        start_s = self._clock.now_s()
        self._clock.wait_until(start_s + 1e-3 * self._exposure_ms)
        return self._frame(frame, start_s)

    def report(self) -> CameraReport:
        self._ensure_open()
        return CameraReport(
            driver="replay",
            id=self._id,
            model=self._source.about,
            size_px=self.size_px,
            rate_hz=self.rate_hz,
            pixel_format="Mono8",
            exposure_ms=self._exposure_ms,
            gain_db=self._gain_db,
            trigger=self._source.trigger,
            dropped=self._source.dropped,
        )

    def close(self) -> None:
        with self._lock:
            self._end_run()
            if not self._closed.is_set():
                self._closed.set()
                self._source.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _frame(self, frame: SourceFrame, start_s: float) -> Frame:
        return Frame(frame.read(), frame.trigger_id, start_s + frame.offset_s if frame.time_s is None else frame.time_s, self._name)

    def _stopped_soon(self, stop: threading.Event) -> bool:
        """The consumer may not have got as far yet as it had when it stopped the run."""
        end_s = time.monotonic() + STOP_S
        while not self._closed.is_set() and time.monotonic() < end_s:
            if stop.wait(_POLL_S):
                return True
        return self._closed.is_set()

    def _end_run(self) -> None:
        """With the lock held."""
        if self._run is not None:
            self._run[1].close()
            self._run = None

    def _ensure_open(self) -> None:
        if self._closed.is_set():
            raise DeviceClosedError("E-CAM-03", camera=self._name)
