"""From one click on a tooth to the whole tooth."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.concavity import Concavity
from scanner_core.comparison.crowns import find_crowns
from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh

REACH_MM = 12.0
"""Way along the surface from the click beyond which no tooth goes on."""


def grow_part(mesh: TriangleMesh, seed_vertex: int, supported: NDArray[np.bool_] | None = None, *, reach_mm: float = REACH_MM) -> NDArray[np.bool_]:
    """(v,) the part round a vertex: as far as the surface goes without a furrow, and no farther than `reach_mm` along it.

    On an arch the crown under the click is the part: its free height, between its valleys.  Elsewhere, and for a click below the
    crowns, furrows alone bound it.  It is a proposal, for a person to correct.  `supported` (v,) is all if None.
    """
    table = EdgeTable.of(mesh.triangles)
    smoother = SurfaceSmoother(mesh, table)
    concavity = Concavity(mesh, smoother, table)
    near = np.isfinite(concavity.distance_mm(np.array([seed_vertex]), reach_mm))
    frame = arch_frame(mesh, np.ones(len(mesh.vertices), np.bool_) if supported is None else supported)
    if frame is not None:
        crowns = find_crowns(mesh, frame.up, smoother, table)
        if crowns.free[seed_vertex]:
            return np.asarray(near & crowns.free & (crowns.crown == crowns.crown[seed_vertex]))
    return np.asarray(_without_furrows(concavity, near, seed_vertex))


def _without_furrows(concavity: Concavity, near: NDArray[np.bool_], seed: int) -> NDArray[np.bool_]:
    inside = near & ~concavity.furrows(near)
    inside[seed] = True
    edges = concavity.table.edges
    grown = np.zeros(len(near), np.bool_)
    front = np.array([seed])
    kept = edges[inside[edges].all(axis=1)]
    while len(front):
        grown[front] = True
        reached = np.unique(np.concatenate([kept[grown[kept[:, 0]] & ~grown[kept[:, 1]], 1], kept[grown[kept[:, 1]] & ~grown[kept[:, 0]], 0]]))
        front = reached
    return grown
