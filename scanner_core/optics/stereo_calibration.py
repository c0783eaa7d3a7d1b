"""Calibrates both cameras from views of the board, and judges the result on views that took no part.

Each camera alone first, then the pair by OpenCV, then all of it together with the board's own shape
(:mod:`scanner_core.optics.bundle_adjustment`): fixing the intrinsics of the single fits makes the stereo fit two to five
times worse, and a board that is believed to be flat puts its bend into the cameras.  fx and fy stay independent, for
pixels need not be square.  k3 is used only where the views ask for it: two parameters (one for each camera) have to
lower the weighted sum of squares by more than ``2 ln n`` (n residuals), the Bayesian information criterion (Schwarz,
Ann. Stat. 6, 1978); otherwise they would follow noise and swing out towards the borders.

The reprojection error of a fit says little about the fit (it stays at the corners' noise whatever their number), so
every `HOLD_OUT`-th view is kept back: its corners are triangulated, laid over the board by a rigid motion, and what
remains is an error in millimetres of space that no pose has seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import CalibrationError
from scanner_core.geometry.fitting import fit_rigid
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_view import MIN_CORNERS, BoardView
from scanner_core.optics.bundle_adjustment import STEREO, Bundle, BundleState, Corners, adjust, intrinsics_of
from scanner_core.optics.calibration import StereoCalibration, TurntableAxis
from scanner_core.optics.camera_model import CameraModel
from scanner_core.optics.stereo_view import StereoView
from scanner_core.optics.triangulation import CameraPair, Triangulator

Array = NDArray[np.float64]

MIN_VIEWS = 8
"""Views with the board in both cameras; fewer leave focal length, distance and distortion entangled."""
HOLD_OUT = 5
"""Every fifth view is kept back."""
MIN_TILT_DEG = 15.0
"""Boards that are all parallel leave the focal length undetermined (Zhang, PAMI 22, 2000): largest angle between two."""
MIN_COVERAGE = 0.25
"""Part of each image, in fields of an 8 x 6 grid, that must have held a corner: distortion is not extrapolated."""
MAX_REPROJECTION_PX = 0.3
"""Corners are read to 0.1 px even in poor light: more means that something moved."""
MAX_HELD_OUT_PX = 0.25
"""Largest held-out error, as a part of the size of a pixel at the board's distance: twice what corners read to 0.1 px make."""
MAX_SCALE_ERROR = 1e-3
"""Largest deviation of the held-out boards' size from the known one: 30 um on 30 mm."""
MIN_MOVE_PX = 5.0
"""Views that are closer than this to each other are one view."""
MAX_VIEWS_LEFT_OUT = 0.2
"""A hand slips once in a while; if more than a fifth of the views contradict the others, something has moved."""
_OUTLIER = 6.0
_OUTLIER_PX = 0.3
"""A corner farther from its place than six times the median, and than 0.3 px, was misread."""
_ROUNDS = 4


@dataclass(frozen=True, slots=True, eq=False)
class StereoCalibrationFit:
    """Two calibrated cameras; the rig frame is the left camera's.

    Attributes
    ----------
    views, held_out_views : used in the fit, and kept back
    views_left_out : in which the board moved between the cameras' exposures, or nothing was read right
    reprojection_rms_px : of the fit, per coordinate
    held_out_rms_um : three-dimensional rms of held-out corners against the board as it was fitted, after rigid alignment;
        it holds the corners' own noise, so the calibration itself is better than this
    held_out_scale : size of the held-out boards over the fitted one
    coverage : part of the image that held corners, the worse camera's
    corners_left_out : misread corners
    marks : (m, 3) mm, the board's corners as they were found to be, in its own frame
    board_bend_mm : from the lowest to the highest corner of the board
    corner_sigma_px : (2, 2) noise of the corners by camera and axis
    covariance : (24 + 3 m, 24 + 3 m) of the stereo parameters (see :mod:`scanner_core.optics.bundle_adjustment`) and the marks
    with_k3 : whether the views asked for k3
    """

    left: CameraModel
    right: CameraModel
    views: int
    held_out_views: int
    views_left_out: int
    reprojection_rms_px: float
    held_out_rms_um: float
    held_out_scale: float
    coverage: float
    corners_left_out: int
    marks: Array
    board_bend_mm: float
    corner_sigma_px: Array
    covariance: Array
    with_k3: bool

    def with_turntable(self, turntable: TurntableAxis, date: str) -> StereoCalibration:
        """The whole calibration of a rig; `date` is ISO 8601."""
        return StereoCalibration(self.left, self.right, turntable, date, self.views, self.reprojection_rms_px, self.held_out_rms_um)

    def scaled(self, factor: float) -> StereoCalibrationFit:
        """The same rig measured with a longer (> 1) or shorter yardstick: all lengths times `factor`, no angle changes."""
        right = replace(self.right, translation=factor * self.right.translation)
        stretch = np.ones(len(self.covariance))
        stretch[STEREO - 3 :] = factor
        covariance = stretch[:, None] * self.covariance * stretch
        return replace(
            self,
            right=right,
            marks=factor * self.marks,
            held_out_rms_um=factor * self.held_out_rms_um,
            board_bend_mm=factor * self.board_bend_mm,
            covariance=covariance,
        )


