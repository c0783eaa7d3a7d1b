"""Where the frames of a replay come from: a recording of this program, a folder of images, or a video file."""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Trigger
from scanner_core.devices.camera_config import TriggerSource
from scanner_core.devices.recording import CameraRecording, RecordedFrame, RecordedRun, grey, read_grey
from scanner_core.errors import DeviceError

SUFFIXES = (".png", ".bmp", ".tif", ".tiff", ".pgm")
RATE_HZ = 30.0
"""Of images without a rate, when the rig file names none."""
_SAME = 1e-9


@dataclass(frozen=True, slots=True)
class SourceFrame:
    """A frame to come.

    Attributes
    ----------
    offset_s : middle of its exposure after the start of its run
    time_s : the same on the clock of the recording; None where there was none
    read : its image, (H, W) uint8
    """

    trigger_id: int
    offset_s: float
    time_s: float | None
    read: Callable[[], NDArray[np.uint8]]


class FrameSource(Protocol):
    """Frames in the order in which they are asked for.

    Everything raises :class:`DeviceError`: E-CAM-21 when it does not hold what is asked for, E-CAM-20 when it cannot be read.
    """

    @property
    def size_px(self) -> tuple[int, int]: ...

    @property
    def rate_hz(self) -> float: ...

    @property
    def about(self) -> str:
        """What it is, in words."""
        ...

    @property
    def trigger(self) -> TriggerSource:
        """What made the camera expose."""
        ...

    @property
    def dropped(self) -> int:
        """Frames of the runs so far that it does not hold."""
        ...

    def settled(self, setting: str, asked: float) -> float | None:
        """What the camera made of that value of ``exposure_ms`` or ``gain_db``; None when nobody knows."""
        ...

    def run(self, trigger: Trigger, exposure_ms: float, gain_db: float) -> Iterator[SourceFrame]:
        """The next run; refused at once when it is another one."""
        ...

    def single(self, exposure_ms: float, gain_db: float) -> SourceFrame:
        """The next single frame."""
        ...

    def close(self) -> None: ...


class RecordedFrames:
    """Of a recording: runs and single frames each in their order, and only with the settings that they were taken with."""

    def __init__(self, recording: CameraRecording, camera: str) -> None:
        self._recording, self._camera = recording, camera
        self._runs, self._singles = iter(recording.runs), iter(recording.singles)
        self._number = 0
        self.dropped = 0

    @property
    def size_px(self) -> tuple[int, int]:
        return self._recording.size_px

    @property
    def rate_hz(self) -> float:
        return self._recording.rate_hz

    @property
    def about(self) -> str:
        head = self._recording.head
        return f"recording of: {head.get('model', 'a camera')} ({head.get('driver', '')} {head.get('id', '')})"

    @property
    def trigger(self) -> TriggerSource:
        return self._recording.trigger

    def settled(self, setting: str, asked: float) -> float | None:
        return self._recording.settled.get((setting, asked))

    def run(self, trigger: Trigger, exposure_ms: float, gain_db: float) -> Iterator[SourceFrame]:
        run = next(self._runs, None)
        if run is None:
            raise self._missing(f"it ends after {self._number} runs")
        self._number += 1
        if (run.first_id, run.count) != (trigger.first_id, trigger.count):
            wanted, held = (f"{first} to {first + count - 1}" for first, count in ((trigger.first_id, trigger.count), (run.first_id, run.count)))
            raise self._missing(f"run {self._number} asks for the triggers {wanted}, and it holds {held}")
        self._expect(f"run {self._number}", (run.exposure_ms, run.gain_db), (exposure_ms, gain_db))
        return self._frames(run, self._number)

    def single(self, exposure_ms: float, gain_db: float) -> SourceFrame:
        frame = next(self._singles, None)
        if frame is None:
            raise self._missing(f"it holds {len(self._recording.singles)} single frames and no more")
        self._expect("a single frame", (frame.exposure_ms, frame.gain_db), (exposure_ms, gain_db))
        return SourceFrame(frame.trigger_id, 0.5e-3 * exposure_ms, frame.time_s, partial(self._read, frame))

    def close(self) -> None:
        pass

    def _frames(self, run: RecordedRun, number: int) -> Iterator[SourceFrame]:
        next_id = run.first_id
        for frame in run.frames:
            self.dropped += frame.trigger_id - next_id
            next_id = frame.trigger_id + 1
            yield SourceFrame(frame.trigger_id, frame.time_s - run.start_s, frame.time_s, partial(self._read, frame))
        if not run.whole:
            told = f"failed with {run.error}" if run.error else "was stopped, or broke off"
            raise self._missing(f"run {number} {told} after {len(run.frames)} frames when it was recorded")
        self.dropped += run.first_id + run.count - next_id

    def _read(self, frame: RecordedFrame) -> NDArray[np.uint8]:
        return of_size(read_grey(frame.path), self.size_px, frame.path)

    def _expect(self, what: str, recorded: tuple[float, float], asked: tuple[float, float]) -> None:
        if max(abs(a - b) for a, b in zip(recorded, asked, strict=True)) > _SAME:
            shown = [f"{exposure_ms:g} ms and {gain_db:g} dB" for exposure_ms, gain_db in (asked, recorded)]
            raise self._missing(f"{what} is asked for with {shown[0]}, and was taken with {shown[1]}")

    def _missing(self, reason: str) -> DeviceError:
        return DeviceError("E-CAM-21", path=self._recording.folder, camera=self._camera, reason=reason)


