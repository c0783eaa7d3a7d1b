"""How far points scatter about the local surface beyond what their covariances say."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.local_surface import NEIGHBOURS, LocalSurface
from scanner_core.geometry.variance_components import MEDIAN_SQUARE, variance_components

Array = NDArray[np.float64]

LEAST_POINTS = 200
_MOST_POINTS = 6000
_MOST_SKIPPED = 150


def excess_scatter_mm(points: Array, covariances: Array, apart_mm: float = 0.0) -> float:
    """Standard deviation along the normal of points (n, 3) mm that their covariances (n, 3, 3) mm^2 leave unexplained; 0 if none.

    Every second point is compared with the local quadratic through the others, so that no point pulls its own surface, and
    of these with the ones that are at least `apart_mm` away: nearer ones share its light and err alike.  Edges and
    other sheets of surface hardly count (:mod:`~scanner_core.geometry.variance_components`).
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
    start = max(0.0, float(np.median(squares)) / MEDIAN_SQUARE - float(np.median(known)))
    return float(np.sqrt(variance_components(squares, np.ones((len(squares), 1)), np.array([start]), known)[0]))


def _within(points: Array, radius_mm: float) -> int:
    """How many points lie within a radius of a place of the surface: the median, at most :data:`_MOST_SKIPPED`."""
    if radius_mm <= 0:
        return 0
    some = points[:: max(1, len(points) // 500)]
    return min(int(np.median(cKDTree(points).query_ball_point(some, radius_mm, return_length=True))), _MOST_SKIPPED)
