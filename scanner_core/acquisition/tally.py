"""The counts, rate and time left of a running scan; written by the scan thread, read by any."""

from __future__ import annotations

import threading
from collections import Counter, deque
from collections.abc import Iterable, Mapping

from scanner_core.acquisition.status import ScanCounts
from scanner_core.case.observation import MEASURED

_WINDOW_S = 2.0
_LEAST = 50
"""Measurements that tell a pace."""


class Tally:
    """Counts over one plan."""

    def __init__(self, planned: int, wanted: int | None, started_s: float, before: Mapping[str, int] | None = None) -> None:
        """`wanted` is the number of points after which the plan is complete, None when every id counts.

        `before` counts verdicts of an earlier run of the same plan, which took none of the time since `started_s`.
        """
        self._lock = threading.Lock()
        self._planned = planned
        self._wanted = wanted
        self._started_s = started_s
        self._turned_s = 0.0
        self._verdicts: Counter[str] = Counter(before)
        self._before = self._verdicts.copy()
        self._recent: deque[tuple[float, int]] = deque([(started_s, self._verdicts[MEASURED])])

    def extend(self, planned: int) -> None:
        """So many more trigger ids are planned; the number of wanted points stays."""
        with self._lock:
            self._planned += planned

    def want(self, more: int) -> None:
        """So many points are wanted beside those that are there."""
        with self._lock:
            self._wanted = self._verdicts[MEASURED] + more

    def rested(self, seconds: float) -> None:
        """A pause on the rig's clock: it does not count to the pace."""
        with self._lock:
            self._started_s += seconds

    def add(self, verdicts: Iterable[str], now_s: float) -> None:
        """Count verdicts; `now_s` is on the rig's clock."""
        with self._lock:
            self._verdicts.update(verdicts)
            self._recent.append((now_s, self._verdicts[MEASURED]))
            while len(self._recent) > 2 and self._recent[0][0] < now_s - _WINDOW_S:
                self._recent.popleft()

    def counts(self) -> ScanCounts:
        with self._lock:
            return ScanCounts.of(self._planned, self._verdicts)

    @property
    def measured(self) -> int:
        with self._lock:
            return self._verdicts[MEASURED]

    @property
    def exposed(self) -> int:
        """Trigger ids with a verdict."""
        with self._lock:
            return self._verdicts.total()

    def rate_hz(self) -> float:
        """Points a second over the last two seconds of the rig's clock."""
        with self._lock:
            (begin_s, before), (end_s, after) = self._recent[0], self._recent[-1]
            return (after - before) / (end_s - begin_s) if end_s > begin_s else 0.0

    def turned(self, seconds: float) -> None:
        """The table turned from one view to another, on the rig's clock."""
        with self._lock:
            self._turned_s += seconds

    def seconds_a_point(self, now_s: float, after: int = 0) -> tuple[float, float] | None:
        """Of sweeping and of turning the table for one wanted point, on the rig's clock; None as long as too few were measured.

        Parameters
        ----------
        after : points that were measured after the plan
        """
        with self._lock:
            points = self._verdicts[MEASURED] - self._before[MEASURED] + after
            if points < _LEAST:
                return None
            return max(0.0, now_s - self._started_s - self._turned_s) / points, self._turned_s / points

    @property
    def lacking(self) -> int:
        """Points that are wanted still."""
        with self._lock:
            return 0 if self._wanted is None else max(0, self._wanted - self._verdicts[MEASURED])

    def seconds_left(self, now_s: float) -> float | None:
        """From the pace so far, on the rig's clock."""
        with self._lock:
            if self._wanted is None:
                done, before, whole = self._verdicts.total(), self._before.total(), self._planned
            else:
                done, before, whole = self._verdicts[MEASURED], self._before[MEASURED], self._wanted
            if done - before < _LEAST:
                return None
            return max(0.0, (now_s - self._started_s) * (whole - done) / (done - before))
