"""The peaks of a line as pieces of a curve: which are neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.stripe_detection import StripePeaks

_LINK_PX = 2.2
"""Neighbours on the line are closer than this."""
_LINK_ASIDE = 0.45
"""And no farther beside each other's tangent than this share of their distance, and a little for their noise."""
_LINK_NOISE_PX = 0.25


def neighbour_links(peaks: StripePeaks) -> NDArray[np.int64]:
    """Pairs of neighbours on the line, (m, 2): every peak's next one to either side along its tangent."""
    n = len(peaks)
    if n < 2:
        return np.empty((0, 2), np.int64)
    tangent = peaks.tangents()
    apart = peaks.xy[None] - peaks.xy[:, None]
    along = np.einsum("ijk,ik->ij", apart, tangent)
    aside = np.abs(apart[:, :, 1] * tangent[:, None, 0] - apart[:, :, 0] * tangent[:, None, 1])
    distance, beside = np.abs(along), np.maximum(aside, aside.T)
    near = (distance < _LINK_PX) & (distance > 1e-6) & (beside < _LINK_ASIDE * distance + _LINK_NOISE_PX)
    found = []
    for ahead in (along > 0, along < 0):
        far = np.where(near & ahead, distance + beside, np.inf)
        nearest = far.argmin(axis=1)
        rows = np.flatnonzero(np.isfinite(far[np.arange(n), nearest]))
        found.append(np.sort(np.c_[rows, nearest[rows]], axis=1))
    return np.unique(np.concatenate(found), axis=0)
