"""The last step of a part's fit: both surfaces against each other, over all of the part that one rigid motion explains."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from scanner_core.comparison.part_fit import PartFit
from scanner_core.comparison.part_normals import PartNormals
from scanner_core.geometry.edges import EdgeTable, row_cross, row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import Feet, SurfaceWalk
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]
_ROUNDS, _SETTLED_MM = 8, 5e-4
_SETTLES_MM = 0.5
_NEIGHBOURS_MM = 0.6
"""Residuals are judged by their mean over so far: what does not move along is off as a patch, noise is off as single points."""
_SIGMAS = 3.0
_BENT_MM = 0.01
"""Mean residual that is never held against a place: surfaces of other triangles differ by as much."""
_LEAST_COSINE = 0.5
_MOST_ROWS = 500
"""As many equations are solved together where noise is correlated; it makes more of them say little more."""
_DISTRUST = 0.4
"""Share of the variance of correlated noise that is weighed as if it were not: to lean on likeness wholly would turn what is bent by
some micrometres into motion.  The covariance is exact for any share."""
_MOST_SLOPES = 0.8
"""Share of an information that the noise's slopes may make up at most."""
_LEAST_ROWS = 30


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """Equations ``residual + jacobian @ (rotation about centre, translation) = noise`` of n points.

    Attributes
    ----------
    points : (n, 3) mm, frame of BEFORE
    residual : (n,) mm, + where the after surface lies outside
    jacobian : (n, 6)
    own : (n,) vertex that the row is of, and (n, 3) `corners` opposite to it with their `shares` (n, 3)
    forward : (n,) whether `own` counts on the after surface and `corners` on the before surface, or the other way round
    centre : (3,) mm
    """

    points: Array
    residual: Array
    jacobian: Array
    own: Indices
    corners: Indices
    shares: Array
    forward: Mask
    centre: Array


class PartRefinement:
    """Refines motions of parts of one aligned after surface; what does not depend on the part is made once."""

    def __init__(self, before: TriangleMesh, after: TriangleMesh) -> None:
        self._sides = _Side(before), _Side(after)

    def refine(self, fit: PartFit, part: Mask, noise_mm: float, correlation_mm: float) -> PartFit:
        """The fit of vertices `part` (v_after,), from one that is right to a few times the noise, with its covariance.

        In turn the motion is fitted and the places are chosen that it explains: those where the mean residual is within the noise and
        what the motion's own uncertainty does there.  White noise is that of the vertices of both surfaces, least squares with exact
        propagation; noise that is alike over a length, ``exp(-h^2 / l^2)``, is weighed by its inverse covariance (Aitken 1936).
        Where too little is left the fit comes back as it was.
        """
        before, after = self._sides
        length_mm = float(np.sqrt(max(correlation_mm**2 - (before.area_mm2 + after.area_mm2) / np.pi, 0.0)))
        covariance = _covariance_of(fit, noise_mm)
        transform, centre = fit.transform, fit.centre
        near = self._opposite(transform, part)
        for turn in range(_ROUNDS):
            rows = self._rows(transform, part, near, noise_mm)
            kept = _explained(rows, _about(covariance, centre, rows.centre), noise_mm, length_mm)
            if kept.sum() < _LEAST_ROWS:
                return fit
            chosen = _chosen(rows, kept)
            if length_mm > before.edge_mm:
                step, covariance = _generalized(chosen, noise_mm, length_mm)
            else:
                step, covariance = _least_squares(chosen, noise_mm)
            centre = rows.centre
            spin = RigidTransform.from_vector(step[:3], np.zeros(3))
            transform = RigidTransform(spin.rotation, rows.centre - spin.apply(rows.centre) + step[3:]) @ transform
            if turn > 1 and np.linalg.norm(step[3:]) + 4 * np.linalg.norm(step[:3]) < _SETTLED_MM:
                break
        rows = self._rows(transform, part, near, noise_mm)
        kept = _explained(rows, _about(covariance, centre, rows.centre), noise_mm, length_mm)
        covariance = _about(covariance, centre, rows.centre)
        return PartFit(transform, rows.residual, kept.astype(np.float64), rows.jacobian, rows.centre, covariance)

    def _opposite(self, transform: RigidTransform, part: Mask) -> Indices:
        """Vertices of the before surface that may lie opposite to a part wherever it settles."""
        before, after = self._sides
        away = cKDTree(transform.apply(after.mesh.vertices[part])).query(before.mesh.vertices, distance_upper_bound=after.edge_mm + _SETTLES_MM)[0]
        return np.flatnonzero(np.isfinite(away))

    def _rows(self, transform: RigidTransform, part: Mask, near: Indices, noise_mm: float) -> _Rows:
        before, after = self._sides
        own = np.flatnonzero(part)
        placed = transform.apply(after.mesh.vertices[own])
        feet, opposite, good = before.feet(placed, noise_mm)
        normals = _half_way(transform.rotate(after.normals(noise_mm)[own]), opposite)
        good &= row_dot(opposite, normals) > np.sqrt(0.5 + 0.5 * _LEAST_COSINE)
        centre = placed.mean(axis=0)
        forward = _rows_of(placed, placed - feet.points, normals, own, before.mesh.triangles[feet.triangles], feet.weights, True, centre)
        forward = _chosen(forward, good)

        feet, opposite, good = after.feet(transform.inverse().apply(before.mesh.vertices[near]), noise_mm)
        corners = after.mesh.triangles[feet.triangles]
        here = before.normals(noise_mm)[near]
        normals = _half_way(transform.rotate(opposite), here)
        good &= part[corners].all(axis=1) & (row_dot(here, normals) > np.sqrt(0.5 + 0.5 * _LEAST_COSINE))
        points = before.mesh.vertices[near]
        ways = transform.apply(feet.points) - points
        return _both(forward, _chosen(_rows_of(points, ways, normals, near, corners, feet.weights, False, centre), good))