def calibrate_stereo(views: Sequence[StereoView], size_px: tuple[int, int], target: CharucoTarget) -> StereoCalibrationFit:
    """Intrinsics of both cameras and their relative pose.

    Parameters
    ----------
    views : of the board at different places and tilts, in any order
    size_px : width and height of both cameras' images
    target : the board as it was drawn

    Raises
    ------
    CalibrationError
        E-CAL-01 when the views are too few or too alike; E-CAL-05 when the cameras are exchanged; E-CAL-03 when the
        held-out error is too large.
    """
    usable = [view for view in views if len(view.common()[0]) >= MIN_CORNERS]
    if len(usable) < MIN_VIEWS:
        reason = f"{len(usable)} of {len(views)} views show the board to both cameras, at least {MIN_VIEWS} are needed"
        raise CalibrationError("E-CAL-01", reason=reason)
    if (moved_px := _largest_move_px(usable)) < MIN_MOVE_PX:
        raise CalibrationError("E-CAL-01", reason=f"the board was never moved (by {moved_px:.1f} px at most)")
    coverage = min(_coverage([getattr(view, side) for view in usable], size_px) for side in ("left", "right"))
    if coverage < MIN_COVERAGE:
        reason = f"the board covered only {100 * coverage:.0f} % of an image, at least {100 * MIN_COVERAGE:.0f} % are needed"
        raise CalibrationError("E-CAL-01", reason=reason)

    held_out = usable[HOLD_OUT - 1 :: HOLD_OUT]
    fitted = [view for i, view in enumerate(usable) if i % HOLD_OUT != HOLD_OUT - 1]
    try:
        bundle, used, with_k3, left_out = _adjust_views(fitted, size_px, target)
    except (cv2.error, np.linalg.LinAlgError) as fault:
        raise CalibrationError("E-CAL-01", reason="the views contradict each other", details=str(fault)) from fault
    left, right = bundle.state.cameras(size_px)
    if right.centre_mm()[0] < 0:
        raise CalibrationError("E-CAL-05")

    rms_px = float(np.sqrt(np.mean(bundle.residuals_px[used] ** 2)))
    if rms_px > MAX_REPROJECTION_PX:
        reason = f"the views contradict each other by {rms_px:.2f} px, at most {MAX_REPROJECTION_PX} px are allowed; did the board or a camera move?"
        raise CalibrationError("E-CAL-03", reason=reason)
    rms_um, scale, pixel_um, unread = _held_out_error(left, right, [view.common() for view in held_out], bundle.state.marks)
    if not rms_um <= MAX_HELD_OUT_PX * pixel_um:
        reason = f"corners that were not used are {rms_um:.0f} um off, at most {MAX_HELD_OUT_PX * pixel_um:.0f} um are allowed"
        raise CalibrationError("E-CAL-03", reason=reason)
    if abs(scale - 1) > MAX_SCALE_ERROR:
        raise CalibrationError("E-CAL-03", reason=f"boards that were not used measure {100 * (scale - 1):+.2f} % of their size too much")
    return StereoCalibrationFit(
        left=left,
        right=right,
        views=len(fitted) - left_out,
        held_out_views=len(held_out) - unread,
        views_left_out=left_out + unread,
        reprojection_rms_px=rms_px,
        held_out_rms_um=rms_um,
        held_out_scale=scale,
        coverage=coverage,
        corners_left_out=int(np.count_nonzero(~used)),
        marks=bundle.state.marks,
        board_bend_mm=float(np.ptp(bundle.state.marks[:, 2])),
        corner_sigma_px=bundle.sigma_px,
        covariance=bundle.covariance,
        with_k3=with_k3,
    )


