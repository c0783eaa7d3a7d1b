"""Poses by voting of point pairs: finds a fragment in a whole, where principal axes mislead."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.surface_sample import SurfaceSample
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_MODEL_POINTS = 220
"""All pairs of these are hashed: time grows with the square, and steeply more once the bins of the hash fill up."""
_FINEST_STEP = 0.08
"""Of the model's diameter: the grid of the model, and the bins of pair distances."""
_MOST_ALIKE = 0.02
"""Chance of two pairs to have the same features above which the surface (a ball, a bowl) has none to speak of, and the search
would take minutes."""


def feature_poses(before: SurfaceSample, after: SurfaceSample, count: int = 8) -> list[RigidTransform]:
    """The `count` poses, after to before, with most votes; rough, a few millimetres off.

    Drost, Ulrich, Navab and Ilic, "Model globally, match locally: efficient and robust 3D object recognition", CVPR 2010.
    The surface with the greater area is the model, the other is looked for in it.  Without features, no pose.
    """
    import cv2  # here: only the pairs that principal axes cannot place need it

    swapped = float(after.areas.sum()) > float(before.areas.sum())
    model, scene = (after, before) if swapped else (before, after)
    model_centre, scene_centre = model.points.mean(axis=0), scene.points.mean(axis=0)
    step = _model_step(model)
    if _alike(model, step) > _MOST_ALIKE:
        return []
    detector = cv2.ppf_match_3d.PPF3DDetector(step, step)
    detector.trainModel(_with_normals(model, model_centre))
    found = detector.match(_with_normals(scene, scene_centre), 1 / 3, 0.05)
    poses = []
    for result in found[:count]:
        turned = RigidTransform.from_matrix(result.pose)
        model_to_scene = RigidTransform(turned.rotation, turned.translation + scene_centre - turned.rotation @ model_centre)
        poses.append(model_to_scene if swapped else model_to_scene.inverse())
    return poses


def _model_step(model: SurfaceSample) -> float:
    """The finest step with which the model's grid keeps few enough points."""
    low = model.points.min(axis=0)
    extent = np.maximum(np.ptp(model.points, axis=0), 1e-9)
    step = _FINEST_STEP
    while step < 0.3:
        cells = np.unique(np.floor((model.points - low) / extent / step).astype(np.int64), axis=0)
        if len(cells) <= _MODEL_POINTS:
            break
        step *= 1.1
    return step


def _alike(model: SurfaceSample, step: float) -> float:
    """Chance of two pairs of points to have the same distance and the same three angles, within the bins of the hash."""
    chosen = np.linspace(0, len(model) - 1, min(len(model), _MODEL_POINTS)).astype(np.int64)
    points, normals = model.points[chosen], model.normals[chosen]
    i, j = np.triu_indices(len(points), 1)
    along = points[j] - points[i]
    length = np.maximum(np.sqrt(np.einsum("ij,ij->i", along, along)), 1e-12)
    along /= length[:, None]
    cosines = [np.einsum("ij,ij->i", a, b) for a, b in ((normals[i], along), (normals[j], along), (normals[i], normals[j]))]
    angles = np.arccos(np.clip(np.stack(cosines), -1.0, 1.0))
    bins = np.concatenate([[length / (step * length.max())], angles / np.radians(12.0)]).astype(np.int64)
    count = np.unique(bins, axis=1, return_counts=True)[1]
    return float(np.sum(count.astype(np.float64) ** 2) / float(count.sum()) ** 2)


def _with_normals(sample: SurfaceSample, centre: Array) -> NDArray[np.float32]:
    return np.concatenate([sample.points - centre, sample.normals], axis=1).astype(np.float32)
