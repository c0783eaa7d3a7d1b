"""At which view a turntable jumped, once it is known by how much.

Every pair of overlapping views gives a turn of one against the other about the table's axis.  It should be the jump where
the two lie on different sides of it, and zero elsewhere; the place that fits all pairs best is told together with those
that fit nearly as well.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.view_motion import reference_surface, view_motion
from scanner_core.geometry.view_matching import overlapping_pairs

Array = NDArray[np.float64]

_PARTNERS = 4
_WITHIN = 6.0
"""Chi-square over the best: places up to there are told as possible (about 2.4 standard deviations)."""
_SYSTEMATIC_MM = 2e-3


@dataclass(frozen=True, slots=True)
class Jump:
    """The first view beyond the jump: the likeliest, and the range that cannot be excluded; indices into the views."""

    view: int
    earliest: int
    latest: int


def locate_jump(views: list[Array], turn_rad: float) -> Jump | None:
    """Where views (n, 3) mm in their order jumped by `turn_rad` about the object frame's z; None when no pair of views tells.

    The jump of the last views against the first, closed turn included, holds for every place and says nothing.
    """
    surfaces = [reference_surface(points) for points in views]
    turns = []
    for first, second in overlapping_pairs(views, _PARTNERS):
        if first < second:
            motion = view_motion(views[second], surfaces[first])
            turn = None if motion is None else motion.turn_about_z(_SYSTEMATIC_MM)
            if turn is not None:
                turns.append((first, second, -turn[0], turn[1]))
    if not turns:
        return None
    places = range(1, len(views))
    misfit = np.array([sum(((t - turn_rad * (i < place <= j)) / u) ** 2 for i, j, t, u in turns) for place in places])
    fits = np.flatnonzero(misfit - misfit.min() <= _WITHIN)
    if len(fits) == len(misfit) and len(misfit) > 2:
        return None
    return Jump(1 + int(misfit.argmin()), 1 + int(fits[0]), 1 + int(fits[-1]))
