"""How far a view lies beside the surface that earlier views have shown, and how well that is known.

Point to plane with robust weights (Chen & Medioni 1992), six unknowns.  A surface does not determine every motion: a
sphere has no turns, a cylinder none about its axis.  The noise of the surface's normals feigns some knowledge of them all
the same; what it feigns is computed from the normals' own variance, and a direction of which it makes up a good part
counts as unknown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.feigned_information import feigned_information
from scanner_core.geometry.local_surface import LocalSurface
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

MIN_POINTS = 60
QUERIES = 800
"""Points of the view that are compared."""
_ROUNDS = 8
_TUKEY = 4.685
_MAX_DISTANCE_MM = 1.5
_FEIGNED = 0.35
"""Largest part of a direction's information that may come from the normals' noise."""
_LEAST_KNOWN_MM = 0.1
"""A direction with a larger standard uncertainty counts as unknown."""
_OVERDISPERSION = 1.3
"""Errors of neighbouring points are not independent: the scatter of clean views over what independent points predict."""


@dataclass(frozen=True, slots=True, eq=False)
class ViewMotion:
    """The small motion that brings a view onto the earlier surface, along the directions that the surface determines.

    Attributes
    ----------
    centre : (3,) mm, object frame, about which the turn is taken
    radius_mm : turns are multiplied by it, so that all six unknowns are lengths
    directions : (6, k) orthonormal, the directions of motion that are known
    amounts_mm, uncertainties_mm : (k,) along them, and their standard uncertainties by the points' scatter
    information, feigned : (6, 6) mm^-2, of independent points, and the part of it that the normals' noise feigns
    points : that were compared
    residual_mm : robust standard deviation of the distances afterwards
    """

    centre: Array
    radius_mm: float
    directions: Array
    amounts_mm: Array
    uncertainties_mm: Array
    information: Array
    feigned: Array
    points: int
    residual_mm: float

    @property
    def vector_mm(self) -> Array:
        """(6,): turn times radius, shift of the centre; zero along what is unknown."""
        result: Array = self.directions @ self.amounts_mm
        return result

    @property
    def shift_mm(self) -> Array:
        """(3,) of the centre."""
        return self.vector_mm[3:]

    def significance(self, systematic_mm: float) -> float:
        """Chi-square of the motion over the known directions; `systematic_mm` is added to every uncertainty in quadrature."""
        if not len(self.amounts_mm):
            return 0.0
        ratio2 = self.amounts_mm**2 / (self.uncertainties_mm**2 + systematic_mm**2)
        return float(ratio2.sum())

    def _axis_motion(self) -> Array:
        """(6,) mm per radian of a turn about the object frame's z axis."""
        axis = np.array([0.0, 0.0, 1.0])
        return np.concatenate([self.radius_mm * axis, np.cross(axis, self.centre)])

    def turn_about_z(self, systematic_mm: float) -> tuple[float, float] | None:
        """The turn about the table's axis that explains the motion best, and its standard uncertainty, rad; None when unknown."""
        along = self._axis_motion()
        information = float(along @ self.information @ along)
        if information <= 0 or float(along @ self.feigned @ along) > _FEIGNED * information:
            return None
        known = self.directions.T @ along
        weight = 1.0 / (self.uncertainties_mm**2 + systematic_mm**2)
        total = float((weight * known**2).sum())
        if total <= 0 or total < 1e-2 * information:
            return None
        return float((weight * known * self.amounts_mm).sum()) / total, 1.0 / float(np.sqrt(total))

    def explained_by_turn(self, turn: float, systematic_mm: float) -> float:
        """The part of the significance that a turn about the table's axis by `turn` rad takes away."""
        rest = replace(self, amounts_mm=self.amounts_mm - turn * (self.directions.T @ self._axis_motion()))
        return 1.0 - rest.significance(systematic_mm) / max(self.significance(systematic_mm), 1e-12)

    def transform(self) -> RigidTransform:
        return _about(self.vector_mm, self.centre, self.radius_mm)


