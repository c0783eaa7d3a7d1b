"""Scanner-like clouds of a surface: unoriented area-uniform points with Gaussian noise, and what can be wrong with a scan.

A noise of 170 um means a standard deviation of 170 um on each axis (convention A), so that it is 170 um along the normal
too.  Under convention B the length of the error vector is 170 um rms; along the normal that is only 98 um.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from tests.bench.reconstruction.implicit import Array, Surface

Region = Callable[[Array], NDArray[np.bool_]]

_DRAW = 1_000_003
"""Distance of the seeds of two draws."""


@dataclass(frozen=True, slots=True)
class Scan:
    """How a surface is sampled.

    Attributes
    ----------
    surface : its name
    points : how many, before those that `dense_above` adds
    sigma_mm : standard deviation of the noise on each axis
    seed : of draw 0
    unscanned_below : no points from below this height, mm: the object stood on its base
    outliers : share of the points that lie anywhere in the bounding box instead
    dense_above : above this height, mm, every point is joined by nine more
    """

    surface: str
    points: int
    sigma_mm: float
    seed: int
    unscanned_below: float | None = None
    outliers: float = 0.0
    dense_above: float | None = None

    def drawn(self, draw: int) -> Scan:
        """The same kind of cloud with other points and other noise."""
        return replace(self, seed=self.seed + _DRAW * draw)

    def scanned(self, p: Array) -> NDArray[np.bool_]:
        """Which points (n, 3) of the truth were in reach of the scanner, (n,)."""
        if self.unscanned_below is None:
            return np.ones(len(p), np.bool_)
        return np.asarray(p[:, 2] > self.unscanned_below)


def area_uniform(mesh: TriangleMesh, count: int, rng: np.random.Generator) -> Array:
    """Points (count, 3) spread evenly over the area of a mesh."""
    a, b, c = mesh.corners()
    cumulative = np.cumsum(mesh.areas())
    i = np.minimum(np.searchsorted(cumulative / cumulative[-1], rng.random(count)), len(cumulative) - 1)
    u, v = np.sqrt(rng.random(count))[:, None], rng.random(count)[:, None]
    return np.asarray((1 - u) * a[i] + u * (1 - v) * b[i] + u * v * c[i])


def true_points(surface: Surface, mesh: TriangleMesh, count: int, rng: np.random.Generator, keep: Region | None = None) -> Array:
    """Area-uniform points (count, 3) on the surface itself, of its part that `keep` accepts."""
    parts: list[Array] = []
    while sum(map(len, parts)) < count:
        p = area_uniform(mesh, count if keep is None else int(1.6 * count), rng)
        parts.append(p if keep is None else p[keep(p)])
    return surface.project(np.concatenate(parts)[:count], 3)


def scan(surface: Surface, mesh: TriangleMesh, how: Scan) -> Array:
    """The points (n, 3) mm of one scan; equal seeds give equal points."""
    rng = np.random.default_rng(how.seed)
    true = true_points(surface, mesh, how.points, rng, None if how.unscanned_below is None else how.scanned)
    height = how.dense_above
    if height is not None:
        more = round(9 * float((true[:, 2] > height).mean()) * how.points)
        true = np.concatenate([true, true_points(surface, mesh, more, rng, lambda p: np.asarray(p[:, 2] > height))])
    points = true + rng.normal(0, how.sigma_mm, true.shape) if how.sigma_mm > 0 else true.copy()
    if how.outliers:
        count = round(how.outliers * len(points))
        which = rng.choice(len(points), count, replace=False)
        low, high = true.min(axis=0), true.max(axis=0)
        points[which] = low + rng.random((count, 3)) * (high - low)
    return points
