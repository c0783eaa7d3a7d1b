"""An area of difference: one entry of the ranked list."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class PartMotion:
    """Rigid motion of a part (a tooth) from before to after, in the frame of BEFORE.

    Attributes
    ----------
    transform : before to after
    centre : (3,) mm, the part's centre before
    displacement_mm : (3,) of that centre
    angle_deg, axis : of the rotation; `axis` (3,) unit
    displacement_uncertainty_um, angle_uncertainty_deg : standard (k = 1), the alignment's own uncertainty included
    rms_um : of what the rigid motion leaves over
    """

    transform: RigidTransform
    centre: Array
    displacement_mm: Array
    angle_deg: float
    axis: Array
    displacement_uncertainty_um: float
    angle_uncertainty_deg: float
    rms_um: float


@dataclass(frozen=True, slots=True, eq=False)
class Area:
    """One area.  A moved tooth shows as a + and a - patch: both are one entry with `parts` 2.

    Attributes
    ----------
    rank : 1 is the greatest
    vertices : (k,) int64 of the AFTER surface
    centroid_mm : (3,) frame of BEFORE
    normal : (3,) unit, outward, to look at it from
    mean_um, max_um : signed; `max_um` is the value of the greatest magnitude
    p95_um : of the magnitude
    volume_mm3 : signed, between the surfaces
    parts : connected patches
    words : for a person
    motion : of the part, when the area is one rigidly moved part
    both_ways : whether it stands out here and lies deeper there
    """

    rank: int
    vertices: NDArray[np.int64]
    centroid_mm: Array
    normal: Array
    area_mm2: float
    mean_um: float
    p95_um: float
    max_um: float
    volume_mm3: float
    parts: int
    words: str
    motion: PartMotion | None = None
    both_ways: bool = False
