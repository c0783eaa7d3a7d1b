"""A pose of one mount on another, fitted to the surfaces under their points: robust least squares, both ways.

The local surface errs by its curvature, the same way on both mounts.  In the distances of one mount's points to the other's
surface that error would pull; those of the other one's points to the first one's surface pull as much the other way.  Where
only one way is open, as at the borders and where one mount has few points, it does pull: the more a surface bends, the less
it counts.

Of many points over few, each tells little: the errors of the few are common to them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.local_surface import BENDING, NEIGHBOURS, LocalSurface, SurfaceDistance
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.mounting.mount_surface import MountSurface
from scanner_core.mounting.pose_knowledge import PoseKnowledge, pose_step
from scanner_core.mounting.sample_fit import SAME_SIDE, TUKEY, tukey

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_LEAST_MATCHES = 80
_STILL_MM = 2e-4
_GLANCE, _HOPELESS = 3, 8.0
"""After so many rounds distances that are so many times the points' scatter will not become those of one surface."""
_AT_ONCE = 2000
ALL_POINTS = 25_000
"""Of each mount, that a final pose rests on at most."""


@dataclass(frozen=True, slots=True, eq=False)
class SurfaceFit:
    """Attributes
    ----------
    transform : moving to fixed
    knowledge : None when too little of the mounts lies on each other
    """

    transform: RigidTransform
    knowledge: PoseKnowledge | None


@dataclass(frozen=True, slots=True, eq=False)
class _Matches:
    """Of points of one mount over the surface of the other.

    Attributes
    ----------
    which : (n,) of the points
    nearest : (n,) of the other mount's points
    places : (n, 3) mm, where the points lie in the other's frame
    normals, distances : (n, 3), (n,) mm, of the surface and over it
    spread : (n,) standard deviations of the distances, in units of a point's
    common : (n,) variances in the same units: what a distance tells is as if it had this one and were independent of all others
    slope_leverage_mm2 : (n,) variance of each slope that the points' noise adds, in the same units, 1/mm^2
    """

    which: Index
    nearest: Index
    places: Array
    normals: Array
    distances: Array
    spread: Array
    common: Array
    slope_leverage_mm2: Array


def fit_surface(
    fixed: MountSurface, moving: MountSurface, start: RigidTransform, *, queries: int, rounds: int, cancelled: IsCancelled, near: bool = False
) -> SurfaceFit:
    """Improves a pose, moving to fixed, on at most `queries` points of each mount.

    Directions of motion that the common surface does not determine keep what the start says.  Of many points only those that
    lie over the other surface matter; when the start is `near`, they are looked for once.

    Raises
    ------
    Cancelled
    """
    transform, knowledge = start, None
    movable, standing = moving.chosen[:queries], fixed.chosen[:queries]
    gate = 1.5 * fixed.sample.spacing_mm
    for number in range(rounds):
        there = _matches(fixed, moving, movable, transform, gate, cancelled)
        back = _matches(moving, fixed, standing, transform.inverse(), gate, cancelled)
        if len(there.which) + len(back.which) < _LEAST_MATCHES:
            return SurfaceFit(transform, None)
        points = np.concatenate([there.places, fixed.points[back.which]])
        normals = np.concatenate([there.normals, transform.rotate(back.normals)])
        # a surface that moves towards a point takes off its distance as a point that moves away from a surface adds to it
        distances = np.concatenate([there.distances, -back.distances])
        spread = np.concatenate([there.spread, back.spread])
        # a point that is compared with the other surface, and makes up the one that the other's points are compared with, counts twice
        twice = np.concatenate([np.isin(there.nearest, back.which), np.isin(back.nearest, there.which)])
        common = np.concatenate([there.common, back.common]) * np.where(twice, 2.0, 1.0)
        slopes = np.concatenate([fixed.scatter_mm**2 * there.slope_leverage_mm2, moving.scatter_mm**2 * back.slope_leverage_mm2])
        ratio = distances / spread
        scale = max(1.4826 * float(np.median(np.abs(ratio))), 1e-3)
        step, knowledge = pose_step(points, normals, distances, tukey(ratio / scale) / (scale**2 * common), slopes)
        transform = step @ transform
        gate = max(0.6 * gate, 2 * TUKEY * scale)
        if np.abs(step.apply(points) - points).max() < _STILL_MM:
            break
        if near and number == 0:
            movable, standing = there.which, back.which
        if number == _GLANCE and scale > _HOPELESS * np.hypot(fixed.scatter_mm, moving.scatter_mm):
            break
    return SurfaceFit(transform, knowledge)


def _distance(surface: LocalSurface, places: Array, cancelled: IsCancelled) -> SurfaceDistance:
    """The same as by the surface itself, asked in parts between which it may be cancelled."""
    parts = []
    for first in range(0, max(len(places), 1), _AT_ONCE):
        if cancelled():
            raise Cancelled
        parts.append(surface.distance(places[first : first + _AT_ONCE]))
    return SurfaceDistance(*(np.concatenate([getattr(part, name) for part in parts]) for name in SurfaceDistance.__slots__))


def _matches(
    target: MountSurface, source: MountSurface, chosen: Index, transform: RigidTransform, gate_mm: float, cancelled: IsCancelled
) -> _Matches:
    moved = transform.apply(source.points[chosen])
    found = _distance(target.surface, moved, cancelled)
    facing = np.abs(np.einsum("ij,ij->i", found.normals, transform.rotate(source.normals[chosen]))) > SAME_SIDE
    use = found.valid & facing & (np.abs(found.signed_mm) < gate_mm)
    nearest, leverage = found.nearest[use], found.leverage[use]
    sharing = np.bincount(nearest, minlength=len(target.points))[nearest]
    bending = (BENDING * found.sag_mm[use] / max(source.scatter_mm, 1e-6)) ** 2
    return _Matches(
        which=chosen[use],
        nearest=nearest,
        places=moved[use],
        normals=found.normals[use],
        distances=found.signed_mm[use],
        spread=np.sqrt(1 + leverage + bending),
        common=1 + np.maximum(leverage, sharing) + NEIGHBOURS * sharing * bending,
        slope_leverage_mm2=found.slope_leverage_mm2[use],
    )
