"""What a calibration sees of the board while it is shown: seen or missed and why, what is covered, what is still wanted.

All of it are values, in the order in which a person needs them; words are English, and every word has a value beside it
by which a window can translate it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.board_view import BoardMiss, BoardMissReason, BoardView

Side = Literal["left", "right"]
SIDES: tuple[Side, Side] = ("left", "right")

FIELDS = (6, 8)
"""Rows and columns of the coverage grid."""


class Phase(Enum):
    """What is before the cameras."""

    BOARD = "board"
    BAR = "bar"
    TABLE = "table"


class ViewVerdict(Enum):
    """What became of a view."""

    TAKEN = "taken"
    MISSED = "missed"
    ONE_CAMERA = "seen_by_one_camera_only"
    FEW_IN_COMMON = "too_few_corners_in_common"
    TOO_SIMILAR = "too_similar_to_an_earlier_view"
    MOVING = "moving"


class WishKind(Enum):
    """What would help."""

    MORE_VIEWS = "more_views"
    TILT_MORE = "tilt_more"
    VARY_DISTANCE = "vary_distance"
    COVER = "cover"


@dataclass(frozen=True, slots=True)
class Wish:
    """What is still wanted; `camera` and `row`, `column` (-1, 0 or 1: upper, middle, lower; left, middle, right) for COVER, `count`
    for MORE_VIEWS."""

    kind: WishKind
    camera: Side | None = None
    row: int = 0
    column: int = 0
    count: int = 0

    def words(self) -> str:
        """One sentence."""
        if self.kind is WishKind.MORE_VIEWS:
            return f"{self.count} more views."
        if self.kind is WishKind.TILT_MORE:
            return "Tilt the board more, each time to another side."
        if self.kind is WishKind.VARY_DISTANCE:
            return "Bring the board nearer and farther."
        up, along = {-1: "upper ", 0: "", 1: "lower "}[self.row], {-1: "left", 0: "middle", 1: "right"}[self.column]
        return f"Bring the board to the {up}{along} of the {self.camera} camera's image."


@dataclass(frozen=True, slots=True, eq=False)
class CameraSighting:
    """The board in one camera: how many corners and where, (n, 2) px, or why none can be used (then None)."""

    corners: int
    reason: BoardMissReason | None
    corners_px: NDArray[np.float64] | None = None


@dataclass(frozen=True, slots=True, eq=False)
class BoardWatch:
    """One look at the board, and what all looks so far add up to.

    Attributes
    ----------
    phase, index, count : what is shown, how many views were taken before this one, how many are wanted
    left, right : what each camera sees
    verdict : what became of the view
    coverage_left, coverage_right : (6, 8) bool, fields of each image that have held a corner
    tilt_deg : largest angle between two boards so far, or None while nothing is known of the lens
    distance_mm : nearest and farthest board so far, or None likewise
    wishes : what is still wanted, most helpful first
    """

    phase: Phase
    index: int
    count: int
    left: CameraSighting
    right: CameraSighting
    verdict: ViewVerdict
    coverage_left: NDArray[np.bool_]
    coverage_right: NDArray[np.bool_]
    tilt_deg: float | None
    distance_mm: tuple[float, float] | None
    wishes: tuple[Wish, ...]

    def words(self) -> str:
        """One sentence on this view."""
        if self.verdict is ViewVerdict.TAKEN:
            return f"View {self.index + 1} of {self.count} taken."
        if self.verdict in (ViewVerdict.MISSED, ViewVerdict.ONE_CAMERA):
            missed = [f"{side} camera: {_WORDS[seen.reason]}" for side, seen in zip(SIDES, (self.left, self.right), strict=True) if seen.reason]
            return ("Seen by one camera only; " if self.verdict is ViewVerdict.ONE_CAMERA else "") + "; ".join(missed) + "."
        return {
            ViewVerdict.FEW_IN_COMMON: "Both cameras see the board, but not the same part of it.",
            ViewVerdict.TOO_SIMILAR: "Too similar to an earlier view; move or tilt the board.",
            ViewVerdict.MOVING: "Hold the board still.",
        }[self.verdict]


OnBoardWatch = Callable[[BoardWatch], None]

_WORDS = {
    BoardMissReason.TOO_DARK: "too dark",
    BoardMissReason.TOO_BRIGHT: "too bright",
    BoardMissReason.TOO_BLURRED: "blurred",
    BoardMissReason.NO_BOARD: "no board",
    BoardMissReason.CUT: "the board is cut by the image's border",
    BoardMissReason.TOO_FEW_CORNERS: "too few corners",
}


def sighting(seen: BoardView | BoardMiss) -> CameraSighting:
    """What one camera sees."""
    return CameraSighting(seen.corners, seen.reason) if isinstance(seen, BoardMiss) else CameraSighting(len(seen.ids), None, seen.corners_px)