Pair = tuple[NDArray[np.int64], Array, Array]


def _start(views: Sequence[StereoView], size_px: tuple[int, int], target: CharucoTarget) -> BundleState:
    """OpenCV's solution for a flat board: each camera alone, then the pair."""
    points = target.object_points.astype(np.float32)
    alone = [_calibrate_camera([getattr(view, side) for view in views], size_px, target) for side in ("left", "right")]
    pairs = [view.common() for view in views]
    solution = cv2.stereoCalibrateExtended(
        [points[ids] for ids, _, _ in pairs],
        [left.astype(np.float32) for _, left, _ in pairs],
        [right.astype(np.float32) for _, _, right in pairs],
        alone[0].matrix.copy(),
        alone[0].distortion.copy(),
        alone[1].matrix.copy(),
        alone[1].distortion.copy(),
        size_px,
        np.eye(3),
        np.zeros(3),
        flags=cv2.CALIB_USE_INTRINSIC_GUESS | cv2.CALIB_FIX_K3,
        criteria=(cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 30, 1e-6),
    )
    _, left_matrix, left_distortion, right_matrix, right_distortion, rotation, translation, _, _, rvecs, tvecs, _ = solution
    left = CameraModel(np.asarray(left_matrix, np.float64), _five(left_distortion), np.eye(3), np.zeros(3), size_px)
    right = CameraModel(np.asarray(right_matrix, np.float64), _five(right_distortion), np.eye(3), np.zeros(3), size_px)
    return BundleState(
        np.stack([intrinsics_of(left), intrinsics_of(right)]),
        RigidTransform(np.asarray(rotation, np.float64), np.ravel(translation).astype(np.float64)),
        np.stack([np.asarray(cv2.Rodrigues(r)[0], np.float64) for r in rvecs]),
        np.stack([np.ravel(t).astype(np.float64) for t in tvecs]),
        target.object_points,
    )


def _calibrate_camera(views: Sequence[BoardView], size_px: tuple[int, int], target: CharucoTarget) -> CameraModel:
    points = target.object_points.astype(np.float32)
    _, matrix, distortion, _, _ = cv2.calibrateCamera(
        [points[view.ids] for view in views],
        [view.corners_px.astype(np.float32) for view in views],
        size_px,
        np.eye(3),
        np.zeros(5),
        flags=cv2.CALIB_FIX_K3,
    )
    return CameraModel(np.asarray(matrix, np.float64), _five(distortion), np.eye(3), np.zeros(3), size_px)


def _adjust_views(views: Sequence[StereoView], size_px: tuple[int, int], target: CharucoTarget) -> tuple[Bundle, NDArray[np.bool_], bool, int]:
    """The joint fit without views that contradict the others, see :func:`_adjust_clean`, and how many of them were left out."""
    kept = list(views)
    while True:
        start = _start(kept, size_px, target)
        if (tilt_deg := _largest_tilt_deg(start.rotations)) < MIN_TILT_DEG:
            raise CalibrationError("E-CAL-01", reason=f"the board was tilted by only {tilt_deg:.0f} degrees, at least {MIN_TILT_DEG:.0f} are needed")
        adjusted = _adjust_clean(Corners.of(kept), start)
        if isinstance(adjusted, tuple):
            return *adjusted, len(views) - len(kept)
        kept = [view for index, view in enumerate(kept) if index not in adjusted]
        if len(views) - len(kept) > MAX_VIEWS_LEFT_OUT * len(views):
            raise CalibrationError("E-CAL-03", reason="the views contradict each other; did the board or a camera move?")


