"""A rough pose of one mount on another, improved on the samples, and what it is worth."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.motion_step import motion_step
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mounting.oriented_sample import OrientedSample

Array = NDArray[np.float64]

TUKEY = 4.685
"""Residuals beyond so many standard deviations count for nothing; 95 % efficient on clean ones (Beaton & Tukey 1974)."""
SAME_SIDE = 0.5
"""Cosine between the normals of two points that may be of one place of the surface."""
_ON_SAMPLE = 0.3
"""In spacings: a sample that lies farther beside the plane of the other contradicts it."""


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
        step = motion_step(moved[pairs], mean, distances, tukey(distances / scale))
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


def tukey(ratio: Array) -> Array:
    """Weights (n,) of residuals over their standard deviation."""
    u = ratio / TUKEY
    return np.where(np.abs(u) < 1, (1 - u * u) ** 2, 0.0)
