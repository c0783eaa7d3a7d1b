"""How far points lie from a surface: a histogram on a logarithmic axis that never moves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

LEAST_UM, MOST_UM = 1.0, 10_000.0
"""Ends of the axis; what is nearer or farther counts in the first or the last class."""
CLASSES = 48
"""Twelve in each of the four decades."""


@dataclass(frozen=True, slots=True)
class DistanceHistogram:
    """Distances of points from a surface without their sign.

    Attributes
    ----------
    counts : points in each of the :data:`CLASSES`, from :data:`LEAST_UM` to :data:`MOST_UM`, each class as wide as the others in its logarithm
    median_um, p95_um : half of the points, and 95 of 100, are nearer
    """

    counts: tuple[int, ...]
    median_um: float
    p95_um: float

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {"median_um": round(self.median_um, 2), "p95_um": round(self.p95_um, 2), "counts": list(self.counts)}


def distance_histogram(distances_mm: NDArray[np.float64]) -> DistanceHistogram:
    """Of distances (n,), at least one, mm."""
    lengths_um = 1e3 * np.abs(distances_mm)
    place = CLASSES * np.log(np.maximum(lengths_um, LEAST_UM) / LEAST_UM) / np.log(MOST_UM / LEAST_UM)
    counts = np.bincount(np.minimum(place.astype(np.int64), CLASSES - 1), minlength=CLASSES)
    median_um, p95_um = (float(part) for part in np.percentile(lengths_um, (50, 95)))
    return DistanceHistogram(tuple(counts.tolist()), median_um, p95_um)
