"""Brings the views of one object together, after the turntable's pose has brought them close.

Every view gets a small rigid correction.  Corrections minimize, over all pairs of views that overlap, the robustly
weighted distances of one view's points to the other's local surface (point to plane: Chen & Medioni 1992; all views at
once: Pulli 1999), plus what is known beforehand: the table's pose is right to a stated standard uncertainty.  That prior
fixes the gauge and holds every motion that the shapes do not determine, so a sphere or a cylinder does not drift.

Calibration errors are the same for neighbouring points, and thousands of them do not average out.  A pair of views is
therefore not believed beyond `systematic_um`, however many points it has.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.local_surface import LocalSurface
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.small_motion import rotation_vector, shared_error_weights, turned_about
from scanner_core.geometry.view_matching import MIN_MATCHES, ViewMatches, match_views, overlap_fractions, overlapping_pairs

Array = NDArray[np.float64]

_STEPS = 4
"""Reweighted steps between two searches for correspondences."""
_SETTLED_MM = 5e-4
_GAIN = 0.99
"""A smaller gain is within the residual's own uncertainty, and means that the views were good to a seventh of it."""
_SHIFTS_FIRST = 4
"""Rounds without turns: a sphere that still lies beside its surface seems to tell something about its turn."""
_SEED = 20_031
"""Of the choice of points: the same cloud gives the same result."""


@dataclass(frozen=True, slots=True)
class RegistrationParameters:
    """What is known beforehand, and what may be spent.

    Attributes
    ----------
    prior_position_um, prior_angle_deg : standard uncertainty of a view's pose as the turntable gives it, per coordinate
    systematic_um : standard uncertainty of the distance between two views that does not average out
    max_distance_mm : farther surfaces are not the same surface
    queries : distances that are evaluated in a round, over all pairs of views
    partners : views that a view is compared with, those with the largest overlap
    rounds : at most; in each the places on the surfaces are found anew
    """

    prior_position_um: float = 30.0
    prior_angle_deg: float = 0.02
    systematic_um: float = 5.0
    max_distance_mm: float = 1.0
    queries: int = 20_000
    partners: int = 4
    rounds: int = 8


@dataclass(frozen=True, slots=True, eq=False)
class RegistrationResult:
    """How the views were brought together.

    Attributes
    ----------
    corrections : by view, object frame to object frame; the identity when `applied` is False
    residual_before_um, residual_after_um : robust standard deviation of the distance between overlapping views, at points
        that were not used in the fit
    overlap_fraction : by view, the part of its points that lie over another view's surface
    converged : the corrections stopped changing
    iterations : rounds spent
    applied : False when the corrections were not used, for the `reason`
    """

    corrections: tuple[RigidTransform, ...]
    residual_before_um: float
    residual_after_um: float
    overlap_fraction: tuple[float, ...]
    converged: bool
    iterations: int
    applied: bool
    reason: str = ""

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "views": len(self.corrections),
            "residual_before_um": round(self.residual_before_um, 2),
            "residual_after_um": round(self.residual_after_um, 2),
            "overlap_fraction": [round(fraction, 3) for fraction in self.overlap_fraction],
            "largest_shift_um": round(1e3 * max((float(np.linalg.norm(c.translation)) for c in self.corrections), default=0.0), 2),
            "largest_angle_deg": round(max((c.angle_deg() for c in self.corrections), default=0.0), 5),
            "converged": self.converged,
            "iterations": self.iterations,
            "applied": self.applied,
            "reason": self.reason,
        }


