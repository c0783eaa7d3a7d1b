"""Least-squares fits to points: a sphere with its uncertainty, and the rigid motion between corresponding points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class SphereFit:
    """A sphere through measured points.

    Attributes
    ----------
    centre : (3,) mm, in the points' frame
    radius_mm : radius
    covariance : (4, 4) mm^2 of centre and radius, from the residuals' own scatter (k = 1)
    residuals_mm : (n,) signed distance of every point to the sphere, + outside
    """

    centre: Array
    radius_mm: float
    covariance: Array
    residuals_mm: Array

    @property
    def centre_uncertainty_mm(self) -> Array:
        """Standard uncertainty of the centre's coordinates, (3,) mm."""
        return np.asarray(np.sqrt(np.diag(self.covariance)[:3]), np.float64)

    @property
    def radius_uncertainty_mm(self) -> float:
        """Standard uncertainty of the radius, mm."""
        return float(np.sqrt(self.covariance[3, 3]))

    @property
    def rms_mm(self) -> float:
        """Form deviation: root mean square of the residuals, mm."""
        return float(np.sqrt(np.mean(self.residuals_mm**2)))


def fit_sphere(points: Array) -> SphereFit:
    """The sphere with the least sum of squared radial distances to points (n, 3), n >= 5, mm.

    Starts from the algebraic fit, which is biased inwards by noise, and refines the geometric distance by Gauss-Newton
    (Shakarji, "Least-squares fitting algorithms of the NIST algorithm testing system", J. Res. NIST 103, 1998).

    Raises
    ------
    UsageError
        E-USE-01 when the points are fewer than five or lie in one plane.
    """
    points = np.asarray(points, np.float64)
    if len(points) < 5:
        raise UsageError("E-USE-01", what=f"{len(points)} points make no sphere", do="measure more of it")
    origin = points.mean(axis=0)
    local = points - origin
    size = float(np.sqrt(np.mean(np.sum(local**2, axis=1))))
    system = np.c_[2 * local, np.full(len(local), size)]
    solution, _, _, singular = np.linalg.lstsq(system, np.sum(local**2, axis=1), rcond=None)
    if size == 0 or singular[-1] < 1e-9 * singular[0]:
        raise UsageError("E-USE-01", what="The points lie in one plane and make no sphere", do="measure more of it")
    centre = solution[:3]
    radius = float(np.sqrt(max(solution[3] * size + centre @ centre, 1e-12)))
    for _ in range(100):
        away = local - centre
        distance = np.linalg.norm(away, axis=1)
        jacobian = np.c_[away / np.maximum(distance, 1e-12)[:, None], np.ones(len(local))]
        step = np.linalg.lstsq(jacobian, distance - radius, rcond=None)[0]
        centre, radius = centre + step[:3], radius + float(step[3])
        if np.abs(step).max() < 1e-12 * max(radius, size):
            break
    residuals = np.linalg.norm(local - centre, axis=1) - radius
    variance = float(residuals @ residuals) / max(len(points) - 4, 1)
    return SphereFit(origin + centre, radius, variance * np.linalg.inv(jacobian.T @ jacobian), residuals)


def fit_rigid(source: Array, target: Array, weights: Array | None = None) -> RigidTransform:
    """The rigid motion that brings source (n, 3) mm closest to target (n, 3) mm, row by row; weights (n,) if given.

    Kabsch, "A solution for the best rotation to relate two sets of vectors", Acta Cryst. A32, 1976.
    """
    w = np.ones(len(source)) if weights is None else weights
    w = w / w.sum()
    from_centre, to_centre = w @ source, w @ target
    u, _, vt = np.linalg.svd(((source - from_centre) * w[:, None]).T @ (target - to_centre))
    rotation = vt.T @ np.diag([1.0, 1.0, np.linalg.det(vt.T @ u.T)]) @ u.T
    return RigidTransform(rotation, to_centre - rotation @ from_centre)
