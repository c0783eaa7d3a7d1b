"""Fits two cameras, their relative pose, the board's poses and the board's shape together to all corners of all views.

Gauss-Newton with Levenberg's damping on the reprojection errors of both cameras, every corner of every camera taking
part (Triggs, McLauchlan, Hartley, Fitzgibbon, "Bundle adjustment: a modern synthesis", 2000).  Unknowns are, for
each camera, fx, fy, cx, cy, k1, k2, p1, p2 and where asked for k3; the relative pose; a pose for each view; and the
board's shape with its prior (:mod:`scanner_core.optics.board_shape`).

The noise of a corner is estimated by camera and axis from the residuals themselves, with the degrees of freedom that
the fit has used up, so that the covariance ``(J^T W J)^-1`` holds without anybody's guess of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board_shape import shape_basis
from scanner_core.optics.camera_model import CameraModel
from scanner_core.optics.stereo_view import StereoView

Array = NDArray[np.float64]

INTRINSICS = 9
"""fx, fy, cx, cy, k1, k2, p1, p2, k3 of one camera: the order of all vectors of parameters."""
STEREO = 2 * INTRINSICS + 6
"""Both cameras' intrinsics, then rotation vector (rad) and translation (mm) of the relative pose."""

_K3 = 8
_ITERATIONS = 30
_CONVERGED = 1e-9
"""Relative decrease of the sum of squares that ends the iteration."""
_START_SIGMA_PX = 0.05
_FLOOR_PX = 1e-6
"""Noise-free corners (in tests) must not divide by zero."""
_NOISE_ROUNDS = 8
_NOISE_SETTLED = 3e-3
"""Relative change of the estimated noise at which it is settled."""


@dataclass(frozen=True, slots=True, eq=False)
class Corners:
    """All corners of all views in one table, (n,) each: which camera (0 left), view and mark; pixels (n, 2)."""

    camera: NDArray[np.int64]
    view: NDArray[np.int64]
    mark: NDArray[np.int64]
    pixels: Array

    @classmethod
    def of(cls, views: Sequence[StereoView]) -> Corners:
        sides = [(side, index, seen) for index, view in enumerate(views) for side, seen in enumerate((view.left, view.right))]
        counts = [len(seen.ids) for _, _, seen in sides]
        return cls(
            np.repeat([side for side, _, _ in sides], counts).astype(np.int64),
            np.repeat([index for _, index, _ in sides], counts).astype(np.int64),
            np.concatenate([seen.ids for _, _, seen in sides]),
            np.concatenate([seen.corners_px for _, _, seen in sides]),
        )

    def __len__(self) -> int:
        return len(self.mark)


@dataclass(frozen=True, slots=True, eq=False)
class BundleState:
    """The values of all unknowns.

    Attributes
    ----------
    intrinsics : (2, 9)
    relative : rig (left camera) to right camera
    rotations, translations : (views, 3, 3) and (views, 3), board to rig
    marks : (m, 3) mm, board frame
    """

    intrinsics: Array
    relative: RigidTransform
    rotations: Array
    translations: Array
    marks: Array

    def cameras(self, size_px: tuple[int, int]) -> tuple[CameraModel, CameraModel]:
        """Left and right, in the rig frame."""
        left, right = (camera_of(values, RigidTransform.identity(), size_px) for values in self.intrinsics)
        return left, replace(right, rotation=self.relative.rotation, translation=self.relative.translation)


@dataclass(frozen=True, slots=True, eq=False)
class Bundle:
    """A fit.

    Attributes
    ----------
    state : its unknowns
    residuals_px : (n, 2), image less model, of every corner, also of those that took no part
    sigma_px : (2, 2) estimated noise by camera and axis
    covariance : (24 + 3 m, 24 + 3 m) of the stereo parameters (:data:`STEREO`) and the marks' places
    misfit : weighted sum of squares with the prior's part; a difference between two fits with the same `sigma_px` is a
        log likelihood ratio times two
    """

    state: BundleState
    residuals_px: Array
    sigma_px: Array
    covariance: Array
    misfit: float


