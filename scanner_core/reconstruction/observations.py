"""The points as the fit sees them: places, how many measurements each stands for, and how uncertain each is.

A cloud of a million points says no more about a surface than its cells do, as long as a cell is small against what the
surface can resolve: for a least-squares fit, points of one cell are exactly their mean with their number as its weight, and
their scatter goes into the estimate of the noise.  Covariances count as proportions only: a scanner knows better in which
direction and where it is uncertain than by how much, so their scale is estimated from the residuals.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MOST_OBSERVATIONS = 120_000
"""More points than these are merged into cells; it bounds memory and time."""

_MOST_UNEVEN = 16.0
"""Largest variance over the typical one, and the typical one over the smallest, that a covariance is believed; the same again for a direction."""


@dataclass(frozen=True, slots=True, eq=False)
class Observations:
    """Points, or means of the points in small cells.

    Attributes
    ----------
    points : (n, 3) float64, mm, about the centre of the cloud
    counts : (n,) float64, measurements in each
    shapes : (n, 3, 3) covariances over their typical variance (the harmonic mean of a third of the trace), or None when all are alike
    scatter : (n, 3, 3) mm^2, second moment of the merged points about their mean, or None when nothing was merged
    """

    points: Array
    counts: Array
    shapes: Array | None = None
    scatter: Array | None = None

    def __len__(self) -> int:
        return len(self.points)

    def select(self, which: NDArray[np.int64]) -> Observations:
        """Those of some indices."""
        shapes = None if self.shapes is None else self.shapes[which]
        scatter = None if self.scatter is None else self.scatter[which]
        return Observations(self.points[which], self.counts[which], shapes, scatter)

    def relative_variance(self, normals: Array) -> Array:
        """Variance of each along its unit normal (n, 3), in units of the typical one, (n,)."""
        if self.shapes is None:
            return np.ones(len(self.points))
        return np.asarray(np.einsum("ni,nij,nj->n", normals, self.shapes, normals))

    def tangential_variance(self, normals: Array) -> Array:
        """Mean variance across the normals (n, 3), in units of the typical one, (n,)."""
        if self.shapes is None:
            return np.ones(len(self.points))
        return np.asarray(0.5 * (np.trace(self.shapes, axis1=1, axis2=2) - self.relative_variance(normals)))

    def scatter_along(self, normals: Array) -> Array:
        """Second moment of the merged points about their mean along the normals (n, 3), (n,), mm^2."""
        if self.scatter is None:
            return np.zeros(len(self.points))
        return np.asarray(np.einsum("ni,nij,nj->n", normals, self.scatter, normals))


def observations_of(points: Array, covariances: Array | None, most: int = MOST_OBSERVATIONS) -> Observations:
    """The observations of points (n, 3) about their centre with covariances (n, 3, 3); merged when there are more than `most`."""
    shapes = None if covariances is None else _shapes(covariances)
    single = Observations(points, np.ones(len(points)), shapes)
    return single if len(points) <= most else merged(single, _cell_mm(points, most))


def _shapes(covariances: Array) -> Array | None:
    """Covariances (n, 3, 3) as proportions; None when they say nothing.  One that is no covariance counts as a typical one."""
    finite = np.asarray(np.isfinite(covariances).all(axis=(1, 2)), np.bool_)
    usable = np.where(finite[:, None, None], covariances, np.eye(3))
    usable = 0.5 * (usable + usable.transpose(0, 2, 1))
    variance = np.trace(usable, axis1=1, axis2=2) / 3
    valid = finite & (variance > 0) & (np.linalg.eigvalsh(usable)[:, 0] >= -1e-6 * variance)
    if not np.any(valid):
        return None
    # the variance of the points that tell most: with the median, many bad points would make the good ones look like them
    typical = float(1 / np.mean(1 / np.maximum(variance[valid], np.median(variance[valid]) / _MOST_UNEVEN)))
    bounded = np.clip(variance, typical / _MOST_UNEVEN, typical * _MOST_UNEVEN)
    shapes = usable * (bounded / np.where(valid, variance, 1.0) / typical)[:, None, None]
    # a direction in which a covariance is singular would weigh without bound
    shapes += np.eye(3) * (bounded / typical / _MOST_UNEVEN)[:, None, None]
    shapes[~valid] = np.eye(3)
    return np.asarray(shapes)


def _cell_mm(points: Array, most: int) -> float:
    """Side of the cells of which `most` are occupied, from a sample of sizes."""
    extent = float((points.max(axis=0) - points.min(axis=0)).max())
    low, high = extent / 4096, extent / 8
    for _ in range(12):
        cell = float(np.sqrt(low * high))
        if len(np.unique(_cell_keys(points, cell))) > most:
            low = cell
        else:
            high = cell
        if high < 1.03 * low:
            break
    return high


def _cell_keys(points: Array, cell_mm: float) -> NDArray[np.int64]:
    """One int64 for the cell of each point (n, 3)."""
    place = np.floor((points - points.min(axis=0)) / cell_mm).astype(np.int64)
    size = place.max(axis=0) + 1
    return np.asarray((place[:, 0] * size[1] + place[:, 1]) * size[2] + place[:, 2])


def merged(single: Observations, cell_mm: float) -> Observations:
    """Merge observations within cubic cells of side `cell_mm`; the order of the cells does not depend on that of the points."""
    keys = _cell_keys(single.points, cell_mm)
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    begins = np.flatnonzero(np.r_[True, ordered[1:] != ordered[:-1]])
    cell = np.cumsum(np.r_[False, ordered[1:] != ordered[:-1]])
    weights = single.counts[order]
    total = np.add.reduceat(weights, begins)
    points = single.points[order]
    means = np.add.reduceat(points * weights[:, None], begins) / total[:, None]
    away = points - means[cell]
    scatter = np.empty((len(total), 3, 3))
    for i in range(3):
        for j in range(i, 3):
            inner = 0.0 if single.scatter is None else single.scatter[order, i, j]
            scatter[:, i, j] = scatter[:, j, i] = np.add.reduceat(weights * (away[:, i] * away[:, j] + inner), begins) / total
    shapes = None
    if single.shapes is not None:
        flat = single.shapes[order].reshape(-1, 9) * weights[:, None]
        shapes = (np.add.reduceat(flat, begins) / total[:, None]).reshape(-1, 3, 3)
    return Observations(means, total, shapes, scatter)
