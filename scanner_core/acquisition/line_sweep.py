"""One sweep of a laser line: both cameras expose, each frame is looked at in its camera's thread, and the pairs come out whole."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np

from scanner_core.acquisition.simultaneous import LEAST_SKEW_S
from scanner_core.devices.camera import Camera, Trigger
from scanner_core.errors import AcquisitionError, DeviceTimeoutError
from scanner_core.optics.stripe_detection import StripeDetector, StripeFrame

_SILENCE_S = 8.0
"""A camera that says nothing for so long in real time has failed."""
_POLL_S = 0.1


@dataclass(frozen=True, slots=True)
class SweptFrame:
    """What both cameras saw of the line at a trigger id; None where the frame was dropped."""

    trigger_id: int
    time_s: float
    left: StripeFrame | None
    right: StripeFrame | None


class LineSweep:
    """The exposures of one sweep.

    Parameters
    ----------
    between : called about every 0.1 s of waiting for frames (for status reports)
    """

    def __init__(self, left: Camera, right: Camera, trigger: Trigger, cancelled: threading.Event, between: Callable[[], None]) -> None:
        self._trigger, self._cancelled, self._between = trigger, cancelled, between
        self._stop = threading.Event()
        left.start(trigger)
        self._readers = [_Reader(left, self._stop)]
        try:
            right.start(trigger)
            self._readers.append(_Reader(right, self._stop))
        except BaseException:
            self._stop.set()
            self._readers[0].thread.start()  # it ends the run that the camera was armed for
            self._readers[0].thread.join()
            raise

    def frames(self) -> list[SweptFrame]:
        """All trigger ids of the sweep in their order; up to the last that came when it was cancelled.

        Raises
        ------
        DeviceError
            What a camera reported, after both have come to their end.
        AcquisitionError
            E-LINE-02: the cameras do not expose at the same instant.
        """
        for reader in self._readers:
            reader.thread.start()
        try:
            while any(reader.thread.is_alive() for reader in self._readers):
                if self._cancelled.is_set() or any(reader.fault is not None for reader in self._readers):
                    self._stop.set()
                self._between()
                for reader in self._readers:
                    reader.thread.join(0.5 * _POLL_S)
                    reader.expect_life(self._stop)
        finally:
            self._stop.set()
            for reader in self._readers:
                reader.thread.join()
        for reader in self._readers:
            if reader.fault is not None:
                raise reader.fault
        return self._paired()

    def _paired(self) -> list[SweptFrame]:
        left, right = (reader.seen for reader in self._readers)
        both = sorted(left.keys() & right.keys())
        skew_s = float(np.median([right[number][0] - left[number][0] for number in both])) if both else 0.0
        if abs(skew_s) > LEAST_SKEW_S:
            raise AcquisitionError("E-LINE-02", skew_us=f"{1e6 * skew_s:.0f}")
        last = self._trigger.first_id + self._trigger.count
        if self._cancelled.is_set():
            last = 1 + max([*left, *right], default=self._trigger.first_id - 1)
        found = []
        for number in range(self._trigger.first_id, last):
            one, other = left.get(number), right.get(number)
            time_s = next((seen[0] for seen in (one, other) if seen is not None), 0.0)
            found.append(SweptFrame(number, time_s, None if one is None else one[1], None if other is None else other[1]))
        return found


class _Reader:
    """One camera's thread over one sweep; `seen` holds time and line by trigger id."""

    def __init__(self, camera: Camera, stop: threading.Event) -> None:
        self._camera, self._stop = camera, stop
        self.seen: dict[int, tuple[float, StripeFrame]] = {}
        self.fault: Exception | None = None
        self._heard_s = time.monotonic()
        self.thread = threading.Thread(target=self._run, name=f"line-{camera.name}")

    def expect_life(self, stop: threading.Event) -> None:
        """E-CAM-01 as its fault when nothing has come for too long."""
        if self.thread.is_alive() and not stop.is_set() and time.monotonic() - self._heard_s > _SILENCE_S:
            self.fault = DeviceTimeoutError("E-CAM-01", camera=self._camera.name, seconds=f"{_SILENCE_S:.0f}")

    def _run(self) -> None:
        cv2.setNumThreads(1)
        detector = StripeDetector()
        self._heard_s = time.monotonic()
        try:
            for frame in self._camera.frames(self._stop):
                self.seen[frame.trigger_id] = frame.time_s, detector.detect(frame.image)
                self._heard_s = time.monotonic()
        except Exception as fault:  # also an unexpected one must reach the scan, not end in this thread
            self.fault = self.fault or fault
