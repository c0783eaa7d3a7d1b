"""How views of the board add up: which are new, what they cover, how far they are tilted, and what is still wanted."""

from __future__ import annotations

from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_view import MIN_CORNERS, BoardMiss, BoardView
from scanner_core.optics.board_watch import FIELDS, SIDES, Side, ViewVerdict, Wish, WishKind
from scanner_core.optics.camera_model import CameraModel
from scanner_core.optics.stereo_view import StereoView

NEW_VIEW = 0.02
"""A view is new when its corners lie in the median this far, as a part of the image's width, from those of every earlier one."""
WANTED_TILT_DEG = 30.0
WANTED_DISTANCE = 1.15
"""Farthest over nearest board."""
_NO_CORNERS = np.empty(0, np.int64)
_FEW_VIEWS = 4
"""Views before which nothing is known of tilts without an earlier calibration."""


def judge(
    left: BoardView | BoardMiss, right: BoardView | BoardMiss, earlier: list[StereoView], width_px: int, needed: NDArray[np.int64] = _NO_CORNERS
) -> StereoView | ViewVerdict:
    """The view, or why it is of no use; `earlier` are the views that it must differ from, `needed` the corners that both must see."""
    missed = [isinstance(seen, BoardMiss) for seen in (left, right)]
    if isinstance(left, BoardMiss) or isinstance(right, BoardMiss):
        return ViewVerdict.MISSED if all(missed) else ViewVerdict.ONE_CAMERA
    view = StereoView(left, right)
    ids = view.common()[0]
    if len(ids) < MIN_CORNERS or not np.isin(needed, ids).all():
        return ViewVerdict.FEW_IN_COMMON
    if any(moved_px(view, other) < NEW_VIEW * width_px for other in earlier):
        return ViewVerdict.TOO_SIMILAR
    return view


def moved_px(view: StereoView, other: StereoView) -> float:
    """How far the corners of the left image lie from those of another view, median; far when no corner is in both."""
    _, here, there = np.intersect1d(view.left.ids, other.left.ids, assume_unique=True, return_indices=True)
    if not len(here):
        return np.inf
    return float(np.median(np.linalg.norm(view.left.corners_px[here] - other.left.corners_px[there], axis=1)))


@dataclass(slots=True, eq=False)
class CoverageSoFar:
    """Adds up what the views of the board have covered.

    `lens` is the left camera as it was calibrated before; without it the lens is guessed from the first views (Zhang's
    closed form with the principal point in the middle), which is good enough to tell tilts.
    """

    target: CharucoTarget
    size_px: tuple[int, int]
    wanted: int
    lens: CameraModel | None = None
    views: list[StereoView] = field(default_factory=list)

    def grid(self, side: Side) -> NDArray[np.bool_]:
        """(6, 8) fields that have held a corner."""
        cells = np.zeros(FIELDS, bool)
        for view in self.views:
            at = (getattr(view, side).corners_px / self.size_px * FIELDS[::-1]).astype(int)
            cells[at[:, 1].clip(0, FIELDS[0] - 1), at[:, 0].clip(0, FIELDS[1] - 1)] = True
        return cells

    def poses(self) -> list[RigidTransform]:
        """Board to left camera by every view, as far as the lens is known; empty otherwise."""
        points = self.target.object_points.astype(np.float32)
        if self.lens is not None:
            matrix, distortion = self.lens.matrix, self.lens.distortion
        elif len(self.views) >= _FEW_VIEWS:
            boards = [points[view.left.ids] for view in self.views]
            seen = [view.left.corners_px.astype(np.float32) for view in self.views]
            matrix = np.asarray(cv2.initCameraMatrix2D(boards, seen, self.size_px, 0), np.float64)
            distortion = np.zeros(5)
        else:
            return []
        poses = []
        for view in self.views:
            found, turn, shift = cv2.solvePnP(points[view.left.ids], view.left.corners_px, matrix, distortion, flags=cv2.SOLVEPNP_IPPE)
            if found:
                poses.append(RigidTransform.from_vector(np.ravel(turn), np.ravel(shift)))
        return poses

    def spread(self) -> tuple[float | None, tuple[float, float] | None]:
        """Largest angle between two boards in degrees, and the nearest and farthest board's distance in mm."""
        poses = self.poses()
        if not poses:
            return None, None
        normals = np.array([pose.rotation[:, 2] for pose in poses])
        tilt_deg = float(np.degrees(np.arccos(np.clip(normals @ normals.T, -1, 1))).max())
        middle = np.array([*(0.5 * np.array(self.target.size_mm)), 0.0])
        distances = [float(np.linalg.norm(pose.apply(middle))) for pose in poses]
        return tilt_deg, (min(distances), max(distances))

    def wishes(self, tilt_deg: float | None, distance_mm: tuple[float, float] | None) -> tuple[Wish, ...]:
        """What is still wanted."""
        wanted = []
        if tilt_deg is not None and tilt_deg < WANTED_TILT_DEG:
            wanted.append(Wish(WishKind.TILT_MORE))
        for side in SIDES:
            cells = self.grid(side)
            for row, rows in ((-1, slice(0, 2)), (0, slice(2, 4)), (1, slice(4, 6))):
                for column, columns in ((-1, slice(0, 3)), (0, slice(3, 5)), (1, slice(5, 8))):
                    if not cells[rows, columns].any():
                        wanted.append(Wish(WishKind.COVER, side, row, column))
        if distance_mm is not None and distance_mm[1] < WANTED_DISTANCE * distance_mm[0]:
            wanted.append(Wish(WishKind.VARY_DISTANCE))
        if len(self.views) < self.wanted:
            wanted.append(Wish(WishKind.MORE_VIEWS, count=self.wanted - len(self.views)))
        return tuple(wanted)
