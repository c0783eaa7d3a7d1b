"""How noisy the signed distance is, and over which length this noise is alike along the surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]

_CENTRES = 1500
_NEIGHBOURS = 1_500_000
"""Bounds the pairs that are looked at."""
_BINS = 12
_LEAST_PAIRS = 300
_ENDS_AT = 0.05
"""Of the variance: a correlation below it is taken for none."""


@dataclass(frozen=True, slots=True, eq=False)
class NoiseCorrelation:
    """Attributes
    ----------
    sd_mm : standard deviation of one distance
    edges_mm : (b + 1,) bounds of the bins of distance, rising
    covariance : (b,) mm^2, mean product of the noise of two points that far apart; empty where nothing is correlated
    length_mm : equivalent radius of the correlation: ``pi length^2 = integral of the correlation over the plane``; 0 for white noise
    """

    sd_mm: float
    edges_mm: Array
    covariance: Array
    length_mm: float


@dataclass(frozen=True, slots=True, eq=False)
class Neighbours:
    """Pairs (centre, other) of points near each other: some of the points are centres, all points may be others.

    `scale` is the number of points over the number of centres.
    """

    centre: NDArray[np.int64]
    other: NDArray[np.int64]
    apart_mm: Array
    scale: float


def neighbours(points: Array, reach_mm: float, rng: np.random.Generator) -> Neighbours:
    """Pairs of different points (n, 3) within `reach_mm`."""
    tree = cKDTree(points)
    centres = np.arange(len(points)) if len(points) <= _CENTRES else rng.choice(len(points), _CENTRES, replace=False)
    about = float(np.mean(tree.query_ball_point(points[centres[:100]], reach_mm, return_length=True)))
    most = max(100, int(_NEIGHBOURS / max(about, 1.0)))
    centres = centres[:most]
    found = tree.query_ball_point(points[centres], reach_mm)
    count = np.array([len(one) for one in found])
    centre = np.repeat(centres, count)
    other = np.fromiter((index for one in found for index in one), np.int64, int(count.sum()))
    different = centre != other
    centre, other = centre[different], other[different]
    apart = np.sqrt(np.sum((points[centre] - points[other]) ** 2, axis=1))
    return Neighbours(centre, other, apart, len(points) / len(centres))


def measure_correlation(points: Array, noise: Array, rng: np.random.Generator) -> tuple[NoiseCorrelation, Neighbours]:
    """Of residuals `noise` (n,) mm at points (n, 3) mm, by the mean product of pairs in bins of their distance.

    The reach doubles until the correlation has died away within it.
    """
    variance = float(np.mean(noise**2))
    extent = float(np.ptp(points, axis=0).max())
    spacing = float(np.median(cKDTree(points).query(points[:: max(1, len(points) // 2000)], 2)[0][:, 1]))
    reach = max(4 * spacing, 1e-9)
    while True:
        near = neighbours(points, reach, rng)
        edges = np.linspace(0, reach, _BINS + 1)
        which = np.minimum((near.apart_mm / reach * _BINS).astype(np.int64), _BINS - 1)
        count = np.bincount(which, minlength=_BINS)
        covariance = np.bincount(which, noise[near.centre] * noise[near.other], minlength=_BINS) / np.maximum(count, 1)
        # bins with hardly a pair (closer than the points lie) take the value of the next bin that has some
        known = np.flatnonzero(count >= _LEAST_PAIRS)
        covariance = covariance[known[np.minimum(np.searchsorted(known, np.arange(_BINS)), len(known) - 1)]] if len(known) else np.zeros(_BINS)
        low = np.flatnonzero(covariance < _ENDS_AT * variance)
        if len(low) or reach > extent / 3:
            break
        reach *= 2
    ends = int(low[0]) if len(low) else _BINS
    middles = 0.5 * (edges[1:] + edges[:-1])
    ring = 2 * np.pi * middles * np.diff(edges)
    integral = float(np.sum(ring[:ends] * covariance[:ends])) / max(variance, 1e-300)
    return NoiseCorrelation(float(np.sqrt(variance)), edges[: ends + 1], covariance[:ends], float(np.sqrt(max(integral, 0.0) / np.pi))), near