def camera_of(values: Array, pose: RigidTransform, size_px: tuple[int, int]) -> CameraModel:
    """A camera from its nine intrinsic parameters."""
    fx, fy, cx, cy = values[:4]
    return CameraModel(np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]]), values[4:].copy(), pose.rotation, pose.translation, size_px)


def intrinsics_of(camera: CameraModel) -> Array:
    """The nine intrinsic parameters of a camera."""
    m = camera.matrix
    return np.concatenate([[m[0, 0], m[1, 1], m[0, 2], m[1, 2]], camera.distortion])


def moved_cameras(left: CameraModel, right: CameraModel, step: Array) -> tuple[CameraModel, CameraModel]:
    """Both cameras after a small step (24,) of the stereo parameters; the rig frame stays the left camera's."""
    first, second = (
        camera_of(intrinsics_of(camera) + step[at : at + INTRINSICS], RigidTransform.identity(), camera.size_px)
        for camera, at in ((left, 0), (right, INTRINSICS))
    )
    turn = RigidTransform.from_vector(step[2 * INTRINSICS : 2 * INTRINSICS + 3], np.zeros(3)).rotation
    return first, replace(second, rotation=turn @ right.rotation, translation=right.translation + step[2 * INTRINSICS + 3 : STEREO])


def adjust(corners: Corners, start: BundleState, used: NDArray[np.bool_], *, with_k3: bool, sigma_px: Array | None = None) -> Bundle:
    """The best values of all unknowns.

    Parameters
    ----------
    start : from closed forms or single-camera fits
    used : (n,) which corners take part
    sigma_px : (2, 2) known noise by camera and axis; estimated when None
    """
    basis = shape_basis(start.marks)
    free = np.ones(STEREO + 6 * len(start.rotations) + basis.shape[1], bool)
    free[[_K3, INTRINSICS + _K3]] = with_k3
    sigma = np.full((2, 2), _START_SIGMA_PX) if sigma_px is None else sigma_px
    state, shape = start, np.zeros(basis.shape[1])
    for _ in range(1 if sigma_px is not None else _NOISE_ROUNDS):
        state, shape, normal = _solve(corners, state, shape, used, sigma, basis, free)
        residuals = corners.pixels - _predict(corners, state)[0]
        inverse = np.linalg.inv(normal)
        if sigma_px is None:
            # Every parameter uses up one degree of freedom, less what its prior has brought along.
            spent = len(normal) - float(np.diag(inverse)[-len(shape) :].sum())
            left = max(0.1, 1.0 - spent / (2 * np.count_nonzero(used)))
            groups = [residuals[used & (corners.camera == side)] for side in (0, 1)]
            before, sigma = sigma, np.maximum(np.sqrt(np.array([(r**2).mean(axis=0) for r in groups]) / left), _FLOOR_PX)
            if np.abs(sigma / before - 1).max() < _NOISE_SETTLED:
                break
    misfit = float(((residuals[used] / sigma[corners.camera[used]]) ** 2).sum() + shape @ shape)
    kept = np.flatnonzero(free)
    whole = np.zeros((len(free), len(free)))
    whole[np.ix_(kept, kept)] = inverse
    chosen = np.r_[np.arange(STEREO), np.arange(len(free) - len(shape), len(free))]
    part = whole[np.ix_(chosen, chosen)]
    spread = np.zeros((STEREO + len(basis), len(chosen)))
    spread[:STEREO, :STEREO], spread[STEREO:, STEREO:] = np.eye(STEREO), basis
    return Bundle(state, residuals, sigma, spread @ part @ spread.T, misfit)


