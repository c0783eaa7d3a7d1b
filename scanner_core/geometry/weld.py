"""Welding of equal points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def weld(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Join points with exactly equal coordinates (0.0 and -0.0 are equal).

    Parameters
    ----------
    points : (n, 3) mm

    Returns
    -------
    The different points (m, 3) in the order in which they first appear, and for each given point its index among
    them, (n,).
    """
    if len(points) == 0:
        return np.empty((0, 3)), np.empty(0, np.int64)
    points = points + 0.0  # turns -0.0 into 0.0
    order = np.lexsort((points[:, 2], points[:, 1], points[:, 0]))  # stable: the first of equals stays first
    ordered = points[order]
    starts = np.r_[True, (ordered[1:] != ordered[:-1]).any(axis=1)]
    first = order[starts]
    appearance = np.argsort(first, kind="stable")
    rank = np.empty(len(first), np.int64)
    rank[appearance] = np.arange(len(first))
    index = np.empty(len(points), np.int64)
    index[order] = rank[np.cumsum(starts) - 1]
    return points[first[appearance]], index
