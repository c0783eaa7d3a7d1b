"""What the mechanics of a rig do that its controller does not know."""

from __future__ import annotations

from dataclasses import replace
from math import exp, isnan, nan

from scanner_core.virtual.motion_state import MotionInstant, MotionTimeline
from scanner_core.virtual.presets import VirtualPreset


class PlayTimeline:
    """A timeline whose table has play: it rests until the drive has crossed the backlash.

    ``true = min(max(true before, reported), reported + backlash)``: turned forwards it follows, turned back it lags.  The
    table is looked at when somebody asks, that is at exposures: a turn to and fro between two exposures is not seen.
    """

    def __init__(self, timeline: MotionTimeline, backlash_deg: float) -> None:
        self._timeline, self._backlash_deg = timeline, backlash_deg
        self._table_deg = nan

    def instant(self, time_s: float) -> MotionInstant:
        """See :class:`~scanner_core.virtual.motion_state.MotionTimeline`."""
        reported = self._timeline.instant(time_s)
        before = reported.table_deg if isnan(self._table_deg) else self._table_deg
        self._table_deg = min(max(before, reported.table_deg), reported.table_deg + self._backlash_deg)
        return replace(reported, table_deg=self._table_deg)


def warm_up_px(preset: VirtualPreset, index: int, time_s: float) -> tuple[float, float]:
    """How far the image of camera `index` has drifted at a time of the rig's clock, which starts when the rig is switched on."""
    grown = 1 - exp(-max(time_s, 0.0) / preset.warm_up_s)
    sign = 1 if index == 0 else -1
    return sign * grown * preset.warm_up_px[0], sign * grown * preset.warm_up_px[1]
