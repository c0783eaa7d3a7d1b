"""Brings one mount onto another from points that a person picked on both."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scanner_core.comparison.picked_points import transform_from_picked
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.mounting.agreement import agreement
from scanner_core.mounting.judgement import LEAST_POINTS, TriedPose, judged, refused, too_few
from scanner_core.mounting.mount_start import MountStart, Verdict
from scanner_core.mounting.mount_surface import CELLS, MountSurface
from scanner_core.mounting.oriented_sample import spacing_for
from scanner_core.mounting.sample_fit import fit_samples
from scanner_core.mounting.surface_fit import ALL_POINTS, fit_surface

Array = NDArray[np.float64]

_QUERIES = 800
_PICKED_MM = 3.0
"""Picks that lie farther apart after the fit (or by more than three spacings of the sample) meant another place."""


def pose_from_points(
    fixed: PointCloud,
    moving: PointCloud,
    fixed_points: ArrayLike,
    moving_points: ArrayLike,
    *,
    seed: int,
    cancelled: IsCancelled,
    fixed_towards: Array | None = None,
    moving_towards: Array | None = None,
) -> MountStart:
    """The pose of a mount on another one near where points picked in the same order (n, 3) mm, n >= 3, lay it.

    Everything else is as in :func:`~scanner_core.mounting.global_pose.find_pose`, but that other poses are not looked for, and
    that directions which the common surface leaves open keep what the points say: they are in ``undetermined``.

    Raises
    ------
    ComparisonError
        E-CMP-05 when the points are fewer than three, in one line, or do not belong to each other.
    Cancelled
    """
    start = transform_from_picked(fixed_points, moving_points)
    if min(len(fixed), len(moving)) < LEAST_POINTS:
        return too_few(min(len(fixed), len(moving)))
    rng = np.random.default_rng(seed)
    spacing = max(spacing_for(fixed.points, CELLS), spacing_for(moving.points, CELLS))
    target = MountSurface.of(fixed, fixed_towards, spacing, rng)
    source = MountSurface.of(moving, moving_towards, spacing, rng)
    if cancelled():
        raise Cancelled
    rough = fit_samples(target.sample, source.sample, start)
    near = [fit_surface(target, source, pose, queries=_QUERIES, rounds=10, cancelled=cancelled) for pose in (start, rough)]
    if cancelled():
        raise Cancelled
    best = max(near, key=lambda fit: agreement(target, source, fit.transform, _QUERIES).score)
    fit = fit_surface(target, source, best.transform, queries=ALL_POINTS, rounds=6, cancelled=cancelled, near=True)
    found = judged(TriedPose(fit, agreement(target, source, fit.transform, 2 * _QUERIES)), [], moving.points, picked=True)
    one, other = np.asarray(fixed_points, np.float64), fit.transform.apply(np.asarray(moving_points, np.float64))
    apart = float(np.sqrt(np.mean(np.sum((one - other) ** 2, axis=1))))
    if found.accepted and apart > max(_PICKED_MM, 3 * spacing):
        return refused(found, Verdict.NO_FIT, "E-MNT-07", apart_mm=round(apart, 1))
    return found
