"""The process that reads a camera through OpenCV.

A read of a camera can hang in its driver, and then no thread of this program could be ended, nor the camera be opened
again before the program has: so the driver runs in a process of its own, which can be killed, and with it the system takes
the camera back.  It also decodes in parallel with the evaluation.  It ends when the program does, whatever ends that.

It writes frames into a ring of shared memory and says over a pipe which place of the ring holds which instant; places
come back when they have been read.  While none is free frames are taken from the camera and thrown away, so that the
next one is always a fresh one.
"""

from __future__ import annotations

import os
import queue
import signal
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.luminance import luminance
from scanner_core.devices.opencv_settings import Capture, Taken, Wanted, set_exposure, set_gain, set_up, take_jpegs

PLACES = 16
READ_TIMEOUT_S = 2.0
OPEN_TIMEOUT_S = 3.0
_SECONDS_MEASURED = 1.0
_MOST_MEASUREMENTS = 3
_WARM_UP_FRAMES = 3
"""The first ones come from buffers that filled while the camera was set."""
_ENOUGH = 0.9
"""Of the wanted rate; a camera that falls short may only have been disturbed, and gets another chance."""
_MOST_FAILURES = 10
_FAILURE_PAUSE_S = 0.02
_RELEASE_S = 1.0
_OLDEST_S = 1.0
"""A driver's time stamp that is older, or of the future, is of another clock."""

Source = str | int
OpenCapture = Callable[[Source], Capture]
Fault = Literal["lost", "silent", "format", "closed"]


@dataclass(frozen=True, slots=True)
class Assignment:
    """What the process shall read: `source` for OpenCV, `node` whose absence means that it was unplugged.

    `measure` is off where a camera is only looked at.
    """

    source: Source
    node: Path | None
    wanted: Wanted
    measure: bool = True


class Started:
    """The process runs, and turns to the camera."""


@dataclass(frozen=True, slots=True)
class Opened:
    """The camera is open and set."""

    taken: Taken
    backend: str


@dataclass(frozen=True, slots=True)
class FirstFrame:
    """The first frame came; the ring's name is awaited."""

    shape: tuple[int, int]


@dataclass(frozen=True, slots=True)
class Ready:
    """The camera delivers; `rate_hz` as measured, 0 when it was not."""

    rate_hz: float


@dataclass(frozen=True, slots=True)
class Failed:
    """It does not, or no longer."""

    fault: Fault
    details: str
    seconds: float = READ_TIMEOUT_S
    """How long a silent one was waited for."""


@dataclass(frozen=True, slots=True)
class Setting:
    """A request to set exposure or gain, and the answer to it: as the driver has it."""

    name: Literal["exposure_ms", "gain_db"]
    value: float
    refused: tuple[str, ...] = ()


def open_with_opencv(source: Source) -> Capture:
    """A node (its path), a stream (its URL) or, on Windows and macOS, a number."""
    if isinstance(source, int):
        return cv2.VideoCapture(source, cv2.CAP_DSHOW if os.name == "nt" else cv2.CAP_ANY)
    if "://" not in source:
        return cv2.VideoCapture(source, cv2.CAP_V4L2)
    timeouts = [cv2.CAP_PROP_OPEN_TIMEOUT_MSEC, round(1e3 * OPEN_TIMEOUT_S), cv2.CAP_PROP_READ_TIMEOUT_MSEC, round(1e3 * READ_TIMEOUT_S)]
    return cv2.VideoCapture(source, cv2.CAP_FFMPEG, timeouts)


