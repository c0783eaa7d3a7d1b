"""Rigid fit of a part of the after surface onto the before surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.part_normals import PartNormals
from scanner_core.geometry.edges import EdgeTable, row_cross, row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import SurfaceWalk
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
_WIDEST_MM, _TUKEY = 1.5, 4.685
"""The robust weight's reach in the first round, and in the last in units of the noise (95 % efficient)."""
_SHRINK = 0.6
_ROUNDS, _ROUNDS_TRIED, _LAST_ROUNDS = 25, 12, 8
OFF_MM = 0.2
"""Residual above which a point did not go along with its part."""
_LOST = 0.3
"""Share of such points above which a fit is tried from elsewhere."""
_BESIDE_MM = 1.2
_SHIFT_FIRST_MM = 0.6
"""Reach above which a step may not turn the part: from a tooth's width away, a crown would rather turn than shift."""
_MEAN_OF_NORMAL = 0.8
"""Mean magnitude of a normal error over its standard deviation."""
_SUSPICIOUS = 1.3
"""Mean residual over what the noise explains, above which turns are tried: a crown is nearly round, and slips."""
_TURNS_DEG = (-18.0, -9.0, 9.0, 18.0)
_TURNED_REACH_MM = 0.4
_SEARCH_POINTS, _TRIED_POINTS = 300, 150
_SEARCHED_MM, _SETTLED_MM = 2e-3, 5e-5
_ASK_AGAIN_MM = 0.3
"""After a step as long the nearest vertices are looked up again; after shorter ones the walk begins at the last feet."""
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
    covariance : (6, 6) of rotation (rad, about `centre`) and translation (mm), where the fit knows better than by its points' number
    """

    transform: RigidTransform
    residual_mm: Array
    weights: Array
    jacobian: Array
    centre: Array
    covariance: Array | None = None

    def off(self) -> float:
        """Share of the points that did not go along."""
        return float((np.abs(self.residual_mm) > OFF_MM).mean())


class PartFitter:
    """Fits parts onto one before surface; made once, used for every part."""

    def __init__(self, before: TriangleMesh) -> None:
        table = EdgeTable.of(before.triangles)
        self._mesh = before
        self._walk = SurfaceWalk(before, table)
        self._tree = cKDTree(before.vertices)
        self._normals = PartNormals(before, table)

    def fit(self, points: Array, normals: Array, noise_mm: float, start: RigidTransform | None = None) -> PartFit:
        """Iteratively reweighted point-to-plane fit of points (n, 3) mm with unit normals (n, 3).

        The weights are Tukey's.  Their reach shrinks from where everything counts to a few times the noise, so that what does not
        move with the part, such as the gum, falls out of the fit.  Where too much falls out, the fit begins again from places
        beside the first one, and the best is taken: a crown may have been caught by the flank of its neighbour.  A part of the points
        is enough to search with; all of them have their say in the last rounds.
        """
        some = slice(None, None, max(1, -(-len(points) // _SEARCH_POINTS)))
        first = self._from(points[some], normals[some], noise_mm, RigidTransform.identity() if start is None else start)
        best = first.transform
        if _loss(first) > _SUSPICIOUS * _MEAN_OF_NORMAL * noise_mm:
            best = self._elsewhere(points, normals, noise_mm, first)
        return self._from(points, normals, noise_mm, best, _TUKEY * noise_mm, _LAST_ROUNDS, _SETTLED_MM)

    def _elsewhere(self, points: Array, normals: Array, noise_mm: float, first: PartFit) -> RigidTransform:
        """The best of a first fit and of those that begin turned, or beside it where it is lost."""
        some = slice(None, None, max(1, -(-len(points) // _TRIED_POINTS)))
        centre = points.mean(axis=0)
        axes = np.linalg.eigh((points - centre).T @ (points - centre))[1].T
        best, least = first.transform, _loss(first)
        trials = [(first.transform @ _turn(axis * np.radians(angle), centre), _TURNED_REACH_MM) for axis in axes[:1] for angle in _TURNS_DEG]
        if first.off() > _LOST:
            trials += [(RigidTransform(np.eye(3), step), _WIDEST_MM) for step in np.concatenate([axes, -axes]) * _BESIDE_MM]
        for begin, reach in trials:
            tried = self._from(points[some], normals[some], noise_mm, begin, reach, _ROUNDS_TRIED)
            if (loss := _loss(tried)) < 0.95 * least:
                best, least = tried.transform, loss
        return best

    def _from(
        self,
        points: Array,
        normals: Array,
        noise_mm: float,
        transform: RigidTransform,
        reach: float = _WIDEST_MM,
        rounds: int = _ROUNDS,
        settled_mm: float = _SEARCHED_MM,
    ) -> PartFit:
        least = _TUKEY * max(noise_mm, 2e-3)
        outward = self._normals(noise_mm)
        placed = transform.apply(points)
        nearest = np.asarray(self._tree.query(placed)[1], np.int64)
        for _ in range(rounds):
            residual, jacobian, facing, centre, nearest = self._linear(placed, transform.rotate(normals), outward, nearest)
            step = _solve(jacobian, residual, _tukey(residual, reach) * facing, turning=reach <= _SHIFT_FIRST_MM)
            turn = RigidTransform.from_vector(step[:3], np.zeros(3))
            transform = RigidTransform(turn.rotation, centre - turn.apply(centre) + step[3:]) @ transform
            placed = transform.apply(points)
            size = float(np.linalg.norm(step[3:]) + 4.0 * np.linalg.norm(step[:3]))
            if reach <= least and size < settled_mm:
                break
            if size > _ASK_AGAIN_MM:
                nearest = np.asarray(self._tree.query(placed)[1], np.int64)
            reach = max(least, _SHRINK * reach) if size < 0.25 * reach else reach
        residual, jacobian, facing, centre, _ = self._linear(placed, transform.rotate(normals), outward, nearest)
        return PartFit(transform, residual, _tukey(residual, least) * facing, jacobian, centre)

    def distances_mm(self, points: Array, transform: RigidTransform) -> Array:
        """How far from the before surface points (n, 3) lie after a motion, (n,)."""
        placed = transform.apply(points)
        return np.asarray(self._walk.feet(placed, np.asarray(self._tree.query(placed)[1], np.int64)).distances_mm)

    def mean_square_mm2(self, points: Array, transform: RigidTransform, most_mm: float) -> float:
        """How badly a motion explains points (n, 3): the mean square of their distances, none of which counts more than `most_mm`."""
        return float((np.minimum(self.distances_mm(points, transform), most_mm) ** 2).mean())

    def _linear(self, placed: Array, normals: Array, outward: Array, nearest: Indices) -> tuple[Array, Array, Array, Array, Indices]:
        """Of placed points (n, 3) with normals (n, 3), each sought from a vertex `nearest` (n,) of the before surface, facing `outward` (v, 3).

        Signed distances (n,), their jacobian (n, 6) about the centre (3,) of the points, whether the sides agree (n,), that centre, and
        where to seek next (n,).
        """
        feet = self._walk.feet(placed, nearest)
        there = np.einsum("nc,ncd->nd", feet.weights, outward[self._mesh.triangles[feet.triangles]])
        there /= np.maximum(np.sqrt(row_dot(there, there)), 1e-12)[:, None]
        facing = (row_dot(there, normals) > _MOST_TURNED).astype(np.float64)
        centre = placed.mean(axis=0)
        jacobian = np.concatenate([row_cross(placed - centre, there), there], axis=1)
        return row_dot(placed - feet.points, there), jacobian, facing, centre, feet.vertices


def _turn(rotation_vector: Array, centre: Array) -> RigidTransform:
    """A rotation about a place (3,)."""
    turn = RigidTransform.from_vector(rotation_vector, np.zeros(3))
    return RigidTransform(turn.rotation, centre - turn.apply(centre))


def _loss(fit: PartFit) -> float:
    """Mean capped residual: what is far off counts, how far does not."""
    return float(np.minimum(np.abs(fit.residual_mm), 2 * OFF_MM).mean())


def _tukey(residual: Array, reach: float) -> Array:
    inside = np.clip(1 - (residual / reach) ** 2, 0.0, None)
    return np.asarray(inside * inside)


def _solve(jacobian: Array, residual: Array, weights: Array, turning: bool) -> Array:
    """The step (6,) that takes the weighted residuals away; directions that nothing holds stay where they are.

    Without `turning` it is a translation.
    """
    if not turning:
        step = np.zeros(6)
        step[3:] = _solve_any(jacobian[:, 3:], residual, weights)
        return step
    return _solve_any(jacobian, residual, weights)


def _solve_any(jacobian: Array, residual: Array, weights: Array) -> Array:
    weighted = jacobian * weights[:, None]
    normal = weighted.T @ jacobian
    damping = (1e-6 * np.trace(normal) / len(normal) + 1e-12) * np.eye(len(normal))
    return np.asarray(np.linalg.solve(normal + damping, -weighted.T @ residual))