class _Side:
    """One of the two surfaces."""

    def __init__(self, mesh: TriangleMesh) -> None:
        table = EdgeTable.of(mesh.triangles)
        self.mesh, self.normals = mesh, PartNormals(mesh, table)
        self.edge_mm = float(np.sqrt(np.mean(table.lengths(mesh.vertices) ** 2)))
        self.area_mm2 = mesh.area() / len(mesh.vertices)
        self._walk, self._tree = SurfaceWalk(mesh, table), cKDTree(mesh.vertices)
        alone = np.bincount(table.side_edges.ravel(), minlength=len(table.edges)) == 1
        self._border_side = alone[table.side_edges.ravel()]

    def feet(self, points: Array, noise_mm: float) -> tuple[Feet, Array, Mask]:
        """Feet of points (n, 3), unit normals there (n, 3), and which do not lie on a border (n,)."""
        feet = self._walk.feet(points, np.asarray(self._tree.query(points)[1], np.int64))
        there = np.einsum("nc,ncd->nd", feet.weights, self.normals(noise_mm)[self.mesh.triangles[feet.triangles]])
        there /= np.maximum(np.sqrt(row_dot(there, there)), 1e-12)[:, None]
        # side i runs from corner i to i + 1: a foot lies on it where the third weight is nothing
        on_border = np.any(self._border_side[3 * feet.triangles[:, None] + np.arange(3)] & (feet.weights[:, (2, 0, 1)] < 1e-9), axis=1)
        return feet, there, ~on_border


def _half_way(one: Array, other: Array) -> Array:
    mean = one + other
    return np.asarray(mean / np.maximum(np.sqrt(row_dot(mean, mean)), 1e-12)[:, None])


def _rows_of(points: Array, ways: Array, normals: Array, own: Indices, corners: Indices, shares: Array, forward: bool, centre: Array) -> _Rows:
    jacobian = np.concatenate([row_cross(points - centre, normals), normals], axis=1)
    return _Rows(points, row_dot(ways, normals), jacobian, own, corners, shares, np.full(len(points), forward), centre)


def _chosen(rows: _Rows, kept: Mask) -> _Rows:
    return _Rows(
        rows.points[kept],
        rows.residual[kept],
        rows.jacobian[kept],
        rows.own[kept],
        rows.corners[kept],
        rows.shares[kept],
        rows.forward[kept],
        rows.centre,
    )


def _both(one: _Rows, other: _Rows) -> _Rows:
    return _Rows(
        np.concatenate([one.points, other.points]),
        np.concatenate([one.residual, other.residual]),
        np.concatenate([one.jacobian, other.jacobian]),
        np.concatenate([one.own, other.own]),
        np.concatenate([one.corners, other.corners]),
        np.concatenate([one.shares, other.shares]),
        np.concatenate([one.forward, other.forward]),
        one.centre,
    )


def _covariance_of(fit: PartFit, noise_mm: float) -> Array:
    information = (fit.jacobian * fit.weights[:, None]).T @ fit.jacobian
    return np.asarray(noise_mm**2 * np.linalg.pinv(information, rcond=1e-9, hermitian=True))


def _about(covariance: Array, centre: Array, other: Array) -> Array:
    """A motion's covariance (6, 6) with its rotation taken about another place (3,)."""
    arm = other - centre
    moving = np.eye(6)
    moving[3:, :3] = -np.array([[0.0, -arm[2], arm[1]], [arm[2], 0.0, -arm[0]], [-arm[1], arm[0], 0.0]])
    return np.asarray(moving @ covariance @ moving.T)


