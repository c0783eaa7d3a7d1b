"""The bodies that stand up from a surface - the crowns of an arch - by a watershed of height."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
VALLEY_MM = 0.8
"""A valley as deep as this parts two crowns: gaps between teeth are deeper, most fissures shallower."""
FURROW_MM = 0.3
"""A valley less deep than this is noise.  What is between the two may be a fissure or a narrow gap: only motion can tell."""
_SMOOTHING_MM = 0.5
_FREE_MM = 0.5
"""The free part of a crown goes down to so far below the highest valley round it."""


@dataclass(frozen=True, slots=True, eq=False)
class Crowns:
    """A partition of a surface into the surroundings of its summits, in two steps.

    Attributes
    ----------
    crown : (v,) int64, of each vertex the crown, 0 to the number of crowns - 1: parted from the others by a valley
    cusp : (v,) int64, the same for the finer parts, parted by furrows at least
    free : (v,) bool, what stands free of the gum
    """

    crown: NDArray[np.int64]
    cusp: NDArray[np.int64]
    free: NDArray[np.bool_]


def find_crowns(mesh: TriangleMesh, up: Array, smoother: SurfaceSmoother, table: EdgeTable) -> Crowns:
    """Watershed of the height along `up` (3,): vertices in falling order join the higher ground beside them.

    Two summits stay apart where the lower one stands as high above the pass between them as the valley's depth must be
    (persistence; Edelsbrunner, Letscher and Zomorodian, Topological persistence and simplification, 2002).  What is not free
    belongs to the crown and cusp whose free part is nearest: down on the gum, falling water tells nothing.
    """
    height = smoother(mesh.vertices @ up, _SMOOTHING_MM)
    cusp, summits, passes = _watershed(height, table)
    peak = height[summits]
    crown_of = np.arange(len(summits))
    for level, one, other in sorted(passes, reverse=True):
        a, b = crown_of[one], crown_of[other]
        if a != b and min(peak[a], peak[b]) - level < VALLEY_MM:
            lower, upper = (a, b) if peak[a] < peak[b] else (b, a)
            crown_of[crown_of == lower] = upper
    pass_of = np.full(len(summits), float(height.min()))
    for level, one, other in passes:
        a, b = crown_of[one], crown_of[other]
        if a != b:
            pass_of[[a, b]] = np.maximum(pass_of[[a, b]], level)
    free = np.asarray(height > pass_of[crown_of[cusp]] - _FREE_MM)
    nearest = cKDTree(mesh.vertices[free]).query(mesh.vertices[~free])[1]
    cusp[~free] = cusp[free][nearest]
    crown = np.unique(crown_of, return_inverse=True)[1][cusp]
    return Crowns(crown.astype(np.int64), cusp, free)


def _watershed(height: Array, table: EdgeTable) -> tuple[NDArray[np.int64], NDArray[np.int64], list[tuple[float, int, int]]]:
    """Number of the summit of each vertex (v,), the summits (n,), and the highest pass between each two: (height, one, other)."""
    count = len(height)
    start = np.concatenate([table.edges[:, 0], table.edges[:, 1]])
    neighbours = np.concatenate([table.edges[:, 1], table.edges[:, 0]])[np.argsort(start, kind="stable")].tolist()
    offsets = np.concatenate([[0], np.cumsum(np.bincount(start, minlength=count))]).tolist()
    heights = height.tolist()
    parent = [-1] * count
    owner = [-1] * count  # the summit on whose slope a vertex was reached; -1: still under water
    passes: list[tuple[float, int, int]] = []

    def root(i: int) -> int:
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for i in np.argsort(-height, kind="stable").tolist():
        around = {root(owner[j]) for j in neighbours[offsets[i] : offsets[i + 1]] if owner[j] >= 0}
        if not around:
            parent[i] = owner[i] = i
            continue
        best = max(around, key=heights.__getitem__)
        owner[i] = best
        for other in around - {best}:
            if heights[other] - heights[i] < FURROW_MM:
                parent[other] = best
            else:
                passes.append((heights[i], best, other))
    summits, label = np.unique(np.array([root(owner[i]) for i in range(count)]), return_inverse=True)
    number = {summit: i for i, summit in enumerate(summits.tolist())}
    numbered = [(level, number[root(one)], number[root(other)]) for level, one, other in passes]
    return label.astype(np.int64), summits.astype(np.int64), [(level, one, other) for level, one, other in numbered if one != other]
