"""The colours of signed deviations, one scale for the window and the report: stepped, symmetric, safe for the colour-blind."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Colours = NDArray[np.uint8]

WITHIN_LEVEL = (200, 200, 200)
"""Grey: not distinguishable from noise."""
NO_COUNTERPART = (226, 226, 226)
"""Lighter grey, under a hatch of `HATCH`: nothing to compare with."""
HATCH = (150, 150, 150)
THRESHOLD_LINE = (27, 31, 36)
"""Of the line on the map where the deviation reaches the clinical threshold."""

# ColorBrewer 2.0 (Brewer, Harrower, 2003; Apache 2.0): YlOrBr and Blues, of both the steps of like lightness, from near
# zero outwards.  Orange against blue keeps the two signs apart in every kind of colour blindness; the darkest steps are left
# out, because shading on a surface darkens as well.
_OUTWARD = np.array([(254, 196, 79), (254, 153, 41), (236, 112, 20), (204, 76, 2), (153, 52, 4)], np.float64)
_INWARD = np.array([(158, 202, 225), (107, 174, 214), (66, 146, 198), (33, 113, 181), (8, 69, 148)], np.float64)
_FEWEST, _MOST = 4, 8


@dataclass(frozen=True, slots=True)
class DeviationScale:
    """Colours of signed deviations: `steps` bands of equal width for either sign, grey within the level of detection.

    Attributes
    ----------
    limit_um : where the last band ends; what lies beyond has its colour
    steps : bands for either sign
    level_um : level of detection: a smaller magnitude is grey
    threshold_um : clinical threshold, an edge of a band when the scale was made by `fitting`
    """

    limit_um: float
    steps: int
    level_um: float
    threshold_um: float

    @classmethod
    def fitting(cls, values_um: Array, level_um: float, threshold_um: float) -> DeviationScale:
        """A scale for signed deviations (n,), NaN where there is no counterpart.

        99 % of the magnitudes lie within the limit, but it is at least twice the threshold.  The bands are half the threshold
        wide, or that doubled until eight suffice, so the limit is as round as the threshold is.
        """
        finite = np.abs(values_um[np.isfinite(values_um)])
        reach = max(float(np.percentile(finite, 99)) if len(finite) else 0.0, 2 * threshold_um)
        step = 0.5 * threshold_um
        while _MOST * step < reach * (1 - 1e-9):
            step *= 2
        steps = min(max(ceil(reach / step - 1e-9), _FEWEST), _MOST)
        return cls(steps * step, steps, level_um, threshold_um)

    @property
    def edges_um(self) -> Array:
        """Edges of the bands, (2 steps + 1,), from -limit to +limit."""
        return np.asarray(np.arange(-self.steps, self.steps + 1) * (self.limit_um / self.steps), np.float64)

    @property
    def band_colours(self) -> Colours:
        """Colours of the bands, (2 steps, 3), in the order of the edges; the level of detection is drawn over them."""
        places = np.linspace(0, len(_OUTWARD) - 1, self.steps)
        known = np.arange(len(_OUTWARD))
        sides = [np.column_stack([np.interp(places, known, table[:, i]) for i in range(3)]) for table in (_INWARD, _OUTWARD)]
        return np.asarray(np.concatenate([sides[0][::-1], sides[1]]).round(), np.uint8)

    def colours(self, values_um: Array, level_um: Array | None = None) -> Colours:
        """Colours (n, 3) of signed deviations (n,): grey within the level of detection, lighter grey for NaN.

        `level_um` (n,) holds the level of detection of each value; without it the scale's own serves for all.
        """
        known = np.isfinite(values_um)
        values = np.where(known, values_um, 0.0)
        band = np.clip(np.floor(values * (self.steps / self.limit_um)) + self.steps, 0, 2 * self.steps - 1).astype(np.int64)
        colours = self.band_colours[band]
        colours[np.abs(values) <= (self.level_um if level_um is None else level_um)] = WITHIN_LEVEL
        colours[~known] = NO_COUNTERPART
        return np.asarray(colours, np.uint8)

    def table(self, entries: int) -> Colours:
        """A look-up table (entries, 3) whose entries divide -limit to +limit evenly; each has the colour of its middle."""
        middles = (np.arange(entries) + 0.5) * (2 * self.limit_um / entries) - self.limit_um
        return self.colours(np.asarray(middles, np.float64))

    def ticks(self) -> tuple[tuple[float, str], ...]:
        """Places (um) and labels (mm, with their sign) for a legend: every edge, or every second one where the bands are many."""
        every = 1 if self.steps <= _FEWEST else 2
        numbers = [n for n in range(-self.steps, self.steps + 1) if n % every == 0]
        width = self.limit_um / self.steps
        return tuple((n * width, _label(n * width)) for n in numbers)


def _label(value_um: float) -> str:
    """In mm, without zeros at its end beyond two digits, the minus as long as the plus."""
    text = f"{value_um / 1000:+.4f}" if value_um else "0"
    while text.endswith("0") and len(text.partition(".")[2]) > 2:
        text = text[:-1]
    return text.replace("-", "−")
