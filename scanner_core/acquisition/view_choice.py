"""Which table angles to measure from, and which place of the surface from which of them.

A place is measured from the angle at which a point has the least standard deviation along the normal, because the information
of a point is 1 / sd^2.  What a set of angles gains grows with every angle, but less and less (it is submodular, like every
problem of placing facilities), so taking the best next angle is as good as 63 % of the best set at least (Nemhauser, Wolsey
and Fisher 1978).  A view costs time as well; it is taken as long as it gains more than the exposures of that time would.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.allocation import EXPONENT, Demand, water_fill

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ViewChoice:
    """The chosen angles and what to measure from each.

    Attributes
    ----------
    chosen : indices of the angles, in the order of their gain
    points : (chosen, n) wanted at every place from every angle
    uncertainty_um : (n,) of the places afterwards, as predicted
    """

    chosen: tuple[int, ...]
    points: Array
    uncertainty_um: Array


def choose_views(
    demand: Demand, point_sd_um: Array, budget_points: float, wanted_um: float, densest_mm2: float, view_points: float, most_views: int
) -> ViewChoice:
    """Choose among candidate angles.

    Parameters
    ----------
    point_sd_um : (angles, n) of a point along the normal, infinite where it cannot be measured
    densest_mm2 : the most points on a square millimetre that a pass may bring
    view_points : exposures that fit into the time of turning to one more view
    most_views : at most so many
    """
    n = len(demand.area_mm2)
    best, chosen = np.full(n, np.inf), list[int]()
    squares = _squares(demand, np.zeros(n))
    while len(chosen) < most_views:
        trials = []
        for angle in range(len(point_sd_um)):
            if angle in chosen:
                trials.append(np.inf)
                continue
            sd = np.minimum(best, point_sd_um[angle])
            trials.append(_squares(demand, water_fill(demand, sd, budget_points, wanted_um, densest_mm2)))
        angle = int(np.argmin(trials))
        worth = EXPONENT * view_points / max(budget_points, 1.0) if chosen else 0.0
        if not trials[angle] < squares * (1 - max(worth, 1e-6)):
            break
        chosen.append(angle)
        best, squares = np.minimum(best, point_sd_um[angle]), trials[angle]
    if not chosen:
        return ViewChoice((), np.zeros((0, n)), demand.after(np.zeros(n)))
    added = water_fill(demand, best, budget_points, wanted_um, densest_mm2)
    owner = np.argmin(point_sd_um[chosen], axis=0)
    wanted = demand.area_mm2 * added * np.where(np.isfinite(best), best, 0.0) ** 2
    points = np.zeros((len(chosen), n))
    points[owner, np.arange(n)] = wanted
    return ViewChoice(tuple(chosen), points, demand.after(added))


def _squares(demand: Demand, added: Array) -> float:
    """Sum of the squared uncertainties over the area."""
    return float(demand.area_mm2 @ demand.after(added) ** 2)