def _solve(
    corners: Corners, state: BundleState, shape: Array, used: NDArray[np.bool_], sigma: Array, basis: Array, free: NDArray[np.bool_]
) -> tuple[BundleState, Array, Array]:
    """State, shape in units of its prior, and normal matrix of the free unknowns at the minimum."""
    weight = np.where(used[:, None], 1.0 / sigma[corners.camera], 0.0)
    marks0 = state.marks - (basis @ shape).reshape(-1, 3)

    def misfit_of(candidate: BundleState, u: Array) -> tuple[float, Array, tuple[Array, Array, Array]]:
        pixels, *parts = _predict(corners, candidate)
        residual = weight * (corners.pixels - pixels)
        return float((residual**2).sum() + u @ u), residual, (parts[0], parts[1], parts[2])

    misfit, residual, parts = misfit_of(state, shape)
    damping = 1e-6
    for _ in range(_ITERATIONS):
        jacobian = _jacobian(corners, state, parts, basis)
        jacobian *= weight[:, :, None]
        rows = jacobian.reshape(2 * len(corners), -1)[:, free]
        normal, right = rows.T @ rows, rows.T @ residual.ravel()
        prior = np.arange(len(normal) - len(shape), len(normal))
        normal[prior, prior] += 1.0
        right[prior] -= shape
        before = misfit
        while damping < 1e6:
            step = np.zeros(len(free))
            step[free] = np.linalg.solve(normal + damping * np.diag(np.diag(normal)), right)
            moved, moved_shape = _moved(state, shape, step, marks0, basis)
            tried, tried_residual, tried_parts = misfit_of(moved, moved_shape)
            if tried <= misfit:
                state, shape, misfit, residual, parts = moved, moved_shape, tried, tried_residual, tried_parts
                damping = max(damping / 10, 1e-12)
                break
            damping *= 10
        if before - misfit <= _CONVERGED * before:
            break
    return state, shape, normal


def _moved(state: BundleState, shape: Array, step: Array, marks0: Array, basis: Array) -> tuple[BundleState, Array]:
    """The state after a step of all unknowns; rotations turn by a vector from the left."""
    views = len(state.rotations)
    intrinsics = state.intrinsics + step[: 2 * INTRINSICS].reshape(2, INTRINSICS)
    turn = RigidTransform.from_vector(step[2 * INTRINSICS : 2 * INTRINSICS + 3], np.zeros(3)).rotation
    relative = RigidTransform(turn @ state.relative.rotation, state.relative.translation + step[2 * INTRINSICS + 3 : STEREO])
    poses = step[STEREO : STEREO + 6 * views].reshape(views, 6)
    turns = np.stack([RigidTransform.from_vector(vector, np.zeros(3)).rotation for vector in poses[:, :3]])
    shape = shape + step[STEREO + 6 * views :]
    marks = marks0 + (basis @ shape).reshape(-1, 3)
    return BundleState(intrinsics, relative, turns @ state.rotations, state.translations + poses[:, 3:], marks), shape


def _predict(corners: Corners, state: BundleState) -> tuple[Array, Array, Array, Array]:
    """Pixels (n, 2), corners in the rig frame and less its view's translation (n, 3), and in their camera's frame (n, 3)."""
    turned = np.einsum("nij,nj->ni", state.rotations[corners.view], state.marks[corners.mark])
    in_rig = turned + state.translations[corners.view]
    right = corners.camera == 1
    in_camera = np.where(right[:, None], state.relative.apply(in_rig), in_rig)
    pixels, _, _ = project_with_derivatives(state.intrinsics[corners.camera], in_camera)
    return pixels, turned, in_rig, in_camera