def view_motion(points: Array, surface: LocalSurface) -> ViewMotion | None:
    """The motion of points (n, 3) mm onto a surface; None when fewer than :data:`MIN_POINTS` lie over it."""
    if len(points) > QUERIES:
        points = points[np.random.default_rng(len(points)).choice(len(points), QUERIES, replace=False)]

    def match(moved: Array) -> _Match:
        near = surface.distance(moved)
        return _Match(near.valid, near.signed_mm, near.normals, 1 + near.leverage, near.slope_leverage_mm2, None)

    return _fit(points, match)


def paired_motion(points: Array, before: Array, surface: LocalSurface) -> ViewMotion | None:
    """The motion of points (n, 3) mm onto the same places measured `before` (n, 3), across the surface that these lie on.

    The same beam finds the same speckle, so most of the points' noise is the same in both.  What lay over the surface before
    is compared with what lies over it now, so that a row that was exposed a little earlier in its sweep than the first time
    does not show as a motion.
    """
    near = surface.distance(before)
    scatter = 1.4826 * float(np.median(np.abs(near.signed_mm[near.valid]))) if near.valid.any() else 0.0

    def match(moved: Array) -> _Match:
        now = surface.distance(moved)
        return _Match(near.valid & now.valid, now.signed_mm - near.signed_mm, now.normals, np.ones(len(moved)), now.slope_leverage_mm2, scatter)

    return _fit(points, match)


@dataclass(frozen=True, slots=True, eq=False)
class _Match:
    """Where n points lie beside what they are compared with.

    `variance` and `slope_leverage_mm2` (of the normals) are parts of a point's variance; the latter of the surface's points,
    whose standard deviation is `scatter_mm`, or that of the distances when None.
    """

    valid: NDArray[np.bool_]
    distance: Array
    normals: Array
    variance: Array
    slope_leverage_mm2: Array
    scatter_mm: float | None


def _fit(points: Array, match: Callable[[Array], _Match]) -> ViewMotion | None:
    """Reweighted least squares along the known directions; the match is made anew in every round."""
    centre, radius = points.mean(axis=0), max(float(np.sqrt(points.var(axis=0).sum())), 1e-3)
    vector = np.zeros(6)
    for _ in range(_ROUNDS):
        moved = _about(vector, centre, radius).apply(points)
        found = match(moved)
        over = found.valid & (np.abs(found.distance) < _MAX_DISTANCE_MM)
        if np.count_nonzero(over) < MIN_POINTS:
            return None
        distance, normals, variance = found.distance[over], found.normals[over], found.variance[over]
        arm = (moved[over] - centre - vector[3:]) / radius
        jacobian = np.hstack([np.cross(arm, normals), normals])
        ratio = distance / np.sqrt(variance)
        middle = float(np.median(ratio))
        residual = max(1.4826 * float(np.median(np.abs(ratio - middle))), 5e-4)
        u = (ratio - middle) / (_TUKEY * residual)
        weight = np.where(np.abs(u) < 1, (1 - u * u) ** 2, 0.0) / (residual**2 * variance)
        information = (jacobian * weight[:, None]).T @ jacobian
        scatter = residual if found.scatter_mm is None else found.scatter_mm
        feigned = feigned_information(arm, normals, weight * scatter**2 * found.slope_leverage_mm2[over])
        values, vectors = np.linalg.eigh(information)
        known = (np.einsum("ik,ij,jk->k", vectors, feigned, vectors) < _FEIGNED * values) & (values > _LEAST_KNOWN_MM**-2)
        directions = vectors[:, known]
        step = directions @ (directions.T @ -((jacobian * weight[:, None]).T @ distance) / values[known])
        vector = vector + step
        if float(np.abs(step).max(initial=0.0)) < 5e-4:
            break
    uncertainties = _OVERDISPERSION / np.sqrt(values[known])
    amounts = directions.T @ vector
    return ViewMotion(centre, radius, directions, amounts, uncertainties, information, feigned, int(over.sum()), residual)


def _about(vector: Array, centre: Array, radius: float) -> RigidTransform:
    turn = RigidTransform.from_vector(vector[:3] / radius, np.zeros(3))
    return RigidTransform(turn.rotation, centre - turn.rotation @ centre + vector[3:])
