"""The data term of phase two: a smoothing spline on the mesh.

Unknown is one displacement u along the normal of every vertex.  It minimises

    sum_i w_i ((A u)_i - d_i)^2 / density  +  integral h^4 (laplace u - (curvature of the surface - target))^2

where d_i is the distance of observation i from the surface and A ties it to the vertices (``association``), and the target
is the surface's own curvature, smoothed over the bandwidth h: what is penalised is not curvature but its unevenness, so that
a sphere is not flattened.  An observation's share in the result reaches about h far; h varies over the surface (``bandwidth``
chooses it).  The weight of an observation is its number of measurements over its relative variance along the normal, times
its robust weight.  Where no point supports the surface there is neither a penalty nor a pull; that part is left to the cap.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.reconstruction.association import associate
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients
from scanner_core.reconstruction.discrete_surface import DiscreteSurface
from scanner_core.reconstruction.observations import Observations
from scanner_core.reconstruction.support import FITTED, density_share

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_LAGS = 2

_REJECTED_BEYOND = 3.0
"""Residuals count for the noise with so many sigma at most: places that the surface has not reached must not speak for it."""


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


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A part of a surface that is fitted while the rest stays.

    Attributes
    ----------
    movable : (v,) bool, which vertices of the part may move; not those at its rim
    density : weight of the observations over the area of the whole surface, the density that bandwidths refer to
    """

    movable: Mask
    density: float


