"""A rough pose of one mount on another, improved: first on the samples, then on the surfaces under the points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.motion_step import motion_step
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mounting.mount_surface import MountSurface
from scanner_core.mounting.oriented_sample import OrientedSample
from scanner_core.mounting.pose_knowledge import PoseKnowledge, pose_step

Array = NDArray[np.float64]

_TUKEY = 4.685
LEAST_MATCHES = 40
SAME_SIDE = 0.5
"""Cosine between the normals of two points that may be of one place of the surface."""
_STILL_MM = 2e-4
_ON_SAMPLE = 0.3
"""In spacings: a sample that lies farther beside the plane of the other contradicts it."""


@dataclass(frozen=True, slots=True, eq=False)
class SurfaceFit:
    """Attributes
    ----------
    transform : moving to fixed
    scale_mm : robust standard deviation of the distances
    knowledge : None when too little of the mounts lies on each other
    """

    transform: RigidTransform
    scale_mm: float
    knowledge: PoseKnowledge | None


def fit_samples(fixed: OrientedSample, moving: OrientedSample, start: RigidTransform, rounds: int = 12) -> RigidTransform:
    """Iterated closest points, point to plane, with a gate that closes from three spacings to one and a half.

    What has no counterpart within the gate, as most of a mount that overlaps in part, does not count.
    """
    transform, gate = start, 3.0
    for _ in range(rounds):
        moved, normals = transform.apply(moving.points), transform.rotate(moving.normals)
        away, which = fixed.tree.query(moved, distance_upper_bound=gate * fixed.spacing_mm, workers=1)
        pairs = np.flatnonzero(np.isfinite(away))
        pairs = pairs[np.einsum("ij,ij->i", normals[pairs], fixed.normals[which[pairs]]) > SAME_SIDE]
        if len(pairs) < 12:
            return transform
        mean = normals[pairs] + fixed.normals[which[pairs]]
        mean /= np.linalg.norm(mean, axis=1)[:, None]
        distances = np.einsum("ij,ij->i", moved[pairs] - fixed.points[which[pairs]], mean)
        scale = max(1.4826 * float(np.median(np.abs(distances))), 0.02 * fixed.spacing_mm)
        step = motion_step(moved[pairs], mean, distances, _tukey(distances / scale))
        transform = step @ transform
        gate = max(0.8 * gate, 1.5)
        if gate == 1.5 and np.abs(step.apply(moved[pairs]) - moved[pairs]).max() < 0.01 * fixed.spacing_mm:
            break
    return transform


def sample_score(fixed: OrientedSample, moving: OrientedSample, transform: RigidTransform) -> float:
    """Share of the moving sample that lies on the fixed one less that which lies beside it: which poses are worth improving."""
    moved, normals = transform.apply(moving.points), transform.rotate(moving.normals)
    away, which = fixed.tree.query(moved, distance_upper_bound=1.5 * fixed.spacing_mm, workers=1)
    near = np.flatnonzero(np.isfinite(away))
    near = near[np.einsum("ij,ij->i", normals[near], fixed.normals[which[near]]) > SAME_SIDE]
    beside = np.abs(np.einsum("ij,ij->i", moved[near] - fixed.points[which[near]], fixed.normals[which[near]]))
    return float(np.sum(1 - 2 * np.minimum(beside / (_ON_SAMPLE * fixed.spacing_mm), 1.0))) / len(moving)


def fit_surface(fixed: MountSurface, moving: MountSurface, start: RigidTransform, *, queries: int, rounds: int) -> SurfaceFit:
    """Robust least squares of the distances of moving points to the surface under the fixed ones.

    Directions of motion that the common surface does not determine keep what the start says.
    """
    transform, scale, knowledge = start, np.inf, None
    chosen = moving.chosen[:queries]
    points, outward = moving.points[chosen], moving.normals[chosen]
    gate = 1.5 * fixed.sample.spacing_mm
    for _ in range(rounds):
        moved = transform.apply(points)
        near = fixed.surface.distance(moved)
        facing = np.abs(np.einsum("ij,ij->i", near.normals, transform.rotate(outward))) > SAME_SIDE
        use = near.valid & facing & (np.abs(near.signed_mm) < gate)
        if np.count_nonzero(use) < LEAST_MATCHES:
            return SurfaceFit(transform, scale, None)
        spread = np.sqrt(1 + near.leverage[use])
        ratio = near.signed_mm[use] / spread
        scale = max(1.4826 * float(np.median(np.abs(ratio))), 1e-3)
        weights = _tukey(ratio / scale) / (scale * spread) ** 2
        slopes = fixed.scatter_mm**2 * near.slope_leverage_mm2[use]
        step, knowledge = pose_step(moved[use], near.normals[use], near.signed_mm[use], weights, slopes)
        transform = step @ transform
        gate = max(0.6 * gate, 2 * _TUKEY * scale)
        if np.abs(step.apply(moved[use]) - moved[use]).max() < _STILL_MM:
            break
    return SurfaceFit(transform, scale, knowledge)


def _tukey(ratio: Array) -> Array:
    u = ratio / _TUKEY
    return np.where(np.abs(u) < 1, (1 - u * u) ** 2, 0.0)
