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
_MOST_APART_MM = 1.2
"""Rms difference of the motions of two neighbours above which they are not even tried as one body."""
_REACH_MM = 10.0
"""From the middle of a crown: no tooth drags the gum farther along."""
_LEAST_SHARE_MM2 = 1.0
"""Less of a patch on a crown than this does not make it that crown's."""
_NEAR_MM = 1.5
"""A patch without a moved body of its own belongs to an area that is as near."""
_WIDEST_TOOTH_MM = 15.0
"""Across a molar's crown, corner to corner: what is wider together is two teeth, however alike they moved."""
_MODEL_MM = 0.03
"""Standard deviation by which a rigid motion misses tissue that went along with it: facets, and rims that the gum bends."""
_FEWEST_PER_MM2 = 2.0
"""Misses of a rigid motion are alike over half a square millimetre, however dense the points are."""
_WORST = 3.0
"""Standard deviations beyond which a point has not gone along: how far then says nothing about the motion."""
_LEAST_NOISE_MM = 0.01
"""Files without noise do not fit better than this: their facets differ."""
_UNKNOWNS = 6
_DEARER = 2.0
"""Times the criterion's price of a motion: what tells two pieces of one tooth apart is no independent noise alone."""
_LEAST_TOOTH_MM2 = 12.0
"""Free area below which cusps are no tooth."""
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
    up: Array,
    smoother: SurfaceSmoother,
    table: EdgeTable,
    before: TriangleMesh,
    alignment: Alignment,
    cancelled: IsCancelled,
) -> list[PatchGroup]:
    """Patches of `over` (v,) by the moved crowns that they lie on or touch; what touches none is grouped as if there were no crowns.

    Of a patch that several moved crowns share, each has its free part, and what lies lower belongs to the one whose middle is nearest,
    seen along `up` (3,): on the gum between two teeth nothing else tells.  `mesh` is the aligned after surface, `seen` (v,) its
    vertices with a counterpart.
    """
    area_mm2 = smoother.area_mm2
    finder = _BodyFinder(mesh, over, seen, crowns, smoother, table, PartFitter(before), alignment, cancelled)
    bodies, still = finder.bodies()
    label = connected(over, table.edges)
    owner = _owners(mesh.vertices - np.outer(mesh.vertices @ up, up), label, bodies, crowns.free & seen & ~still, area_mm2)
    core = finder.core(bodies)
    groups = []
    for body in np.unique(owner[owner >= 0]).tolist():
        vertices = np.flatnonzero(owner == body)
        if area_mm2[vertices].sum() >= LEAST_AREA_MM2:
            free = np.flatnonzero((bodies == body) & crowns.free & seen)
            fitted = free[core[free]] if core[free].sum() >= _LEAST_POINTS else free
            groups.append(PatchGroup(vertices, free, fitted, finder.fit(fitted, finder.start[body])))
    rest = over & (owner < 0)
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
    """A crown or a cusp that was fitted: its free vertices, those that were fitted, some of their places, how many independent
    observations these are worth, and how they went."""

    vertices: Indices
    fitted: Indices
    points: Array
    observations: float
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
        alignment: Alignment,
        cancelled: IsCancelled,
    ) -> None:
        self._mesh, self._normals, self._over, self._seen = mesh, mesh.vertex_normals(), over, seen
        self._crowns, self._table, self._area_mm2 = crowns, table, smoother.area_mm2
        self._fitter, self._noise_mm, self._cancelled = fitter, max(alignment.noise_um / 1e3, _LEAST_NOISE_MM), cancelled
        self._alike_mm2 = max(np.pi * alignment.correlation_length_mm**2, 1 / _FEWEST_PER_MM2)
        self._variance = self._noise_mm**2 + _MODEL_MM**2
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
            if self._cost(whole, whole.fit.transform) > whole.observations:
                clusters = self._apart(here, whole, core)
                for cusps, piece in clusters:
                    bodies[here & np.isin(crowns.cusp, cusps)], pieces[following] = following, piece
                    following += 1
                if clusters:
                    del pieces[crown]
        moved = {body: piece for body, piece in pieces.items() if self._has_moved(piece)}
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
        return self._fitted(free, fitted, None)

    def _fitted(self, vertices: Indices, fitted: Indices, start: RigidTransform | None) -> _Piece:
        some = _some(fitted)
        observations = float(self._area_mm2[fitted].sum()) / self._alike_mm2
        return _Piece(vertices, fitted, self._mesh.vertices[some], observations, self.fit(some, start))

    def _has_moved(self, piece: _Piece) -> bool:
        stands = self._cost(piece, RigidTransform.identity()) - self._cost(piece, piece.fit.transform) < _price(piece.observations)
        return not stands and piece.moved_mm() > _LEAST_MOVED_MM

    def _cost(self, piece: _Piece, motion: RigidTransform) -> float:
        """Twice the negative logarithm of the likelihood of a piece under a motion, up to a constant."""
        return piece.observations * self._fitter.mean_square_mm2(piece.points, motion, _WORST * np.sqrt(self._variance)) / self._variance

    def _joint(self, one: _Piece, other: _Piece) -> _Piece | None:
        """Two neighbours as one body; None where two motions explain them better than one (Schwarz, 1978)."""
        both = np.concatenate([one.points, other.points])
        if one.apart_mm(other) > _MOST_APART_MM or _width_mm(both) > _WIDEST_TOOTH_MM:
            return None
        joint = self._fitted(np.concatenate([one.vertices, other.vertices]), np.concatenate([one.fitted, other.fitted]), one.fit.transform)
        gain = sum(self._cost(piece, joint.fit.transform) - self._cost(piece, piece.fit.transform) for piece in (one, other))
        return joint if gain < _price(one.observations + other.observations) else None

    def _apart(self, here: NDArray[np.bool_], whole: _Piece, core: NDArray[np.bool_]) -> list[tuple[list[int], _Piece]]:
        """Cusps of one crown by motion, each cluster with its own, one cluster where one motion explains them all; empty where there are none.

        Each motion on trial, that of the whole, none and that of every cusp, explains every cusp at a cost.  The one that costs
        least is kept with all cusps that are not worth a motion of their own, then the best one for what is left.  A cusp that
        stands still is no part of a tooth that does not.  What is too small for a tooth goes where it costs least.
        """
        found = {int(cusp): self._piece(here & (self._crowns.cusp == cusp), core) for cusp in np.unique(self._crowns.cusp[here])}
        cusps = {cusp: piece for cusp, piece in found.items() if piece is not None}
        if len(cusps) < 2:
            return []
        names, parts = list(cusps), list(cusps.values())
        motions = [whole.fit.transform, RigidTransform.identity(), *(part.fit.transform for part in parts)]
        cost = np.array([[self._cost(part, motion) for part in parts] for motion in motions])
        price = np.array([_price(part.observations) for part in parts])
        size = np.array([self._area_mm2[part.vertices].sum() for part in parts])
        least = np.minimum(cost[np.arange(2, len(parts) + 2), np.arange(len(parts))] + price, cost[1])
        left, chosen = np.ones(len(parts), np.bool_), []
        while left.any():
            best = int(np.argmin(np.minimum(cost, least)[:, left].sum(axis=1)))
            with_it = left & (cost[best] <= least)
            with_it = with_it if with_it.any() else left.copy()
            if size[with_it].sum() > _LEAST_TOOTH_MM2:
                chosen.append(best)
            left &= ~with_it
        if len(chosen) < 2:  # a motion of one of its cusps may be a better beginning than none
            start = motions[chosen[0]] if chosen else whole.fit.transform
            again = self._fitted(whole.vertices, whole.fitted, start) if start is not whole.fit.transform else whole
            return [(list(found), min(whole, again, key=lambda piece: self._cost(piece, piece.fit.transform)))]
        cheapest = np.argmin(cost[chosen], axis=0)
        clusters = []
        for number in np.unique(cheapest).tolist():
            members = [name for name, one in zip(names, cheapest.tolist(), strict=True) if one == number]
            if number == cheapest[np.argmax(size)]:
                members += [cusp for cusp, piece in found.items() if piece is None]
            one = self._piece(here & np.isin(self._crowns.cusp, members), core)
            if one is not None:
                clusters.append((members, one))
        return clusters


def _price(observations: float) -> float:
    """What a further motion must gain, by the Bayesian information criterion."""
    return _DEARER * _UNKNOWNS * float(np.log(max(observations, np.e)))


def _width_mm(places: Array) -> float:
    about = places - places.mean(axis=0)
    return float(np.ptp(about @ np.linalg.eigh(about.T @ about)[1][:, 2]))


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
