"""A rough pose of two samples, improved by trimmed iterated closest points, and a score that says what it is worth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.surface_sample import SurfaceSample
from scanner_core.geometry.motion_step import motion_step
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """A pose that was tried.

    Attributes
    ----------
    transform : after to before
    score : 0 to 1, see `pose_score`
    """

    transform: RigidTransform
    score: float


def trimmed_fit(before: SurfaceSample, after: SurfaceSample, start: RigidTransform, *, share: float, rounds: int) -> RigidTransform:
    """Iterated closest points, point to plane, on the best `share` of the pairs (Chetverikov et al. 2005).

    Pairs with normals more than 60 degrees apart are no pairs.
    """
    transform = start
    for _ in range(rounds):
        moved, normals = transform.apply(after.points), transform.rotate(after.normals)
        away, which = before.tree.query(moved, workers=1)
        cosine = np.einsum("ij,ij->i", normals, before.normals[which])
        pairs = np.flatnonzero(cosine > 0.5)
        if len(pairs) < 12:
            return transform
        pairs = pairs[away[pairs] <= np.quantile(away[pairs], share)]
        # the mean of both normals (Rusinkiewicz 2019): exact to second order on curved surfaces
        mean = normals[pairs] + before.normals[which[pairs]]
        mean /= np.linalg.norm(mean, axis=1)[:, None]
        distances = np.einsum("ij,ij->i", moved[pairs] - before.points[which[pairs]], mean)
        step = motion_step(moved[pairs], mean, distances, after.areas[pairs])
        transform = step @ transform
        if np.abs(step.apply(moved[pairs]) - moved[pairs]).max() < 1e-3 * before.spacing_mm:
            return transform
    return transform


def pose_score(before: SurfaceSample, after: SurfaceSample, transform: RigidTransform, close_mm: float) -> float:
    """Share of the surface that lies close on the other, seen from the side of which more does, 0 to 1.

    Either surface may show more than the other; that is why the better side counts.
    """
    inverse = transform.inverse()
    return max(
        _close_share(before, after.points, after.normals, after.areas, transform, close_mm),
        _close_share(after, before.points, before.normals, before.areas, inverse, close_mm),
    )


def _close_share(target: SurfaceSample, points: Array, normals: Array, areas: Array, transform: RigidTransform, close_mm: float) -> float:
    moved, turned = transform.apply(points), transform.rotate(normals)
    away, which = target.tree.query(moved, distance_upper_bound=1.5 * target.spacing_mm)
    found = np.isfinite(away)
    off = moved[found] - target.points[which[found]]
    facing = target.normals[which[found]]
    close = (np.abs(np.einsum("ij,ij->i", off, facing)) < close_mm) & (np.einsum("ij,ij->i", turned[found], facing) > 0.8)
    return float(areas[found][close].sum() / areas.sum())