def register_views(cloud: PointCloud, parameters: RegistrationParameters | None = None) -> RegistrationResult:
    """Small rigid corrections of the views of a cloud in the object frame.

    Parameters
    ----------
    cloud : with `views` numbered from 0; its covariances, when known, weigh the points
    parameters : prior and cost

    Returns
    -------
    RegistrationResult
        One correction for every view number up to the largest.  That the views do not overlap, that the iteration did
        not settle or that it gained nothing is said in it.
    """
    p = parameters or RegistrationParameters()
    number = np.zeros(len(cloud), np.int32) if cloud.views is None else cloud.views
    count = int(number.max()) + 1 if len(cloud) else 0
    identity = tuple(RigidTransform.identity() for _ in range(count))
    rng = np.random.default_rng(_SEED)
    members = [rng.permutation(np.flatnonzero(number == view)) for view in range(count)]
    surfaces = [LocalSurface(cloud.points[np.sort(m)]) for m in members]
    pairs = overlapping_pairs([cloud.points[m] for m in members], p.partners)
    share = max(p.queries // max(len(pairs), 1), 2 * MIN_MATCHES)
    half = [min(share, len(m) // 2) for m in members]
    fit_points = [m[:n] for m, n in zip(members, half, strict=True)]
    check_points = [m[n : 2 * n] for m, n in zip(members, half, strict=True)]

    before = match_views(cloud, check_points, surfaces, pairs, identity, p.max_distance_mm)
    if not before:
        return RegistrationResult(identity, 0.0, 0.0, (0.0,) * count, False, 0, False, "the views do not overlap")
    overlap = overlap_fractions(before, check_points, count)
    centre = np.mean([matches.points.mean(axis=0) for matches in before], axis=0)
    radius = float(np.sqrt(np.mean([((m.points - centre) ** 2).sum(axis=1).mean() for m in before])))

    corrections, converged, iterations = identity, False, 0
    for iteration in range(p.rounds):
        iterations = iteration + 1
        matches = match_views(cloud, fit_points, surfaces, pairs, corrections, p.max_distance_mm)
        if not matches:
            break
        corrections, moved_mm = _solve(matches, corrections, centre, radius, p)
        if moved_mm < _SETTLED_MM:
            converged = True
            break
    after = match_views(cloud, check_points, surfaces, pairs, corrections, p.max_distance_mm)
    residual_before, residual_after = _residual_um(before), _residual_um(after) if after else float("inf")
    if not converged or not residual_after < _GAIN * residual_before:
        reason = "the refinement gained nothing" if converged else "the refinement did not settle"
        return RegistrationResult(identity, residual_before, residual_before, overlap, converged, iterations, False, reason)
    return RegistrationResult(corrections, residual_before, residual_after, overlap, True, iterations, True)


def fit_rigid_to_surface(
    points: Array, closest: Callable[[Array], tuple[Array, Array]], *, iterations: int = 50, tolerance_mm: float = 1e-6
) -> RigidTransform:
    """The rigid motion that brings points (n, 3) mm closest to a surface: least squares, point to plane, from the identity.

    Motions that the surface does not determine (the turns of a sphere) are left at zero.

    Parameters
    ----------
    closest : (n, 3) points -> their closest points on the surface (n, 3) mm and its unit normals there (n, 3)
    """
    motion = RigidTransform.identity()
    centre = points.mean(axis=0)
    radius = float(np.sqrt(((points - centre) ** 2).sum(axis=1).mean()))
    for iteration in range(iterations):
        moved = motion.apply(points)
        about = moved - motion.apply(centre)
        foot, normals = closest(moved)
        jacobian = np.hstack([np.cross(about, normals) / radius, normals])
        if iteration < _SHIFTS_FIRST:
            jacobian[:, :3] = 0.0
        values, vectors = np.linalg.eigh(jacobian.T @ jacobian)
        known = values > 1e-4 * values[-1]
        right = vectors.T @ (jacobian.T @ ((foot - moved) * normals).sum(axis=1))
        step = vectors[:, known] @ (right[known] / values[known])
        motion = turned_about(step[:3] / radius, step[3:], motion.apply(centre)) @ motion
        if iteration >= _SHIFTS_FIRST and float(np.abs(step).max()) < tolerance_mm:
            break
    return motion


def _residual_um(matches: list[ViewMatches]) -> float:
    return 1e3 * 1.4826 * float(np.median(np.abs(np.concatenate([m.distance for m in matches]))))


def _solve(
    matches: list[ViewMatches], corrections: tuple[RigidTransform, ...], centre: Array, radius: float, p: RegistrationParameters
) -> tuple[tuple[RigidTransform, ...], float]:
    """Corrections for these correspondences by reweighted least squares; also the largest change of a view, mm.

    Unknowns of a view: its turn about `centre` times `radius`, and its shift, both in mm.  The motions are so small that
    a distance is linear in them.
    """
    n = len(corrections)
    jacobians = [np.hstack([np.cross(m.points - centre, m.normals) / radius, m.normals]) for m in matches]
    so_far = np.array([np.concatenate([radius * rotation_vector(c), c.apply(centre) - centre]) for c in corrections])
    prior = 1.0 / np.repeat([radius * np.radians(p.prior_angle_deg), 1e-3 * p.prior_position_um], 3) ** 2
    change = np.zeros((n, 6))
    for _ in range(_STEPS):
        distances = [m.distance + j @ (change[m.first] - change[m.second]) for m, j in zip(matches, jacobians, strict=True)]
        ratios = np.concatenate([d / np.sqrt(m.relative_variance) for d, m in zip(distances, matches, strict=True)])
        scale = max(1.4826 * float(np.median(np.abs(ratios))), 1e-5)
        normal, right = np.zeros((n, 6, n, 6)), np.zeros((n, 6))
        for m, jacobian, distance in zip(matches, jacobians, distances, strict=True):
            weight = shared_error_weights(distance, scale**2 * m.relative_variance, 1e-3 * p.systematic_um)
            weighted = jacobian * weight[:, None]
            block, pull = weighted.T @ jacobian, weighted.T @ distance
            i, j = m.first, m.second
            normal[i, :, i] += block
            normal[j, :, j] += block
            normal[i, :, j] -= block
            normal[j, :, i] -= block
            right[i] -= pull
            right[j] += pull
        for view in range(n):
            normal[view, :, view] += np.diag(prior)
        right -= prior * (so_far + change)
        change += np.linalg.solve(normal.reshape(6 * n, 6 * n), right.ravel()).reshape(n, 6)
    moved = tuple(turned_about(turn / radius, shift, centre) @ c for turn, shift, c in zip(change[:, :3], change[:, 3:], corrections, strict=True))
    return moved, float(np.linalg.norm(change, axis=1).max())
