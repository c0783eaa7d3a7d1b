"""Observes the spot of a standing beam: the beam does not move, both cameras are triggered over and over.

The controller switches a standing laser off by itself after a while, whatever the program does; the observation is
therefore made in blocks, each of which asks for the laser again.
"""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.capture import CaptureThread
from scanner_core.acquisition.engine import StereoEngine
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.acquisition.plan import Row
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.row_scan import RowScan
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.errors import CalibrationError
from scanner_core.optics.spot_detection import SpotDetector

Array = NDArray[np.float64]

_BLOCK_S = 10.0
"""Of the rig's time; a block is over long before the controller's timer switches the laser off."""

_STATUS_PERIOD_S = 0.2

OnPairs = Callable[[int], None]
"""Told how many pairs were evaluated since the last call."""


@dataclass(slots=True, eq=False)
class SpotRecord:
    """What was seen of standing spots, in the order of time; it grows while the test runs.

    Attributes
    ----------
    rows : one a measured pair: place of the beam; number of the stay; time in s on the rig's clock; the point's x, y, z in mm, object frame at
        the table's angle of that moment; left x, y, right x, y in px; the spots' sigmas in the same order; peaks left and
        right in DN
    rejected : reason -> count
    """

    rows: list[tuple[float, ...]] = field(default_factory=list)
    rejected: Counter[str] = field(default_factory=Counter)

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def exposed(self) -> int:
        """Pairs of both kinds."""
        return len(self.rows) + self.rejected.total()


class StandingSpot:
    """The beam at rest on a surface, before both cameras.  A context manager: leaving it, the laser is off."""

    def __init__(self, rig: OpenRig) -> None:
        """
        Raises
        ------
        CalibrationError
            E-CAL-02 when the rig has none.
        """
        if rig.calibration is None:
            raise CalibrationError("E-CAL-02")
        self._rig = rig
        self._engine = StereoEngine(rig.calibration, rig.config.volume, rig.config.spot.floor_px)
        self.table_deg = rig.motion.status().table_deg
        """Where the table stands; to be set anew by who turns it."""
        detector = SpotDetector(rig.config.spot)
        self._captures = [CaptureThread(camera, detector, LatestSlot()) for camera in (rig.left, rig.right)]
        self._next_id = 0
        self._stay = -1
        self._never = threading.Event()
        self._asked_s = 0.0

    def observe(self, record: SpotRecord, place: int, x_deg: float, y_deg: float, count: int, told: OnPairs) -> None:
        """Point the beam and add `count` pairs to the record; the laser is off afterwards, also when it was interrupted."""
        block = max(1, int(_BLOCK_S * self._rig.left.rate_hz))
        self._stay += 1
        self._rig.motion.aim(x_deg, y_deg)
        try:
            for first in range(0, count, block):
                self._rig.motion.laser(True)
                self._expose(record, place, Row(0, self._next_id, min(block, count - first), y_deg, x_deg, x_deg), told)
        finally:
            self._rig.motion.laser(False)

    def close(self) -> None:
        """End the capture threads; the laser is off."""
        for capture in self._captures:
            capture.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def _look_after(self) -> None:
        """A lit laser wants to be asked about: an open lid, a lost controller and an owner that hangs are noticed by that."""
        if time.monotonic() - self._asked_s > _STATUS_PERIOD_S:
            self._confirm()

    def _confirm(self) -> None:
        self._rig.motion.status()
        self._asked_s = time.monotonic()

    def _expose(self, record: SpotRecord, place: int, row: Row, told: OnPairs) -> None:
        self._next_id += row.count
        scan = RowScan(self._captures[0], self._captures[1], row, self._rig.clock.now_s(), self._never, self._look_after, self._confirm)
        told_s, waiting = time.monotonic(), 0
        try:
            for pairs in scan.batches():
                seen = self._engine.evaluate(pairs, row.view, self.table_deg)
                _add(record, place, self._stay, seen.observations, seen.points)
                waiting += len(pairs)
                if time.monotonic() - told_s > 0.1:
                    told(waiting)
                    told_s, waiting = time.monotonic(), 0
        except BaseException:
            scan.stop()
            raise
        finally:
            scan.finish()
        told(waiting)


def _add(record: SpotRecord, place: int, stay: int, observations: list[StereoObservation], points: Array) -> None:
    measured = [seen for seen in observations if seen.verdict == MEASURED]
    record.rejected.update(seen.verdict for seen in observations if seen.verdict != MEASURED)
    for seen, point in zip(measured, points, strict=True):
        a, b = seen.left, seen.right
        if a is None or b is None:
            raise RuntimeError("a measured pair without its spots")
        centroids = (a.x_px, a.y_px, b.x_px, b.y_px)
        sigmas = (a.sigma_x_px, a.sigma_y_px, b.sigma_x_px, b.sigma_y_px)
        record.rows.append((place, stay, seen.time_s, *point.tolist(), *centroids, *sigmas, a.peak_dn, b.peak_dn))
