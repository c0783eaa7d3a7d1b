"""Limits of a spot's size, learned from spots that both cameras agree on and from what else was seen beside them.

Areas of one spot scatter like a product (brightness times spread times obliquity), so they are judged as logarithms.  A limit stands
where the spots' own spread ends, with room for places that were not looked at; where stray light lies within that room, it
stands between the two.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from scanner_core.optics.spot_detection import SpotDetectorParameters

LEAST_SPOTS = 12
"""Fewer say nothing of the spread."""
_ROOM = 4.5
"""In robust standard deviations: of 10,000 further spots of the same kind one lies beyond."""
_LEAST_ROOM = float(np.log(4.0))
"""A place elsewhere on the object is seen more obliquely, or farther away."""
_CLOSE = 3.0
"""Stray light within so many standard deviations of the spots cannot be told by its size."""


@dataclass(frozen=True, slots=True)
class SizeLimits:
    """Areas of a spot in pixels, both inside."""

    min_area_px: int
    max_area_px: int

    def of(self, parameters: SpotDetectorParameters) -> SpotDetectorParameters:
        """The detector's settings with these limits."""
        return replace(parameters, min_area_px=self.min_area_px, max_area_px=self.max_area_px)

    def holds(self, area_px: float) -> bool:
        return self.min_area_px <= area_px <= self.max_area_px


def learn_limits(spots_px: Sequence[float], strays_px: Sequence[float] = ()) -> SizeLimits | None:
    """Limits from the areas of good spots and of what is none; None where there are too few to learn from."""
    if len(spots_px) < LEAST_SPOTS:
        return None
    logs = np.log(np.asarray(spots_px, np.float64))
    middle = float(np.median(logs))
    spread = max(1.4826 * float(np.median(np.abs(logs - middle))), float(np.ptp(np.quantile(logs, [0.1, 0.9]))) / 2.563, 0.03)
    room = max(_ROOM * spread, _LEAST_ROOM)
    low, high = middle - room, middle + room
    own_low, own_high = middle - _CLOSE * spread, middle + _CLOSE * spread
    strays = np.log(np.asarray(strays_px, np.float64)) if len(strays_px) else np.empty(0)
    below, above = strays[(strays > low) & (strays < own_low)], strays[(strays < high) & (strays > own_high)]
    if len(below):
        low = 0.5 * (float(below.max()) + own_low)
    if len(above):
        high = 0.5 * (float(above.min()) + own_high)
    smallest = min(max(int(np.floor(np.exp(low))), 2), 100)
    return SizeLimits(smallest, int(min(max(np.ceil(np.exp(high)), smallest + 1), 100_000)))
