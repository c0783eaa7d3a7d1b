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

Array = NDArray[np.float64]
REACH_MM = 12.0
"""Way along the surface from the click beyond which no tooth goes on."""
_BULGE_MM = 1.5
"""Round the click the part is taken to bulge outwards."""
CUSPS_APART_MM = 4.5
"""Tips that are farther apart are taken for two teeth's; a lower incisor is 5 mm wide."""


def grow_part(mesh: TriangleMesh, seed_vertex: int, supported: NDArray[np.bool_] | None = None, *, reach_mm: float = REACH_MM) -> NDArray[np.bool_]:
    """(v,) the part round a vertex: as far as the surface goes without a furrow, and no farther than `reach_mm` along it.

    On an arch the crown under the click is the part: its free height between its valleys, as far as its cusps stand close together.
    Elsewhere, and for a click below the crowns, furrows alone bound it.  It is a proposal, for a person to correct.  `supported`
    (v,) is all if None.
    """
    table = EdgeTable.of(mesh.triangles)
    smoother = SurfaceSmoother(mesh, table)
    concavity = Concavity(mesh, smoother, table)
    near = np.isfinite(concavity.distance_mm(np.array([seed_vertex]), reach_mm))
    frame = arch_frame(mesh, np.ones(len(mesh.vertices), np.bool_) if supported is None else supported)
    if frame is not None:
        crowns = find_crowns(mesh, frame.up, smoother, table)
        if crowns.free[seed_vertex]:
            here = near & crowns.free & (crowns.crown == crowns.crown[seed_vertex])
            return np.asarray(here & np.isin(crowns.cusp, _cusps_of_one_tooth(mesh.vertices, frame.up, crowns.cusp, here, seed_vertex)))
    return np.asarray(_without_furrows(concavity, near, seed_vertex))


def _cusps_of_one_tooth(places: Array, up: Array, cusp: NDArray[np.int64], here: NDArray[np.bool_], seed: int) -> list[int]:
    """The cusps of a crown that stand as near to one another as those of one tooth do, from that of the click on."""
    tips = {int(name): places[np.flatnonzero(here & (cusp == name))] for name in np.unique(cusp[here])}
    tips = {name: vertices[np.argmax(vertices @ up)] for name, vertices in tips.items()}
    found, front = [int(cusp[seed])], [int(cusp[seed])]
    while front:
        tip = tips[front.pop()]
        for name, other in tips.items():
            if name not in found and np.linalg.norm(other - tip) < CUSPS_APART_MM:
                found.append(name)
                front.append(name)
    return found


def _without_furrows(concavity: Concavity, near: NDArray[np.bool_], seed: int) -> NDArray[np.bool_]:
    bulge = np.isfinite(concavity.distance_mm(np.array([seed]), _BULGE_MM))
    inside = near & ~concavity.furrows(bulge)
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