def read_camera(control: Connection, frames: Connection, assignment: Assignment, open_capture: OpenCapture) -> None:
    """The process: open, set, measure, then deliver until `control` is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches the whole group; the program decides what it means
    with suppress(OSError):  # what drivers print belongs to nobody's result
        silence = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silence, 1)
        os.dup2(silence, 2)
    os.environ["OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT"] = str(round(READ_TIMEOUT_S))
    os.environ["OPENCV_FFMPEG_CAPTURE_OPTIONS"] = "rtsp_transport;tcp|fflags;nobuffer"
    cv2.setNumThreads(1)
    reader = _Reader(control, frames, assignment)
    threading.Thread(target=reader.listen, name="program-watch", daemon=True).start()
    with suppress(OSError):  # the program is gone
        reader.run(open_capture)
    os._exit(0)  # the ring is still mapped, which the interpreter's own end would complain about


class _FaultError(Exception):
    def __init__(self, fault: Fault, details: str = "") -> None:
        super().__init__(fault, details)
        self.failed = Failed(fault, details)


class _Reader:
    def __init__(self, control: Connection, frames: Connection, assignment: Assignment) -> None:
        self._control, self._frames, self._assignment = control, frames, assignment
        self._requests: queue.SimpleQueue[Setting | str] = queue.SimpleQueue()
        self._ending = threading.Event()
        self._free = deque(range(PLACES))
        self._backend = ""
        self._exposure_s = 0.0
        self._period_s = self._middle_s = 0.0

    def listen(self) -> None:
        """In a thread: pass requests on; end this process with the program, even while the driver hangs."""
        with suppress(EOFError, OSError):
            while True:
                self._requests.put(self._control.recv())
        self._ending.set()
        time.sleep(_RELEASE_S)
        os._exit(1)

    def run(self, open_capture: OpenCapture) -> None:
        self._frames.send(Started())
        try:
            capture = open_capture(self._assignment.source)
            try:
                if not capture.isOpened():
                    raise _FaultError("closed")
                self._serve(capture)
            finally:
                capture.release()
        except _FaultError as fault:
            self._frames.send(fault.failed)
        except Exception as fault:  # of OpenCV, which raises what its drivers throw: nobody else would see it
            self._frames.send(Failed("lost", repr(fault)))

    def _serve(self, capture: Capture) -> None:
        self._backend = capture.getBackendName()
        taken = set_up(capture, self._assignment.wanted)
        self._exposure_s = 1e-3 * taken.exposure_ms
        self._frames.send(Opened(taken, self._backend))
        take_jpegs(capture, taken)
        first = self._next(capture)
        self._frames.send(FirstFrame((first.shape[0], first.shape[1])))
        rate_hz = self._measure(capture) if self._assignment.measure else 0.0
        self._period_s = 1.0 / (rate_hz or taken.rate_hz or 30.0)
        self._frames.send(Ready(rate_hz))
        name = self._requests.get()
        assert isinstance(name, str)
        ring = SharedMemory(name)
        assert ring.buf is not None
        images = np.frombuffer(ring.buf, np.uint8, PLACES * first.size).reshape(PLACES, *first.shape)
        while not self._ending.is_set():
            self._take_back()
            while not self._requests.empty():
                self._set(capture, self._requests.get())
            if not self._free:
                self._grab(capture)
                continue
            image = self._next(capture)
            if image.shape != first.shape:
                raise _FaultError("format", f"the size changed to {image.shape[1]} x {image.shape[0]} pixels")
            place = self._free.popleft()
            np.copyto(images[place], image)
            self._frames.send((place, self._middle_s))

    def _next(self, capture: Capture) -> NDArray[np.uint8]:
        """The image of the next frame that is whole."""
        for _ in range(_MOST_FAILURES):
            self._grab(capture)
            taken, frame = capture.retrieve()
            if taken and frame is not None:
                try:
                    image = luminance(frame)
                except ValueError as fault:
                    raise _FaultError("format", str(fault)) from None
                if image is not None:
                    return image
        raise _FaultError("format", f"{_MOST_FAILURES} frames could not be decoded, one after the other")

    def _grab(self, capture: Capture) -> None:
        """Take the next frame from the camera, and remember its time."""
        failures = 0
        while not self._ending.is_set():
            began_s = time.monotonic()
            if capture.grab():
                self._middle_s = self._stamp_s(capture) - 0.5 * self._exposure_s
                return
            if self._assignment.node is not None and not self._assignment.node.exists():
                raise _FaultError("lost", f"{self._assignment.node} is gone")
            if time.monotonic() - began_s > 0.8 * READ_TIMEOUT_S:
                if self._backend == "FFMPEG":  # a stream that was given up does not come back
                    raise _FaultError("silent")
                continue
            failures += 1
            if failures == _MOST_FAILURES:
                raise _FaultError("lost", f"{failures} reads failed, one after the other")
            time.sleep(_FAILURE_PAUSE_S)
        raise _FaultError("lost", "the program closed it")

    def _measure(self, capture: Capture) -> float:
        """Frames a second over one second; of a camera that falls short the best of three."""
        for _ in range(_WARM_UP_FRAMES):
            self._next(capture)
        wanted_hz = self._assignment.wanted.rate_hz
        best_hz = 0.0
        for _ in range(_MOST_MEASUREMENTS):
            start_s, seconds, count = time.monotonic(), 0.0, 0
            while seconds < _SECONDS_MEASURED:
                self._next(capture)
                count += 1
                seconds = time.monotonic() - start_s
            best_hz = max(best_hz, count / seconds)
            if wanted_hz is None or best_hz >= _ENOUGH * wanted_hz:
                break
        return best_hz

    def _stamp_s(self, capture: Capture) -> float:
        """End of the last frame's exposure on ``time.monotonic``.

        The Linux driver for USB cameras stamps a frame's first packet with that very clock; it leaves when the exposure has ended.
        Elsewhere only the arrival of the last packet is known: reading the sensor out and sending the frame takes about one period.
        """
        now_s = time.monotonic()
        if self._backend == "V4L2" and 0.0 <= now_s - (stamp_s := 1e-3 * capture.get(cv2.CAP_PROP_POS_MSEC)) < _OLDEST_S:
            return stamp_s
        return now_s - self._period_s

    def _take_back(self) -> None:
        while self._frames.poll():
            self._free.append(self._frames.recv())

    def _set(self, capture: Capture, request: Setting | str) -> None:
        assert isinstance(request, Setting)
        has, refused = (set_exposure if request.name == "exposure_ms" else set_gain)(capture, request.value)
        if request.name == "exposure_ms":
            self._exposure_s = 1e-3 * has
        self._control.send(Setting(request.name, has, tuple(refused)))
