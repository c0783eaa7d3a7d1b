"""The small rigid motion that takes distances off a surface: one step of a point-to-plane fit."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]


def motion_step(points: Array, normals: Array, distances: Array, weights: Array) -> RigidTransform:
    """The small motion that takes `distances` (n,) along `normals` (n, 3) off `points` (n, 3), by weighted least squares.

    Chen and Medioni, "Object modelling by registration of multiple range images", 1992.  Directions that the normals do
    not determine stay still.
    """
    centre = points.mean(axis=0)
    jacobian = np.concatenate([np.cross(points - centre, normals), normals], axis=1)
    radius = max(float(np.sqrt(np.mean((points - centre) ** 2))), 1e-9)
    jacobian[:, :3] /= radius  # rotation and translation in one unit, so that "not determined" has one meaning
    weighted = jacobian * weights[:, None]
    values, vectors = np.linalg.eigh(weighted.T @ jacobian)
    kept = values > 1e-6 * max(float(values[-1]), 1e-300)
    solution = vectors[:, kept] @ ((vectors[:, kept].T @ (weighted.T @ -distances)) / values[kept])
    turn = Rotation.from_rotvec(solution[:3] / radius).as_matrix()
    return RigidTransform(turn, centre - turn @ centre + solution[3:])
