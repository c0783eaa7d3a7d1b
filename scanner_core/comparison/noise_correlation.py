"""How noisy the signed distance is, and over which length this noise is alike along the surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

_CENTRES = 2000
_PAIRS = 400_000
"""Bounds the pairs that are looked at: over a long reach the points are thinned, not the centres."""
_BINS = 16
_LEAST_PAIRS = 200
_SMALL = 0.02
"""Of the variance: a correlation below it is taken for none.  Five per cent over a ring of a millimetre would already
matter as much as the variance itself, so dense are the points."""
_FURTHEST_MM = 6.0


@dataclass(frozen=True, slots=True, eq=False)
class Neighbours:
    """Pairs (centre, other) of different points near each other: some of the points are centres, all may be others.

    `scale` is the number of pairs that there are over that of those here.
    """

    centre: Indices
    other: Indices
    apart_mm: Array
    scale: float


@dataclass(frozen=True, slots=True, eq=False)
class NoiseCorrelation:
    """Attributes
    ----------
    variance : mean square of the noise of one point
    covariance : (b,) mean product of the noise of two points, by bins of equal width of their distance, up to `reach_mm`;
        empty where nothing is correlated
    reach_mm : end of the last bin
    near : the pairs on which it was measured
    """

    variance: float
    covariance: Array
    reach_mm: float
    near: Neighbours

    @property
    def length_mm(self) -> float:
        """Radius of the disk that holds as much correlation: ``pi length^2`` is its integral over the plane; 0 for white noise."""
        if not len(self.covariance) or self.variance <= 0:
            return 0.0
        edges = np.linspace(0, self.reach_mm, len(self.covariance) + 1)
        integral = float(np.sum((edges[1:] ** 2 - edges[:-1] ** 2) * self.covariance)) / self.variance
        return float(np.sqrt(max(integral, 0.0)))

    def gaussian(self) -> tuple[float, float]:
        """Share of the variance that is correlated, and the length l of ``exp(-h^2 / 2 l^2)`` that falls off alike, mm."""
        share = float(np.clip(self.covariance[0] / self.variance, 0.05, 0.95))
        below = np.flatnonzero(self.covariance < np.exp(-0.5) * self.covariance[0])
        bins = int(below[0]) if len(below) else len(self.covariance)
        return share, max(bins, 1) * self.reach_mm / len(self.covariance)

    def correlated(self) -> tuple[Indices, Indices, Array]:
        """The pairs within reach, centre and other, and the covariance of each."""
        close = self.near.apart_mm < self.reach_mm
        which = (self.near.apart_mm[close] / max(self.reach_mm, 1e-300) * len(self.covariance)).astype(np.int64)
        return self.near.centre[close], self.near.other[close], self.covariance[np.minimum(which, len(self.covariance) - 1)]


def measure_correlation(points: Array, noise: Array, rng: np.random.Generator) -> NoiseCorrelation:
    """Of residuals `noise` (n,) at points (n, 3) mm: an empirical covariance function (Cressie, "Statistics for spatial data", 1993).

    The reach doubles until the correlation has died away within it.
    """
    tree = cKDTree(points)
    variance = float(np.mean(noise**2))
    few = points[rng.choice(len(points), min(500, len(points)), replace=False)]
    spacing = float(np.median(tree.query(few, min(7, len(points)))[0][:, -1]))
    furthest = max(min(float(np.ptp(points, axis=0).max()) / 4, _FURTHEST_MM), 2 * spacing)
    reach = 4 * spacing
    while True:
        near = _neighbours(tree, points, reach, rng)
        which = np.minimum((near.apart_mm / reach * _BINS).astype(np.int64), _BINS - 1)
        count = np.bincount(which, minlength=_BINS)
        known = np.flatnonzero(count >= _LEAST_PAIRS)
        if not len(known):
            return NoiseCorrelation(variance, np.zeros(0), 0.0, near)
        mean = np.bincount(which, noise[near.centre] * noise[near.other], minlength=_BINS) / np.maximum(count, 1)
        # bins with hardly a pair (closer than the points lie) take the value of the next one
        mean = mean[known[np.minimum(np.searchsorted(known, np.arange(_BINS)), len(known) - 1)]]
        high = np.flatnonzero(np.abs(mean) > _SMALL * variance)
        ends = int(high[-1]) + 1 if len(high) else 0
        if ends <= _BINS // 2 or reach >= furthest:
            return NoiseCorrelation(variance, mean[:ends], reach * ends / _BINS, near)
        reach = min(2 * reach, furthest)


def _neighbours(tree: cKDTree, points: Array, reach_mm: float, rng: np.random.Generator) -> Neighbours:
    centres = rng.choice(len(points), min(_CENTRES, len(points)), replace=False)
    about = float(np.mean(tree.query_ball_point(points[centres[:100]], reach_mm, return_length=True)))
    others = np.arange(len(points))
    if len(centres) * about > _PAIRS:
        others = rng.choice(len(points), max(int(len(points) * _PAIRS / (len(centres) * about)), 100), replace=False)
        tree = cKDTree(points[others])
    found = tree.query_ball_point(points[centres], reach_mm)
    count = np.array([len(one) for one in found])
    centre, other = np.repeat(centres, count).astype(np.int64), others[np.concatenate([np.asarray(one, np.int64) for one in found])]
    different = centre != other
    centre, other = centre[different], other[different]
    apart = np.sqrt(np.sum((points[centre] - points[other]) ** 2, axis=1))
    return Neighbours(centre, other, apart, len(points) ** 2 / (len(centres) * len(others)))
