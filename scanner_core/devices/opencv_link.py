"""The program's side of the process that reads a camera: every wait has an end."""

from __future__ import annotations

import multiprocessing
import threading
import time
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.shared_memory import SharedMemory
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.opencv_process import (
    PLACES,
    Assignment,
    Failed,
    FirstFrame,
    OpenCapture,
    Opened,
    Ready,
    Setting,
    Started,
    open_with_opencv,
    read_camera,
)

_START_S = 20.0
"""For the process to start, seconds: a third of one, but many on a machine with more to do."""
_FIRST_FRAME_S = 3.5
"""For the driver to open the camera, to set it, and to deliver its first frame, together."""
_MEASURED_S = 8.0
_ANSWER_S = 3.0
_POLL_S = 0.05
_END_S = 1.5
"""For the process to end by itself; after that it is killed."""

Answer = TypeVar("Answer", Started, Opened, FirstFrame, Ready)


@dataclass(frozen=True, slots=True, eq=False)
class StampedImage:
    """A frame: (H, W) uint8, and the middle of its exposure on ``time.monotonic``."""

    image: NDArray[np.uint8]
    middle_s: float


class LinkError(Exception):
    """The camera failed; `failed` says how, in the process's words."""

    def __init__(self, failed: Failed) -> None:
        super().__init__(failed.fault, failed.details)
        self.failed = failed


class CameraLink:
    """A camera that a process reads.  ``close()`` ends the process, also one that hangs."""

    def __init__(self, assignment: Assignment, open_capture: OpenCapture = open_with_opencv) -> None:
        """Start, open, set, see the first frame, measure.

        Raises
        ------
        LinkError
            `closed`: it does not open; `silent`; `lost`; `format`.
        """
        context = multiprocessing.get_context("spawn")
        self._control, control = context.Pipe()
        self._frames, frames = context.Pipe()
        self._lock, self._control_lock, self._close_lock = threading.Lock(), threading.Lock(), threading.Lock()
        self._closing = threading.Event()
        self._owed = 0
        """Answers of the process still to come: one that came too late is not the next one's."""
        self._failed: Failed | None = None
        self._ring: SharedMemory | None = None
        self._process = context.Process(target=read_camera, args=(control, frames, assignment, open_capture), name="camera-reader", daemon=True)
        try:
            self._process.start()
            control.close()  # only the process holds these ends now: its end closes them
            frames.close()
            self._expect(Started, _START_S, Failed("closed", "the process that reads it did not start"))
            end_s = time.monotonic() + _FIRST_FRAME_S
            self.opened = self._expect(Opened, _FIRST_FRAME_S, Failed("closed", "its driver does not answer"))
            left_s = max(0.0, end_s - time.monotonic())
            self.shape = self._expect(FirstFrame, left_s, Failed("silent", "", _FIRST_FRAME_S)).shape
            self.measured_hz = self._expect(Ready, _MEASURED_S, Failed("silent", "", _MEASURED_S)).rate_hz
            self._ring = SharedMemory(create=True, size=PLACES * self.shape[0] * self.shape[1])
            self._control.send(self._ring.name)
        except BaseException as fault:
            if self._process.pid is not None:
                self._process.kill()  # it may hang in its driver, and there is nothing to end in order yet
            self.close()
            if isinstance(fault, OSError):  # the process is gone without a word
                raise LinkError(Failed("lost", repr(fault))) from None
            raise

    def next(self, timeout_s: float) -> StampedImage | None:
        """The next frame, or None after `timeout_s` real seconds.

        Raises
        ------
        LinkError
        """
        with self._lock:
            message = self._receive(timeout_s)
            if message is None:
                return None
            place, middle_s = message
            assert self._ring is not None
            assert self._ring.buf is not None
            size = self.shape[0] * self.shape[1]
            image = np.frombuffer(self._ring.buf, np.uint8, size, place * size).reshape(self.shape).copy()
            with suppress(OSError):
                self._frames.send(place)
            return StampedImage(image, middle_s)

    def discard(self) -> None:
        """Throw away what has come so far."""
        while self.next(0.0) is not None:
            pass

    def set(self, setting: Setting) -> Setting | None:
        """Set exposure or gain; returns it as the driver has it, None when the driver does not answer, or the link is closed meanwhile.

        Raises
        ------
        LinkError
        """
        end_s = time.monotonic() + _ANSWER_S
        try:
            with self._control_lock:
                self._control.send(setting)
                self._owed += 1
                while True:
                    while not self._control.poll(_POLL_S):
                        if self._closing.is_set() or time.monotonic() > end_s:
                            return None
                    answer: Setting = self._control.recv()
                    self._owed -= 1
                    if self._owed == 0:
                        return answer
        except (EOFError, OSError):
            self.discard()  # ends at the word that the process has left
            raise LinkError(Failed("lost", "")) from None

    def close(self) -> None:
        """End the process within about two seconds, whatever its driver does; may be called again, and from any thread."""
        self._closing.set()
        with self._close_lock:
            with self._control_lock:  # its number may soon be another file's: nobody may be waiting on it
                self._control.close()
            if self._process.pid is not None:
                self._process.join(_END_S)
                if self._process.is_alive():
                    self._process.kill()
                    self._process.join(_END_S)  # a process that even the system cannot end goes when its driver returns
            with self._lock:
                self._frames.close()
                if self._ring is not None:
                    self._ring.close()
                    self._ring.unlink()
                    self._ring = None

    def _receive(self, timeout_s: float) -> Any:
        if self._failed is None:
            try:
                message = self._frames.recv() if self._frames.poll(timeout_s) else None
            except (EOFError, OSError):
                self._process.join(_END_S)
                message = Failed("lost", f"the process that read it ended with {self._process.exitcode}")
            if not isinstance(message, Failed):
                return message
            self._failed = message
        raise LinkError(self._failed)

    def _expect(self, kind: type[Answer], seconds: float, otherwise: Failed) -> Answer:
        message = self._receive(seconds)
        if not isinstance(message, kind):
            raise LinkError(otherwise)
        return message
