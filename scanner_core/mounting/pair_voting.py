"""Rough poses by voting of point pairs, for surfaces of which each shows a part that the other does not.

Drost, Ulrich, Navab and Ilic, "Model globally, match locally: efficient and robust 3D object recognition", CVPR 2010.  A
pair of oriented points has four features that no motion changes: its length and three angles.  Every pair of one cloud votes
for the poses that lay it onto the pairs of the other with equal features.  A reference point on the common part collects
the votes of all pairs with another point on the common part, however much else there is; and what many pairs have in common
(flat and round regions) is left out first when the votes become too many.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.mounting.oriented_sample import OrientedSample

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_MODEL_POINTS, _REFERENCES = 500, 150
_ANGLES, _TURNS = 15, 30
"""Bins of 12 degrees, of the features and of the turn about the reference's normal."""
_STEP = 1.2
"""Of the samples' spacing: bins of the pairs' length, which says where a sample lies only to half a spacing."""
_SHORTEST, _LONGEST = 2.5, 0.75
"""Pairs that are used: in spacings, whose normals say little of the direction; and of the smaller cloud's diameter."""
_MOST_VOTES = 6_000_000
_AT_ONCE = 20
_PEAKS = 2
"""Poses that a reference point may propose."""


@dataclass(frozen=True, slots=True, eq=False)
class VotedPose:
    """A rough pose, moving to fixed, and the votes of it and of those like it."""

    transform: RigidTransform
    votes: float


def voted_poses(fixed: OrientedSample, moving: OrientedSample, count: int, *, rng: np.random.Generator, cancelled: IsCancelled) -> list[VotedPose]:
    """At most `count` different poses, those with most votes first; a spacing or two off."""
    model, scene = fixed.thinned(_MODEL_POINTS, rng), moving.thinned(_MODEL_POINTS, rng)
    step = _STEP * fixed.spacing_mm
    longest = _LONGEST * min(fixed.diameter_mm, moving.diameter_mm)
    i, key, turn = _pairs(model, np.arange(len(model)), step, longest)
    order = np.argsort(key, kind="stable")
    i, key, turn = i[order], key[order], turn[order]
    references = np.sort(rng.permutation(len(scene))[:_REFERENCES])
    which, wanted, scene_turn = _pairs(scene, references, step, longest)
    begin, end = np.searchsorted(key, wanted, "left"), np.searchsorted(key, wanted, "right")
    many = end - begin
    rarest = np.argsort(many, kind="stable")
    affordable = np.zeros(len(many), np.bool_)
    affordable[rarest[np.cumsum(many[rarest]) <= _MOST_VOTES]] = True

    proposed: list[VotedPose] = []
    model_frames, scene_frames = _frames(model.normals), _frames(scene.normals)
    size = len(model) * _TURNS
    for first in range(0, len(references), _AT_ONCE):
        if cancelled():
            raise Cancelled
        some = references[first : first + _AT_ONCE]
        here = np.flatnonzero(affordable & (which >= some[0]) & (which <= some[-1]))
        slot = np.searchsorted(some, which[here])
        repeats = many[here]
        pair = np.repeat(begin[here] - np.concatenate([[0], np.cumsum(repeats)[:-1]]), repeats) + np.arange(repeats.sum())
        angle = np.repeat(scene_turn[here], repeats) - turn[pair]
        bin_ = np.floor(angle / (2 * np.pi) * _TURNS).astype(np.int64) % _TURNS
        votes = np.bincount((np.repeat(slot, repeats) * len(model) + i[pair]) * _TURNS + bin_, minlength=len(some) * size)
        table = votes.reshape(len(some), len(model), _TURNS).astype(np.float32)
        table = table + 0.5 * (np.roll(table, 1, axis=2) + np.roll(table, -1, axis=2))
        flat = table.reshape(len(some), size)
        best = np.argpartition(-flat, _PEAKS, axis=1)[:, :_PEAKS]
        for row, peaks in enumerate(best):
            for peak in peaks:
                at, bin_at = divmod(int(peak), _TURNS)
                about = 2 * np.pi * (bin_at + 0.5) / _TURNS
                transform = _pose(model.points[at], model_frames[at], scene.points[some[row]], scene_frames[some[row]], about)
                proposed.append(VotedPose(transform, float(flat[row, peak])))
    return _clustered(proposed, moving, 3 * fixed.spacing_mm)[:count]


def _pairs(sample: OrientedSample, references: Index, step: float, longest: float) -> tuple[Index, Index, Array]:
    """Of pairs of a reference and any other point: the reference's number, the key of their features, and the turn of the
    other about the reference's normal in radians."""
    points, normals = sample.points, sample.normals
    i, j = (part.ravel() for part in np.meshgrid(references, np.arange(len(points)), indexing="ij"))
    along = points[j] - points[i]
    length = np.linalg.norm(along, axis=1)
    kept = (length > _SHORTEST * sample.spacing_mm) & (length < longest)
    i, j, along, length = i[kept], j[kept], along[kept], length[kept]
    unit = along / length[:, None]
    cosines = [np.einsum("ij,ij->i", a, b) for a, b in ((normals[i], unit), (normals[j], unit), (normals[i], normals[j]))]
    angles = np.minimum(np.arccos(np.clip(np.stack(cosines), -1, 1)) / np.pi * _ANGLES, _ANGLES - 1).astype(np.int64)
    key = (length / step).astype(np.int64)
    for angle in angles:
        key = key * _ANGLES + angle
    frame = _frames(normals)
    x, y = (np.einsum("ij,ij->i", frame[i, :, axis], along) for axis in (1, 2))
    return i.astype(np.int64), key, np.arctan2(y, x)


def _frames(normals: Array) -> Array:
    """(n, 3, 3): columns are the normal and two axes across it."""
    other = np.where(np.abs(normals[:, :1]) < 0.7, np.array([[1.0, 0.0, 0.0]]), np.array([[0.0, 1.0, 0.0]]))
    across = np.cross(normals, other)
    across /= np.linalg.norm(across, axis=1)[:, None]
    return np.stack([normals, across, np.cross(normals, across)], axis=2)


def _pose(model_point: Array, model_frame: Array, scene_point: Array, scene_frame: Array, about: float) -> RigidTransform:
    """The pose that lays the scene's point and normal on the model's, turned about it so that a pair at scene angle a lies at a - about."""
    c, s = np.cos(about), np.sin(about)
    turn = np.array([[1.0, 0.0, 0.0], [0.0, c, s], [0.0, -s, c]])
    rotation = model_frame @ turn @ scene_frame.T
    return RigidTransform(rotation, model_point - rotation @ scene_point)


def _clustered(poses: list[VotedPose], moving: OrientedSample, apart_mm: float) -> list[VotedPose]:
    """Poses that lay the sample to nearly the same place become one, with the sum of their votes; most votes first."""
    if not poses:
        return []
    # four places of the cloud stand for all: motions of a rigid body are linear in them
    middle, spread = moving.points.mean(axis=0), moving.points.std(axis=0).max()
    corners = middle + spread * np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    poses = sorted(poses, key=lambda pose: -pose.votes)
    places = np.stack([pose.transform.apply(corners) for pose in poses])
    free = np.ones(len(poses), np.bool_)
    clusters = []
    for k, pose in enumerate(poses):
        if not free[k]:
            continue
        near = free & (np.sqrt(np.mean(np.sum((places - places[k]) ** 2, axis=2), axis=1)) < apart_mm)
        free &= ~near
        clusters.append(VotedPose(pose.transform, float(sum(poses[m].votes for m in np.flatnonzero(near)))))
    return sorted(clusters, key=lambda pose: -pose.votes)
