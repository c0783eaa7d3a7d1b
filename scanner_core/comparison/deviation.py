"""The signed distance of two aligned surfaces, both ways, with what has no counterpart kept apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class DeviationStatistics:
    """Of the after surface against the before surface, weighted by area, only where there is a counterpart; um unless named.

    `p50_um`, `p95_um`, `p99_um` and `max_um` are of the magnitude; `mean_um` is signed (+ outward).
    `area_above_mm2` is the area by threshold ("100", "250", "500").
    """

    points: int
    no_counterpart_fraction: float
    mean_um: float
    rms_um: float
    p50_um: float
    p95_um: float
    p99_um: float
    max_um: float
    area_above_mm2: dict[str, float]
    hausdorff_after_to_before_um: float
    hausdorff_before_to_after_um: float


@dataclass(frozen=True, slots=True, eq=False)
class Deviation:
    """Signed distances by vertex.

    Attributes
    ----------
    signed_um : (v_after,) of the after surface's vertices to the before surface, + outside of it; NaN without counterpart
    before_signed_um : (v_before,) the other way: of the before surface's vertices to the after surface, + outside of that
    feet_mm : (v_after, 3) closest points on the before surface, frame of BEFORE
    level_um : (v_after,) level of detection, 95 %: what noise and alignment alone would reach one time in twenty
    detection_level_um : its typical (area-weighted median) value
    statistics : see there
    """

    signed_um: Array
    before_signed_um: Array
    feet_mm: Array
    level_um: Array
    detection_level_um: float
    statistics: DeviationStatistics
