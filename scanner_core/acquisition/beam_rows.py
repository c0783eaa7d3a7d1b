"""From the points wanted at places of a surface to rows of the beam, at one table angle.

The rows lie on a raster that is as fine as the densest part asks for.  Where fewer points are wanted, rows are left out: down
the rows every column adds up what it is owed, and where that comes to one exposure the beam sweeps there and nowhere else
(error diffusion, Floyd and Steinberg 1976, in one dimension).  A short gap is swept through, since a row of its own costs time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.acquisition.plan import Row

Array = NDArray[np.float64]

_COMBS = (0, 2, 1, 3)
"""Order of four interleaved combs of rows, so that a view that has its points early is thinned evenly."""

_DENSEST = 0.9
"""Quantile of the wanted densities, by points, that the raster is made for."""

_SHORTEST = 5
"""Exposures of the shortest row."""

_GAP = 4
"""Exposures that take as long as the way to another row."""

_MOST_CELLS = 400_000


@dataclass(frozen=True, slots=True, eq=False)
class BeamRows:
    """The rows of one view, the raster's step and the exposures."""

    rows: tuple[Row, ...]
    step_deg: float

    @property
    def exposures(self) -> int:
        return sum(row.count for row in self.rows)


def beam_rows(
    beam_deg: Array, per_deg2: Array, exposures: float, reach_deg: float, steps_deg: tuple[float, float],
    limits_deg: tuple[tuple[float, float], tuple[float, float]], view: int, first_id: int,
) -> BeamRows:  # fmt: skip
    """Rows over places that the beam reaches.

    Parameters
    ----------
    beam_deg : (n, 2) pan and tilt of places that the beam meets; also of those where nothing is wanted, so that they are left out
    per_deg2 : (n,) exposures wanted on a square degree there
    exposures : wanted in all
    reach_deg : how far from a place its density still holds
    steps_deg : the narrowest and the widest step of the raster
    limits_deg : of pan and tilt
    """
    wanted = per_deg2 > 0
    if not np.any(wanted):
        return BeamRows((), steps_deg[1])
    dense = _weighted_quantile(per_deg2[wanted], per_deg2[wanted], _DENSEST)
    low, high = beam_deg[wanted].min(axis=0) - reach_deg, beam_deg[wanted].max(axis=0) + reach_deg
    low = np.maximum(low, [limits_deg[0][0], limits_deg[1][0]])
    high = np.minimum(high, [limits_deg[0][1], limits_deg[1][1]])
    step = min(max(dense**-0.5, float(np.sqrt(np.prod(high - low) / _MOST_CELLS)), steps_deg[0]), steps_deg[1])
    # the raster's phase differs from view to view, so that rows of two views do not fall on each other
    phase = np.mod((view + 1) * np.array([0.7548776662, 0.5698402910]), 1.0)  # Roberts' R2 sequence
    x = np.arange(low[0] + phase[0] * step, high[0], step)
    y = np.arange(low[1] + phase[1] * step, high[1], step)
    if len(x) < _SHORTEST or not len(y):
        x = np.clip(beam_deg[wanted].mean(axis=0)[0] + (np.arange(_SHORTEST) - 0.5 * (_SHORTEST - 1)) * step, *limits_deg[0])
        y = y if len(y) else beam_deg[wanted].mean(axis=0)[1:]
    owed = _density(beam_deg, per_deg2, reach_deg, x, y)
    owed *= exposures / max(float(owed.sum()), 1e-12)
    sweeps = _diffused(np.minimum(owed, 1.0))
    rows, next_id = list[Row](), first_id
    for comb in _COMBS:
        for line in range(comb, len(y), len(_COMBS)):
            for begin, end in sweeps[line]:
                rows.append(Row(view, next_id, end - begin, float(y[line]), float(x[begin]), float(x[end - 1])))
                next_id += end - begin
    return BeamRows(tuple(rows), step)


def _density(beam_deg: Array, per_deg2: Array, reach_deg: float, x: Array, y: Array) -> Array:
    """(rows, columns) of the raster, that of the nearest place; 0 where none is near."""
    grid = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    away, which = cKDTree(beam_deg).query(grid, distance_upper_bound=reach_deg)
    density = np.where(np.isfinite(away), per_deg2[np.minimum(which, len(per_deg2) - 1)], 0.0)
    return np.asarray(density.reshape(len(y), len(x)))


def _diffused(owed: Array) -> list[list[tuple[int, int]]]:
    """Runs (begin, end) of columns to sweep in each row, whose cells sum to what is owed (rows, columns), each at most 1."""
    debt = 0.5 * (np.arange(owed.shape[1]) % 2) * (owed.max(axis=0) > 0)
    result = []
    for line in owed:
        debt = debt + line
        level = np.convolve(np.pad(debt, 2, mode="edge"), np.ones(5) / 5, mode="valid")
        runs = _runs((level >= 0.75) & (line > 0))
        result.append(runs)
        for begin, end in runs:
            debt[begin:end] -= 1.0
    return result


def _runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Runs of a mask (n,): short gaps are filled, and runs that are too short left away."""
    edges = np.flatnonzero(np.diff(np.r_[False, mask, False].astype(np.int8)))
    runs = list[tuple[int, int]]()
    for begin, end in edges.reshape(-1, 2).tolist():
        if runs and begin - runs[-1][1] <= _GAP:
            runs[-1] = (runs[-1][0], end)
        else:
            runs.append((begin, end))
    return [(begin, end) for begin, end in runs if end - begin >= _SHORTEST]


def _weighted_quantile(values: Array, weights: Array, share: float) -> float:
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(total, share * total[-1])])
