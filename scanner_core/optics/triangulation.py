"""Points from pairs of centroids: weighted linear triangulation, its covariance, and the epipolar residual.

With ``x = P X`` (P the 3 x 4 projection to normalized coordinates) each centroid gives two equations linear in X,
``(x P3 - P1) X = 0`` and ``(y P3 - P2) X = 0`` (Hartley & Sturm, "Triangulation", CVIU 68, 1997).  Divided by the
point's depth and by the centroid's standard uncertainty their residuals are unit normal, so the 3 x 3 normal matrix of
the four equations gives the maximum-likelihood point for small noise, and its inverse is the point's covariance.  The
depths come from a first, closed-form intersection.  No singular value decomposition: same scatter, half the time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.camera_model import CameraModel

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Triangulated:
    """Points of n pairs of centroids.

    Attributes
    ----------
    points : (n, 3) mm, rig frame; NaN where the two rays do not meet in front of both cameras
    epipolar_residual_px : (n,) signed Sampson distance of the pair to the epipolar constraint; its standard deviation is
        that of one centroid coordinate.  Infinite where the point is NaN
    covariances : (n, 3, 3) mm^2, rig frame, propagated from the centroids' standard uncertainties
    """

    points: Array
    epipolar_residual_px: Array
    covariances: Array


@dataclass(frozen=True, slots=True)
class EpipolarGate:
    """Which pairs show the same spot.

    Attributes
    ----------
    sigmas : the limit in standard uncertainties of the residual
    floor_px : the limit is never below this: what a calibration may leave towards the image's border
    """

    sigmas: float = 3.0
    floor_px: float = 0.25

    def limit_px(self, left_sigma_px: Array, right_sigma_px: Array) -> Array:
        """Largest believable ``|epipolar_residual_px|`` of centroids with these standard uncertainties, (n,) or (n, 2) each."""
        pooled = np.sqrt(0.5 * (_mean_square(left_sigma_px) + _mean_square(right_sigma_px)))
        return np.asarray(np.maximum(self.sigmas * pooled, self.floor_px), np.float64)

    def accepts(self, residual_px: Array, left_sigma_px: Array, right_sigma_px: Array) -> NDArray[np.bool_]:
        """(n,) True where the pair passes; never for an infinite or undefined residual."""
        passed: NDArray[np.bool_] = np.abs(residual_px) <= self.limit_px(left_sigma_px, right_sigma_px)
        return passed


def _mean_square(sigma_px: Array) -> Array:
    square = np.square(sigma_px)
    return np.asarray(square if square.ndim == 1 else square.mean(axis=1), np.float64)


class StereoCameras(Protocol):
    """Whatever has two calibrated cameras: a whole calibration, or what is there before the turntable is known."""

    @property
    def left(self) -> CameraModel: ...

    @property
    def right(self) -> CameraModel: ...


class CameraPair(NamedTuple):
    """Two calibrated cameras and nothing else."""

    left: CameraModel
    right: CameraModel


class Triangulator:
    """Turns pairs of centroids into points of the rig frame; immutable, so threads may share it."""

    def __init__(self, cameras: StereoCameras) -> None:
        left, right = cameras.left, cameras.right
        self._left, self._right = left, right
        self._normal = _normal_factors(left.projection(), right.projection())
        self._focal = np.stack([np.diag(left.matrix)[:2], np.diag(right.matrix)[:2]])[:, :, None]
        # right = R left + t, whatever the rig frame is
        self._rotation = right.rotation @ left.rotation.T
        self._translation = right.translation - self._rotation @ left.translation
        x, y, z = self._translation
        essential = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]) @ self._rotation
        per_px = 1.0 / self._focal[:, :, 0]
        # what is linear in `_seen`, row by row: E x_left; the gradient of the epipolar form by the right and left pixel; the
        # third and the first two components of the left ray in the right camera; t_xy - x_right t_z
        self._linear = np.zeros((12, 5))
        self._linear[:3, _LEFT_RAY] = essential
        self._linear[3:5, _LEFT_RAY] = essential[:2] * per_px[1, :, None]
        self._linear[5:7, 2:4], self._linear[5:7, 4] = essential[:2, :2].T, essential[2, :2]
        self._linear[5:7] *= per_px[0, :, None]
        self._linear[7, _LEFT_RAY] = self._rotation[2]
        self._linear[8:10, _LEFT_RAY] = self._rotation[:2]
        self._linear[10:, 2:4], self._linear[10:, 4] = -z * np.eye(2), (x, y)

    def triangulate(self, left_px: Array, right_px: Array, left_sigma_px: Array, right_sigma_px: Array) -> Triangulated:
        """Points of pairs of centroids.

        Parameters
        ----------
        left_px, right_px : (n, 2) centroids, px
        left_sigma_px, right_sigma_px : standard uncertainties, px; (n, 2) of x and y, or (n,) of each of both

        Notes
        -----
        Distortion is removed from the centroids, but its local magnification (1 to 3 % with common lenses) is not
        applied to their uncertainties.
        """
        n = len(left_px)
        if n == 0:
            return Triangulated(np.empty((0, 3)), np.empty(0), np.empty((0, 3, 3)))
        seen = self._seen(left_px, right_px)
        scale = np.empty((2, 2, n))  # depth times standard uncertainty, by camera and coordinate
        scale[0], scale[1] = left_sigma_px.T, right_sigma_px.T

        with np.errstate(all="ignore"):  # rays that do not meet are answered by NaN below
            linear = self._linear.dot(seen)
            residual = _sampson(seen, linear)
            depth = self._depths(seen, linear)
            scale *= depth[:, None]
            np.divide(self._focal, scale, scale)
            weights = np.empty((3, 4, n))  # 1 over the variance of each of the four equations; times x, times x^2
            np.square(scale.reshape(4, n), weights[2])
            np.multiply(weights[2], seen[:4], weights[1])
            np.multiply(weights[1], seen[:4], weights[0])
            factors = self._normal.dot(weights.reshape(12, n)).reshape(5, 6, n)
            products = factors[:4:2] * factors[1:4:2]
            cofactors = products[0] - products[1]
            determinant = np.add.reduce(factors[4, :3] * cofactors[:3])
            cofactors /= determinant
            inverse = cofactors.take(_SYMMETRIC, axis=0)  # (3, 3, n)
            terms = inverse * factors[4, 3:]
            points = terms[:, 0] + terms[:, 1]
            points += terms[:, 2]
        # a sum is finite where all its terms are
        if not (np.minimum.reduce(depth, axis=None) > 0 and math.isfinite(np.add.reduce(points, axis=None))):
            lost = ~((depth > 0).all(axis=0) & np.isfinite(points).all(axis=0))
            points[:, lost], inverse[:, :, lost], residual[lost] = np.nan, np.nan, np.inf
        return Triangulated(np.ascontiguousarray(points.T), residual, np.ascontiguousarray(inverse.transpose(2, 0, 1)))

    def epipolar_residual(self, left_px: Array, right_px: Array) -> Array:
        """Signed Sampson distances (n,) px of pairs (n, 2) px to the epipolar constraint."""
        if not len(left_px):
            return np.empty(0)
        seen = self._seen(left_px, right_px)
        return _sampson(seen, self._linear.dot(seen))

    def epipolar_sigma(self, left_px: Array, right_px: Array, left_sigma_px: Array, right_sigma_px: Array) -> Array:
        """Standard deviations (n,) px of the epipolar residuals of pairs whose coordinates have these, (n, 2) px each."""
        slope = self._linear[_SLOPES] @ self._seen(left_px, right_px)
        sigma = np.concatenate([right_sigma_px.T, left_sigma_px.T])
        return np.asarray(np.sqrt((np.square(slope) * np.square(sigma)).sum(axis=0) / np.square(slope).sum(axis=0)), np.float64)

    def _seen(self, left_px: Array, right_px: Array) -> Array:
        """Normalized x and y of the left, of the right, and 1, (5, n): long rows, so that each step is one call."""
        seen = np.empty((5, len(left_px)))
        seen[4] = 1.0
        seen[:2] = self._left.normalize(left_px).T
        seen[2:4] = self._right.normalize(right_px).T
        return seen

    def _depths(self, seen: Array, linear: Array) -> Array:
        """Depth in the left and right camera, (2, n) mm: the point of the left ray that the right camera sees best."""
        ahead, turned = linear[7], linear[8:10]
        u = seen[2:4] * ahead
        u -= turned
        linear[8:10] = u  # their last use
        products = linear[8:].reshape(2, 2, -1) * u  # of u by u, and of t_xy - x_right t_z by u
        squares, along = products[:, 0] + products[:, 1]
        depth: Array = np.empty((2, seen.shape[1]))
        np.divide(along, squares, depth[0])
        np.multiply(depth[0], ahead, depth[1])
        depth[1] += self._translation[2]
        return depth


def _sampson(seen: Array, linear: Array) -> Array:
    """Signed Sampson distance in px, (n,): the epipolar form over the norm of its gradient by the four pixel coordinates."""
    value = np.add.reduce(seen[2:] * linear[:3])
    slope = np.square(linear[_SLOPES])
    return np.asarray(value / np.sqrt(np.add.reduce(slope)), np.float64)


_LEFT_RAY = [0, 1, 4]
"""Rows of what is seen that make up the direction of the left ray."""

_SLOPES = slice(3, 7)
"""Rows of the linear forms that are the gradient by right x, y and left x, y, per px."""

_UPPER = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
_SYMMETRIC = np.array([[0, 1, 2], [1, 3, 4], [2, 4, 5]])
"""Where the elements of a symmetric matrix stand among its upper ones."""


def _normal_factors(left: Array, right: Array) -> Array:
    """What makes the factors of the inverse normal matrix of the weighted sums of the four equations, (30, 12).

    With ``a = x P3 - Pk`` a coordinate x of weight w adds ``w a a^T = w x^2 P3 P3^T - w x (P3 Pk^T + Pk P3^T) + w Pk Pk^T`` to
    the normal matrix N: linear in the 12 numbers w x^2, w x and w of the four coordinates.  The rows are, six each, the a, b, c and
    d of the upper cofactors ``a b - c d`` of its 3 x 3 part, then that part's first row and the right-hand side ``-N[:3, 3]``:
    so the inverses of all pairs come from one matrix product, by cofactors: cheaper than ``np.linalg.inv`` for a few.
    """
    by_sum = np.empty((4, 4, 3, 4))
    for i, (projection, k) in enumerate(((left, 0), (left, 1), (right, 0), (right, 1))):
        third, own = projection[2], projection[k]
        mixed = np.outer(third, own)
        by_sum[:, :, 0, i], by_sum[:, :, 1, i], by_sum[:, :, 2, i] = np.outer(third, third), -mixed - mixed.T, np.outer(own, own)
    normal = by_sum.reshape(4, 4, 12)
    rows = [normal[(i + di) % 3, (j + dj) % 3] for di, dj in ((1, 1), (2, 2), (1, 2), (2, 1)) for i, j in _UPPER]
    return np.asarray(np.stack([*rows, *normal[0, :3], *-normal[:3, 3]]), np.float64)
