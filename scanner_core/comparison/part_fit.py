"""Rigid fit of a part of the after surface onto the before surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.edges import row_cross, row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import SurfaceWalk
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.smoothing import uniform_averaging

Array = NDArray[np.float64]
_WIDEST_MM, _TUKEY = 1.5, 4.685
"""The robust weight's reach in the first round, and in the last in units of the noise (95 % efficient)."""
_ROUNDS = 40
_SETTLED_MM = 2e-5
_MOST_TURNED = 0.5
"""Cosine below which a foot's normal belongs to another side of the surface."""


@dataclass(frozen=True, slots=True, eq=False)
class PartFit:
    """Where n points of a part came from.

    Attributes
    ----------
    transform : brings the part onto the before surface
    residual_mm : (n,) signed, of every point after the fit
    weights : (n,) 0 to 1, what each counted at the end
    jacobian : (n, 6) of the residuals by rotation about `centre` and translation
    centre : (3,) mm, about which the rotation is meant: the part's place on the before surface
    """

    transform: RigidTransform
    residual_mm: Array
    weights: Array
    jacobian: Array
    centre: Array


class PartFitter:
    """Fits parts onto one before surface; made once, used for every part."""

    def __init__(self, before: TriangleMesh) -> None:
        self._mesh = before
        self._walk = SurfaceWalk(before)
        self._tree = cKDTree(before.vertices)
        normals, averaging = before.vertex_normals(), uniform_averaging(before)
        for _ in range(4):  # facets of a noisy scan face anywhere; their neighbourhood does not
            normals = averaging @ normals
        self._normals = normals / np.maximum(np.sqrt(row_dot(normals, normals)), 1e-12)[:, None]

    def fit(self, points: Array, normals: Array, noise_mm: float, start: RigidTransform | None = None) -> PartFit:
        """Iteratively reweighted point-to-plane fit of points (n, 3) mm with unit normals (n, 3).

        The weights are Tukey's.  Their reach shrinks from where everything counts to a few times the noise, so that what does not
        move with the part, such as the gum, falls out of the fit.
        """
        transform = RigidTransform.identity() if start is None else start
        widest = _WIDEST_MM
        reach, least = widest, _TUKEY * max(noise_mm, 2e-3)
        for _ in range(_ROUNDS):
            placed = transform.apply(points)
            residual, outward, facing = self._residuals(placed, transform.rotate(normals))
            weights = _tukey(residual, reach) * facing
            centre = placed.mean(axis=0)
            jacobian = np.concatenate([row_cross(placed - centre, outward), outward], axis=1)
            step = _solve(jacobian, residual, weights)
            turn = RigidTransform.from_vector(step[:3], np.zeros(3))
            about = RigidTransform(turn.rotation, centre - turn.apply(centre) + step[3:])
            transform = about @ transform
            size = float(np.linalg.norm(step[3:]) + 4.0 * np.linalg.norm(step[:3]))
            if reach <= least and size < _SETTLED_MM:
                break
            reach = max(least, 0.7 * reach) if size < 0.25 * reach else reach
        placed = transform.apply(points)
        residual, outward, facing = self._residuals(placed, transform.rotate(normals))
        centre = placed.mean(axis=0)
        jacobian = np.concatenate([row_cross(placed - centre, outward), outward], axis=1)
        return PartFit(transform, residual, _tukey(residual, least) * facing, jacobian, centre)

    def _residuals(self, placed: Array, normals: Array) -> tuple[Array, Array, Array]:
        """Signed distances (n,) from the before surface, its normals there (n, 3) and whether the sides agree (n,)."""
        feet = self._walk.feet(placed, np.asarray(self._tree.query(placed)[1], np.int64))
        outward = np.einsum("nc,ncd->nd", feet.weights, self._normals[self._mesh.triangles[feet.triangles]])
        outward /= np.maximum(np.sqrt(row_dot(outward, outward)), 1e-12)[:, None]
        facing = row_dot(outward, normals) > _MOST_TURNED
        return row_dot(placed - feet.points, outward), outward, facing.astype(np.float64)


def _tukey(residual: Array, reach: float) -> Array:
    inside = np.clip(1 - (residual / reach) ** 2, 0.0, None)
    return np.asarray(inside * inside)


def _solve(jacobian: Array, residual: Array, weights: Array) -> Array:
    """The step (6,) that takes the weighted residuals away; directions that nothing holds stay where they are."""
    weighted = jacobian * weights[:, None]
    normal = weighted.T @ jacobian
    damping = 1e-6 * np.trace(normal) / 6 * np.eye(6) + 1e-12 * np.eye(6)
    return np.asarray(np.linalg.solve(normal + damping, -weighted.T @ residual))