def _jacobian(corners: Corners, state: BundleState, parts: tuple[Array, Array, Array], basis: Array) -> Array:
    """Derivatives of the pixels by all unknowns, (n, 2, unknowns)."""
    turned, in_rig, in_camera = parts
    n, views = len(corners), len(state.rotations)
    jacobian = np.zeros((n, 2, STEREO + 6 * views + basis.shape[1]))
    _, by_point, by_intrinsics = project_with_derivatives(state.intrinsics[corners.camera], in_camera)
    right = np.flatnonzero(corners.camera == 1)
    left = np.flatnonzero(corners.camera == 0)
    jacobian[left, :, :INTRINSICS] = by_intrinsics[left]
    jacobian[right, :, INTRINSICS : 2 * INTRINSICS] = by_intrinsics[right]
    about = in_rig[right] @ state.relative.rotation.T
    jacobian[right, :, 2 * INTRINSICS : 2 * INTRINSICS + 3] = _by_turn(by_point[right], about)
    jacobian[right, :, 2 * INTRINSICS + 3 : STEREO] = by_point[right]
    by_rig = by_point.copy()
    by_rig[right] = by_point[right] @ state.relative.rotation
    column = STEREO + 6 * corners.view[:, None] + np.arange(6)
    by_pose = np.concatenate([_by_turn(by_rig, turned), by_rig], axis=2)
    np.put_along_axis(jacobian, np.broadcast_to(column[:, None], by_pose.shape), by_pose, axis=2)
    by_mark = by_rig @ state.rotations[corners.view]
    jacobian[:, :, STEREO + 6 * views :] = by_mark @ basis.reshape(-1, 3, basis.shape[1])[corners.mark]
    return jacobian


def _by_turn(by_point: Array, about: Array) -> Array:
    """Derivative by a rotation vector that turns `about` (n, 3) from the left: ``by_point @ -[about]x``, as cross products."""
    return np.asarray(np.cross(about[:, None], by_point), np.float64)


def project_with_derivatives(intrinsics: Array, points: Array) -> tuple[Array, Array, Array]:
    """Pixels of points in their camera's frame, and the derivatives.

    Parameters
    ----------
    intrinsics : (n, 9)
    points : (n, 3) mm

    Returns
    -------
    Pixels (n, 2), their derivatives by the point (n, 2, 3) and by the intrinsics (n, 2, 9).
    """
    fx, fy, cx, cy, k1, k2, p1, p2, k3 = intrinsics.T
    depth = points[:, 2]
    x, y = points[:, 0] / depth, points[:, 1] / depth
    r2 = x * x + y * y
    radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
    slope = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3))
    xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
    yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
    mixed = slope * x * y + 2 * p1 * x + 2 * p2 * y
    xx = radial + slope * x * x + 2 * p1 * y + 6 * p2 * x
    yy = radial + slope * y * y + 6 * p1 * y + 2 * p2 * x
    by_point = np.empty((len(points), 2, 3))
    by_point[:, 0, 0], by_point[:, 0, 1], by_point[:, 0, 2] = fx * xx / depth, fx * mixed / depth, -fx * (x * xx + y * mixed) / depth
    by_point[:, 1, 0], by_point[:, 1, 1], by_point[:, 1, 2] = fy * mixed / depth, fy * yy / depth, -fy * (x * mixed + y * yy) / depth
    by_intrinsics = np.zeros((len(points), 2, INTRINSICS))
    by_intrinsics[:, 0, 0], by_intrinsics[:, 1, 1] = xd, yd
    by_intrinsics[:, 0, 2], by_intrinsics[:, 1, 3] = 1.0, 1.0
    for column, power in ((4, r2), (5, r2 * r2), (_K3, r2 * r2 * r2)):
        by_intrinsics[:, 0, column], by_intrinsics[:, 1, column] = fx * x * power, fy * y * power
    by_intrinsics[:, 0, 6], by_intrinsics[:, 1, 6] = fx * 2 * x * y, fy * (r2 + 2 * y * y)
    by_intrinsics[:, 0, 7], by_intrinsics[:, 1, 7] = fx * (r2 + 2 * x * x), fy * 2 * x * y
    pixels = np.stack([fx * xd + cx, fy * yd + cy], axis=1)
    return pixels, by_point, by_intrinsics
