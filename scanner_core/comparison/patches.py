"""Patches of a surface where it differs, grouped into what belongs together."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.concavity import Concavity
from scanner_core.comparison.crowns import Crowns
from scanner_core.comparison.part_fit import PartFit, PartFitter
from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
LEAST_AREA_MM2 = 3.0
"""An area below this is a speck: noise that is correlated over 1 mm makes patches of 1 to 2 mm^2 at three sigma."""
_LEAST_MOVED_MM = 0.12
"""Rms displacement of a body below which it stands still."""
_MOST_APART_MM = 0.8
"""Rms difference of the motions of two neighbours above which they are not even tried as one body."""
_NEAR_MM = 1.5
"""A patch without a moved body of its own belongs to an area that is as near."""
_ENOUGH_OFF = 0.08
"""Share of a crown's points above which it may hold more than one motion."""
_ENOUGH_LOSS = 1.0
"""Mean distance over the noise's standard deviation, 0.8 for a normal one, above which it may too."""
_OTHER_WAY_MM = 0.3
"""Difference of two motions at a cusp above which they are two teeth's, where the cusp's own also explains it better."""
_BETTER = 1.3
_AS_GOOD = 1.2
"""Mean distance without any motion over that with the cusp's own, below which the cusp stands still: no tooth stands still in part."""
_LEAST_TOOTH_MM2 = 12.0
"""Free area below which a cusp is no tooth."""
_LEAST_GAIN = 0.2
"""Share of a cusp's points that its own motion explains and that of the rest of the crown does not, if the two are different teeth."""
_LEAST_POINTS = 40
_FIT_POINTS = 400
"""Enough to tell whether and how a crown moved."""


@dataclass(frozen=True, slots=True, eq=False)
class PatchGroup:
    """One area.

    Attributes
    ----------
    vertices : (k,) what differs
    body : (m,) the free part of the moved body that it lies on, empty where none has moved
    core : (n,) what of that was fitted
    fit : of the core onto the before surface; None where no body has moved
    """

    vertices: Indices
    body: Indices
    core: Indices
    fit: PartFit | None


def plain_groups(over: NDArray[np.bool_], table: EdgeTable, area_mm2: Array) -> list[PatchGroup]:
    """Each connected patch of `over` (v,) that is no speck."""
    label = connected(over, table.edges)
    size = np.bincount(label[over], area_mm2[over])
    none = np.empty(0, np.int64)
    return [PatchGroup(np.flatnonzero(label == i), none, none, None) for i in np.flatnonzero(size >= LEAST_AREA_MM2)]


def crown_groups(
    mesh: TriangleMesh,
    over: NDArray[np.bool_],
    seen: NDArray[np.bool_],
    crowns: Crowns,
    smoother: SurfaceSmoother,
    table: EdgeTable,
    before: TriangleMesh,
    alignment: Alignment,
    cancelled: IsCancelled,
) -> list[PatchGroup]:
    """Patches of `over` (v,) by the moved crowns that they lie on or touch; what touches none is grouped as if there were no crowns.

    `mesh` is the aligned after surface, `seen` (v,) its vertices with a counterpart.
    """
    area_mm2 = smoother.area_mm2
    finder = _BodyFinder(mesh, over, seen, crowns, smoother, table, PartFitter(before), alignment.noise_um / 1e3, cancelled)
    bodies, still = finder.bodies()
    inside = bodies[table.edges[:, 0]] == bodies[table.edges[:, 1]]
    label = connected(over, table.edges[inside])
    owner = np.full(int(label.max()) + 1, -1, np.int64)
    owner[label[over]] = np.where(still[over], -1, bodies[over])
    owner = _spread(owner, label, table.edges[~inside], over)
    core = finder.core(bodies)
    groups = []
    for body in np.unique(owner[owner >= 0]).tolist():
        vertices = np.flatnonzero(over & (owner[label] == body))
        if area_mm2[vertices].sum() >= LEAST_AREA_MM2:
            free = np.flatnonzero((bodies == body) & crowns.free & seen)
            fitted = free[core[free]] if core[free].sum() >= _LEAST_POINTS else free
            groups.append(PatchGroup(vertices, free, fitted, finder.fit(fitted, finder.start[body])))
    rest = over & (owner[label] < 0)
    if not rest.any():
        return groups
    return _with_near_patches(groups, connected(rest, table.edges), mesh.vertices, area_mm2)


