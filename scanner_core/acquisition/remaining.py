"""What of a plan an interrupted scan has not exposed yet."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.plan import Row, ScanPlan

_SHORTEST = 3
"""Exposures of a row that are worth a sweep."""


@dataclass(frozen=True, slots=True)
class Remaining:
    """The rest of a plan.

    Attributes
    ----------
    plan : with all views of the whole plan; those that are done have no rows
    complete : the first so many views are done
    """

    plan: ScanPlan
    complete: int


def remaining_plan(
    plan: ScanPlan, exposed: NDArray[np.int64], measured: NDArray[np.int64], begins: Sequence[int] = (0,), again: Collection[int] = ()
) -> Remaining:
    """The part of `plan` that is missing.

    A scan follows its rows in order, so all before the last one that was exposed is done: what it lacks there was cut off
    when a view had its quota, or lost on the way and counts as skipped.

    Parameters
    ----------
    exposed : (n,) trigger ids that have a verdict
    measured : (views,) points of each view
    begins : the first view of each pass; what a pass lacks is not carried into the next one, which was planned knowing of it, nor into
        the repetition of a view
    again : views that are going to be measured once more; what they lack is measured there
    """
    latest = -1
    for number, view in enumerate(plan.views):
        if any(_part(row, exposed) for row in view.rows):
            latest = number
    owed, views = 0, []
    for number, view in enumerate(plan.views):
        rows, quota = view.rows, view.quota
        if number in begins or view.repeats is not None:
            owed = 0
        if number <= latest and quota is not None:
            quota += owed - int(measured[number])
            owed = 0 if number in again else quota
        if number < latest:
            rows = ()
        elif number == latest:
            rows = () if quota is not None and quota <= 0 else _rest(rows, exposed)
            if rows:
                owed = 0  # the follower carries on what this view cannot fill
        elif quota is not None:
            quota, owed = quota + owed, 0
        views.append(replace(view, rows=rows, quota=quota if rows else 0))
    complete = next((number for number in range(latest + 1) if views[number].rows), latest + 1)
    return Remaining(ScanPlan(tuple(views), plan.sweep_speed_deg_s), complete)


def _rest(rows: Sequence[Row], exposed: NDArray[np.int64]) -> tuple[Row, ...]:
    """From behind the last exposure on."""
    at = max(i for i, row in enumerate(rows) if _part(row, exposed))
    row, done = rows[at], _part(rows[at], exposed)
    if row.count - done < _SHORTEST:
        return tuple(rows[at + 1 :])
    step = (row.x_to_deg - row.x_from_deg) / (row.count - 1)
    begun = replace(row, first_id=row.first_id + done, count=row.count - done, x_from_deg=row.x_from_deg + done * step)
    return (begun, *rows[at + 1 :])


def _part(row: Row, exposed: NDArray[np.int64]) -> int:
    """How much of a row is done, up to its last exposure."""
    here = exposed[(exposed >= row.first_id) & (exposed < row.first_id + row.count)]
    return int(here.max()) - row.first_id + 1 if len(here) else 0
