"""Named points that a person picks on both surfaces, and how the distances between them changed."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
PICKING_UM = 150.0
"""Standard deviation of each coordinate of a point that a person picks, half a triangle of a usual scan; a person who has picked
the same points several times knows a better one."""


@dataclass(frozen=True, slots=True, eq=False)
class Landmark:
    """One named point, (3,) mm on each surface, each in the frame of its own surface or both in one."""

    name: str
    before: Array
    after: Array


@dataclass(frozen=True, slots=True)
class DistanceChange:
    """Distance of two landmarks before and after, and its change with its standard uncertainty (k = 1)."""

    one: str
    other: str
    before_mm: float
    after_mm: float
    uncertainty_mm: float

    @property
    def change_mm(self) -> float:
        return self.after_mm - self.before_mm


def distance_changes(landmarks: list[Landmark], picking_um: float = PICKING_UM, noise_um: float = 0.0) -> list[DistanceChange]:
    """Every pair of landmarks.  Distances within one surface need no alignment.

    Each of the four points of a pair adds `picking_um` and the surface's own noise along the connecting line, independently.
    """
    uncertainty = 2 * float(np.hypot(picking_um, noise_um)) / 1e3
    return [
        DistanceChange(a.name, b.name, float(np.linalg.norm(a.before - b.before)), float(np.linalg.norm(a.after - b.after)), uncertainty)
        for a, b in combinations(landmarks, 2)
    ]
