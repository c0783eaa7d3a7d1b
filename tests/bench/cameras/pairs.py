"""Points and pace of recorded stereo pairs, from memory or through cameras, by the scan's own threads, pairing and engine."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.engine import StereoEngine
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.acquisition.plan import Row
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.case.observation import MEASURED
from scanner_core.clock import Clock
from scanner_core.devices.camera import Camera, Frame, Trigger
from scanner_core.devices.rig import RigConfig
from scanner_core.devices.wrapped_camera import WrappedCamera
from scanner_core.optics.spot_detection import SpotDetector
from tests.core.devices.recorded_runs import RecordedRuns


@dataclass(slots=True, eq=False)
class Measured:
    """What came of a number of pairs.

    Attributes
    ----------
    points : by trigger id, mm
    exposed : trigger ids that both cameras delivered
    wall_s : from arming to the last verdict
    camera_s, thread_s : time of the processor in the driver, and in the capture threads as a whole, both cameras
    """

    points: dict[int, NDArray[np.float64]] = field(default_factory=dict)
    exposed: int = 0
    wall_s: float = 0.0
    camera_s: float = 0.0
    thread_s: float = 0.0


class MemoryCamera:
    """Frames of the runs as arrays, as fast as they are taken."""

    def __init__(self, name: str, size_px: tuple[int, int], rate_hz: float, runs: RecordedRuns) -> None:
        self.name, self.size_px, self.rate_hz, self._runs = name, size_px, rate_hz, runs
        self._images: list[NDArray[np.uint8]] = []
        self._trigger = Trigger(0, 0, 0.0)

    def prepare(self, row: Row) -> None:
        """Read a run's files, which is no part of what is measured."""
        self._images = self._runs.images(self.name, row)

    def start(self, trigger: Trigger) -> None:
        self._trigger = trigger

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        for k, image in enumerate(self._images):
            yield Frame(image, self._trigger.first_id + k, self._trigger.start_s + k / self.rate_hz, self.name)


class TimedCamera(WrappedCamera):
    """Adds up the time of the processor that its thread spends in the driver, and altogether."""

    def __init__(self, camera: Camera) -> None:
        super().__init__(camera)
        self.camera_s = self.thread_s = 0.0

    def frames(self, stop: threading.Event) -> Iterator[Frame]:
        begin_s = asked_s = time.thread_time()
        for frame in super().frames(stop):
            self.camera_s += time.thread_time() - asked_s
            yield frame
            asked_s = time.thread_time()
        self.camera_s += time.thread_time() - asked_s
        self.thread_s += time.thread_time() - begin_s


def measure(config: RigConfig, clock: Clock, cameras: tuple[TimedCamera, TimedCamera], rows: Iterator[Row]) -> Measured:
    """Scan the rows; what prepares a row is the iterator's, and not timed."""
    assert config.calibration is not None
    detector, engine = SpotDetector(config.spot), StereoEngine(config.calibration, config.volume, config.spot.floor_px)
    captures = [CaptureThread(camera, detector, LatestSlot()) for camera in cameras]
    found = Measured()
    try:
        for row in rows:
            begin_s = time.perf_counter()
            scan = RowScan(captures[0], captures[1], row, clock.now_s(), threading.Event(), lambda: None)
            for pairs in scan.batches():
                seen = engine.evaluate(pairs, 0, 0.0)
                found.exposed += sum(pair.left is not None and pair.right is not None for pair in pairs)
                ids = [observation.trigger_id for observation in seen.observations if observation.verdict == MEASURED]
                found.points.update(zip(ids, seen.points, strict=True))
            found.wall_s += time.perf_counter() - begin_s
    finally:
        for capture in captures:
            capture.close()
    found.camera_s, found.thread_s = (sum(getattr(camera, name) for camera in cameras) for name in ("camera_s", "thread_s"))
    return found


def difference_um(first: Measured, second: Measured) -> float:
    """Largest distance of two points of one trigger id."""
    common = first.points.keys() & second.points.keys()
    return max((1e3 * float(np.linalg.norm(first.points[k] - second.points[k])) for k in common), default=float("nan"))
