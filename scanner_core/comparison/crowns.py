"""The bodies that stand up from a surface - the crowns of an arch - by a watershed of height."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
LEAST_DEPTH_MM = 0.8
"""A valley less deep than this parts no two crowns: fissures and the furrows of noise are shallower, gaps between teeth deeper."""
_SMOOTHING_MM = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Crowns:
    """A partition of a surface into the surroundings of its summits.

    Attributes
    ----------
    label : (v,) int64, 0 to the number of crowns - 1
    summits : (n,) int64, the highest vertex of each
    height_mm : (v,) smoothed height
    saddle_mm : (n,) height of the highest valley that leads to another crown; the lowest height of all where there is none
    """

    label: NDArray[np.int64]
    summits: NDArray[np.int64]
    height_mm: Array
    saddle_mm: Array

    def above_gum(self, below_saddle_mm: float) -> NDArray[np.bool_]:
        """(v,) what stands higher than the highest valley round its crown less `below_saddle_mm`: the free part of a crown."""
        return np.asarray(self.height_mm > self.saddle_mm[self.label] - below_saddle_mm)


def find_crowns(mesh: TriangleMesh, up: Array, smoother: SurfaceSmoother, table: EdgeTable) -> Crowns:
    """Watershed of the height along `up` (3,): vertices in falling order join the higher ground beside them.

    Two summits stay apart where the lower one stands `LEAST_DEPTH_MM` or more above the valley between them (persistence;
    Edelsbrunner, Letscher and Zomorodian, Topological persistence and simplification, 2002).
    """
    height = smoother(mesh.vertices @ up, _SMOOTHING_MM)
    count = len(mesh.vertices)
    start = np.concatenate([table.edges[:, 0], table.edges[:, 1]])
    neighbours = np.concatenate([table.edges[:, 1], table.edges[:, 0]])[np.argsort(start, kind="stable")].tolist()
    offsets = np.concatenate([[0], np.cumsum(np.bincount(start, minlength=count))]).tolist()
    heights = height.tolist()
    parent = [-1] * count  # -1: not under way yet
    owner = [-1] * count  # the summit whose slope a vertex was reached on
    saddles: dict[tuple[int, int], float] = {}

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
            if heights[other] - heights[i] < LEAST_DEPTH_MM:
                parent[other] = best
            else:
                saddles.setdefault((min(best, other), max(best, other)), heights[i])
    summits, label = np.unique(np.array([root(owner[i]) for i in range(count)]), return_inverse=True)
    saddle = np.full(len(summits), float(height.min()))
    for pair, level in saddles.items():
        ends = np.searchsorted(summits, [root(pair[0]), root(pair[1])])
        if ends[0] != ends[1]:
            saddle[ends] = np.maximum(saddle[ends], level)
    return Crowns(label.astype(np.int64), summits.astype(np.int64), height, saddle)
