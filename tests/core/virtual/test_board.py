"""The calibration board before the virtual cameras."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_detection import BoardView, detect_board
from scanner_core.virtual.board import BoardRenderer, flat_on_table, operator_poses
from scanner_core.virtual.image_formation import ImageSensor
from scanner_core.virtual.presets import PRESETS, TARGET
from scanner_core.virtual.print_errors import FAULTLESS, BoardFaults, PrintErrors

BENCH = PRESETS["bench"]
BOARD = CharucoTarget()


@pytest.fixture(scope="module")
def renderers() -> tuple[BoardRenderer, BoardRenderer]:
    return BoardRenderer(BENCH, 0, BOARD), BoardRenderer(BENCH, 1, BOARD)


def corner_errors(renderer: BoardRenderer, index: int, pose: RigidTransform) -> np.ndarray:
    """Where the inner corners are found in the frame, less where they truly are, (n, 2) px."""
    frame = ImageSensor(BENCH, index, seed=2).lit_frame(renderer.signal(pose), key=index)
    view = detect_board(frame, BOARD)
    assert isinstance(view, BoardView)
    return view.corners_px - BENCH.cameras[index].project(pose.apply(renderer.errors.marks(BOARD.object_points[view.ids])))


@pytest.mark.parametrize("index", [0, 1])
def test_corners_are_found_where_the_true_camera_projects_them(renderers: tuple[BoardRenderer, BoardRenderer], index: int) -> None:
    poses = [*operator_poses(BENCH, BOARD, 4, seed=1), flat_on_table(BOARD, 30.0)]
    errors = np.concatenate([corner_errors(renderers[index], index, pose) for pose in poses])
    assert len(errors) > 180
    assert np.abs(errors).max() < 0.1
    assert np.sqrt((errors**2).mean()) < 0.03


def test_a_corner_is_where_black_and_white_cross(renderers: tuple[BoardRenderer, BoardRenderer]) -> None:
    """Without any detector: on the four sides of an inner corner the squares alternate, and its own pixel is between them."""
    pose = operator_poses(BENCH, BOARD, 1, seed=5)[0]
    camera, signal = BENCH.cameras[0], renderers[0].signal(pose)
    corner = BOARD.object_points[19]
    sides = corner + 4.0 * np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0]])
    values = [signal[y, x] for x, y in np.rint(camera.project(pose.apply(sides))).astype(int)]
    middle = 0.5 * (max(values) + min(values))
    assert (values[0] > middle) == (values[2] > middle) != (values[1] > middle) == (values[3] > middle)


def test_a_board_seen_from_behind_shows_no_pattern(renderers: tuple[BoardRenderer, BoardRenderer]) -> None:
    pose = operator_poses(BENCH, BOARD, 1, seed=5)[0]
    turned = RigidTransform(pose.rotation @ np.diag([-1.0, 1.0, -1.0]), pose.translation)
    assert np.ptp(renderers[0].signal(turned)) == 0


def test_poses_fill_the_volume_tilt_and_repeat_by_seed() -> None:
    poses = operator_poses(BENCH, BOARD, 24, seed=0)
    again, other = operator_poses(BENCH, BOARD, 24, seed=0), operator_poses(BENCH, BOARD, 24, seed=1)
    np.testing.assert_array_equal([p.matrix() for p in poses], [p.matrix() for p in again])
    assert not np.array_equal(poses[0].matrix(), other[0].matrix())
    middles = np.array([pose.apply(BOARD.object_points).mean(axis=0) for pose in poses]) - TARGET
    assert (np.ptp(middles, axis=0) > [90, 90, 60]).all()
    normals = np.array([pose.rotation[:, 2] for pose in poses])
    mean = normals.mean(axis=0) / np.linalg.norm(normals.mean(axis=0))
    assert np.degrees(np.arccos(normals @ mean)).max() > 25
    for camera in BENCH.cameras:
        for pose in poses:
            pixels = camera.project(pose.apply(BOARD.object_points))
            assert ((pixels > 0) & (pixels < camera.size_px)).all(axis=1).mean() >= 0.5


def test_the_board_on_the_table_lies_face_up_at_zero_and_turns_with_it() -> None:
    first, second = flat_on_table(BOARD, 10.0), flat_on_table(BOARD, 55.0)
    for pose in (first, second):
        np.testing.assert_allclose(pose.apply(BOARD.object_points)[:, 2], 0, atol=1e-9)
        np.testing.assert_allclose(pose.rotation[:, 2], [0, 0, -1], atol=1e-9)
    np.testing.assert_allclose((RigidTransform.about_z(45.0) @ first).matrix(), second.matrix(), atol=1e-9)
    assert np.linalg.norm(first.apply(BOARD.object_points).mean(axis=0)) < 10


def test_the_board_is_bent_twisted_and_too_large_as_asked() -> None:
    errors = PrintErrors(BOARD, BoardFaults(uneven_um=0.0, print_um=0.0))
    width, height = BOARD.size_mm
    corners = np.array([[0, 0, 0], [width, 0, 0], [width, height, 0], [0, height, 0], [0.5 * width, 0.5 * height, 0]], float)
    off = errors.marks(corners) - corners
    np.testing.assert_allclose(-off[:, 2], [0.12, -0.12, 0.12, -0.12, 0.3], atol=1e-5)
    np.testing.assert_allclose(off[:4, :2], 0.001 * np.array([[-width, -height], [width, -height], [width, height], [-width, height]]), atol=1e-5)
    assert errors.lowest_mm() == pytest.approx(-0.12, abs=1e-4)


def test_ink_and_unevenness_are_those_of_the_board_s_seed() -> None:
    points = BOARD.object_points
    errors, again, other = (PrintErrors(BOARD, BoardFaults(bow_mm=0.0, twist_mm=0.0, scale=1.0, seed=seed)) for seed in (1, 1, 2))
    off = 1e3 * (errors.marks(points) - points)
    assert 4 < np.sqrt((off[:, :2] ** 2).mean()) < 12
    assert 5 < np.sqrt((off[:, 2] ** 2).mean()) < 25
    np.testing.assert_array_equal(errors.marks(points), again.marks(points))
    assert not np.array_equal(errors.marks(points), other.marks(points))


def test_a_board_without_faults_is_its_drawing() -> None:
    np.testing.assert_array_equal(PrintErrors(BOARD, FAULTLESS).marks(BOARD.object_points), BOARD.object_points)


def test_a_bent_board_rests_on_the_table_with_its_lowest_point() -> None:
    errors = PrintErrors(BOARD)
    pose = flat_on_table(BOARD, 20.0, errors.lowest_mm())
    x, y = np.meshgrid(np.linspace(0, BOARD.size_mm[0], 30), np.linspace(0, BOARD.size_mm[1], 30))
    heights = pose.apply(errors.marks(np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)))[:, 2]
    assert heights.min() == pytest.approx(0.0, abs=0.01)
    assert heights.max() > 0.2
