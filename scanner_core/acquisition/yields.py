"""How often an exposure of a place gives a point, learned from the views so far.

A surface that is only half known predicts sights that are not there: behind a cap that spans a hole, light finds something
else or nothing.  What was tried in vain is not tried again from about the same angle.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.acquisition.plan import ViewPlan
from scanner_core.coverage.sight import Sight

Array = NDArray[np.float64]

_EXPECTED = 0.9
_TRIALS = 1.5
"""What is expected before anything was tried, and the trials that this is worth."""

_ALIKE_DEG = 12.0
"""Angles that differ by so much speak for each other by 60 %."""


def expected_yields(
    angles_deg: Array, places: int, done: Sequence[ViewPlan], measured_ids: NDArray[np.int64], sight_at: Callable[[float], Sight], reach_deg: float
) -> Array:
    """Points for an exposure of every place from every angle, (angles, places), 0 to 1.

    Parameters
    ----------
    done : views that were scanned, in the order of their trigger ids; what follows the last point of one was not exposed
    measured_ids : (m,) trigger ids that gave a point
    sight_at : the places, seen at a table angle
    reach_deg : how near to a place the beam means it
    """
    tries, hits = np.zeros((len(angles_deg), places)), np.zeros((len(angles_deg), places))
    for view in done:
        ids, beams = _exposures(view)
        got = np.isin(ids, measured_ids)
        if not np.any(got):
            continue
        last = int(np.flatnonzero(got)[-1]) + 1
        sight = sight_at(view.table_deg)
        met = np.flatnonzero(sight.beam_free & (sight.cosines[:, 0] > 0))
        if not len(met):
            continue
        away, nearest = cKDTree(sight.beam_deg[met]).query(beams[:last], distance_upper_bound=reach_deg)
        near = np.isfinite(away)
        meant = met[nearest[near]]
        apart = (angles_deg - view.table_deg + 180) % 360 - 180
        alike = np.exp(-0.5 * (apart / _ALIKE_DEG) ** 2)[:, None]
        tries += alike * np.bincount(meant, minlength=places)
        hits += alike * np.bincount(meant[got[:last][near]], minlength=places)
    return np.asarray((hits + _TRIALS * _EXPECTED) / (tries + _TRIALS))


def _exposures(view: ViewPlan) -> tuple[NDArray[np.int64], Array]:
    """Trigger ids (n,) and beam angles (n, 2) of a view."""
    ids = [np.arange(row.first_id, row.first_id + row.count) for row in view.rows]
    beams = [np.column_stack([np.linspace(row.x_from_deg, row.x_to_deg, row.count), np.full(row.count, row.y_deg)]) for row in view.rows]
    return (np.concatenate(ids), np.concatenate(beams)) if ids else (np.zeros(0, np.int64), np.zeros((0, 2)))
