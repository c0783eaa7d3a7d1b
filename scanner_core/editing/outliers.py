"""Points that belong to no surface: far from their neighbours, off the plane through them, or in a small group of their own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from scanner_core.editing.sight import Array, Mask
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

NEIGHBOURS = 14
_CHUNK = 20_000
_LINK = 4.0
"""Neighbours closer than this many times what is usual there belong together."""
_DENSITIES = 3.0
"""Spacing of the thinnest part of an object, in that of the usual."""
_GROUP_FRACTION = 0.004
_GROUP_LEAST = 30


@dataclass(frozen=True, slots=True, eq=False)
class Outlyingness:
    """How far from usual every point (n,) is, in what is usual about it.

    Attributes
    ----------
    distance : mean distance to its nearest neighbours, in the median of theirs
    offset : distance from the plane through its neighbours, in the rms of theirs
    stray : of a group that is far too small to be part of the object
    """

    distance: Array
    offset: Array
    stray: Mask

    def beyond(self, limit: float) -> Mask:
        """Which points are outliers: `limit` 3 takes much, 8 only what is far off."""
        return np.asarray((self.distance > 0.6 * limit) | (self.offset > limit) | self.stray)


def outlyingness(points: Array, *, progress: OnProgress = lambda _: None, cancelled: IsCancelled = lambda: False) -> Outlyingness:
    """Of points (n, 3) mm.  After the statistical outlier removal of Rusu et al. (2008), with scatter that is local instead of common to all.

    Raises
    ------
    Cancelled
        within half a second.
    """
    count = len(points)
    if count <= NEIGHBOURS:
        return Outlyingness(np.zeros(count), np.zeros(count), np.zeros(count, np.bool_))
    tree = cKDTree(points)
    near = np.empty((count, NEIGHBOURS), np.int32)
    mean_mm, off_mm = np.empty(count), np.empty(count)
    links: list[NDArray[np.float64]] = []
    for start in range(0, count, _CHUNK):
        if cancelled():
            raise Cancelled
        progress(Progress("outliers", 0.9 * start / count))
        here = points[start : start + _CHUNK]
        distances, found = tree.query(here, NEIGHBOURS + 1)
        end = start + len(here)
        near[start:end] = found[:, 1:]
        mean_mm[start:end] = distances[:, 1:].mean(axis=1)
        links.append(distances[:, 1:])
        about = points[found[:, 1:]]
        middle = about.mean(axis=1)
        spread = about - middle[:, None]
        _, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", spread, spread))
        off_mm[start:end] = np.abs(np.einsum("ni,ni->n", here - middle, axes[:, :, 0]))
    # Where a cloud of strays is dense enough to be its own neighbourhood, what is usual elsewhere tells that it is none.
    usual_mm = np.minimum(np.median(mean_mm[near], axis=1), _DENSITIES * float(np.median(mean_mm)))
    # Curvature puts every point a little off the plane of its neighbours; a flat place has next to none.
    scatter_mm = np.sqrt((off_mm[near] ** 2).mean(axis=1) + float(np.median(off_mm)) ** 2)
    distances = np.concatenate(links)
    linked = distances < _LINK * usual_mm[:, None]
    rows = np.repeat(np.arange(count), linked.sum(axis=1))
    groups, of = connected_components(coo_array((np.ones(len(rows), np.bool_), (rows, near[linked])), (count, count)), directed=False)
    sizes = np.bincount(of, minlength=groups)
    stray = sizes[of] < max(_GROUP_FRACTION * count, _GROUP_LEAST) if groups > 1 else np.zeros(count, np.bool_)
    if stray.all():
        stray[:] = False
    return Outlyingness(mean_mm / usual_mm, off_mm / scatter_mm, stray)