def _with_near_patches(groups: list[PatchGroup], label: Indices, places: Array, area_mm2: Array) -> list[PatchGroup]:
    """The remaining patches, by their number `label` (v,): each to the group that it lies beside, or on its own if it is no speck."""
    groups = list(groups)
    trees = [cKDTree(places[group.vertices]) for group in groups]
    none = np.empty(0, np.int64)
    for patch in range(int(label.max()) + 1):
        vertices = np.flatnonzero(label == patch)
        ways = [float(tree.query(places[vertices])[0].min()) for tree in trees]
        if ways and min(ways) < _NEAR_MM:
            nearest = int(np.argmin(ways))
            groups[nearest] = replace(groups[nearest], vertices=np.union1d(groups[nearest].vertices, vertices))
        elif area_mm2[vertices].sum() >= LEAST_AREA_MM2:
            groups.append(PatchGroup(vertices, none, none, None))
    return groups


def connected(inside: NDArray[np.bool_], edges: Indices) -> Indices:
    """Number of the connected piece of every vertex that is `inside` (v,), counted from 0; -1 for the others."""
    kept = edges[inside[edges].all(axis=1)]
    graph = sparse.coo_array((np.ones(len(kept)), (kept[:, 0], kept[:, 1])), shape=(len(inside),) * 2)
    label = np.full(len(inside), -1, np.int64)
    label[inside] = np.unique(connected_components(graph, directed=False)[1][inside], return_inverse=True)[1]
    return label


@dataclass(frozen=True, slots=True, eq=False)
class _Piece:
    """A crown or a cusp that was fitted: its free vertices, those that were fitted, some points of it and how they went."""

    vertices: Indices
    fitted: Indices
    points: Array
    fit: PartFit

    def moved_mm(self) -> float:
        return _rms_mm(self.fit.transform.apply(self.points) - self.points)

    def apart_mm(self, other: _Piece) -> float:
        """Rms difference of two motions where they are at home."""
        both = np.concatenate([self.points, other.points])
        return _rms_mm(self.fit.transform.apply(both) - other.fit.transform.apply(both))