class FrameSequence:
    """Images without an index: they are counted into whatever is asked for, one after the other, at a constant rate."""

    dropped = 0
    trigger = TriggerSource.FREE

    def __init__(self, path: Path, images: Iterator[NDArray[np.uint8]], rate_hz: float, camera: str, release: Callable[[], None]) -> None:
        self._path, self._images, self._rate_hz, self._camera, self._release = path, images, rate_hz, camera, release
        self._given = 0
        self._lock = threading.Lock()  # a video must not be closed while another thread reads it
        self._ahead: NDArray[np.uint8] | None = next(images, None)  # its size is wanted before it is
        if self._ahead is None:
            release()
            raise DeviceError("E-CAM-20", path=path, reason="it holds no image")
        self._size_px = self._ahead.shape[1], self._ahead.shape[0]

    @property
    def size_px(self) -> tuple[int, int]:
        return self._size_px

    @property
    def rate_hz(self) -> float:
        return self._rate_hz

    @property
    def about(self) -> str:
        return f"images of {self._path.name}"

    def settled(self, setting: str, asked: float) -> float | None:
        return None

    def run(self, trigger: Trigger, exposure_ms: float, gain_db: float) -> Iterator[SourceFrame]:
        for k in range(trigger.count):
            image = self._next()
            yield SourceFrame(trigger.first_id + k, k / self._rate_hz + 0.5e-3 * exposure_ms, None, partial(_kept, image))

    def single(self, exposure_ms: float, gain_db: float) -> SourceFrame:
        image = self._next()
        return SourceFrame(self._given, 0.5e-3 * exposure_ms, None, partial(_kept, image))

    def close(self) -> None:
        with self._lock:
            self._release()

    def _next(self) -> NDArray[np.uint8]:
        with self._lock:
            image, self._ahead = self._ahead, None
            if image is None:
                image = next(self._images, None)
        if image is None:
            raise DeviceError("E-CAM-21", path=self._path, camera=self._camera, reason=f"it ends after {self._given} images")
        self._given += 1
        return of_size(image, self._size_px, self._path)


def image_folder(path: Path, rate_hz: float | None, camera: str) -> FrameSequence:
    """The images of a folder in the natural order of their names (2 before 10)."""
    try:
        names = sorted((entry for entry in path.iterdir() if entry.suffix.lower() in SUFFIXES and entry.is_file()), key=_natural)
    except OSError as fault:
        raise DeviceError("E-CAM-20", path=path, reason=fault.strerror or str(fault)) from fault
    return FrameSequence(path, map(read_grey, names), rate_hz or RATE_HZ, camera, lambda: None)


def video_file(path: Path, camera: str) -> FrameSequence:
    """The frames of a video file at the rate that it states."""
    capture = cv2.VideoCapture(str(path))
    if not capture.isOpened():
        capture.release()
        raise DeviceError("E-CAM-20", path=path, reason="it is no recording, no folder of images and no video that can be read")
    rate_hz = float(capture.get(cv2.CAP_PROP_FPS))
    return FrameSequence(path, _frames_of(capture), rate_hz if 0.01 <= rate_hz <= 1e5 else RATE_HZ, camera, capture.release)


def _frames_of(capture: cv2.VideoCapture) -> Iterator[NDArray[np.uint8]]:
    while capture.isOpened():
        there, image = capture.read()
        if not there:
            return
        yield grey(np.asarray(image, np.uint8))


def of_size(image: NDArray[np.uint8], size_px: tuple[int, int], path: Path) -> NDArray[np.uint8]:
    """The image, when it is as large as all the others; else E-CAM-20."""
    height, width = image.shape
    if (width, height) != size_px:
        raise DeviceError("E-CAM-20", path=path, reason=f"an image has {width} x {height} pixels, and the others have {size_px[0]} x {size_px[1]}")
    return image


def _kept(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return image


def _natural(path: Path) -> list[tuple[int, int, str]]:
    """``frame2`` before ``frame10``."""
    return [(0, int(part), "") if part.isdigit() else (1, 0, part) for part in re.split(r"(\d+)", path.name.lower()) if part]
