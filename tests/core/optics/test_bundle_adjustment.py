from __future__ import annotations

from dataclasses import replace

import numpy as np

from scanner_core.optics.board_shape import shape_basis
from scanner_core.optics.bundle_adjustment import INTRINSICS, STEREO, Corners, adjust, intrinsics_of, moved_cameras, project_with_derivatives
from scanner_core.optics.stereo_calibration import _start
from tests.core.optics.boards import TARGET, bent, shown
from tests.core.optics.rigs import known_rig

TRUTH = known_rig()
SIZE = TRUTH.left.size_px


def test_projection_is_the_camera_s_own_and_its_derivatives_are_differences() -> None:
    rng = np.random.default_rng(1)
    points = rng.uniform((-90, -60, 380), (90, 60, 480), (20, 3))
    values = np.tile(intrinsics_of(TRUTH.left), (20, 1))
    values[:, 8] = 0.3
    pixels, by_point, by_intrinsics = project_with_derivatives(values, points)
    same = project_with_derivatives(np.tile(intrinsics_of(TRUTH.left), (20, 1)), points)[0]
    np.testing.assert_allclose(same, TRUTH.left.project(points), atol=1e-9)
    for column in range(3):
        step = np.eye(3)[column] * 1e-3
        difference = (project_with_derivatives(values, points + step)[0] - project_with_derivatives(values, points - step)[0]) / 2e-3
        np.testing.assert_allclose(by_point[:, :, column], difference, atol=1e-6)
    for column in range(INTRINSICS):
        step = np.eye(INTRINSICS)[column] * 1e-4
        difference = (project_with_derivatives(values + step, points)[0] - project_with_derivatives(values - step, points)[0]) / 2e-4
        np.testing.assert_allclose(by_intrinsics[:, :, column], difference, atol=1e-5)
    assert np.isfinite(pixels).all()


def test_a_shape_has_no_rigid_motion_and_no_change_of_size() -> None:
    basis = shape_basis(TARGET.object_points)
    about = TARGET.object_points - TARGET.object_points.mean(axis=0)
    field = basis.reshape(-1, 3, basis.shape[1])
    np.testing.assert_allclose(field.sum(axis=0), 0, atol=1e-10)
    np.testing.assert_allclose(np.cross(about[:, None], field.transpose(0, 2, 1)).sum(axis=0), 0, atol=1e-7)
    np.testing.assert_allclose((about[:, :, None] * field).sum(axis=(0, 1)), 0, atol=1e-7)
    assert np.linalg.matrix_rank(basis) == 3 * len(about) - 7


def test_the_covariance_is_the_scatter_of_many_fits() -> None:
    """Focal lengths, principal points and baseline of 12 fits to new noise, over their predicted standard deviation."""
    marks = bent(0.2, ink_mm=0.01)
    z = []
    for seed in range(12):
        views = shown(TRUTH, 8, 0.0, seed=3, marks=marks)
        corners = Corners.of(views)
        noise = np.random.default_rng(seed).normal(0, 0.05, corners.pixels.shape)
        noisy = replace(corners, pixels=corners.pixels + noise)
        fit = adjust(noisy, _start(views, SIZE, TARGET), np.ones(len(noisy), bool), with_k3=False)
        left, right = fit.state.cameras(SIZE)
        error = np.r_[intrinsics_of(left)[:4] - intrinsics_of(TRUTH.left)[:4], intrinsics_of(right)[:4] - intrinsics_of(TRUTH.right)[:4]]
        shift = right.translation - TRUTH.right.translation
        spread = np.sqrt(np.diag(fit.covariance))
        chosen = np.r_[0:4, INTRINSICS : INTRINSICS + 4, STEREO - 3 : STEREO]
        z.append(np.r_[error, shift] / spread[chosen])
        assert 0.045 < fit.sigma_px.mean() < 0.055
    z_all = np.array(z)
    assert 0.7 < np.sqrt((z_all.std(axis=0) ** 2).mean()) < 1.35


def test_a_step_of_nothing_moves_nothing() -> None:
    left, right = moved_cameras(TRUTH.left, TRUTH.right, np.zeros(STEREO))
    np.testing.assert_allclose(left.matrix, TRUTH.left.matrix)
    np.testing.assert_allclose(right.rotation, TRUTH.right.rotation, atol=1e-12)
    np.testing.assert_allclose(right.translation, TRUTH.right.translation)
