"""Finds calibrated spheres among measured points, without being told where they stand.

A scan of an artefact also holds its stem, its rod and what lies beside it.  The sphere is the one thing of known radius,
so it is sought as such: many spheres through four points each (RANSAC: Fischler & Bolles, Comm. ACM 24, 1981), the one
with the most points close to it, then least squares with the points beyond five robust standard deviations left out,
repeated until the choice of points stands still.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.fitting import SphereFit, fit_sphere

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

LEAST_POINTS = 50
"""Fewer make no trustworthy radius."""
REJECT_SIGMAS = 5.0
"""Points farther from the sphere than so many robust standard deviations do not count as its own: of clean normal noise
less than one in a million."""
_TRIALS = 2000
_LOOKED_AT = 600
_NEAR = 0.05
"""A trial sphere is scored by the points within this share of its radius."""
_RADIUS_RANGE = 0.25
"""Trial spheres whose radius is off by a larger share are another thing."""
_SEED = 20_031
_ROUNDS = 50


@dataclass(frozen=True, slots=True, eq=False)
class FoundSphere:
    """A sphere among n points.

    Attributes
    ----------
    fit : least squares on the points that count as the sphere's
    members : (n,) True for those points
    near : (n,) True for all points that lie within a twentieth of the radius of the surface
    """

    fit: SphereFit
    members: Mask
    near: Mask

    @property
    def rejected(self) -> int:
        """Points close to the sphere that were left out of the fit."""
        return int(np.count_nonzero(self.near & ~self.members))


def find_sphere(points: Array, radius_mm: float) -> FoundSphere | None:
    """The sphere of about `radius_mm` that holds the most of the points (n, 3) mm, or None.

    The same points give the same answer: the trials are drawn with a seed of their own.
    """
    if len(points) < LEAST_POINTS:
        return None
    rng = np.random.default_rng(_SEED)
    some = points if len(points) <= _LOOKED_AT else points[rng.choice(len(points), _LOOKED_AT, replace=False)]
    centres, radii = _trial_spheres(some, radius_mm, rng)
    if not len(radii):
        return None
    counts = [np.count_nonzero(_close(some, centre, radius, radius_mm)) for centre, radius in zip(centres, radii, strict=True)]
    best = int(np.argmax(counts))
    return settle(points, _close(points, centres[best], float(radii[best]), radius_mm), radius_mm)


def _close(points: Array, centre: Array, radius: float, radius_mm: float) -> Mask:
    return np.asarray(np.abs(np.linalg.norm(points - centre, axis=1) - radius) < _NEAR * radius_mm, bool)


def settle(points: Array, members: Mask, radius_mm: float) -> FoundSphere | None:
    """Least squares from a first choice of points, with :data:`REJECT_SIGMAS` and repeated until the choice stands still."""
    for _ in range(_ROUNDS):
        if members.sum() < LEAST_POINTS:
            return None
        fit = fit_sphere(points[members])
        if not abs(fit.radius_mm - radius_mm) < _RADIUS_RANGE * radius_mm:
            return None
        off = np.abs(np.linalg.norm(points - fit.centre, axis=1) - fit.radius_mm)
        # The scale comes from all near points, not from the chosen ones, whose scatter shrinks with every rejection.
        near = off < max(_NEAR * radius_mm, 3 * fit.rms_mm)
        scale = 1.4826 * float(np.median(off[near]))
        chosen = near & (off <= REJECT_SIGMAS * scale)
        if (chosen == members).all():
            break
        members = chosen
    return FoundSphere(fit, members, near)


def find_spheres(points: Array, radii_mm: tuple[float, ...]) -> list[FoundSphere]:
    """Spheres of these radii one after the other, each among the points that the ones before left; their masks cover all points."""
    found: list[FoundSphere] = []
    free = np.ones(len(points), bool)
    for radius_mm in radii_mm:
        here = np.flatnonzero(free)
        sphere = find_sphere(points[here], radius_mm)
        if sphere is None:
            break
        members, near = np.zeros(len(points), bool), np.zeros(len(points), bool)
        members[here], near[here] = sphere.members, sphere.near
        found.append(FoundSphere(sphere.fit, members, near))
        free[near] = False
    return found


def _trial_spheres(points: Array, radius_mm: float, rng: np.random.Generator) -> tuple[Array, Array]:
    """Spheres through four points each, (m, 3) and (m,), those of about the right radius; the four lie within a diameter."""
    first = points[rng.integers(len(points), size=_TRIALS)]
    others = points[rng.integers(len(points), size=(_TRIALS, 3))]
    away = others - first[:, None]
    close = (np.linalg.norm(away, axis=2) < 2 * (1 + _RADIUS_RANGE) * radius_mm).all(axis=1)
    first, away = first[close], away[close]
    size = np.abs(away).max(axis=(1, 2), initial=1e-9)
    sound = np.abs(np.linalg.det(away)) > 1e-4 * size**3
    first, away = first[sound], away[sound]
    if not len(first):
        return np.empty((0, 3)), np.empty(0)
    offset = np.linalg.solve(away, 0.5 * np.einsum("ijk,ijk->ij", away, away)[:, :, None])[:, :, 0]
    radii = np.linalg.norm(offset, axis=1)
    right = np.abs(radii - radius_mm) < _RADIUS_RANGE * radius_mm
    return first[right] + offset[right], radii[right]
