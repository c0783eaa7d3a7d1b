"""A start from points that a person picked on both surfaces."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scanner_core.errors import ComparisonError
from scanner_core.geometry.fitting import fit_rigid
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_LEAST_APART_MM = 1.0
"""How far the points must lie off the line through them, rms."""
_WORST_FIT = 0.1
"""Of the points' spread: picks that disagree by more were taken in another order or on another tooth."""


def transform_from_picked(before_points: ArrayLike, after_points: ArrayLike) -> RigidTransform:
    """The rigid motion, after to before, that fits points picked in the same order, (n, 3) each, n >= 3, mm.

    Raises
    ------
    ComparisonError
        E-CMP-05 when they are fewer than three, in one line, or do not belong to each other.
    """
    before, after = np.asarray(before_points, np.float64).reshape(-1, 3), np.asarray(after_points, np.float64).reshape(-1, 3)
    if len(before) != len(after):
        raise ComparisonError("E-CMP-05", reason=f"{len(before)} were picked on one surface and {len(after)} on the other")
    if len(before) < 3:
        raise ComparisonError("E-CMP-05", reason="fewer than three were picked")
    if not (np.isfinite(before).all() and np.isfinite(after).all()):
        raise ComparisonError("E-CMP-05", reason="one of them is not on the surface")
    for points in (before, after):
        spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False) / np.sqrt(len(points))
        if spread[1] < _LEAST_APART_MM:
            raise ComparisonError("E-CMP-05", reason="they lie in one line")
    transform = fit_rigid(after, before)
    left_over = float(np.sqrt(np.mean(np.sum((transform.apply(after) - before) ** 2, axis=1))))
    extent = float(np.sqrt(np.mean(np.sum((before - before.mean(axis=0)) ** 2, axis=1))))
    if left_over > max(_WORST_FIT * extent, 2.0):
        raise ComparisonError("E-CMP-05", reason=f"after the best fit they still lie {left_over:.1f} mm apart")
    return transform