def _explained(rows: _Rows, covariance: Array, noise_mm: float, length_mm: float) -> Mask:
    """(n,) where the mean residual about a point is within the noise and the motion's uncertainty."""
    if not len(rows.points):
        return np.zeros(0, np.bool_)
    pairs = cKDTree(rows.points).query_pairs(_NEIGHBOURS_MM, output_type="ndarray")
    count = np.ones(len(rows.points))
    total = rows.residual.copy()
    for one, other in ((pairs[:, 0], pairs[:, 1]), (pairs[:, 1], pairs[:, 0])):
        count += np.bincount(one, minlength=len(count))
        total += np.bincount(one, rows.residual[other], minlength=len(count))
    alike = min(1.0, (length_mm / _NEIGHBOURS_MM) ** 2)
    variance = noise_mm**2 * (alike + (1 - alike) * 2 / count) + np.einsum("ni,ij,nj->n", rows.jacobian, covariance, rows.jacobian)
    return np.asarray(np.abs(total / count) < _SIGMAS * np.sqrt(variance) + _BENT_MM)


def _least_squares(rows: _Rows, noise_mm: float) -> tuple[Array, Array]:
    """Step (6,) and its covariance (6, 6) where every vertex of both surfaces has its own noise."""
    inverse = np.linalg.pinv(rows.jacobian.T @ rows.jacobian, rcond=1e-9, hermitian=True)
    of_row = 1 + (rows.shares**2).sum(axis=1)
    variance = max(noise_mm**2, float(np.mean(rows.residual**2))) / float(of_row.mean())
    scatter = np.zeros((6, 6))
    for side in (rows.forward, ~rows.forward):  # a vertex's noise enters by its own row and, the other way, where it is a corner
        own, across = rows.jacobian[side], rows.jacobian[~side]
        index = np.concatenate([rows.own[side], rows.corners[~side].ravel()])
        pull = np.concatenate([own, (rows.shares[~side][:, :, None] * across[:, None, :]).reshape(-1, 6)])
        vertex, place = np.unique(index, return_inverse=True)
        total = np.stack([np.bincount(place, pull[:, i], minlength=len(vertex)) for i in range(6)], axis=1)
        scatter += variance * total.T @ total
    return -inverse @ (rows.jacobian.T @ rows.residual), inverse @ scatter @ inverse


def _generalized(rows: _Rows, noise_mm: float, length_mm: float) -> tuple[Array, Array]:
    """Step (6,) and its covariance (6, 6) where the noise of neighbours is alike.

    Correlated noise has slopes, of standard deviation n / l along each direction of the surface: they look like shape that would hold
    the part, and the estimate follows them.  The covariance is that of an M-estimator, ``H^-1 S H^-1`` with the information H of
    the shape alone.
    """
    some = np.random.default_rng(0).permutation(len(rows.points))[:_MOST_ROWS]
    points, jacobian, residual = rows.points[some], rows.jacobian[some], rows.residual[some]
    alike = np.exp(-cdist(points, points, "sqeuclidean") / length_mm**2)
    trusted = (1 - _DISTRUST) * alike
    trusted[np.diag_indices_from(trusted)] = 1.0
    inverse = cho_solve(cho_factor(trusted, lower=True, overwrite_a=True, check_finite=False), np.eye(len(some)), check_finite=False)
    weighed = inverse @ jacobian
    information = jacobian.T @ weighed
    step = -np.linalg.pinv(information, rcond=1e-12, hermitian=True) @ (weighed.T @ residual)
    variance = max(noise_mm**2, float(np.mean((residual + jacobian @ step) ** 2)))
    slopes = np.zeros((6, 6))
    normals, about = jacobian[:, 3:], points - rows.centre
    for axis in np.eye(3):
        tilt = axis - normals * (normals @ axis)[:, None]
        pull = np.concatenate([row_cross(about, tilt), tilt], axis=1)
        slopes += 0.5 * variance / length_mm**2 * pull.T @ ((inverse * alike) @ pull)
    sharp = np.linalg.pinv(_less(information, slopes), rcond=1e-12, hermitian=True)
    return step, variance * sharp @ (weighed.T @ alike @ weighed) @ sharp


def _less(information: Array, slopes: Array) -> Array:
    """What of an information (6, 6) is not that of the noise's slopes; a part of it always is left."""
    root = np.linalg.cholesky(information + 1e-12 * np.trace(information) * np.eye(6))
    whitened = np.linalg.solve(root, np.linalg.solve(root, slopes).T)
    values, vectors = np.linalg.eigh(0.5 * (whitened + whitened.T))
    kept = 1 - np.minimum(values, _MOST_SLOPES)
    return np.asarray(root @ (vectors * kept) @ vectors.T @ root.T)
