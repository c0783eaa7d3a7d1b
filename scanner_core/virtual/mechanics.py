"""What the mechanics of a rig do that its controller does not know."""

from __future__ import annotations

from dataclasses import replace
from math import exp, isnan, nan

from scanner_core.virtual.motion_state import MotionInstant, MotionTimeline
from scanner_core.virtual.presets import VirtualPreset


class PlayTimeline:
    """A timeline whose table has play: it rests until the drive has crossed the backlash.

    ``true = min(max(true before, reported), reported + backlash)``: turned forwards it follows, turned back it lags.  Between
    two questions its motion is looked at in :data:`_LOOKS` steps, so that a turn to and fro is not missed.
    """

    def __init__(self, timeline: MotionTimeline, backlash_deg: float) -> None:
        self._timeline, self._backlash_deg = timeline, backlash_deg
        self._time_s, self._reported_deg, self._table_deg = nan, nan, nan

    def instant(self, time_s: float) -> MotionInstant:
        """See :class:`~scanner_core.virtual.motion_state.MotionTimeline`."""
        now = self._timeline.instant(time_s)
        if isnan(self._table_deg):
            self._table_deg = now.table_deg
        elif now.table_deg != self._reported_deg:
            since_s = max(self._time_s, time_s - _HISTORY_S)
            for k in range(1, _LOOKS):
                self._follow(self._timeline.instant(since_s + (time_s - since_s) * k / _LOOKS).table_deg)
        self._follow(now.table_deg)
        self._time_s, self._reported_deg = time_s, now.table_deg
        return replace(now, table_deg=self._table_deg)

    def _follow(self, reported_deg: float) -> None:
        self._table_deg = min(max(self._table_deg, reported_deg), reported_deg + self._backlash_deg)


_LOOKS = 64
_HISTORY_S = 18.0
"""How far back a timeline is asked: less than what the firmware model remembers."""


def warm_up_px(preset: VirtualPreset, index: int, time_s: float) -> tuple[float, float]:
    """How far the image of camera `index` has drifted at a time of the rig's clock, which starts when the rig is switched on."""
    grown = 1 - exp(-max(time_s, 0.0) / preset.warm_up_s)
    sign = 1 if index == 0 else -1
    return sign * grown * preset.warm_up_px[0], sign * grown * preset.warm_up_px[1]
