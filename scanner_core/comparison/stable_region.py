"""The region that did not change, found without being told: where the distance stays within its own noise."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components, dijkstra

from scanner_core.comparison.surface_pairing import Mask, Pairs, SurfacePairing

Array = NDArray[np.float64]

AVERAGE_MM = 0.5
"""Distances are averaged over this length: noise of single vertices goes, the change of a tooth stays."""
THRESHOLD = 3.0
"""In standard deviations of the averaged distance."""
MARGIN_MM = 1.0
"""Width of the seam left out along what changed: a change fades out over the gum, below the threshold."""
LEAST_MM2 = 15.0
"""Smaller pieces are the lines along which a moved tooth crosses its former surface."""
_LEAST_NOISE_MM = 1e-5
"""Two copies of one file differ by rounding alone."""


def averaged_distance(pairing: SurfacePairing, pairs: Pairs) -> Array:
    """The distance (v,) averaged along the surface over vertices with a counterpart; 0 where there is none near."""
    known = pairs.facing.astype(np.float64)
    both = pairing.average(np.stack([pairs.distances * known, known], axis=1), AVERAGE_MM)
    return np.asarray(both[:, 0] / np.maximum(both[:, 1], 1e-9), np.float64)


def core_noise(values: Array, weights: Array) -> tuple[float, float]:
    """Centre and standard deviation of the narrow peak in values that are partly changes, as wide as may be.

    Starts from the densest quarter, and repeats the standard deviation within two of them until it agrees with itself:
    changes spread over much more than the peak, and add little inside of it.
    """
    order = np.argsort(values)
    v, w = values[order], np.cumsum(weights[order])
    w = w / w[-1]
    # the shortest interval that holds a quarter: around the mode, whatever share lies elsewhere
    low = np.searchsorted(w, np.minimum(w + 0.25, 1.0))
    fits = np.flatnonzero(w + 0.25 <= 1.0)
    width = v[np.minimum(low[fits], len(v) - 1)] - v[fits]
    best = fits[np.argmin(width)]
    centre, sd = 0.5 * (v[best] + v[min(low[best], len(v) - 1)]), max(float(width.min()) / 0.637, _LEAST_NOISE_MM)
    for _ in range(50):
        inside = np.abs(values - centre) < 2.0 * sd
        weight = weights[inside]
        if weight.sum() <= 0:
            break
        centre = float(np.average(values[inside], weights=weight))
        # a normal distribution cut at 2 sd keeps 0.880 of its standard deviation
        new = max(float(np.sqrt(np.average((values[inside] - centre) ** 2, weights=weight))) / 0.8796, _LEAST_NOISE_MM)
        if abs(new - sd) < 1e-4 * sd:
            break
        sd = new
    return centre, sd


def find_stable(pairing: SurfacePairing, pairs: Pairs, at: Pairs | None = None) -> Mask:
    """(v,) bool: averaged distance below the threshold, off the seams of what changed, in pieces that are large.

    The noise is that at the pose of `at`; without it at this pose, where it holds only what a fit to the stable region leaves over.
    """
    averaged = averaged_distance(pairing, pairs)
    facing = pairs.facing
    if not facing.any():
        return facing.copy()
    fitted = facing if at is None else at.facing
    values = averaged if at is None else averaged_distance(pairing, at)
    _, noise = core_noise(values[fitted], pairing.areas[fitted])
    changed = facing & (np.abs(averaged) > THRESHOLD * noise)
    stable = facing & ~changed & ~_within(pairing, changed, MARGIN_MM)
    return _large_pieces(pairing, stable)


def _within(pairing: SurfacePairing, seeds: Mask, distance_mm: float) -> Mask:
    """(v,) bool: within a distance, along the edges, of the seeds."""
    if not seeds.any():
        return np.zeros(len(seeds), np.bool_)
    lengths = pairing.edges.lengths(pairing.after.vertices)
    i, j = pairing.edges.edges.T
    graph = sparse.csr_array((lengths + 1e-12, (i, j)), shape=(len(seeds),) * 2)
    away = dijkstra(graph, directed=False, indices=np.flatnonzero(seeds), min_only=True, limit=distance_mm)
    return np.asarray(np.isfinite(away), np.bool_)


def _large_pieces(pairing: SurfacePairing, stable: Mask) -> Mask:
    """Only the connected pieces of at least `LEAST_MM2`."""
    i, j = pairing.edges.edges.T
    inside = stable[i] & stable[j]
    graph = sparse.csr_array((np.ones(int(inside.sum())), (i[inside], j[inside])), shape=(len(stable),) * 2)
    _, label = connected_components(graph, directed=False)
    area = np.bincount(label, pairing.areas * stable)
    return np.asarray(stable & (area[label] >= LEAST_MM2), np.bool_)
