"""From where on a difference is listed as an area: what it means that there is none."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.comparison.areas import SMOOTHING_MM, THRESHOLD_UM
from scanner_core.comparison.deviation import Deviation
from scanner_core.comparison.moved_bodies import LEAST_AREA_MM2


@dataclass(frozen=True, slots=True)
class AreaBar:
    """An area differs by more than `deviation_um`, smoothed over `smoothing_mm`, on at least `extent_mm2`."""

    deviation_um: float
    extent_mm2: float
    smoothing_mm: float

    @classmethod
    def of(cls, deviation: Deviation) -> AreaBar:
        """Of a comparison, by its typical level of detection."""
        return cls(max(THRESHOLD_UM, deviation.detection_level_um), LEAST_AREA_MM2, SMOOTHING_MM)
