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


def feature_poses(before: SurfaceSample, after: SurfaceSample, count: int = 8) -> list[RigidTransform]:
    """The `count` poses, after to before, with most votes; rough, a few millimetres off.

    Drost, Ulrich, Navab and Ilic, "Model globally, match locally: efficient and robust 3D object recognition", CVPR 2010.
    The surface with the greater area is the model, the other is looked for in it.
    """
    import cv2  # here: only the pairs that principal axes cannot place need it

    swapped = float(after.areas.sum()) > float(before.areas.sum())
    model, scene = (after, before) if swapped else (before, after)
    model_centre, scene_centre = model.points.mean(axis=0), scene.points.mean(axis=0)
    step = _model_step(model)
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


def _with_normals(sample: SurfaceSample, centre: Array) -> NDArray[np.float32]:
    return np.concatenate([sample.points - centre, sample.normals], axis=1).astype(np.float32)
