"""A pose of one mount on another, fitted to the surfaces under their points: robust least squares, both ways.

The local surface errs by its curvature, the same way on both mounts.  In the distances of one mount's points to the other's
surface that error would pull; those of the other one's points to the first one's surface pull as much the other way.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mounting.mount_surface import MountSurface
from scanner_core.mounting.pose_knowledge import PoseKnowledge, pose_step
from scanner_core.mounting.sample_fit import SAME_SIDE, TUKEY, tukey

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_LEAST_MATCHES = 80
_STILL_MM = 2e-4
_COUNTED_TWICE = 2.0
"""Every point is compared with the other surface and makes up its own, so independent information is half of what is summed."""
_GLANCE, _HOPELESS = 3, 8.0
"""After so many rounds distances that are so many times the points' scatter will not become those of one surface."""
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
    """Of points of one mount over the surface of the other: `which` they are, where they lie in the other's frame, and the
    surface's normals, signed distances and the parts of a point's variance that its noise adds."""

    which: Index
    places: Array
    normals: Array
    distances: Array
    leverage: Array
    slope_leverage_mm2: Array


def fit_surface(fixed: MountSurface, moving: MountSurface, start: RigidTransform, *, queries: int, rounds: int, near: bool = False) -> SurfaceFit:
    """Improves a pose, moving to fixed, on at most `queries` points of each mount.

    Directions of motion that the common surface does not determine keep what the start says.  Of many points only those that
    lie over the other surface matter; when the start is `near`, they are looked for once.
    """
    transform, knowledge = start, None
    movable, standing = moving.chosen[:queries], fixed.chosen[:queries]
    gate = 1.5 * fixed.sample.spacing_mm
    for number in range(rounds):
        there = _matches(fixed, moving, movable, transform, gate)
        back = _matches(moving, fixed, standing, transform.inverse(), gate)
        if len(there.which) + len(back.which) < _LEAST_MATCHES:
            return SurfaceFit(transform, None)
        points = np.concatenate([there.places, fixed.points[back.which]])
        normals = np.concatenate([there.normals, transform.rotate(back.normals)])
        # a surface that moves towards a point takes off its distance as a point that moves away from a surface adds to it
        distances = np.concatenate([there.distances, -back.distances])
        spread = np.sqrt(1 + np.concatenate([there.leverage, back.leverage]))
        slopes = np.concatenate([fixed.scatter_mm**2 * there.slope_leverage_mm2, moving.scatter_mm**2 * back.slope_leverage_mm2])
        ratio = distances / spread
        scale = max(1.4826 * float(np.median(np.abs(ratio))), 1e-3)
        step, knowledge = pose_step(points, normals, distances, tukey(ratio / scale) / (scale * spread) ** 2, slopes)
        transform = step @ transform
        gate = max(0.6 * gate, 2 * TUKEY * scale)
        if np.abs(step.apply(points) - points).max() < _STILL_MM:
            break
        if near and number == 0:
            movable, standing = there.which, back.which
        if number == _GLANCE and scale > _HOPELESS * np.hypot(fixed.scatter_mm, moving.scatter_mm):
            break
    if knowledge is None:
        return SurfaceFit(transform, None)
    return SurfaceFit(transform, replace(knowledge, uncertainties_mm=np.sqrt(_COUNTED_TWICE) * knowledge.uncertainties_mm))


def _matches(target: MountSurface, source: MountSurface, chosen: Index, transform: RigidTransform, gate_mm: float) -> _Matches:
    moved = transform.apply(source.points[chosen])
    found = target.surface.distance(moved)
    facing = np.abs(np.einsum("ij,ij->i", found.normals, transform.rotate(source.normals[chosen]))) > SAME_SIDE
    use = found.valid & facing & (np.abs(found.signed_mm) < gate_mm)
    return _Matches(chosen[use], moved[use], found.normals[use], found.signed_mm[use], found.leverage[use], found.slope_leverage_mm2[use])
