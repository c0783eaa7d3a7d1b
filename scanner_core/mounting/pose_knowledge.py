"""Which of the six directions of motion the common surface of two mounts determines, and how well."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.feigned_information import feigned_information
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_FEIGNED = 0.35
"""Largest part of a direction's information that may come from the normals' noise."""
_LEAST_KNOWN_MM = 0.1
"""A direction with a larger standard uncertainty counts as unknown."""


@dataclass(frozen=True, slots=True, eq=False)
class PoseKnowledge:
    """Attributes
    ----------
    centre : (3,) mm, about which turns are taken
    radius_mm : turns are multiplied by it, so that all six unknowns are lengths
    directions : (6, 6) orthonormal columns: turn times radius, then shift
    uncertainties_mm : (6,) standard uncertainty along them, of independent points
    known : (6,) bool, whether the surface determines them
    """

    centre: Array
    radius_mm: float
    directions: Array
    uncertainties_mm: Array
    known: NDArray[np.bool_]

    @property
    def undetermined(self) -> Array:
        """(6, k) the directions that stay open, turn times radius and shift, mm."""
        return self.directions[:, ~self.known]

    def uncertainty_mm(self, points: Array) -> float:
        """Standard uncertainty of where the pose lays points (n, 3) mm, fixed frame, rms over them, by the known directions.

        What lies far from the common surface is laid the less certainly.
        """
        arm = (points - self.centre) / self.radius_mm
        total = 0.0
        for direction, uncertainty in zip(self.directions.T[self.known], self.uncertainties_mm[self.known], strict=True):
            shifts = np.cross(direction[:3], arm) + direction[3:]
            total += float(uncertainty**2 * np.mean(np.sum(shifts**2, axis=1)))
        return float(np.sqrt(total))


def pose_step(points: Array, normals: Array, distances: Array, weights: Array, slope_variance: Array) -> tuple[RigidTransform, PoseKnowledge]:
    """The small motion that takes `distances` (n,) along `normals` (n, 3) off `points` (n, 3), along what they determine.

    Parameters
    ----------
    weights : (n,) reciprocal variances of the distances, 1/mm^2
    slope_variance : (n,) of the normals, for each of the two slopes: noisy normals seem to know of motions along the surface
    """
    centre = points.mean(axis=0)
    arm = points - centre
    radius = max(float(np.sqrt(np.mean(np.sum(arm**2, axis=1)))), 1e-9)
    arm /= radius
    jacobian = np.hstack([np.cross(arm, normals), normals])
    weighted = jacobian * weights[:, None]
    values, vectors = np.linalg.eigh(weighted.T @ jacobian)
    feigned = np.einsum("ik,ij,jk->k", vectors, feigned_information(arm, normals, weights * slope_variance), vectors)
    known = (feigned < _FEIGNED * values) & (values > _LEAST_KNOWN_MM**-2)
    step = vectors[:, known] @ ((vectors[:, known].T @ -(weighted.T @ distances)) / values[known])
    turn = RigidTransform.from_vector(step[:3] / radius, np.zeros(3))
    motion = RigidTransform(turn.rotation, centre - turn.rotation @ centre + step[3:])
    return motion, PoseKnowledge(centre, radius, vectors, 1 / np.sqrt(np.maximum(values, 1e-12)), known)
