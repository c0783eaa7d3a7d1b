"""Limits of a spot's size, learned from spots that both cameras agree on and from what else was seen beside them.

Areas of one spot scatter like a product (brightness times spread times obliquity), so they are judged as logarithms.  A limit stands
where the spots' own spread ends, with room for places that were not looked at; where stray light lies within that room, it
stands between the two.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.spot_detection import SpotDetectorParameters

Array = NDArray[np.float64]

LEAST_SPOTS = 12
"""Fewer say nothing of the spread."""
_ROOM = 4.5
"""In robust standard deviations: of 10,000 further spots of the same kind one lies beyond."""
_LEAST_ROOM = float(np.log(4.0))
"""A place elsewhere on the object is seen more obliquely, or farther away."""
_CLOSE = 3.0
"""Stray light within so many standard deviations of the spots, or one beyond the farthest of them, cannot be told by its size."""
_EIGHT_IN_TEN = 1.2816
"""Standard deviations within which eight in ten of a normal distribution's one side lie."""
_LEAST_SPREAD = 0.03


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
    strays = np.log(np.asarray(strays_px, np.float64)) if len(strays_px) else np.empty(0)
    low, high = middle - _reach(middle - logs, middle - strays), middle + _reach(logs - middle, strays - middle)
    smallest = min(max(int(np.floor(np.exp(low))), 2), 100)
    return SizeLimits(smallest, int(min(max(np.ceil(np.exp(high)), smallest + 1), 100_000)))


def _reach(away: Array, strays: Array) -> float:
    """How far from the middle a limit stands, by what lies on its side: spots that grow dim at slopes reach farther down than up."""
    side = away[away >= 0]
    spread = max(float(np.quantile(side, 0.8)) / _EIGHT_IN_TEN, _LEAST_SPREAD)
    own = max(_CLOSE * spread, float(side.max()) + spread)
    reach = max(_ROOM * spread, own, _LEAST_ROOM)
    beyond = strays[(strays > own) & (strays < reach)]
    return 0.5 * (own + float(beyond.min())) if len(beyond) else reach
