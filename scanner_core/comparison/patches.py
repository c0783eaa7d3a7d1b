"""Patches of a surface where it differs, grouped into what belongs together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components

from scanner_core.comparison.crowns import Crowns
from scanner_core.comparison.part_fit import PartFit, PartFitter
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
LEAST_AREA_MM2 = 3.0
"""An area below this is a speck: noise that is correlated over 1 mm makes patches of 1 to 2 mm^2 at three sigma."""
_LEAST_MOVED_MM = 0.12
"""Rms displacement of a crown's free part below which it stands still."""
_SAME_MM = 0.12
"""Rms difference of the motions of two neighbouring crowns below which they are one body: two cusps of a tooth."""
_FREE_MM = 0.5
_LEAST_POINTS = 40
_FIT_POINTS = 400
"""Enough to tell whether and how a crown moved."""


@dataclass(frozen=True, slots=True, eq=False)
class PatchGroup:
    """Vertices of one area (k,), and of the moved body that it lies on (m,), empty where none has moved."""

    vertices: Indices
    body: Indices


def plain_groups(over: NDArray[np.bool_], table: EdgeTable, area_mm2: Array) -> list[PatchGroup]:
    """Each connected patch of `over` (v,) that is no speck."""
    label = connected(over, table.edges)
    size = np.bincount(label[over], area_mm2[over])
    none = np.empty(0, np.int64)
    return [PatchGroup(np.flatnonzero(label == i), none) for i in np.flatnonzero(size >= LEAST_AREA_MM2)]


def crown_groups(
    mesh: TriangleMesh,
    normals: Array,
    over: NDArray[np.bool_],
    seen: NDArray[np.bool_],
    crowns: Crowns,
    table: EdgeTable,
    area_mm2: Array,
    fitter: PartFitter,
    noise_mm: float,
    cancelled: IsCancelled,
) -> list[PatchGroup]:
    """Patches of `over` (v,) by the moved crowns that they lie on or touch; what touches none is grouped as if there were no crowns.

    `seen` (v,) are the vertices with a counterpart, `normals` (v, 3) the mesh's.
    """
    inside = crowns.label[table.edges[:, 0]] == crowns.label[table.edges[:, 1]]
    label = connected(over, table.edges[inside])
    count = int(label.max()) + 1
    crown_of = np.zeros(count, np.int64)
    crown_of[label[over]] = crowns.label[over]
    body_of = _moved_bodies(mesh, normals, over, seen, crowns, table, area_mm2, fitter, noise_mm, cancelled)
    owner = np.array([body_of.get(int(crown), -1) for crown in crown_of], np.int64)
    owner = _spread(owner, label, table.edges[~inside], over)
    free = crowns.above_gum(_FREE_MM)
    groups = []
    for body in np.unique(owner[owner >= 0]):
        vertices = np.flatnonzero(over & (owner[label] == body))
        if area_mm2[vertices].sum() >= LEAST_AREA_MM2:
            members = [crown for crown, of in body_of.items() if of == body]
            groups.append(PatchGroup(vertices, np.flatnonzero(np.isin(crowns.label, members) & free & seen)))
    rest = over & (owner[label] < 0)
    return groups + (plain_groups(rest, table, area_mm2) if rest.any() else [])


def connected(inside: NDArray[np.bool_], edges: Indices) -> Indices:
    """Number of the connected piece of every vertex that is `inside` (v,), counted from 0; -1 for the others."""
    kept = edges[inside[edges].all(axis=1)]
    graph = sparse.coo_array((np.ones(len(kept)), (kept[:, 0], kept[:, 1])), shape=(len(inside),) * 2)
    label = np.full(len(inside), -1, np.int64)
    label[inside] = np.unique(connected_components(graph, directed=False)[1][inside], return_inverse=True)[1]
    return label


def _moved_bodies(
    mesh: TriangleMesh,
    normals: Array,
    over: NDArray[np.bool_],
    seen: NDArray[np.bool_],
    crowns: Crowns,
    table: EdgeTable,
    area_mm2: Array,
    fitter: PartFitter,
    noise_mm: float,
    cancelled: IsCancelled,
) -> dict[int, int]:
    """Crowns that have moved, each with the number of its body: the lowest of its crowns."""
    size = np.bincount(crowns.label, area_mm2 * over, minlength=len(crowns.summits))
    free = crowns.above_gum(_FREE_MM) & seen
    fits: dict[int, PartFit] = {}
    points: dict[int, Array] = {}
    for crown in np.flatnonzero(size > 0.3 * LEAST_AREA_MM2).tolist():
        if cancelled():
            raise Cancelled
        part = np.flatnonzero(free & (crowns.label == crown))
        if len(part) < _LEAST_POINTS:
            continue
        part = part[:: max(1, len(part) // _FIT_POINTS)]
        fit = fitter.fit(mesh.vertices[part], normals[part], noise_mm)
        moved = np.linalg.norm(fit.transform.apply(mesh.vertices[part]) - mesh.vertices[part], axis=1)
        if np.sqrt(np.mean(moved**2)) > _LEAST_MOVED_MM and fit.weights.mean() > 0.4:
            fits[crown], points[crown] = fit, mesh.vertices[part]
    body = {crown: crown for crown in fits}
    pairs = np.unique(np.sort(crowns.label[table.edges], axis=1), axis=0)
    for one, other in pairs[pairs[:, 0] != pairs[:, 1]].tolist():
        if one in fits and other in fits:
            both = np.concatenate([points[one], points[other]])
            apart = np.linalg.norm(fits[one].transform.apply(both) - fits[other].transform.apply(both), axis=1)
            if np.sqrt(np.mean(apart**2)) < _SAME_MM:
                lower, upper = sorted((body[one], body[other]))
                body = {crown: lower if of == upper else of for crown, of in body.items()}
    return body


def _spread(owner: Indices, label: Indices, edges: Indices, over: NDArray[np.bool_]) -> Indices:
    """Pieces without an owner take that of the piece with which they share most of their outline, from piece to piece."""
    touching = label[edges[over[edges].all(axis=1)]]
    owner = owner.copy()
    while True:
        pairs = np.concatenate([touching, touching[:, ::-1]])
        pairs = pairs[(owner[pairs[:, 0]] < 0) & (owner[pairs[:, 1]] >= 0)]
        if not len(pairs):
            return owner
        for piece in np.unique(pairs[:, 0]):
            owner[piece] = np.bincount(owner[pairs[pairs[:, 0] == piece, 1]]).argmax()
