"""How far points scatter about the local surface beyond what their covariances say."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.local_surface import NEIGHBOURS, LocalSurface

Array = NDArray[np.float64]

LEAST_POINTS = 200
_MOST_POINTS = 6000
_MOST_SKIPPED = 150
_CLIP = 3.0
_CLIPPED_VARIANCE = 0.9950
"""E[min(z^2, 9)] of a standard normal variate z."""
_ROUNDS = 30


def excess_scatter_mm(points: Array, covariances: Array, apart_mm: float = 0.0) -> float:
    """Standard deviation along the normal of points (n, 3) mm that their covariances (n, 3, 3) mm^2 leave unexplained; 0 if none.

    Every second point is compared with the local quadratic through the others, so that no point pulls its own surface, and
    of these with the ones that are at least `apart_mm` away: nearer ones share its light and err alike.  Distances beyond
    three standard deviations (edges, another sheet of surface) are clipped.
    """
    odd = np.arange(len(points)) % 2 == 1
    asked = np.flatnonzero(odd)
    asked = asked[:: max(1, len(asked) // _MOST_POINTS)]
    if len(asked) < LEAST_POINTS:
        return 0.0
    others = points[~odd]
    about = LocalSurface(others, NEIGHBOURS + _within(others, apart_mm)).distance(points[asked], apart_mm)
    at = asked[about.valid]
    if len(at) < LEAST_POINTS:
        return 0.0
    normals, share = about.normals[about.valid], 1 + about.leverage[about.valid]
    squares = np.square(about.signed_mm[about.valid]) / share
    known = np.einsum("ni,nij,nj->n", normals, covariances[at], normals)
    excess = max(0.0, float(np.median(squares)) / 0.4549 - float(np.median(known)))
    for _ in range(_ROUNDS):
        variance = known + excess
        clipped = np.minimum(squares, _CLIP**2 * variance) / _CLIPPED_VARIANCE
        weight = 1 / np.square(variance)
        before, excess = excess, max(0.0, float(weight @ (clipped - known) / weight.sum()))
        if abs(excess - before) < 1e-4 * float(variance.mean()):
            break
    return float(np.sqrt(excess))


def _within(points: Array, radius_mm: float) -> int:
    """How many points lie within a radius of a place of the surface: the median, at most :data:`_MOST_SKIPPED`."""
    if radius_mm <= 0:
        return 0
    some = points[:: max(1, len(points) // 500)]
    return min(int(np.median(cKDTree(points).query_ball_point(some, radius_mm, return_length=True))), _MOST_SKIPPED)
