from __future__ import annotations

import numpy as np

from scanner_core.geometry.voxel_region import VoxelGrid, closed_by, handles, largest_piece, opened_by, signed_depth


def ball(radius: float, size: int = 41) -> np.ndarray:
    x = np.arange(size) - size // 2
    return x[:, None, None] ** 2 + x[None, :, None] ** 2 + x[None, None, :] ** 2 <= radius**2


def ring(size: int = 41) -> np.ndarray:
    x = np.arange(size) - size // 2
    rho = np.sqrt(x[:, None, None] ** 2.0 + x[None, :, None] ** 2.0)
    return (rho - 12) ** 2 + x[None, None, :] ** 2 <= 16


def test_handles_of_a_ball_a_ring_and_two_rings() -> None:
    assert handles(ball(12)) == 0
    assert handles(ring()) == 1
    eight = np.zeros((80, 41, 41), bool)
    eight[:41] |= ring()
    eight[30:71] |= ring()
    assert handles(largest_piece(eight)) == 2  # they overlap in one place


def test_splat_and_sample_are_trilinear() -> None:
    rng = np.random.default_rng(0)
    grid = VoxelGrid(np.array([-1.0, 2.0, 0.5]), 0.5, (8, 9, 10))
    points = grid.origin + 0.5 * rng.uniform(0, 7, size=(50, 3))
    values = rng.normal(size=50)
    weights = grid.weights(points)
    assert np.isclose(weights.splat(values).sum(), values.sum(), atol=1e-4)
    x, y, z = (grid.origin[i] + 0.5 * np.arange(grid.shape[i]) for i in range(3))
    plane = 2 * x[:, None, None] - y[None, :, None] + 0.5 * z[None, None, :]
    np.testing.assert_allclose(grid.sample(plane, points), points @ (2, -1, 0.5), atol=1e-9)
    inner = grid.origin + 0.5 * rng.uniform(1, 6, size=(20, 3))
    np.testing.assert_allclose(weights.sample(plane.astype(np.float32)), points @ (2, -1, 0.5), atol=1e-5)
    np.testing.assert_allclose(grid.weights(inner).gradient(plane.astype(np.float32)), np.tile((2, -1, 0.5), (20, 1)), atol=1e-5)


def test_depth_is_the_distance_to_the_border() -> None:
    depth = signed_depth(ball(12), 0.5)
    assert abs(depth[20, 20, 20] - 6.0) < 0.3
    assert depth[0, 20, 20] < -3


def test_opening_removes_a_bridge_and_closing_a_slit() -> None:
    blocks = np.zeros((40, 20, 20), bool)
    blocks[4:16, 4:16, 4:16] = blocks[24:36, 4:16, 4:16] = True
    bridged = blocks.copy()
    bridged[16:24, 9:11, 9:11] = True
    assert not opened_by(bridged, 3)[20, 10, 10]
    slit = np.zeros((40, 20, 20), bool)
    slit[4:36, 4:16, 4:16] = True
    slit[20, :, 8:] = False
    assert closed_by(slit, 2)[20, 9, 12]
