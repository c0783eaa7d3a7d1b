"""The peaks of a line as pieces of a curve: which are neighbours, and what the lens's blur does to a bent curve.

A lens blurs a line along itself as well as across.  Where the light grows along a slanted line by the share g per pixel, the profile
of a row is drawn to the brighter side by ``sigma^2 slope g``.  Where it is bent, the light of both sides lies on the inner side of the bend, so
the ridge is drawn inwards: to first order by half the curvature times the variance of the blur.  A quarter of a pixel on the
cusp of a tooth, towards the inside in both images: the points would lie deep.  Seen as a filter, the blur takes
``exp(-k^2 sigma^2 / 2)`` of a wave with wave number k; each of the two rounds here puts back the next term of its inverse's series.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.stripe_detection import StripePeaks

Array = NDArray[np.float64]

_LINK_PX = 2.2
"""Neighbours on the line are closer than this."""
_LINK_ASIDE = 0.45
"""And no farther beside each other's tangent than this share of their distance, and a little for their noise."""
_LINK_NOISE_PX = 0.25
_REACH_PX = 2.6
"""So far to both sides a parabola is laid through the peaks."""
_LEAST_FITTED = 5


def neighbour_links(peaks: StripePeaks) -> NDArray[np.int64]:
    """Pairs of neighbours on the line, (m, 2): every peak's next one to either side along its tangent."""
    n = len(peaks)
    if n < 2:
        return np.empty((0, 2), np.int64)
    along, aside = _apart(peaks)
    distance, beside = np.abs(along), np.maximum(np.abs(aside), np.abs(aside.T))
    near = (distance < _LINK_PX) & (distance > 1e-6) & (beside < _LINK_ASIDE * distance + _LINK_NOISE_PX)
    found = []
    for ahead in (along > 0, along < 0):
        far = np.where(near & ahead, distance + beside, np.inf)
        nearest = far.argmin(axis=1)
        rows = np.flatnonzero(np.isfinite(far[np.arange(n), nearest]))
        found.append(np.sort(np.c_[rows, nearest[rows]], axis=1))
    return np.unique(np.concatenate(found), axis=0)


def sharpened(peaks: StripePeaks, blur_px: tuple[float, float]) -> StripePeaks:
    """The peaks where they would be without the lens's blur, whose standard deviations along x and y are given, px.

    A peak is moved along the coordinate that was measured, and its variance grows by what the correction itself is uncertain.
    Peaks with too few neighbours stay where they are.
    """
    n = len(peaks)
    if not n:
        return peaks
    along, aside = _apart(peaks)
    beside = np.maximum(np.abs(aside), np.abs(aside.T))
    weight = np.where(beside < _LINK_ASIDE * np.abs(along) + _LINK_NOISE_PX, np.maximum(1 - (along / _REACH_PX) ** 2, 0.0), 0.0)
    # parabolas through the neighbours in each peak's own frame, by weighted least squares: c = row of `second` times aside
    powers = np.stack([np.ones_like(along), along, along**2], axis=2)
    normal = np.einsum("ij,ijk,ijl->ikl", weight, powers, powers) + 1e-9 * np.eye(3)
    second = np.einsum("ik,ijk,ij->ij", np.linalg.inv(normal)[:, 2], powers, weight)
    both = np.minimum((weight * (along > 0.5)).sum(axis=1), (weight * (along < -0.5)).sum(axis=1))
    fitted = ((weight > 0).sum(axis=1) >= _LEAST_FITTED) & (both > 0.5)
    second[~fitted] = 0.0
    tangent = peaks.tangents()
    # a row gathers light from the rows above and below: its mean is drawn by half of x'' = 2 c (1 + slope^2)^1.5 times their variance,
    # across the line by c (1 + slope^2) times it; twice, the second time of what the first has put back
    gathered = np.where(peaks.along_row, blur_px[1] ** 2, blur_px[0] ** 2)
    variance = gathered * (1 + peaks.slope**2)
    normals = np.c_[-tangent[:, 1], tangent[:, 0]]
    moved = -variance * (second * aside).sum(axis=1)
    again = -variance * (second * (moved[None, :] * (normals @ normals.T))).sum(axis=1)
    across = moved + 0.5 * again
    measured = np.where(peaks.along_row, normals[:, 0], normals[:, 1])
    xy = peaks.xy.copy()
    shift = across / measured - gathered * peaks.slope * peaks.growth
    xy[peaks.along_row, 0] += shift[peaks.along_row]
    xy[~peaks.along_row, 1] += shift[~peaks.along_row]
    own = peaks.across_variance_px2()
    grown = peaks.variance_px2 * np.maximum(1 - variance * np.diag(second), 1.0) ** 2 + (variance**2 * (second**2 @ own)) * (1 + peaks.slope**2)
    return replace(peaks, xy=xy, variance_px2=grown)


def _apart(peaks: StripePeaks) -> tuple[Array, Array]:
    """Where all peaks lie from each, along its tangent and along its normal, (n, n) px each; row i from peak i."""
    tangent = peaks.tangents()
    apart = peaks.xy[None] - peaks.xy[:, None]
    along = np.einsum("ijk,ik->ij", apart, tangent)
    aside = apart[:, :, 1] * tangent[:, None, 0] - apart[:, :, 0] * tangent[:, None, 1]
    return along, aside
