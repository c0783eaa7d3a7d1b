"""Measures whether the window keeps breathing, and who held its breath.

A 10 ms timer beats in the GUI thread; the time between two beats is a gap.  A watchdog thread asks for the GUI thread's
stack whenever the beat is more than 100 ms late, so that a long gap names its cause.
"""

from __future__ import annotations

import json
import os
import threading
import time
from pathlib import Path

from PySide6.QtCore import QObject, Qt, QTimer

from app.stack_probe import StackProbe

BEAT_MS = 10
LATE_S = 0.1
_KEPT_STACKS = 40


class Heartbeat(QObject):
    """Gaps of the GUI thread from :meth:`start` on."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._gaps_s: list[float] = []
        self._last_s = 0.0
        self._stacks: list[dict[str, object]] = []
        self._stop = threading.Event()
        self._probe: StackProbe | None = None
        self._watchdog: threading.Thread | None = None
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)
        self.notes: dict[str, float] = {}
        """Other times worth keeping with the gaps, in seconds."""

    def start(self) -> None:
        self._last_s = time.perf_counter()
        self._timer.start(BEAT_MS)
        self._probe = StackProbe()
        self._watchdog = threading.Thread(target=self._watch, args=(self._probe,), name="heartbeat-watchdog")
        self._watchdog.start()

    def forget(self) -> None:
        """Count anew: what came before (the import of the 3D view) is not part of the measurement."""
        self._gaps_s.clear()
        self._stacks.clear()
        self._last_s = time.perf_counter()

    def stop(self) -> None:
        """End the measurement and the watchdog."""
        self._timer.stop()
        self._stop.set()
        if self._watchdog is not None and self._probe is not None:
            self._watchdog.join()
            self._probe.close()
            self._watchdog = self._probe = None

    def result(self) -> dict[str, object]:
        """Gaps in milliseconds: how many, the 99.9th percentile, the worst, and the stacks of the late ones."""
        gaps = sorted(self._gaps_s)
        return {
            "beats": len(gaps),
            "seconds": round(sum(gaps), 3),
            "p50_ms": round(1000 * _quantile(gaps, 0.5), 2),
            "p99_ms": round(1000 * _quantile(gaps, 0.99), 2),
            "p999_ms": round(1000 * _quantile(gaps, 0.999), 2),
            "worst_ms": round(1000 * gaps[-1], 2) if gaps else 0.0,
            "late": list(self._stacks),
            **{name: round(value, 3) for name, value in self.notes.items()},
        }

    def write(self, path: Path) -> None:
        beside = path.with_name(path.name + ".part")
        beside.write_text(json.dumps(self.result(), indent=1), encoding="utf-8")
        os.replace(beside, path)

    def _beat(self) -> None:
        now = time.perf_counter()
        self._gaps_s.append(now - self._last_s)
        self._last_s = now

    def _watch(self, probe: StackProbe) -> None:
        seen_s = 0.0
        while not self._stop.wait(LATE_S / 4):
            last_s = self._last_s
            late_s = time.perf_counter() - last_s
            if late_s < LATE_S or last_s == seen_s or len(self._stacks) >= _KEPT_STACKS:
                continue
            seen_s = last_s
            self._stacks.append({"late_ms": round(1000 * late_s, 1), "stack": probe.stack()[-12:]})


def _quantile(ordered: list[float], share: float) -> float:
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0