def _some(vertices: Indices) -> Indices:
    return vertices[:: max(1, len(vertices) // _FIT_POINTS)]


def _rms_mm(ways: Array) -> float:
    return float(np.sqrt((ways * ways).sum(axis=1).mean()))


class _BodyFinder:
    """Which crowns, or cusps of them, have moved, and how."""

    def __init__(
        self,
        mesh: TriangleMesh,
        over: NDArray[np.bool_],
        seen: NDArray[np.bool_],
        crowns: Crowns,
        smoother: SurfaceSmoother,
        table: EdgeTable,
        fitter: PartFitter,
        noise_mm: float,
        cancelled: IsCancelled,
    ) -> None:
        self._mesh, self._normals, self._over, self._seen = mesh, mesh.vertex_normals(), over, seen
        self._crowns, self._table, self._area_mm2 = crowns, table, smoother.area_mm2
        self._fitter, self._noise_mm, self._cancelled = fitter, noise_mm, cancelled
        self._concavity = Concavity(mesh, smoother, table)
        self.start: dict[int, RigidTransform] = {}

    def core(self, bodies: Indices) -> NDArray[np.bool_]:
        """(v,) the free parts of bodies (v,) away from the furrows that bound them."""
        return self._concavity.core(bodies, self._crowns.free)

    def fit(self, vertices: Indices, start: RigidTransform | None = None) -> PartFit:
        if self._cancelled():
            raise Cancelled
        return self._fitter.fit(self._mesh.vertices[vertices], self._normals[vertices], self._noise_mm, start)

    def bodies(self) -> tuple[Indices, NDArray[np.bool_]]:
        """Number of the body of each vertex (v,), and whether it stands still (v,).

        A body is a crown, or where a crown holds more than one motion, some cusps of it; neighbours with one motion are one body.
        """
        crowns = self._crowns
        bodies = crowns.crown.copy()
        pieces: dict[int, _Piece] = {}
        size = np.bincount(crowns.crown, self._area_mm2 * self._over)
        following = len(size)
        core = self.core(bodies)
        for crown in np.flatnonzero(size > 0.3 * LEAST_AREA_MM2).tolist():
            here = crowns.crown == crown
            whole = self._piece(here, core)
            if whole is None:
                continue
            pieces[crown] = whole
            loss, off = self._fitter.loss(whole.points, whole.fit.transform)
            if off > _ENOUGH_OFF or loss > _ENOUGH_LOSS * self._noise_mm:
                for cluster in self._apart(here, whole, core):
                    one = here & np.isin(crowns.cusp, cluster)
                    piece = self._piece(one, core)
                    if piece is not None:
                        bodies[one], pieces[following] = following, piece
                        following += 1
        moved = {body: piece for body, piece in pieces.items() if piece.moved_mm() > _LEAST_MOVED_MM}
        renamed = np.arange(following)
        pairs = np.unique(np.sort(bodies[self._table.edges], axis=1), axis=0)
        for a, b in pairs[pairs[:, 0] != pairs[:, 1]].tolist():
            one, other = int(renamed[a]), int(renamed[b])
            if one != other and one in moved and other in moved:
                joint = self._joint(moved[one], moved[other])
                if joint is not None:
                    renamed[renamed == other] = one
                    moved[one] = joint
                    del moved[other]
        still = np.ones(following, np.bool_)
        still[list(moved)] = False  # a body that was joined to another is called by the other's number
        self.start = {body: piece.fit.transform for body, piece in moved.items()}
        return renamed[bodies], still[bodies]

    def _piece(self, here: NDArray[np.bool_], core: NDArray[np.bool_]) -> _Piece | None:
        free = np.flatnonzero(here & self._crowns.free & self._seen)
        if len(free) < _LEAST_POINTS:
            return None
        inner = free[core[free]]
        fitted = inner if len(inner) >= _LEAST_POINTS else free
        return _Piece(free, fitted, self._mesh.vertices[_some(free)], self.fit(_some(fitted)))

    def _joint(self, one: _Piece, other: _Piece) -> _Piece | None:
        """Two neighbours as one body; None where one motion explains them worse than two."""
        if one.apart_mm(other) > _MOST_APART_MM:
            return None
        fit = self.fit(np.concatenate([_some(one.fitted), _some(other.fitted)]), one.fit.transform)
        for piece in (one, other):
            if self._fitter.loss(piece.points, fit.transform)[0] > _BETTER * self._fitter.loss(piece.points, piece.fit.transform)[0]:
                return None
        both = np.concatenate([one.vertices, other.vertices])
        return _Piece(both, np.concatenate([one.fitted, other.fitted]), self._mesh.vertices[_some(both)], fit)

    def _apart(self, here: NDArray[np.bool_], whole: _Piece, core: NDArray[np.bool_]) -> list[list[int]]:
        """Cusps of one crown by motion, each cluster a tooth of its own; empty where one motion explains them all.

        Each motion on trial, that of the whole and of every cusp, explains some points of every cusp.  The one that explains most is
        kept with all cusps that no motion of their own explains much better, then the best one for what is left.
        """
        found = {int(cusp): self._piece(here & (self._crowns.cusp == cusp), core) for cusp in np.unique(self._crowns.cusp[here])}
        cusps = {cusp: piece for cusp, piece in found.items() if piece is not None and self._area_mm2[piece.vertices].sum() > _LEAST_TOOTH_MM2}
        if len(cusps) < 2:
            return []
        names, parts = list(cusps), list(cusps.values())
        count = np.array([len(part.vertices) for part in parts])
        motions = [whole.fit.transform, RigidTransform.identity(), *(part.fit.transform for part in parts)]
        losses = np.array([[self._fitter.loss(part.points, motion) for part in parts] for motion in motions])  # (n + 2, n, 2)
        own = losses[np.arange(2, len(parts) + 2), np.arange(len(parts))]
        stands = losses[1, :, 0] < _AS_GOOD * own[:, 0]
        left, clusters = np.ones(len(parts), np.bool_), []
        while left.any():
            best = int(np.argmin(losses[:, left, 0] @ count[left]))
            way = np.array([np.linalg.norm((motions[best].apply(p := part.points) - part.fit.transform.apply(p)).mean(axis=0)) for part in parts])
            other = losses[best, :, 1] > own[:, 1] + _LEAST_GAIN
            other |= ((way > _OTHER_WAY_MM) | stands) & (losses[best, :, 0] > _BETTER * own[:, 0])
            with_it = left & ~other
            with_it = with_it if with_it.any() else left.copy()
            clusters.append([name for name, in_it in zip(names, with_it.tolist(), strict=True) if in_it])
            left &= ~with_it
        return clusters if len(clusters) > 1 else []


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