def _adjust_clean(corners: Corners, start: BundleState) -> tuple[Bundle, NDArray[np.bool_], bool] | set[int]:
    """The joint fit without misread corners, which corners took part, and whether k3 did; or the views that contradict the others.

    Every round judges all corners anew, for a misread one bends the first fit and makes its neighbours look wrong.
    """
    used = np.ones(len(corners), bool)
    bundle = adjust(corners, start, used, with_k3=False)
    for _ in range(_ROUNDS):
        judged = np.abs(bundle.residuals_px).max(axis=1)
        good = judged <= max(_OUTLIER * float(np.median(judged)), _OUTLIER_PX)
        if (good == used).all():
            break
        seen = np.zeros((2, len(start.rotations)), int)
        np.add.at(seen, (corners.camera[good], corners.view[good]), 1)
        if (contradict := seen.min(axis=0) < MIN_CORNERS // 2).any():
            return set(np.flatnonzero(contradict).tolist())
        used = good
        bundle = adjust(corners, bundle.state, used, with_k3=False)
    without, with_it = (adjust(corners, bundle.state, used, with_k3=k3, sigma_px=bundle.sigma_px).misfit for k3 in (False, True))
    if without - with_it > 2 * np.log(2 * np.count_nonzero(used)):
        return adjust(corners, bundle.state, used, with_k3=True), used, True
    return bundle, used, False


def _five(distortion: object) -> Array:
    return np.ravel(np.asarray(distortion, np.float64))[:5]


def _coverage(views: Sequence[BoardView], size_px: tuple[int, int]) -> float:
    cells = np.zeros((6, 8), bool)
    for view in views:
        at = view.corners_px / size_px * (8, 6)
        cells[at[:, 1].astype(int).clip(0, 5), at[:, 0].astype(int).clip(0, 7)] = True
    return float(cells.mean())


def _largest_move_px(views: Sequence[StereoView]) -> float:
    """How far a corner of any view lies from its place in the first view, at most; in views that share none it moved far."""
    first, largest = views[0].left, 0.0
    for view in views[1:]:
        _, here, there = np.intersect1d(first.ids, view.left.ids, assume_unique=True, return_indices=True)
        if not len(here):
            return np.inf
        largest = max(largest, float(np.abs(first.corners_px[here] - view.left.corners_px[there]).max()))
    return largest


def _largest_tilt_deg(rotations: Array) -> float:
    normals = rotations[:, :, 2]
    return float(np.degrees(np.arccos(np.clip(normals @ normals.T, -1, 1))).max())


def _held_out_error(left: CameraModel, right: CameraModel, held_out: Sequence[Pair], marks: Array) -> tuple[float, float, float, int]:
    """Rms error in um and scale of the held-out boards, the size of a pixel at their distance in um, and views not judged.

    A single view whose two images do not belong together at all (by its epipolar residuals, which are not what is judged)
    is left out like a misread corner.
    """
    triangulator = Triangulator(CameraPair(left, right))
    squares, count, measured, known, depths = 0.0, 0, 0.0, 0.0, []
    seen = []
    for ids, left_px, right_px in held_out:
        sigma = np.ones(len(ids))
        triangulated = triangulator.triangulate(left_px, right_px, sigma, sigma)
        seen.append((ids, triangulated, np.abs(triangulated.epipolar_residual_px)))
    typical = [float(np.median(epipolar)) for _, _, epipolar in seen]
    limit = max(_OUTLIER * float(np.median(typical)), _OUTLIER_PX)
    unread = [index for index, value in enumerate(typical) if value > limit]
    for index, (ids, triangulated, epipolar) in enumerate(seen):
        if len(unread) == 1 and index in unread:
            continue
        read = epipolar <= max(_OUTLIER * float(np.median(epipolar)), _OUTLIER_PX)  # as a scan would reject a misread pair
        found, board = triangulated.points[read], marks[ids[read]]
        laid = fit_rigid(found, board).apply(found)
        squares += float(np.sum((laid - board) ** 2))
        count += len(found)
        about = board - board.mean(axis=0)
        measured += float(np.sum(about * (laid - laid.mean(axis=0))))
        known += float(np.sum(about * about))
        depths.append(float(found[:, 2].mean()))
    pixel_um = 1e3 * float(np.mean(depths)) / min(left.matrix[0, 0], left.matrix[1, 1])
    return 1e3 * float(np.sqrt(squares / count)), measured / known, pixel_um, int(len(unread) == 1)
