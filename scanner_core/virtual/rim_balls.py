"""The three balls on the rim of the virtual table, as they really stand: matt white, each in a hollow of its own.

The rig file tells where somebody wanted to put them; a drill is off by a few tenths of a millimetre.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.marks_config import MarksConfig

Array = NDArray[np.float64]

BALL_ALBEDO = 0.9
_MISPLACED_MM = np.array([[0.21, -0.34, 0.12], [-0.28, 0.17, -0.09], [0.11, 0.26, 0.18]])


def true_centres_mm(marks: MarksConfig) -> Array:
    """Centres (3, 3) mm, object frame."""
    return np.asarray(marks.places_mm() + _MISPLACED_MM, np.float64)


class RimBalls:
    """Spheres for ray casting; `without` is the number (from 0) of one that is not there any more, or None."""

    def __init__(self, marks: MarksConfig, without: int | None = None) -> None:
        self._radius = marks.ball_radius_mm
        centres = true_centres_mm(marks).tolist()
        self._centres: list[list[float]] = [centre for number, centre in enumerate(centres) if number != without]

    def first_hit(self, start: list[float], towards: list[float], reach: float) -> tuple[list[float], list[float]] | None:
        """The first point within `reach` of a ray, `towards` a unit vector, and the outward normal there."""
        nearest, found = reach, None
        for centre in self._centres:
            distance = self._distance(start, towards, centre)
            if distance is not None and 0.0 < distance < nearest:
                nearest, found = distance, centre
        if found is None:
            return None
        point = [s + nearest * t for s, t in zip(start, towards, strict=True)]
        return point, [(p - c) / self._radius for p, c in zip(point, found, strict=True)]

    def meets(self, start: list[float], end: list[float]) -> bool:
        """Whether a ball meets the segment."""
        along = [e - s for s, e in zip(start, end, strict=True)]
        length = sqrt(sum(a * a for a in along))
        return self.first_hit(start, [a / length for a in along], length) is not None

    def _distance(self, start: list[float], towards: list[float], centre: list[float]) -> float | None:
        """To where a ray enters a ball; negative behind its start."""
        x, y, z = centre[0] - start[0], centre[1] - start[1], centre[2] - start[2]
        along = x * towards[0] + y * towards[1] + z * towards[2]
        inside = self._radius * self._radius - (x * x + y * y + z * z - along * along)
        return along - sqrt(inside) if inside > 0 else None
