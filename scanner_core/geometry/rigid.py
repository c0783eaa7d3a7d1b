"""Rigid motions of space."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class RigidTransform:
    """``q = rotation @ p + translation``.

    Attributes
    ----------
    rotation : (3, 3) float64, orthonormal, determinant +1
    translation : (3,) float64, mm
    """

    rotation: Array
    translation: Array

    @classmethod
    def identity(cls) -> RigidTransform:
        return cls(np.eye(3), np.zeros(3))

    @classmethod
    def about_z(cls, angle_deg: float) -> RigidTransform:
        """Rotation about +z, counter-clockwise seen from above."""
        c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
        return cls(np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]), np.zeros(3))

    @classmethod
    def from_vector(cls, rotation_vector: ArrayLike, translation: ArrayLike) -> RigidTransform:
        """From an axis times an angle in radians, (3,), and a translation in mm, (3,)."""
        v = np.asarray(rotation_vector, np.float64)
        angle = float(np.linalg.norm(v))
        if angle < 1e-12:
            k = _cross_matrix(v)
            rotation = np.eye(3) + k
        else:
            k = _cross_matrix(v / angle)
            rotation = np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)
        u, _, vt = np.linalg.svd(rotation)
        return cls(u @ vt, np.asarray(translation, np.float64))

    def apply(self, points: Array) -> Array:
        """Move points, (n, 3) or (3,), mm."""
        return points @ self.rotation.T + self.translation

    def rotate(self, vectors: Array) -> Array:
        """Turn directions, (n, 3) or (3,)."""
        return vectors @ self.rotation.T

    def rotate_covariances(self, covariances: Array) -> Array:
        """Turn covariance matrices, (n, 3, 3), mm^2."""
        return self.rotation @ covariances @ self.rotation.T

    def inverse(self) -> RigidTransform:
        return RigidTransform(self.rotation.T, -self.rotation.T @ self.translation)

    def __matmul__(self, other: RigidTransform) -> RigidTransform:
        """``(a @ b).apply(p) == a.apply(b.apply(p))``."""
        return RigidTransform(self.rotation @ other.rotation, self.rotation @ other.translation + self.translation)

    def angle_deg(self) -> float:
        """Angle of the rotation, 0 to 180."""
        skew = 0.5 * (self.rotation - self.rotation.T)
        sine = np.linalg.norm([skew[2, 1], skew[0, 2], skew[1, 0]])
        return float(np.degrees(np.arctan2(sine, 0.5 * (np.trace(self.rotation) - 1))))

    def matrix(self) -> Array:
        """The homogeneous (4, 4) matrix."""
        m = np.eye(4)
        m[:3, :3], m[:3, 3] = self.rotation, self.translation
        return m

    @classmethod
    def from_matrix(cls, matrix: ArrayLike) -> RigidTransform:
        """From a homogeneous (4, 4) matrix."""
        m = np.asarray(matrix, np.float64)
        return cls(m[:3, :3].copy(), m[:3, 3].copy())


def _cross_matrix(v: Array) -> Array:
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
