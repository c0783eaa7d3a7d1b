"""Hands observations to the case in portions that are small enough to lose little and large enough to cost little."""

from __future__ import annotations

import time

from scanner_core.case.observation import StereoObservation
from scanner_core.case.store import CaseStore

_PERIOD_S = 0.5
_COUNT = 500


class Keeper:
    """What a scan has measured and the case does not hold yet.  One thread."""

    def __init__(self, store: CaseStore) -> None:
        self._store = store
        self._scan_id = 0
        self._unkept: list[StereoObservation] = []
        self._kept_s = time.monotonic()

    def add(self, scan_id: int, observations: list[StereoObservation]) -> None:
        self._scan_id = scan_id
        self._unkept += observations
        if len(self._unkept) >= _COUNT or time.monotonic() - self._kept_s > _PERIOD_S:
            self.keep()

    def keep(self) -> None:
        """Write to the case what it does not hold yet."""
        if self._unkept:
            self._store.append(self._scan_id, self._unkept)
            self._unkept = []
        self._kept_s = time.monotonic()
