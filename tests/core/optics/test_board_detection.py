"""Board detection on the virtual bench's rendered frames: every pixel is drawn, no corner is handed over."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.clock import SteppedClock
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_detection import BoardMiss, BoardMissReason, BoardView, detect_board
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.board import flat_on_table
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.print_errors import FAULTLESS
from tests.core.optics.tables import Table

TARGET = CharucoTarget()
PRESET = PRESETS["bench"]


@pytest.fixture(scope="module")
def bench() -> VirtualBench:
    return VirtualBench(PRESET, None, SteppedClock(), Table(), seed=3, faults=FAULTLESS)


@pytest.fixture(scope="module")
def frame(bench: VirtualBench) -> NDArray[np.uint8]:
    """The board in the left camera."""
    bench.show_board(bench.operator_poses(4)[1])
    image = bench.camera("left").grab().image
    bench.remove_board()
    return image


def _errors(view: BoardView, camera: int, pose: RigidTransform) -> np.ndarray:
    model = PRESET.cameras[camera]
    return view.corners_px - model.project(pose.apply(TARGET.object_points))[view.ids]


def test_corners_are_placed_to_hundredths_of_a_pixel(bench: VirtualBench) -> None:
    for pose in bench.operator_poses(6):
        bench.show_board(pose)
        for index, side in enumerate(("left", "right")):
            view = detect_board(bench.camera(side).grab().image, TARGET)
            assert isinstance(view, BoardView)
            error = _errors(view, index, pose)
            assert np.sqrt((error**2).mean()) < 0.04
            assert np.abs(error).max() < 0.2


def test_board_flat_on_the_table_is_read_at_grazing_view(bench: VirtualBench) -> None:
    """Seen from 30 degrees above, a marker's cell is two pixels high."""
    bench.lay_board_on_table()
    for index, side in enumerate(("left", "right")):
        view = detect_board(bench.camera(side).grab().image, TARGET)
        assert isinstance(view, BoardView)
        assert len(view.ids) >= 40
        assert np.sqrt((_errors(view, index, flat_on_table(TARGET, 0.0)) ** 2).mean()) < 0.05


def test_part_of_the_board_is_enough_and_hidden_corners_are_left_out(frame: NDArray[np.uint8]) -> None:
    whole = detect_board(frame, TARGET)
    assert isinstance(whole, BoardView)
    covered = frame.copy()
    x = int(np.median(whole.corners_px[:, 0]))
    covered[:, x:] = 40  # a hand before the right half
    part = detect_board(covered, TARGET)
    assert isinstance(part, BoardView)
    assert 12 <= len(part.ids) < len(whole.ids)
    assert set(part.ids) <= set(whole.ids)
    same = np.isin(whole.ids, part.ids)
    assert np.abs(part.corners_px - whole.corners_px[same]).max() < 0.2


def _miss(image: NDArray[np.uint8]) -> BoardMissReason:
    found = detect_board(image, TARGET)
    assert isinstance(found, BoardMiss)
    return found.reason


def test_why_a_frame_cannot_be_used(frame: NDArray[np.uint8]) -> None:
    noise = np.random.default_rng(1).normal(0, 2, frame.shape)
    whole = detect_board(frame, TARGET)
    assert isinstance(whole, BoardView)
    few = np.full_like(frame, 60)
    x, y = np.round(whole.corners_px.mean(axis=0)).astype(int)
    few[y - 55 : y + 55, x - 70 : x + 70] = frame[y - 55 : y + 55, x - 70 : x + 70]  # a dozen squares in a blank frame
    assert _miss((frame * 0.08).astype(np.uint8)) is BoardMissReason.TOO_DARK
    assert _miss(np.full_like(frame, 255)) is BoardMissReason.TOO_BRIGHT
    assert _miss(np.clip(cv2.GaussianBlur(frame, (0, 0), 9.0) + noise, 0, 255).astype(np.uint8)) is BoardMissReason.TOO_BLURRED
    assert _miss(np.clip(120 + 20 * noise, 0, 255).astype(np.uint8)) is BoardMissReason.NO_BOARD
    assert _miss(few) is BoardMissReason.TOO_FEW_CORNERS


def test_a_board_that_leaves_the_image_is_called_cut(frame: NDArray[np.uint8]) -> None:
    """The image is moved until only the board's edge is in it, four markers of it still whole."""
    view = detect_board(frame, TARGET)
    assert isinstance(view, BoardView)
    reasons = set()
    for keep in range(60, 300, 20):
        shifted = np.full_like(frame, int(np.median(frame[:8])))
        left = max(0, int(view.corners_px[:, 0].min()) - 40)
        shifted[:, -keep:] = frame[:, left : left + keep]
        seen = detect_board(shifted, TARGET)
        reasons.add(seen.reason if isinstance(seen, BoardMiss) else None)
    assert BoardMissReason.CUT in reasons


def test_the_length_bar_is_never_taken_for_the_board(bench: VirtualBench) -> None:
    bench.show_bar(bench.bar_poses(1)[0])
    image = bench.camera("left").grab().image
    bench.remove_board()
    assert isinstance(detect_board(image, bench.bar.plate), BoardView)
    seen = detect_board(image, TARGET)
    assert isinstance(seen, BoardMiss)
    assert seen.reason is BoardMissReason.NO_BOARD
