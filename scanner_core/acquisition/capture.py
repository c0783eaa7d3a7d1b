"""The capture threads: one per camera, from frames to spots.

A thread waits for runs of exposures, evaluates each frame as it comes and posts what it saw into a bounded queue;
after the last frame of a run it posts an END marker: neither an angle nor a silence decides that a row is over.
"""

from __future__ import annotations

import queue
import threading
import time
from contextlib import suppress
from dataclasses import dataclass

import cv2

from scanner_core.acquisition.handover import LatestSlot, Preview
from scanner_core.devices.camera import Camera, Trigger
from scanner_core.errors import DeviceError
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.spot_tracking import SpotTracker
from scanner_core.optics.torn_frames import TornFrames

QUEUE_LENGTH = 256
_PATIENCE_S = 5.0
"""How long a full queue is waited for, real seconds."""
_PREVIEW_PERIOD_S = 0.05
_TORN = SpotMiss(MissReason.TORN)


@dataclass(frozen=True, slots=True)
class SpotEvent:
    """What a camera saw at a trigger id."""

    trigger_id: int
    time_s: float
    seen: Spot | SpotMiss


class RunEnd:
    """The END marker of a run of exposures."""


@dataclass(frozen=True, slots=True)
class CaptureFault:
    """The camera failed; the thread waits for the next run or its end."""

    error: BaseException


CaptureEvent = SpotEvent | RunEnd | CaptureFault


class CaptureThread:
    """One camera's thread.  ``close()`` ends and joins it."""

    def __init__(self, camera: Camera, detector: SpotDetector, preview: LatestSlot[Preview]) -> None:
        self.camera = camera
        self.events: queue.Queue[CaptureEvent] = queue.Queue(QUEUE_LENGTH)
        self._tracker = SpotTracker(detector)
        self._torn_frames = TornFrames()
        self._preview = preview
        self._runs: queue.SimpleQueue[Trigger | None] = queue.SimpleQueue()
        self._stop_run = threading.Event()
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name=f"capture-{camera.name}")
        self._thread.start()

    def arm(self, trigger: Trigger) -> None:
        """Arm the camera for a run, which waits for :meth:`expose`: so no camera runs ahead of one that is not armed yet."""
        self._stop_run.clear()
        self.camera.start(trigger)

    def expose(self, trigger: Trigger) -> None:
        """Read the frames of the run; its events follow, closed by a :class:`RunEnd`."""
        self._runs.put(trigger)

    def stop_run(self) -> None:
        """End the run now; its END marker still comes."""
        self._stop_run.set()

    def close(self, timeout_s: float = 5.0) -> None:
        """End the thread; events that nobody read are dropped."""
        self._closing.set()
        self._stop_run.set()
        self._runs.put(None)
        end_s = time.monotonic() + timeout_s
        while self._thread.is_alive() and time.monotonic() < end_s:
            try:
                self.events.get(timeout=0.02)
            except queue.Empty:
                self._thread.join(0.02)

    def _run(self) -> None:
        cv2.setNumThreads(1)
        while (trigger := self._runs.get()) is not None:
            try:
                self._follow(trigger)
                self._post(RunEnd())
            except Exception as error:  # also an unexpected fault must reach the scan, not end in this thread
                self._insist(CaptureFault(error))
                self._insist(RunEnd())

    def _follow(self, trigger: Trigger) -> None:
        shown_s = 0.0
        self._tracker.forget()  # a row begins elsewhere
        for frame in self.camera.frames(self._stop_run):
            seen = _TORN if self._torn_frames.torn(frame.image) else self._tracker.detect(frame.image)
            now_s = time.monotonic()
            if now_s - shown_s > _PREVIEW_PERIOD_S:
                self._preview.put(Preview(frame, seen))
                shown_s = now_s
            self._post(SpotEvent(frame.trigger_id, frame.time_s, seen))

    def _insist(self, event: CaptureEvent) -> None:
        """Post what must arrive: the run has failed, so of its spots the oldest can make room."""
        while True:
            try:
                self.events.put_nowait(event)
                return
            except queue.Full:
                with suppress(queue.Empty):
                    self.events.get_nowait()

    def _post(self, event: CaptureEvent) -> None:
        end_s = time.monotonic() + _PATIENCE_S
        while not self._closing.is_set():
            try:
                self.events.put(event, timeout=0.2)
                return
            except queue.Full:
                if time.monotonic() > end_s:
                    raise DeviceError("E-CAM-04", camera=self.camera.name, frames=QUEUE_LENGTH) from None
