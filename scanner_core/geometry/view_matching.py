"""Which views of an object overlap, and how far their surfaces lie apart where they do."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.local_surface import LocalSurface
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

MIN_MATCHES = 30
"""Correspondences between two views: fewer say nothing about six unknowns."""


@dataclass(frozen=True, slots=True, eq=False)
class ViewMatches:
    """Correspondences of a pair of views: points of `first` against the surface of `second`."""

    first: int
    second: int
    points: Array
    """(n, 3) mm, moved by the first view's correction."""
    distance: Array
    """(n,) signed, mm."""
    normals: Array
    relative_variance: Array
    """(n,), of the distance in units of a typical point's variance."""


def overlapping_pairs(views: list[Array], partners: int) -> list[tuple[int, int]]:
    """Ordered pairs of views to compare: each view with those that share the most cells of space with it."""
    filled = [v for v in views if len(v)]
    if len(filled) < 2:
        return []
    every = np.concatenate(filled)
    low = every.min(axis=0)
    cell = max(float((every.max(axis=0) - low).max()) / 40, 1e-6)
    cells = []
    for points in views:
        i, j, k = np.floor((points - low) / cell).astype(np.int64).T if len(points) else np.empty((3, 0), np.int64)
        cells.append(np.unique(i + 64 * (j + 64 * k)))
    shared = np.array([[0 if a is b else len(np.intersect1d(a, b, assume_unique=True)) for b in cells] for a in cells])
    pairs = set()
    for view in range(len(views)):
        for partner in np.argsort(-shared[view], kind="stable")[:partners]:
            if shared[view, partner] > 0:
                pairs |= {(view, int(partner)), (int(partner), view)}
    return sorted(pairs)


def match_views(
    cloud: PointCloud,
    chosen: list[NDArray[np.int64]],
    surfaces: list[LocalSurface],
    pairs: list[tuple[int, int]],
    corrections: tuple[RigidTransform, ...],
    max_distance_mm: float,
) -> list[ViewMatches]:
    """Distances of the chosen points to the other views' surfaces, with the corrections so far."""
    found = []
    typical = typical_variance(cloud)
    for first, second in pairs:
        index = chosen[first]
        moved = corrections[first].apply(cloud.points[index])
        back = corrections[second].inverse()
        near = surfaces[second].distance(back.apply(moved))
        keep = near.valid & (np.abs(near.signed_mm) < max_distance_mm)
        if np.count_nonzero(keep) < MIN_MATCHES:
            continue
        normals = corrections[second].rotate(near.normals[keep])
        variance = np.ones(len(normals))
        if cloud.covariances is not None:
            own = np.einsum("ni,nij,nj->n", normals, cloud.covariances[index[keep]], normals)
            variance = np.clip(own / typical, 0.25, 16.0)
        found.append(ViewMatches(first, second, moved[keep], near.signed_mm[keep], normals, variance + near.leverage[keep]))
    return found


def typical_variance(cloud: PointCloud) -> float:
    """Median variance of a coordinate, mm^2."""
    if cloud.covariances is None:
        return 1.0
    return max(float(np.median(np.trace(cloud.covariances, axis1=1, axis2=2))) / 3, 1e-12)


def overlap_fractions(matches: list[ViewMatches], chosen: list[NDArray[np.int64]], count: int) -> tuple[float, ...]:
    """By view, the largest part of its chosen points that one partner's surface covers."""
    best = [0.0] * count
    for m in matches:
        best[m.first] = max(best[m.first], len(m.distance) / max(len(chosen[m.first]), 1))
    return tuple(best)
