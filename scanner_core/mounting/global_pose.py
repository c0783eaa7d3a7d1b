"""Brings one mount onto another from any pose and without targets, and says whether there is only one way."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.mounting.agreement import agreement
from scanner_core.mounting.judgement import LEAST_POINTS, TriedPose, judged, too_few
from scanner_core.mounting.mount_start import MountStart
from scanner_core.mounting.mount_surface import CELLS, MountSurface
from scanner_core.mounting.oriented_sample import OrientedSample, spacing_for
from scanner_core.mounting.pair_voting import voted_poses
from scanner_core.mounting.sample_fit import fit_samples, sample_score
from scanner_core.mounting.surface_fit import ALL_POINTS, fit_surface

Array = NDArray[np.float64]

_VOTED, _TRIED, _IMPROVED = 40, 24, 6
"""Poses: from the votes; of these, improved on the samples; of these, improved on the surfaces."""
_ROUGH_QUERIES = 800
_DIFFERENT = 1.0
"""In spacings, rms over the moving cloud: nearer poses are one."""


def find_pose(
    fixed: PointCloud,
    moving: PointCloud,
    *,
    seed: int,
    progress: OnProgress,
    cancelled: IsCancelled,
    fixed_towards: Array | None = None,
    moving_towards: Array | None = None,
) -> MountStart:
    """The pose of a mount on another one, or on the merged cloud of several.

    Parameters
    ----------
    fixed, moving : clouds in the object frames of their mounts; each may show much that the other does not
    seed : of the choice of points; the same clouds and seed give the same result
    fixed_towards, moving_towards : (n, 3) unit, from each point to where its light came from, in the cloud's frame; they turn
        normals outwards and tell where space was free.  Without them the covariances' long axis, upwards, stands in.

    Returns
    -------
    MountStart
        Whatever speaks against the pose is in its verdict; nothing is raised for a mount that fits nowhere.

    Raises
    ------
    Cancelled
    """
    if min(len(fixed), len(moving)) < LEAST_POINTS:
        return too_few(min(len(fixed), len(moving)))
    rng = np.random.default_rng(seed)
    progress(Progress("sampling", 0.0))
    spacing = max(spacing_for(fixed.points, CELLS), spacing_for(moving.points, CELLS))
    target = MountSurface.of(fixed, fixed_towards, spacing, rng)
    source = MountSurface.of(moving, moving_towards, spacing, rng)
    progress(Progress("searching", 0.1))
    rough = voted_poses(target.sample, source.sample, _VOTED, rng=rng, cancelled=cancelled)
    thin = source.sample.thinned(400, rng)
    improved: list[RigidTransform] = []
    progress(Progress("improving", 0.5))
    for voted in rough[:_TRIED]:
        _check(cancelled)
        improved.append(fit_samples(target.sample, thin, voted.transform))
    tried: list[TriedPose] = []
    for number, start in enumerate(_unlike(improved, target, thin, spacing)[:_IMPROVED]):
        _check(cancelled)
        progress(Progress("improving", 0.6 + 0.3 * number / _IMPROVED))
        fit = fit_surface(target, source, start, queries=_ROUGH_QUERIES // 2, rounds=8, cancelled=cancelled)
        tried.append(TriedPose(fit, agreement(target, source, fit.transform, _ROUGH_QUERIES)))
    tried.sort(key=lambda pose: -pose.agreement.score)
    if not tried:
        return judged(None, [], moving.points)
    _check(cancelled)
    progress(Progress("refining", 0.9))
    fit = fit_surface(target, source, tried[0].fit.transform, queries=ALL_POINTS, rounds=6, cancelled=cancelled, near=True)
    best = TriedPose(fit, agreement(target, source, fit.transform, 2 * _ROUGH_QUERIES))
    different = [pose for pose in tried[1:] if _apart_mm(pose.fit.transform, fit.transform, thin.points) > _DIFFERENT * spacing]
    return judged(best, different, moving.points)


def _unlike(poses: list[RigidTransform], target: MountSurface, source: OrientedSample, spacing: float) -> list[RigidTransform]:
    """Best first, without those that lay the cloud nearly to where a better one does."""
    kept: list[RigidTransform] = []
    for pose in sorted(poses, key=lambda pose: -sample_score(target.sample, source, pose)):
        if all(_apart_mm(pose, other, source.points) > _DIFFERENT * spacing for other in kept):
            kept.append(pose)
    return kept


def _apart_mm(one: RigidTransform, other: RigidTransform, points: Array) -> float:
    """rms over points (n, 3) of the distance between where two poses lay them."""
    return float(np.sqrt(np.mean(np.sum((one.apply(points) - other.apply(points)) ** 2, axis=1))))


def _check(cancelled: IsCancelled) -> None:
    if cancelled():
        raise Cancelled
