"""Small rigid motions as unknowns of a least-squares fit of surfaces, and the weights of the distances that determine them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

TUKEY = 4.685
"""Residuals beyond so many standard deviations count for nothing; 95 % efficient on clean ones (Beaton & Tukey 1974)."""


def turned_about(rotation: Array, shift: Array, centre: Array) -> RigidTransform:
    """Turn by a rotation vector (3,) rad about `centre` (3,) mm, then shift by (3,) mm."""
    turn = RigidTransform.from_vector(rotation, np.zeros(3))
    return RigidTransform(turn.rotation, centre - turn.rotation @ centre + shift)


def rotation_vector(transform: RigidTransform) -> Array:
    """Of a small rotation, (3,) radians."""
    r = transform.rotation
    return 0.5 * np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])


def robust_weights(distance: Array, variance: Array) -> Array:
    """Tukey's weights (n,) of distances (n,) mm with variances (n,) mm^2, 0 to 1."""
    u = distance / (TUKEY * np.sqrt(variance))
    return np.where(np.abs(u) < 1, (1 - u * u) ** 2, 0.0)


def shared_error_weights(distance: Array, variance: Array, systematic_mm: float) -> Array:
    """Tukey's weights over the variance, in which a common error of all n distances is shared out.

    n points of a six-parameter motion so weigh no more than 6 / systematic^2.
    """
    robust = robust_weights(distance, variance)
    return np.asarray(robust / (variance + robust.sum() / 6 * systematic_mm**2), np.float64)
