"""A whole comparison: alignment, signed deviation and the areas of greatest difference."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.area import Area
from scanner_core.comparison.deviation import Deviation
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.comparison.surface import ComparedSurface


@dataclass(frozen=True, slots=True, eq=False)
class Comparison:
    """What came out, and from what.

    Attributes
    ----------
    mask : (v_after,) bool, what was painted as stable; None without
    null_level_um : the empirical level of detection of this rig and material (see `null_comparison`); None when none was measured
    null_area_mm2 : the largest area that seemed to have moved by more than 0.2 mm in that null comparison
    pair : what the two surfaces together give reason to doubt (see `pair_doubts`)
    """

    before: ComparedSurface
    after: ComparedSurface
    parameters: ComparisonParameters
    alignment: Alignment
    deviation: Deviation
    areas: tuple[Area, ...]
    mask: NDArray[np.bool_] | None = None
    null_level_um: float | None = None
    pair: tuple[Doubt, ...] = ()
    null_area_mm2: float | None = None

    @property
    def doubts(self) -> tuple[Doubt, ...]:
        """Of both surfaces, of the two together, and of the alignment."""
        return self.before.doubts + self.after.doubts + self.pair + self.alignment.doubts

    @property
    def reliable(self) -> bool:
        """No serious doubt."""
        return not any(doubt.serious for doubt in self.doubts)
