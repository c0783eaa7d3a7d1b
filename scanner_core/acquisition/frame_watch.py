"""Counts what goes wrong frame by frame, and names the cause once it is no accident any more."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from scanner_core.acquisition.engine import StereoPair
from scanner_core.acquisition.finding import Finding
from scanner_core.optics.spot import MissReason, Spot, SpotMiss

SIDES = ("left", "right")
WINDOW = 300
"""Exposures over which missing frames are counted; five seconds."""
MISSING = 6
"""Missing frames in the window that are no accident: 2 %."""
TORN = 3
"""Torn frames that are no accident."""
IN_A_ROW = 30
"""Frames in a row that are too bright, or saturated among those that show anything: half a second."""
ONE_SIDED = 150
"""Spots in a row that only one camera sees; folds of an object hide it for some dozens."""
SKEW_FRAMES = 0.05
"""Part of the frame period by which the cameras' time stamps may differ."""
_SKEWS = 60


@dataclass(slots=True)
class _Side:
    """One camera's counters."""

    missing: int = 0
    recent: deque[bool] = field(default_factory=lambda: deque(maxlen=WINDOW))
    too_bright: int = 0
    saturated: int = 0
    torn: int = 0
    blind: int = 0


class FrameWatch:
    """The frames of one scan in the order of their trigger ids.  One thread writes."""

    def __init__(self, rate_hz: float) -> None:
        self._rate_hz = rate_hz
        self._sides = (_Side(), _Side())
        self._exposures = 0
        self._dark = 0
        self._dark_limit = 1 << 30
        self._skews: deque[float] = deque(maxlen=_SKEWS)

    def expect_light(self, dark_limit: int) -> None:
        """From now on so many exposures in a row without any spot are too many."""
        self._dark_limit, self._dark = dark_limit, 0

    def add(self, pairs: Sequence[StereoPair], view: int, table_deg: float) -> list[Finding]:
        """What these pairs bring to light; a finding comes again, with its newest figures, as long as it grows."""
        found: list[Finding] = []
        for pair in pairs:
            self._exposures += 1
            both = (pair.left, pair.right)
            for side, seen in enumerate(both):
                self._look(side, seen, both[1 - side])
                found += self._causes(side, seen if isinstance(seen, SpotMiss) else None, pair.trigger_id, view, table_deg)
            self._dark = self._dark + 1 if all(isinstance(seen, SpotMiss) and seen.reason is MissReason.NO_SPOT for seen in both) else 0
            if self._dark == self._dark_limit:
                fields: dict[str, object] = {"frames": self._dark, "seconds": f"{self._dark / self._rate_hz:.1f}"}
                found.append(Finding("H-LSR-01", "warning", fields, view, table_deg, pair.trigger_id - self._dark + 1, self._dark, "frames"))
            if pair.left is not None and pair.right is not None:
                self._skews.append(pair.skew_s)
        return found + self._out_of_step(pairs, view, table_deg)

    def missing(self) -> tuple[int, int]:
        """Frames that left and right did not deliver."""
        return self._sides[0].missing, self._sides[1].missing

    def _look(self, side: int, seen: Spot | SpotMiss | None, other: Spot | SpotMiss | None) -> None:
        counts = self._sides[side]
        counts.recent.append(seen is None)
        counts.missing += seen is None
        reason = seen.reason if isinstance(seen, SpotMiss) else None
        counts.too_bright = counts.too_bright + 1 if reason is MissReason.TOO_BRIGHT else 0
        if seen is not None and reason is not MissReason.NO_SPOT:
            counts.saturated = counts.saturated + 1 if reason is MissReason.SATURATED else 0
        counts.torn += reason is MissReason.TORN
        if isinstance(seen, Spot):
            counts.blind = 0
        elif reason is MissReason.NO_SPOT and isinstance(other, Spot):
            counts.blind += 1

    def _causes(self, side: int, newest: SpotMiss | None, trigger_id: int, view: int, table_deg: float) -> list[Finding]:
        counts, camera, found = self._sides[side], SIDES[side], []

        def finding(code: str, value: float, back: int, **fields: object) -> None:
            found.append(Finding(code, "warning", {"camera": camera} | fields, view, table_deg, trigger_id - back + 1, value, "frames"))

        if counts.recent[-1] and (recent := sum(counts.recent)) >= MISSING:
            share = f"{100 * recent / len(counts.recent):.0f}"
            finding("H-CAM-01", counts.missing, 1, count=counts.missing, exposures=self._exposures, share=share)
        if newest is not None and newest.reason is MissReason.TORN and counts.torn >= TORN:
            finding("H-CAM-03", counts.torn, 1, count=counts.torn, exposures=self._exposures)
        if counts.too_bright == IN_A_ROW:
            finding("H-LGT-01", IN_A_ROW, IN_A_ROW, frames=IN_A_ROW)
        if counts.saturated == IN_A_ROW:
            finding("H-LGT-02", IN_A_ROW, IN_A_ROW, frames=IN_A_ROW)
        if counts.blind == ONE_SIDED:
            finding("H-CAM-02", ONE_SIDED, ONE_SIDED, frames=ONE_SIDED, other=SIDES[1 - side])
        return found

    def _out_of_step(self, pairs: Sequence[StereoPair], view: int, table_deg: float) -> list[Finding]:
        """By the time stamps: cameras whose drivers stamp truly."""
        if len(self._skews) < _SKEWS:
            return []
        # One of the skews themselves: half of them from before a lost trigger and half from after have no middle.
        skew_s = float(np.sort(self._skews)[len(self._skews) // 2])
        frames = skew_s * self._rate_hz
        if abs(frames) < SKEW_FRAMES:
            return []
        late, first = SIDES[skew_s > 0], pairs[0].trigger_id
        self._skews.clear()
        if round(frames) and abs(frames - round(frames)) < SKEW_FRAMES:
            steps = abs(round(frames))
            return [Finding("H-SYN-01", "warning", {"late": late, "count": steps}, view, table_deg, first, steps, "frames")]
        fields: dict[str, object] = {"late": late, "skew_ms": f"{1e3 * abs(skew_s):.1f}"}
        return [Finding("H-SYN-02", "warning", fields, view, table_deg, first, 1e3 * abs(skew_s), "ms")]
