"""Patches of a surface where it differs, grouped into what belongs together."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.crowns import Crowns
from scanner_core.comparison.moved_bodies import LEAST_AREA_MM2, LEAST_POINTS, BodyFinder
from scanner_core.comparison.part_fit import PartFit, PartFitter
from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import IsCancelled

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
_REACH_MM = 10.0
"""From the middle of a crown: no tooth drags the gum farther along."""
_LEAST_SHARE_MM2 = 1.0
"""Less of a patch on a crown than this does not make it that crown's."""
_NEAR_MM = 1.5
"""A patch without a moved body of its own belongs to an area that is as near."""


@dataclass(frozen=True, slots=True, eq=False)
class PatchGroup:
    """One area.

    Attributes
    ----------
    vertices : (k,) what differs
    body : (m,) the free part of the moved body that it lies on, empty where none has moved
    core : (n,) what of that was fitted
    fit : of the core onto the before surface; None where no body has moved
    judged : (f,) the body and whatever else differs and stands free of the gum
    left_mm : (f,) how far from the before surface the fit leaves these
    """

    vertices: Indices
    body: Indices
    core: Indices
    fit: PartFit | None
    judged: Indices
    left_mm: Array


def _unmoved(vertices: Indices) -> PatchGroup:
    none = np.empty(0, np.int64)
    return PatchGroup(vertices, none, none, None, none, np.empty(0))


def plain_groups(over: NDArray[np.bool_], table: EdgeTable, area_mm2: Array) -> list[PatchGroup]:
    """Each connected patch of `over` (v,) that is no speck."""
    label = connected(over, table.edges)
    size = np.bincount(label[over], area_mm2[over])
    return [_unmoved(np.flatnonzero(label == i)) for i in np.flatnonzero(size >= LEAST_AREA_MM2)]


def crown_groups(
    mesh: TriangleMesh,
    over: NDArray[np.bool_],
    measured: NDArray[np.bool_],
    crowns: Crowns,
    up: Array,
    smoother: SurfaceSmoother,
    table: EdgeTable,
    before: TriangleMesh,
    alignment: Alignment,
    cancelled: IsCancelled,
) -> list[PatchGroup]:
    """Patches of `over` (v,) by the moved crowns that they lie on or touch; what touches none is grouped as if there were no crowns.

    Of a patch that several moved crowns share, each has its free part, and what lies lower belongs to the one whose middle is nearest,
    seen along `up` (3,): on the gum between two teeth nothing else tells.  `mesh` is the aligned after surface, `measured` (v,) its
    vertices where the before surface was measured too, however far away that is by now.
    """
    area_mm2 = smoother.area_mm2
    fitter = PartFitter(before)
    finder = BodyFinder(mesh, over, measured, crowns, up, smoother, table, fitter, alignment, cancelled)
    bodies, still = finder.bodies()
    label = connected(over, table.edges)
    owner = _owners(mesh.vertices - np.outer(mesh.vertices @ up, up), label, bodies, crowns.free & measured & ~still, area_mm2)
    core = finder.core(bodies)
    groups = []
    for body in np.unique(owner[owner >= 0]).tolist():
        vertices = np.flatnonzero(owner == body)
        if area_mm2[vertices].sum() >= LEAST_AREA_MM2:
            free = np.flatnonzero((bodies == body) & crowns.free & measured)
            fitted = free[core[free]] if core[free].sum() >= LEAST_POINTS else free
            shown = fitted[finder.shown(fitted, finder.start[body])]
            fitted = shown if len(shown) >= LEAST_POINTS else fitted
            fit = finder.fit(fitted, finder.start[body])
            told = np.union1d(free, vertices[crowns.free[vertices]])
            judged = told[finder.shown(told, fit.transform)]
            left_mm = fitter.distances_mm(mesh.vertices[judged], fit.transform)
            groups.append(PatchGroup(vertices, free, fitted, fit, judged, left_mm))
    rest = over & (owner < 0)
    if not rest.any():
        return groups
    return _with_near_patches(groups, connected(rest, table.edges), mesh.vertices, area_mm2)


def _with_near_patches(groups: list[PatchGroup], label: Indices, places: Array, area_mm2: Array) -> list[PatchGroup]:
    """The remaining patches, by their number `label` (v,): each to the group that it lies beside, or on its own if it is no speck."""
    groups = list(groups)
    trees = [cKDTree(places[group.vertices]) for group in groups]
    for patch in range(int(label.max()) + 1):
        vertices = np.flatnonzero(label == patch)
        ways = [float(tree.query(places[vertices])[0].min()) for tree in trees]
        if ways and min(ways) < _NEAR_MM:
            nearest = int(np.argmin(ways))
            groups[nearest] = replace(groups[nearest], vertices=np.union1d(groups[nearest].vertices, vertices))
        elif area_mm2[vertices].sum() >= LEAST_AREA_MM2:
            groups.append(_unmoved(vertices))
    return groups


def connected(inside: NDArray[np.bool_], edges: Indices) -> Indices:
    """Number of the connected piece of every vertex that is `inside` (v,), counted from 0; -1 for the others."""
    kept = edges[inside[edges].all(axis=1)]
    graph = sparse.coo_array((np.ones(len(kept)), (kept[:, 0], kept[:, 1])), shape=(len(inside),) * 2)
    label = np.full(len(inside), -1, np.int64)
    label[inside] = np.unique(connected_components(graph, directed=False)[1][inside], return_inverse=True)[1]
    return label


def _owners(flat: Array, label: Indices, bodies: Indices, standing: NDArray[np.bool_], area_mm2: Array) -> Indices:
    """Number of the moved body to which each vertex (v,) of a patch belongs, -1 for none.

    `label` (v,) numbers the patches, `bodies` (v,) the bodies, of which those parts that moved freely are `standing` (v,); `flat`
    (v, 3) are the places as seen along the way up.
    """
    owner = np.full(len(label), -1, np.int64)
    on_body = standing & (label >= 0)
    if not on_body.any():
        return owner
    owner[on_body] = bodies[on_body]
    count = int(bodies.max()) + 1
    weight = np.bincount(bodies[standing], area_mm2[standing], minlength=count)
    middles = np.column_stack([np.bincount(bodies[standing], area_mm2[standing] * flat[standing, axis], minlength=count) for axis in range(3)])
    middles = np.asarray(middles / np.maximum(weight, 1e-12)[:, None])
    shared = np.bincount(label[on_body] * count + bodies[on_body], area_mm2[on_body], minlength=(int(label.max()) + 1) * count).reshape(-1, count)
    for patch in np.flatnonzero(shared.any(axis=1)).tolist():
        here = np.flatnonzero(label == patch)
        own = np.flatnonzero(shared[patch] >= _LEAST_SHARE_MM2)
        own = own if len(own) else np.array([np.argmax(shared[patch])])
        lower = here[~np.isin(owner[here], own)]
        far, nearest = cKDTree(middles[own]).query(flat[lower])
        owner[lower] = np.where(far < _REACH_MM, own[nearest], -1)
    return owner
