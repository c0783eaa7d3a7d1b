"""Brings several mounts of one object into one frame, with all their views at once.

Unknown are the pose of every mount but the first, the turntable's axis (its tilt, and where it meets the table: shared by
all views that were measured with one calibration), and a small correction of every view.  They minimize the robustly
weighted distances of points to the local surfaces of other views of their mount, and to the merged surfaces of all other
mounts (point to plane: Chen & Medioni 1992; all views at once: Pulli 1999), plus what is known beforehand of axis and
views.  Every pair of mounts that overlaps enters at once, so a loop of mounts closes as well as its surfaces let it;
how far each pair by itself would rather lie is told (:attr:`PairFit.closure_um`).

As in :mod:`~scanner_core.geometry.registration`, errors that are common to neighbouring points do not average out:
neither a pair of views nor a pair of mounts is believed beyond `systematic_um`, however many points it has.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mount_matching import Matches, MountSurface
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import RegistrationParameters
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.small_motion import robust_weights, rotation_vector, shared_error_weights, turned_about
from scanner_core.geometry.view_matching import MIN_MATCHES
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]

_BETWEEN = 4_000
"""Points of a mount that are compared with each other mount."""
_STEPS = 4
"""Reweighted steps between two searches for correspondences."""
_APPROACH, _ROUNDS = 30, 12
"""Rounds at most with the mounts rigid, and with everything free."""
_CLOSE_MM, _SETTLED_MM = 1e-3, 2.5e-3
_LOOSE_MM = 1.0
"""Of a step of a mount: what no surface determines stays where it is."""
_AGREES = 4.685
"""Standard deviations within which a distance agrees with the others."""
_MOUNT, _AXIS, _VIEW = 6, 4, 6


@dataclass(frozen=True, slots=True, eq=False)
class MountedCloud:
    """What was measured of one mount, and about where it lies.

    Attributes
    ----------
    cloud : own object frame, as the table's pose gives it; `views` numbered from 0
    table_deg : (v,) of each view
    pose : about, of its object frame in that of the first mount
    axis : mounts with the same number were measured with the same calibration of the table's axis
    """

    cloud: PointCloud
    table_deg: Array
    pose: RigidTransform
    axis: int = 0


@dataclass(frozen=True, slots=True)
class PairFit:
    """How two mounts lie together, at points that were not used in the fit.

    Attributes
    ----------
    first, second : of the list of mounts
    overlap_fraction : part of a mount's points that lie over the other's surface, of the mount where it is smaller
    agreeing_fraction : part of those whose distance agrees with the noise of most
    residual_um : robust standard deviation of the distances
    closure_um : rms distance, along the normals, by which the pair alone would rather lie otherwise
    matches : distances that this rests on
    """

    first: int
    second: int
    overlap_fraction: float
    agreeing_fraction: float
    residual_um: float
    closure_um: float
    matches: int


@dataclass(frozen=True, slots=True, eq=False)
class MountRefinement:
    """Where the mounts lie.

    Attributes
    ----------
    poses : of every mount's object frame in that of the first, mm
    corrections : of every view of every mount, in its mount's object frame, the axis' part included
    axes : by calibration, tilt (x, y) in degrees and shift (x, y) in mm of the table frame by which the axis was corrected
    residual_within_um : robust standard deviation of the distances of views to views of the same mount
    pairs : those that overlap
    converged : nothing moved any more
    """

    poses: tuple[RigidTransform, ...]
    corrections: tuple[tuple[RigidTransform, ...], ...]
    axes: Array
    residual_within_um: float
    pairs: tuple[PairFit, ...]
    converged: bool
    iterations: int

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "mounts": len(self.poses),
            "views": sum(map(len, self.corrections)),
            "residual_within_um": round(self.residual_within_um, 2),
            "pairs": [{name: round(getattr(pair, name), 3) for name in PairFit.__slots__} for pair in self.pairs],
            "axes": [
                {"tilt_deg": [round(float(v), 5) for v in axis[:2]], "shift_um": [round(float(1e3 * v), 2) for v in axis[2:]]} for axis in self.axes
            ],
            "converged": self.converged,
            "iterations": self.iterations,
        }


def refine_mounts(
    mounts: list[MountedCloud],
    parameters: RegistrationParameters | None = None,
    *,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> MountRefinement:
    """All views of all mounts together.

    Parameters
    ----------
    mounts : at least one, each so close to its place that surfaces within `max_distance_mm` are the same one
    parameters : prior of axis and views, and cost

    Raises
    ------
    Cancelled
    """
    return _Refinement(mounts, parameters or RegistrationParameters(), progress, cancelled).run()


class _Refinement:
    """The state of a refinement: poses of mounts, axes, corrections of views."""

    def __init__(self, mounts: list[MountedCloud], p: RegistrationParameters, progress: OnProgress, cancelled: IsCancelled) -> None:
        self._mounts, self._p, self._progress, self._cancelled = mounts, p, progress, cancelled
        counts = [len(mount.table_deg) for mount in mounts]
        first_views = np.cumsum([0, *counts])
        self._surfaces = [
            MountSurface(mount.cloud, count, p.partners, p.queries, _BETWEEN, int(first))
            for mount, count, first in zip(mounts, counts, first_views, strict=False)
        ]
        self._of_view = np.repeat(np.arange(len(mounts)), counts)
        self._poses = [mount.pose for mount in mounts]
        self._axes = np.zeros((max(mount.axis for mount in mounts) + 1, _AXIS))
        self._own = [RigidTransform.identity()] * len(self._of_view)  # of each view, in the common frame
        self._pairs = list(permutations(range(len(mounts)), 2))
        placed = np.concatenate([mount.pose.apply(mount.cloud.points) for mount in mounts])
        self._centre = placed.mean(axis=0)
        self._radius = float(np.sqrt(((placed - self._centre) ** 2).sum(axis=1).mean()))
        angle_mm, shift_mm = self._radius * np.radians(p.prior_angle_deg), 1e-3 * p.prior_position_um
        self._axis_weight = 1 / np.repeat([angle_mm, shift_mm], 2) ** 2
        self._view_weight = 1 / np.repeat([angle_mm, shift_mm], 3) ** 2

    def run(self) -> MountRefinement:
        iterations, converged = 0, False
        for surface, corrections in zip(self._surfaces, self._corrections(), strict=True):
            surface.merge(corrections)
        if len(self._mounts) > 1:
            self._approach()
        for i in range(_ROUNDS):
            self._tell(0.5 + 0.5 * i / _ROUNDS)
            iterations += 1
            moved_mm = self._step(Matches.joined([self._within(), self._between()]), free=True)
            for surface, corrections in zip(self._surfaces, self._corrections(), strict=True):
                surface.merge(corrections)
            if moved_mm < _SETTLED_MM:
                converged = True
                break
        within = self._within(check=True)
        return MountRefinement(
            poses=tuple(self._poses),
            corrections=tuple(tuple(corrections) for corrections in self._corrections()),
            axes=self._axes * np.repeat([np.degrees(1 / self._radius), 1.0], 2),
            residual_within_um=1e3 * _robust_sd(within.distance),
            pairs=self._pair_fits(),
            converged=converged,
            iterations=iterations,
        )

    def _approach(self) -> None:
        """The mounts alone, each of them rigid."""
        for i in range(_APPROACH):
            self._tell(0.5 * i / _APPROACH)
            if self._step(self._between(), free=False) < _CLOSE_MM:
                break

    def _tell(self, fraction: float) -> None:
        if self._cancelled():
            raise Cancelled
        self._progress(Progress("register", fraction))

    # ------------------------------------------------------------------------------------------ correspondences
    def _corrections(self) -> list[list[RigidTransform]]:
        """By mount and view, in the mount's object frame."""
        found = []
        for number, mount in enumerate(self._mounts):
            pose, back = self._poses[number], self._poses[number].inverse()
            first = self._surfaces[number].first_view
            found.append(
                [back @ self._own[first + view] @ pose @ self._axis_motion(mount.axis, float(angle)) for view, angle in enumerate(mount.table_deg)]
            )
        return found

    def _axis_motion(self, axis: int, table_deg: float) -> RigidTransform:
        """What the correction of the axis does to a view, in the object frame."""
        tilt, shift = self._axes[axis, :2] / self._radius, self._axes[axis, 2:]
        in_table = RigidTransform.from_vector([*tilt, 0.0], [*shift, 0.0])
        return RigidTransform.about_z(-table_deg) @ in_table @ RigidTransform.about_z(table_deg)

    def _within(self, check: bool = False) -> Matches:
        found, group = [], 0
        for surface, corrections, pose in zip(self._surfaces, self._corrections(), self._poses, strict=True):
            found.append(surface.match_within(corrections, pose, group, self._p.max_distance_mm, check))
            group += len(surface.pairs)
        return Matches.joined(found)

    def _between(self, check: bool = False) -> Matches:
        """Both directions of a pair of mounts are one group, numbered below those of the views."""
        corrected = [surface.corrected(motions) for surface, motions in zip(self._surfaces, self._corrections(), strict=True)]
        found = []
        for a, b in self._pairs:
            one, other = self._surfaces[a], self._surfaces[b]
            found.append(one.match_with(corrected[a], self._poses[a], other, self._poses[b], self._group(a, b), self._p.max_distance_mm, check))
        return Matches.joined([matches for matches in found if len(matches) >= MIN_MATCHES])

    def _group(self, a: int, b: int) -> int:
        return -1 - (min(a, b) * len(self._mounts) + max(a, b))

    # ------------------------------------------------------------------------------------------ least squares
    def _step(self, matches: Matches, free: bool) -> float:
        """Move everything by reweighted least squares for these correspondences; the largest motion, mm.

        Unknowns are twists, turns times `radius` and shifts, both in mm.  A view's twist is the sum of its mount's, of what
        the axis gives it and, where views are `free`, its own.
        """
        if not len(matches):
            return 0.0
        jacobian = np.hstack([np.cross(matches.points - self._centre, matches.normals) / self._radius, matches.normals])
        views = len(self._of_view)
        parts, part_weight, part_so_far = self._parts(free)
        shared = parts.shape[2]
        own_so_far = np.array([np.r_[self._radius * rotation_vector(v), v.apply(self._centre) - self._centre] for v in self._own])
        steps = np.zeros(shared + _VIEW * views * free)
        for _ in range(_STEPS):
            twists = parts @ steps[:shared] + (steps[shared:].reshape(views, _VIEW) if free else 0.0)
            distance = matches.distance + (jacobian * (twists[matches.first] - twists[matches.second])).sum(axis=1)
            normal, right = self._equations(matches, jacobian, distance)
            flat = parts.reshape(-1, shared)
            of_parts = normal @ flat
            if not free:
                whole, pull = flat.T @ of_parts, flat.T @ right
                whole[np.diag_indices(shared)] += part_weight
                pull -= part_weight * (part_so_far + steps)
            else:
                weights = np.r_[part_weight, np.tile(self._view_weight, views)]
                whole = np.block([[flat.T @ of_parts, of_parts.T], [of_parts, normal]])
                whole[np.diag_indices(len(whole))] += weights
                pull = np.r_[flat.T @ right, right] - weights * (np.r_[part_so_far, own_so_far.ravel()] + steps)
            steps += np.linalg.solve(whole, pull)
        self._move(steps, shared, free)
        twists = parts @ steps[:shared] + (steps[shared:].reshape(views, _VIEW) if free else 0.0)
        return float(np.linalg.norm(twists, axis=1).max())

    def _parts(self, free: bool) -> tuple[Array, Array, Array]:
        """What the shared unknowns do to the views, (views, 6, k); the weights of their priors, (k,); and their values so far, (k,)."""
        moving = len(self._mounts) - 1
        axes = len(self._axes) * free
        parts = np.zeros((len(self._of_view), _VIEW, _MOUNT * moving + _AXIS * axes))
        for view, number in enumerate(self._of_view):
            if number:
                parts[view, :, _MOUNT * (number - 1) : _MOUNT * number] = np.eye(6)
            if axes:
                at = _MOUNT * moving + _AXIS * self._mounts[number].axis
                parts[view, :, at : at + _AXIS] = self._of_axis(view, int(number))
        weights = np.r_[np.full(_MOUNT * moving, 1 / _LOOSE_MM**2), np.tile(self._axis_weight, axes)]
        return parts, weights, np.r_[np.zeros(_MOUNT * moving), self._axes.ravel() if free else np.zeros(0)]

    def _of_axis(self, view: int, number: int) -> Array:
        """(6, 4): the twist of a view about the common centre by the twist of the axis in the table frame."""
        table_deg = float(self._mounts[number].table_deg[view - self._surfaces[number].first_view])
        pose = self._poses[number]
        turn = pose.rotation @ RigidTransform.about_z(-table_deg).rotation
        from_origin = self._centre - pose.translation
        columns = np.zeros((_VIEW, _AXIS))
        for k in range(2):
            columns[:3, k] = turn[:, k]
            columns[3:, k] = np.cross(turn[:, k], from_origin) / self._radius
            columns[3:, 2 + k] = turn[:, k]
        return columns

    def _equations(self, matches: Matches, jacobian: Array, distance: Array) -> tuple[Array, Array]:
        """Normal matrix (6 v, 6 v) of the views' twists, and its right side (6 v,)."""
        views = len(self._of_view)
        weight = self._weights(matches, distance)
        normal, right = np.zeros((views, _VIEW, views, _VIEW)), np.zeros((views, _VIEW))
        order = np.lexsort((matches.second, matches.first))
        pair = matches.first[order] * views + matches.second[order]
        for chunk in np.split(order, np.flatnonzero(np.diff(pair)) + 1):
            i, j = int(matches.first[chunk[0]]), int(matches.second[chunk[0]])
            weighted = jacobian[chunk] * weight[chunk, None]
            block, pull = weighted.T @ jacobian[chunk], weighted.T @ distance[chunk]
            normal[i, :, i] += block
            normal[j, :, j] += block
            normal[i, :, j] -= block
            normal[j, :, i] -= block
            right[i] -= pull
            right[j] += pull
        return normal.reshape(_VIEW * views, _VIEW * views), right.ravel()

    def _weights(self, matches: Matches, distance: Array) -> Array:
        """Robust, and with a scale of their own for each pair of mounts and for all views within mounts."""
        weight = np.zeros(len(matches))
        kinds = np.minimum(matches.group, 0)
        for kind in np.unique(kinds):
            here = kinds == kind
            scale = max(_robust_sd(distance[here] / np.sqrt(matches.relative_variance[here])), 1e-5)
            for group in np.unique(matches.group[here]):
                of = matches.group == group
                weight[of] = shared_error_weights(distance[of], scale**2 * matches.relative_variance[of], 1e-3 * self._p.systematic_um)
        return weight

    def _move(self, steps: Array, shared: int, free: bool) -> None:
        moving = len(self._mounts) - 1
        for number in range(moving):
            self._poses[number + 1] = self._turned(steps[_MOUNT * number : _MOUNT * (number + 1)]) @ self._poses[number + 1]
        if free:
            self._axes = self._axes + steps[_MOUNT * moving : shared].reshape(-1, _AXIS)
            own = steps[shared:].reshape(-1, _VIEW)
            self._own = [self._turned(step) @ before for step, before in zip(own, self._own, strict=True)]

    def _turned(self, twist: Array) -> RigidTransform:
        return turned_about(twist[:3] / self._radius, twist[3:], self._centre)

    # ------------------------------------------------------------------------------------------ what it came to
    def _pair_fits(self) -> tuple[PairFit, ...]:
        between = self._between(check=True)
        found = []
        for a, b in self._pairs:
            of = between.group == self._group(a, b)
            if a > b or not of.any():
                continue
            from_a = self._of_view[between.first[of]] == a
            shares = [np.count_nonzero(side) / max(self._surfaces[m].compared, 1) for m, side in ((a, from_a), (b, ~from_a))]
            sign = np.where(from_a, -1.0, 1.0)
            distance, variance = between.distance[of], between.relative_variance[of]
            scale = max(_robust_sd(distance / np.sqrt(variance)), 1e-5)
            agrees = np.abs(distance) < _AGREES * scale * np.sqrt(variance)
            weight = robust_weights(distance, scale**2 * variance) / variance
            arm = np.cross(between.points[of] - self._centre, between.normals[of]) / self._radius
            jacobian = sign[:, None] * np.hstack([arm, between.normals[of]])
            rather = _least(jacobian, distance, weight)
            closure = np.sqrt((weight * (jacobian @ rather) ** 2).sum() / weight.sum())
            found.append(
                PairFit(a, b, float(min(shares)), float(agrees.mean()), 1e3 * _robust_sd(distance), float(1e3 * closure), int(np.count_nonzero(of)))
            )
        return tuple(found)


def _least(jacobian: Array, distance: Array, weight: Array) -> Array:
    """The twist (6,) that takes the distances away, as far as they determine one."""
    values, vectors = np.linalg.eigh((jacobian * weight[:, None]).T @ jacobian)
    known = values > 1e-4 * values[-1]
    right = vectors.T @ (jacobian.T @ (weight * distance))
    return np.asarray(vectors[:, known] @ (right[known] / values[known]), np.float64)


def _robust_sd(values: Array) -> float:
    return 1.4826 * float(np.median(np.abs(values))) if len(values) else 0.0
