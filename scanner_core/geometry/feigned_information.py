"""What noisy normals seem to know of a motion."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def feigned_information(arm: Array, normals: Array, weight: Array) -> Array:
    """(6, 6): what normals with errors of variance `weight` over the residual's add to the information on average."""
    # Both tangents t of a normal contribute (arm x t, t): their sum over t is that over all axes less that of the normal.
    result = np.zeros((6, 6))
    for axis in np.eye(3):
        rows = np.hstack([np.cross(arm, axis), np.broadcast_to(axis, arm.shape)])
        result += (rows * weight[:, None]).T @ rows
    rows = np.hstack([np.cross(arm, normals), normals])
    difference: Array = result - (rows * weight[:, None]).T @ rows
    return difference