class SmoothingSpline:
    """The spline for one mesh, one set of observations and one set of robust weights.

    Parameters
    ----------
    robust : (n,) from 0 (ignored) to 1
    spacing_mm : (n,) side of the square that each observation stands for
    noise_mm : sigma of a typical observation along the normal, as far as it is known
    check : raises when the caller asked to stop
    share : (v,) the share of the density, if it is known
    part : what must be known of the whole when `mesh` is a part of it, with `share`

    Attributes
    ----------
    share : (v,) density of the observations over the one that they have among themselves
    supported : (v,) bool, where the surface is fitted
    """

    def __init__(
        self,
        mesh: TriangleMesh,
        observations: Observations,
        robust: Array,
        spacing_mm: Array,
        noise_mm: float,
        check: Callable[[], None],
        share: Array | None = None,
        part: Part | None = None,
    ) -> None:
        self.surface = surface = DiscreteSurface(mesh, check)
        self.mesh = mesh
        self.noise_mm = noise_mm
        self._check = check
        self.normals, self.area, self.stiffness, self.curvature = surface.normals, surface.area, surface.stiffness, surface.curvature
        self.association = associate(surface, observations, noise_mm, softly=part is None)  # what is fitted in parts has feet
        check()
        self.observations = observations
        self.variance = observations.relative_variance(self.association.normals)
        self.robust = robust
        self.weights = robust * observations.counts / self.variance
        interpolation = self.association.interpolation
        if share is None:
            share = density_share(surface, interpolation, robust, spacing_mm)
        self.share = share
        self.supported = share > FITTED
        scanned = max(float(self.area[self.supported].sum()), 1e-12)
        self.density = float(self.weights.sum()) / scanned if part is None else part.density
        self.spacing_mm = float(np.sqrt(scanned / max(float((robust * observations.counts).sum()), 1e-12)))
        self._interpolation = interpolation
        self._pull = interpolation.multiply((self.weights / self.density)[:, None]).T.tocsr()
        # Under a soft association the product of both is wide: it pays for many solves, for a few it is applied in two steps.
        self._gram: sparse.csr_array | None = None
        if not self.association.soft:
            self.prepare_for_many()
        self._gram_diagonal = np.asarray(interpolation.power(2).T @ (self.weights / self.density))
        self._mass = np.asarray(self._pull.sum(axis=1))
        self._squared = self.stiffness.power(2)
        self._inner = _away_from(mesh, ~self.supported)
        self._free = _away_from(mesh, ~self.supported, rings=1)  # the bend at the rim of a cap is no bend of the object
        self._anchor = np.where(self.supported, 1e-6, 1e-2) * self.area
        self._movable = np.ones((len(self.area), 1), np.float32) if part is None else part.movable.astype(np.float32)[:, None]

    def prepare_for_many(self) -> None:
        """Spend time once that many solves save."""
        if self._gram is None:
            self._gram = (self._pull @ self._interpolation).tocsr().astype(np.float32)

    @property
    def distances_mm(self) -> Array:
        """(n,) of the observations from the surface, + outside."""
        return self.association.distances_mm

    def at_observations(self, values: Array) -> Array:
        """Values at the vertices (v,) or (v, k), seen from the observations."""
        return np.asarray(self._interpolation @ values)

    def _smoothed_curvature(self, curvature: Array, bandwidth_mm: Array, start: Array | None = None) -> Array:
        """Curvatures (v, k) smoothed twice over the bandwidth (v,).

        Only the measured part speaks: the bend where it meets the cap would be taken for the object's own.
        """
        if np.all(self._inner):
            once = self.surface.diffused(curvature, bandwidth_mm, start=start)
            return self.surface.diffused(once, bandwidth_mm, start=once)
        measured = np.where(self._inner, 1.0, 1e-6)[:, None]
        both = np.concatenate([measured * curvature, measured], axis=1)
        for _ in range(2):
            both = self.surface.diffused(both, bandwidth_mm)
        return np.asarray(both[:, :-1] / np.maximum(both[:, -1:], 1e-12), np.float64)

    def solve(
        self,
        bandwidth_mm: Array,
        pulls: Array,
        curvature: Array,
        *,
        tolerance: float = 1e-3,
        majorized: bool = False,
        smoothed: Array | None = None,
    ) -> Array:
        """Displacements (v, k) for distances `pulls` (n, k) from a surface with the sums of principal curvatures `curvature` (v, k).

        The target depends on the answer: the curvature that is smoothed is that of the displaced surface.  It is found by
        two rounds of lagging behind (each leaves an eighth of the error at most).  `smoothed` is the first target, if it is known.
        """
        rows = np.where(self._free, bandwidth_mm**4 / self.area, 0.0)
        mass = (self._mass if majorized else self._gram_diagonal)[:, None]
        diagonal = mass[:, 0] + self._squared @ rows + self._anchor
        stiffness, area, stiff = self.stiffness, self.area[:, None], (rows * self.area)[:, None]
        apply = self._operator(rows, majorized)
        pulled = self._pull @ pulls
        answer: Array = np.zeros_like(pulled)
        target = self._smoothed_curvature(curvature, bandwidth_mm) if smoothed is None else smoothed
        for lag in range(_LAGS):
            if lag:
                target = self._smoothed_curvature(curvature + stiffness @ answer / area, bandwidth_mm, target)
            right = self._movable * (pulled - stiffness @ (stiff * (curvature - target))).astype(np.float32)
            answer = conjugate_gradients(apply, diagonal, right, answer, tolerance=tolerance, most=600, check=self._check).astype(np.float64)
        return answer

    def _operator(self, rows: Array, majorized: bool) -> Callable[[NDArray[np.floating]], NDArray[np.floating]]:
        """The left side of the normal equations, in single precision."""
        bend, anchor, mass = (x.astype(np.float32)[:, None] for x in (rows, self._anchor, self._mass))
        stiffness, gram, pull, interpolation = self.surface.single, self._gram, self._pull, self._interpolation
        movable = self._movable

        def apply(x: NDArray[np.floating]) -> NDArray[np.floating]:
            if majorized:
                data = mass * x
            elif gram is not None:
                data = gram @ x
            else:
                data = (pull @ (interpolation @ x)).astype(np.float32)
            return np.asarray(movable * (data + stiffness @ (bend * (stiffness @ x)) + anchor * x))

        return apply

    def step(self, bandwidth_mm: Array, *, tolerance: float = 1e-3) -> SplineStep:
        """One displacement towards the observations."""
        curvature = self.curvature[:, None]
        smoothed = self._smoothed_curvature(curvature, bandwidth_mm)
        pulls = self._without_curvature_bias(smoothed[:, 0])
        soft = self.association.soft
        moved = self.solve(bandwidth_mm, pulls[:, None], curvature, tolerance=tolerance, majorized=soft, smoothed=smoothed)[:, 0]
        return SplineStep(moved, pulls - self.at_observations(moved))

    def _without_curvature_bias(self, curvature: Array) -> Array:
        """Distances (n,) without the mean offset that noise causes on a surface with these sums of principal curvatures (v,)."""
        if self.association.soft:
            return self.distances_mm  # the probabilities know it already
        # Isotropic noise of sigma moves a point along the curved surface too: sigma^2 times the mean curvature.
        steepest = 1 / max(2 * self.noise_mm, 1e-9)
        across = self.observations.tangential_variance(self.association.normals)
        return np.asarray(self.distances_mm - 0.5 * self.noise_mm**2 * across * self.at_observations(np.clip(curvature, -steepest, steepest)))

    def squares(self, residuals_mm: Array) -> Array:
        """Squared residuals (n,) of single measurements in units of a typical one's variance, bounded; mm^2."""
        variance = self.variance / self.observations.counts
        typical = 1.4826 * float(np.median(np.abs(residuals_mm) / np.sqrt(variance)))
        bounded = np.minimum(np.abs(residuals_mm), _REJECTED_BEYOND * typical * np.sqrt(variance))
        within = self.association.spread_mm2 + self.observations.scatter_along(self.association.normals)
        return np.asarray((bounded**2 + within) / self.variance)

    def noise(self, residuals_mm: Array, freedom: float) -> float:
        """Sigma of a typical measurement, mm, from residuals (n,) of a fit with so many degrees of freedom."""
        counts = self.robust * self.observations.counts
        left = max(float(counts.sum()) - freedom, 0.02 * float(counts.sum()))
        return float(np.sqrt((counts * self.squares(residuals_mm)).sum() / left))


def grown(mesh: TriangleMesh, mask: Mask, rings: int) -> Mask:
    """The vertices of a mask (v,) and so many rings around them, (v,)."""
    for _ in range(rings):
        wide = mask.copy()
        wide[mesh.triangles[mask[mesh.triangles].any(axis=1)]] = True
        mask = wide
    return mask


def _away_from(mesh: TriangleMesh, forbidden: Mask, rings: int = 2) -> Mask:
    """Which vertices are more than some rings away from the forbidden ones, (v,); all of them when none is left."""
    touched = grown(mesh, forbidden, rings)
    return ~touched if not np.all(touched) else np.ones(len(forbidden), bool)
