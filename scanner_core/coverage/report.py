"""How much of an object is measured as well as wanted, and the places that are not."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.coverage.place import CoveragePlace


@dataclass(frozen=True, slots=True, eq=False)
class CoverageReport:
    """The coverage of one surface.

    Attributes
    ----------
    wanted_um : standard uncertainty that was asked for
    reasons : (v,) uint8, index into ``tuple(Reason)`` of every vertex
    within_fraction : share of the area within the wanted uncertainty
    reachable_within_fraction : the same over the area that can be measured as the object stands
    places : largest first
    members : vertices of each place, where they are known
    """

    wanted_um: float
    reasons: NDArray[np.uint8]
    within_fraction: float
    reachable_within_fraction: float
    places: tuple[CoveragePlace, ...]
    members: tuple[NDArray[np.int64], ...] = ()

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "wanted_um": self.wanted_um,
            "within_fraction": round(self.within_fraction, 4),
            "reachable_within_fraction": round(self.reachable_within_fraction, 4),
            "places": [place.as_dict() for place in self.places],
        }
