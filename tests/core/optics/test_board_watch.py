from __future__ import annotations

import numpy as np
import pytest

from scanner_core.optics.board_coverage import CoverageSoFar, judge
from scanner_core.optics.board_detection import BoardMiss, BoardMissReason, BoardView
from scanner_core.optics.board_watch import ViewVerdict, Wish, WishKind
from scanner_core.optics.stereo_view import StereoView
from tests.core.optics.boards import TARGET, shown
from tests.core.optics.rigs import DISTANCE_MM, known_rig

TRUTH = known_rig()
SIZE = TRUTH.left.size_px
VIEWS = shown(TRUTH, 8, 0.02, seed=1)
MISS = BoardMiss(BoardMissReason.TOO_DARK)


def test_verdicts() -> None:
    view, other = VIEWS[:2]
    assert isinstance(judge(view.left, view.right, [other], SIZE[0]), StereoView)
    assert judge(view.left, view.right, [other, view], SIZE[0]) is ViewVerdict.TOO_SIMILAR
    assert judge(MISS, view.right, [], SIZE[0]) is ViewVerdict.ONE_CAMERA
    assert judge(MISS, MISS, [], SIZE[0]) is ViewVerdict.MISSED
    few = BoardView(view.right.ids[:5], view.right.corners_px[:5])
    assert judge(view.left, few, [], SIZE[0]) is ViewVerdict.FEW_IN_COMMON


@pytest.mark.parametrize("known", [True, False])
def test_tilts_and_distances_are_told(known: bool) -> None:
    so_far = CoverageSoFar(TARGET, SIZE, 25, TRUTH.left if known else None)
    assert so_far.spread() == (None, None)
    so_far.views.extend(VIEWS)
    tilt_deg, distance_mm = so_far.spread()
    assert tilt_deg is not None
    assert distance_mm is not None
    assert 30 < tilt_deg < 80
    assert 0.7 * DISTANCE_MM < distance_mm[0] < distance_mm[1] < 1.3 * DISTANCE_MM


def test_boards_held_alike_are_asked_to_be_tilted() -> None:
    so_far = CoverageSoFar(TARGET, SIZE, 25, TRUTH.left, shown(TRUTH, 6, 0.02, seed=2, tilt_deg=3.0))
    wishes = so_far.wishes(*so_far.spread())
    assert wishes[0].kind is WishKind.TILT_MORE
    assert wishes[-1] == Wish(WishKind.MORE_VIEWS, count=19)


def test_a_part_of_an_image_without_corners_is_asked_for_by_name() -> None:
    so_far = CoverageSoFar(TARGET, SIZE, 1)
    lower = np.array([[x, y] for x in range(20, 600, 20) for y in range(110, 290, 10)], float)
    everywhere = np.array([[x, y] for x in range(20, 600, 20) for y in range(10, 290, 10)], float)
    so_far.views.append(StereoView(BoardView(np.arange(len(everywhere)), everywhere), BoardView(np.arange(len(lower)), lower)))
    assert so_far.grid("left").all()
    wishes = so_far.wishes(None, None)
    assert [wish.words() for wish in wishes] == [
        "Bring the board to the upper left of the right camera's image.",
        "Bring the board to the upper middle of the right camera's image.",
        "Bring the board to the upper right of the right camera's image.",
    ]
