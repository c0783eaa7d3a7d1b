"""Poses from the principal axes of two surfaces: quick and right for whole objects, useless for fragments."""

from __future__ import annotations

from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.surface_sample import SurfaceSample
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_DISTINCT = 1.25
"""Ratio of the moments of two axes above which their order is not in question."""


def principal_poses(before: SurfaceSample, after: SurfaceSample) -> list[RigidTransform]:
    """The proper rotations, after to before, that lay centroid on centroid and axis on axis.

    Four when the moments are distinct (an axis has no sense of direction); axes with similar moments may stand for each
    other as well, which makes eight or all twenty-four.
    """
    from_centre, _, from_axes = _axes(after)
    to_centre, moments, to_axes = _axes(before)
    ranks = np.arange(3)
    poses = []
    for order in permutations(range(3)):
        high = np.maximum(moments[ranks], moments[list(order)])
        low = np.minimum(moments[ranks], moments[list(order)])
        if np.any(high > _DISTINCT * low):
            continue
        for signs in product((1.0, -1.0), repeat=3):
            rotation = (to_axes[:, order] * np.array(signs)) @ from_axes.T
            if np.linalg.det(rotation) > 0:
                poses.append(RigidTransform(rotation, to_centre - rotation @ from_centre))
    return poses


def _axes(sample: SurfaceSample) -> tuple[Array, Array, Array]:
    """Centroid, moments in rising order and their axes as columns."""
    weights = sample.areas / sample.areas.sum()
    centre = weights @ sample.points
    about = sample.points - centre
    moments, axes = np.linalg.eigh((about * weights[:, None]).T @ about)
    return centre, np.maximum(moments, 1e-12), axes
