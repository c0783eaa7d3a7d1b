"""The data term of phase two: a smoothing spline on the mesh.

Unknown is one displacement u along the normal of every vertex.  It minimises

    sum_i w_i ((A u)_i - r_i)^2 / density  +  h^4  integral (laplace u - (curvature of the surface - target))^2

where r_i is the distance of point i from the curved surface over its foot on the mesh, A interpolates u at the feet, and the target is the
surface's own curvature, smoothed over the bandwidth h: what is penalised is not curvature but its unevenness, so that a
sphere is not flattened.  A point's share in the result reaches about h far.  Where no point supports the surface there
is neither a penalty nor a pull; that part is left to the cap.

The bandwidth is chosen by generalized cross-validation (Craven and Wahba 1979), with the trace of the smoother estimated
from random signs (Hutchinson 1989).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import Feet, closest_near
from scanner_core.geometry.smoothing import cotangent_laplacian
from scanner_core.geometry.subdivision import side_lifts
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class SplineStep:
    """The answer of one linear solve.

    Attributes
    ----------
    displacement_mm : (v,) along the vertex normals
    residuals_mm : (n,) what the displaced surface leaves of the distances
    """

    displacement_mm: Array
    residuals_mm: Array


class SmoothingSpline:
    """The spline for one mesh, one set of points and one set of weights.

    Parameters
    ----------
    points : (n, 3), mm
    weights : (n,) from 0 (ignored) to 1
    supported : (v,) bool
    check : raises when the caller asked to stop
    """

    def __init__(self, mesh: TriangleMesh, points: Array, weights: Array, supported: NDArray[np.bool_], check: Callable[[], None]) -> None:
        self.mesh = mesh
        self.supported = supported
        self._check = check
        self.normals = mesh.vertex_normals()
        self.feet: Feet = closest_near(mesh, points)
        check()
        corners = mesh.triangles[self.feet.triangles]
        at_feet = np.einsum("nc,ncd->nd", self.feet.weights, self.normals[corners])
        at_feet /= np.maximum(np.linalg.norm(at_feet, axis=1), 1e-30)[:, None]
        # the vertices are on the surface and the facets are its chords: measure from the curved surface over the foot
        w = self.feet.weights
        over_foot = 4 * (w * w[:, (1, 2, 0)] * side_lifts(mesh, self.normals)[self.feet.triangles]).sum(axis=1)
        self.distances_mm = ((points - self.feet.points) * at_feet).sum(axis=1) - over_foot
        self.weights = weights
        count, vertices = len(points), len(mesh.vertices)
        offsets = np.arange(0, 3 * count + 1, 3)
        self.interpolation = sparse.csr_array((self.feet.weights.ravel(), corners.ravel(), offsets), shape=(count, vertices))
        check()
        self.stiffness, self.area = cotangent_laplacian(mesh)
        self.density = float(weights.sum()) / max(float(self.area[supported].sum()), 1e-12)
        weighted = sparse.diags_array(weights / self.density) @ self.interpolation
        self._gram = sparse.csr_array(self.interpolation.T @ weighted)
        self._squared = self.stiffness.power(2)
        self.curvature = (self.stiffness @ mesh.vertices * self.normals).sum(axis=1) / self.area
        self._inner = _away_from(mesh, ~supported)
        self._anchor = np.where(supported, 1e-6, 1e-2) * self.area

    def target_curvature(self, bandwidth_mm: float) -> Array:
        """The sum of the principal curvatures, smoothed twice over the bandwidth, (v,), 1/mm.

        Only the measured part speaks: the bend where it meets the cap would be taken for the object's own.
        """
        reach = bandwidth_mm**2
        measured = np.where(self._inner, 1.0, 1e-6)
        both = np.stack([measured * self.curvature, measured], axis=1)
        diagonal = self.area + reach * self.stiffness.diagonal()

        def apply(x: Array) -> Array:
            return np.asarray(self.area[:, None] * x + reach * (self.stiffness @ x))

        for _ in range(2):
            right = self.area[:, None] * both
            both = conjugate_gradients(apply, diagonal, right, both, tolerance=1e-3, most=200, check=self._check)
        return np.asarray(both[:, 0] / np.maximum(both[:, 1], 1e-12), np.float64)

    def solve(self, bandwidth_mm: float, pulls: Array, bend: Array | None, *, start: Array | None = None, tolerance: float = 1e-3) -> Array:
        """Displacements (v, k) for distances `pulls` (n, k) and a curvature `bend` (v,) beyond the target; mm."""
        stiff = bandwidth_mm**4
        rows = np.where(self.supported, stiff / self.area, 0.0)
        right = self.interpolation.T @ (self.weights[:, None] / self.density * pulls)
        if bend is not None:
            right = right - (self.stiffness @ (rows * self.area * bend))[:, None]
        diagonal = self._gram.diagonal() + self._squared @ rows + self._anchor

        def apply(x: Array) -> Array:
            return np.asarray(self._gram @ x + self.stiffness @ (rows[:, None] * (self.stiffness @ x)) + self._anchor[:, None] * x)

        begin = np.zeros_like(right) if start is None else start
        return conjugate_gradients(apply, diagonal, right, begin, tolerance=tolerance, most=600, check=self._check)

    def step(self, bandwidth_mm: float, noise_mm: float, *, tolerance: float = 1e-3) -> SplineStep:
        """One displacement towards the points, corrected for the curvature bias of noisy points."""
        target = self.target_curvature(bandwidth_mm)
        pulls = self.distances_mm - self.curvature_bias(target, noise_mm)
        moved = self.solve(bandwidth_mm, pulls[:, None], self.curvature - target, tolerance=tolerance)[:, 0]
        return SplineStep(moved, pulls - self.interpolation @ moved)

    def curvature_bias(self, target: Array, noise_mm: float) -> Array:
        """How far outside of the surface a noisy point lies on average, (n,), mm.

        Isotropic noise of sigma per axis moves a point along the curved surface too: sigma^2 times the mean curvature.
        """
        steepest = 1 / max(2 * noise_mm, 1e-9)
        return np.asarray(0.5 * noise_mm**2 * (self.interpolation @ np.clip(target, -steepest, steepest)))

    def degrees_of_freedom(self, bandwidth_mm: float, signs: Array) -> float:
        """Trace of the smoother, from random signs (n, k)."""
        answer = self.solve(bandwidth_mm, signs, None, tolerance=1e-2)
        back = signs * (self.interpolation @ answer) * self.weights[:, None]
        return float(back.sum() / signs.shape[1])

    def cross_validation(self, bandwidth_mm: float, noise_mm: float, signs: Array) -> tuple[float, float]:
        """Generalized cross-validation score (mm^2, lower is better) of a bandwidth, and the noise it implies, mm."""
        step = self.step(bandwidth_mm, noise_mm, tolerance=1e-2)
        freedom = self.degrees_of_freedom(bandwidth_mm, signs)
        total = float(self.weights.sum())
        # places that the surface has not reached yet must not speak for the noise
        typical = 1.4826 * float(np.median(np.abs(step.residuals_mm)))
        squares = float((self.weights * np.minimum(np.abs(step.residuals_mm), 3 * typical) ** 2).sum())
        left = max(total - freedom, 0.02 * total)
        return total * squares / left**2, float(np.sqrt(squares / left))


def _away_from(mesh: TriangleMesh, forbidden: NDArray[np.bool_], rings: int = 2) -> NDArray[np.bool_]:
    """Which vertices are more than some rings away from the forbidden ones, (v,); all of them when none is left."""
    touched = forbidden
    for _ in range(rings):
        wide = touched.copy()
        wide[mesh.triangles[touched[mesh.triangles].any(axis=1)]] = True
        touched = wide
    return ~touched if not np.all(touched) else np.ones(len(forbidden), bool)
