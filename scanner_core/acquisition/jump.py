"""At which view a turntable jumped, once it is known by how much.

For every place between two views, some views after it are laid on some views before it, which gives a turn about the
table's axis.  It is the whole jump at the place of the jump, and falls to zero a few views on either side, where both
groups lie on the same side of it.  The place that fits all turns best is told together with those that fit nearly as well.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.view_motion import view_motion
from scanner_core.geometry.local_surface import reference_surface

Array = NDArray[np.float64]

_GROUP = 3
"""Views on either side: one alone may be too sparse for a surface."""
_WITHIN = 6.0
"""Chi-square over the best: places up to there are told as possible (about 2.4 standard deviations)."""
_SYSTEMATIC_MM = 2e-3
_SHAPE = 0.15
"""What the linear fall is off by, in parts of the jump: views overlap their neighbours most."""


@dataclass(frozen=True, slots=True)
class Jump:
    """The first view beyond the jump: the likeliest, and the range that cannot be excluded; indices into the views."""

    view: int
    earliest: int
    latest: int


def locate_jump(views: list[Array], turn_rad: float) -> Jump | None:
    """Where views (n, 3) mm in their order jumped by `turn_rad` about the object frame's z; None when their shapes do not tell."""
    count = len(views)
    turns = []
    for place in range(1, count):
        before, after = views[max(0, place - _GROUP) : place], views[place : place + _GROUP]
        motion = view_motion(np.concatenate(after), reference_surface(np.concatenate(before)))
        turn = None if motion is None else motion.turn_about_z(_SYSTEMATIC_MM)
        if turn is not None:
            turns.append((place, -turn[0], float(np.hypot(turn[1], _SHAPE * turn_rad))))
    if not turns:
        return None
    misfit = np.array([_misfit(turns, jump, turn_rad) for jump in range(1, count)])
    fits = np.flatnonzero(misfit - misfit.min() <= _WITHIN)
    if len(fits) == len(misfit) and len(misfit) > 2:
        return None
    return Jump(1 + int(misfit.argmin()), 1 + int(fits[0]), 1 + int(fits[-1]))


def _misfit(turns: list[tuple[int, float, float]], jump: int, turn_rad: float) -> float:
    """Chi-square of a jump before view `jump`."""
    return sum(((turn - turn_rad * max(0.0, 1 - abs(place - jump) / _GROUP)) / u) ** 2 for place, turn, u in turns)
