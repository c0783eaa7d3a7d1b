"""Which crowns of a surface have moved as rigid bodies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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
LEAST_POINTS = 40
_LEAST_MOVED_MM = 0.12
"""Rms displacement of a body below which it stands still."""
_MOST_APART_MM = 1.2
"""Rms difference of the motions of two neighbours above which they are not even tried as one body."""
_WIDEST_TOOTH_MM = 15.0
"""Across a molar's crown, corner to corner: what is wider together is two teeth, however alike they moved."""
_MODEL_MM = 0.03
"""Standard deviation by which a rigid motion misses tissue that went along with it: facets, and rims that the gum bends."""
_FEWEST_PER_MM2 = 2.0
"""Misses of a rigid motion are alike over half a square millimetre, however dense the points are."""
_WORST = 3.0
"""Standard deviations beyond which a point has not gone along: how far then says nothing about the motion."""
_HOPELESS = 2.5
"""Mean square of a cusp's misses over the variance above which it must hold two motions."""
_LEAST_NOISE_MM = 0.01
"""Files without noise do not fit better than this: their facets differ."""
_UNKNOWNS = 6
_DEARER = 2.0
"""Times the criterion's price of a motion: what tells two pieces of one tooth apart is no independent noise alone."""
_LEAST_TOOTH_MM2 = 12.0
"""Free area below which cusps are no tooth."""
_MOSTLY = 0.9
"""Share of a piece that was free of the gum before, above which what else there is does no harm to its fit."""
_LOWER_MM = 0.1
_FIT_POINTS = 400
"""Enough to tell whether and how a crown moved."""


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


class BodyFinder:
    """Which crowns, or cusps of them, have moved, and how."""

    def __init__(
        self,
        mesh: TriangleMesh,
        over: NDArray[np.bool_],
        measured: NDArray[np.bool_],
        crowns: Crowns,
        up: Array,
        smoother: SurfaceSmoother,
        table: EdgeTable,
        fitter: PartFitter,
        alignment: Alignment,
        cancelled: IsCancelled,
    ) -> None:
        self._mesh, self._normals, self._over, self._measured = mesh, mesh.vertex_normals(), over, measured
        self._height, self._up = mesh.vertices @ up, up
        self._crowns, self._table, self._area_mm2 = crowns, table, smoother.area_mm2
        self._cusp = crowns.cusp.copy()
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
                    bodies[here & np.isin(self._cusp, cusps)], pieces[following] = following, piece
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
        free = np.flatnonzero(here & self._crowns.free & self._measured)
        if len(free) < LEAST_POINTS:
            return None
        inner = free[core[free]]
        fitted = inner if len(inner) >= LEAST_POINTS else free
        return self._fitted(free, fitted, None)

    def _fitted(self, vertices: Indices, fitted: Indices, start: RigidTransform | None) -> _Piece:
        """What of a piece lay under the gum before, by its own motion, is left out: nothing is there that it could be held against."""
        fit = self.fit(_some(fitted), start)
        kept = fitted[self.shown(fitted, fit.transform)]
        if len(kept) >= LEAST_POINTS and len(kept) < _MOSTLY * len(fitted):
            fitted, fit = kept, self.fit(_some(kept), fit.transform)
        observations = float(self._area_mm2[fitted].sum()) / self._alike_mm2
        return _Piece(vertices, fitted, self._mesh.vertices[_some(fitted)], observations, fit)

    def shown(self, vertices: Indices, motion: RigidTransform) -> NDArray[np.bool_]:
        """Which vertices (n,) of a piece a motion brings to where the before surface stands free of the gum, (n,)."""
        return np.asarray(motion.apply(self._mesh.vertices[vertices]) @ self._up >= self._height[vertices].min() - _LOWER_MM)

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

    def _cusps(self, here: NDArray[np.bool_], core: NDArray[np.bool_]) -> dict[int, _Piece | None]:
        """The cusps of a crown; one that no motion explains is halved across its length: two teeth may touch without a furrow."""
        found: dict[int, _Piece | None] = {}
        for cusp in np.unique(self._cusp[here]).tolist():
            inside = here & (self._cusp == cusp)
            piece = self._piece(inside, core)
            if piece is not None and self._cost(piece, piece.fit.transform) > _HOPELESS * piece.observations:
                about = self._mesh.vertices - piece.points.mean(axis=0)
                axis = np.linalg.eigh(about[piece.vertices].T @ about[piece.vertices])[1][:, 2]
                half = inside & (about @ axis > 0)
                halves = [self._piece(one, core) for one in (half, inside & ~half)]
                if None not in halves:
                    new = int(self._cusp.max()) + 1
                    self._cusp[half] = new
                    found[new], found[cusp] = halves
                    continue
            found[cusp] = piece
        return found

    def _apart(self, here: NDArray[np.bool_], whole: _Piece, core: NDArray[np.bool_]) -> list[tuple[list[int], _Piece]]:
        """Cusps of one crown by motion, each cluster with its own, one cluster where one motion explains them all; empty where there are none.

        Each motion on trial, that of the whole, none and that of every cusp, explains every cusp at a cost.  The one that costs
        least is kept with all cusps that are not worth a motion of their own, then the best one for what is left.  A cusp that
        stands still is no part of a tooth that does not.  What is too small for a tooth goes where it costs least.
        """
        found = self._cusps(here, core)
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
            one = self._piece(here & np.isin(self._cusp, members), core)
            if one is not None:
                clusters.append((members, one))
        return clusters


def _price(observations: float) -> float:
    """What a further motion must gain, by the Bayesian information criterion."""
    return _DEARER * _UNKNOWNS * float(np.log(max(observations, np.e)))


def _width_mm(places: Array) -> float:
    about = places - places.mean(axis=0)
    return float(np.ptp(about @ np.linalg.eigh(about.T @ about)[1][:, 2]))
