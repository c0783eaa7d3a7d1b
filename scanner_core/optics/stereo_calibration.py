"""Calibrates both cameras from views of the board, and judges the result on views that took no part.

Each camera alone first, then all intrinsics and the relative pose together: fixing the intrinsics of the single fits
makes the stereo fit two to five times worse.  fx and fy stay independent, for pixels need not be square; k3 is left out,
for the two frames of a moderate lens cannot tell it from k2.

The reprojection error of a fit says little about the fit (it stays at the corners' noise whatever their number), so
every `HOLD_OUT`-th view is kept back: its corners are triangulated, laid over the known board by a rigid motion, and
what remains is an error in millimetres of space that no parameter has seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import CalibrationError
from scanner_core.geometry.fitting import fit_rigid
from scanner_core.jobs.progress import OnProgress, Progress
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_detection import MIN_CORNERS, BoardView
from scanner_core.optics.calibration import StereoCalibration, TurntableAxis
from scanner_core.optics.camera_model import CameraModel
from scanner_core.optics.triangulation import Triangulator

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
_OUTLIER = 6.0
_OUTLIER_PX = 0.3
"""A corner farther from its place than six times the median, and than 0.3 px, was misread."""
_ROUNDS = 4


@dataclass(frozen=True, slots=True, eq=False)
class StereoView:
    """The board in both cameras at one instant."""

    left: BoardView
    right: BoardView

    def common(self) -> tuple[NDArray[np.int64], Array, Array]:
        """Ids (n,) of the corners that both cameras see, and their pixels (n, 2) in the left and the right."""
        ids, at_left, at_right = np.intersect1d(self.left.ids, self.right.ids, assume_unique=True, return_indices=True)
        return ids, self.left.corners_px[at_left], self.right.corners_px[at_right]


@dataclass(frozen=True, slots=True, eq=False)
class StereoCalibrationFit:
    """Two calibrated cameras; the rig frame is the left camera's.

    Attributes
    ----------
    views, held_out_views : used in the fit, and kept back
    reprojection_rms_px : of the fit, per coordinate
    held_out_rms_um : three-dimensional rms of held-out corners against the known board, after rigid alignment; it holds
        the corners' own noise, so the calibration itself is better than this
    held_out_scale : size of the held-out boards over the known one
    coverage : part of the image that held corners, the worse camera's
    corners_left_out : misread corners
    """

    left: CameraModel
    right: CameraModel
    views: int
    held_out_views: int
    reprojection_rms_px: float
    held_out_rms_um: float
    held_out_scale: float
    coverage: float
    corners_left_out: int
    notes: dict[str, float] = field(default_factory=dict)

    def with_turntable(self, turntable: TurntableAxis, date: str) -> StereoCalibration:
        """The whole calibration of a rig; `date` is ISO 8601."""
        notes = {"held_out_scale": self.held_out_scale, "held_out_views": float(self.held_out_views), "coverage": self.coverage, **self.notes}
        return StereoCalibration(self.left, self.right, turntable, date, self.views, self.reprojection_rms_px, self.held_out_rms_um, notes)


def calibrate_stereo(
    views: Sequence[StereoView], size_px: tuple[int, int], target: CharucoTarget, *, progress: OnProgress | None = None
) -> StereoCalibrationFit:
    """Intrinsics of both cameras and their relative pose.

    Parameters
    ----------
    views : of the board at different places and tilts, in any order
    size_px : width and height of both cameras' images
    target : the board

    Raises
    ------
    CalibrationError
        E-CAL-01 when the views are too few or too alike, E-CAL-03 when the held-out error is too large.
    """
    usable = [view for view in views if len(view.common()[0]) >= MIN_CORNERS]
    if len(usable) < MIN_VIEWS:
        reason = f"{len(usable)} of {len(views)} views show the board to both cameras, at least {MIN_VIEWS} are needed"
        raise CalibrationError("E-CAL-01", reason=reason)
    coverage = min(_coverage([getattr(view, side) for view in usable], size_px) for side in ("left", "right"))
    if coverage < MIN_COVERAGE:
        reason = f"the board covered only {100 * coverage:.0f} % of an image, at least {100 * MIN_COVERAGE:.0f} % are needed"
        raise CalibrationError("E-CAL-01", reason=reason)

    held_out = usable[HOLD_OUT - 1 :: HOLD_OUT]
    fitted = [view for i, view in enumerate(usable) if i % HOLD_OUT != HOLD_OUT - 1]
    tell = progress or (lambda _: None)
    tell(Progress("calibrate", 0.0))
    try:
        starts = [_calibrate_camera([getattr(view, side) for view in fitted], size_px, target) for side in ("left", "right")]
        tell(Progress("calibrate", 0.3))
        fit, left_out = _calibrate_clean([view.common() for view in fitted], starts, size_px, target)
    except cv2.error as fault:
        raise CalibrationError("E-CAL-01", reason="the views contradict each other", details=str(fault)) from fault
    if (tilt_deg := _largest_tilt_deg(fit.rotations)) < MIN_TILT_DEG:
        raise CalibrationError("E-CAL-01", reason=f"the board was tilted by only {tilt_deg:.0f} degrees, at least {MIN_TILT_DEG:.0f} are needed")

    rms_px = float(np.sqrt(np.mean(np.concatenate(fit.errors_px) ** 2)))
    if rms_px > MAX_REPROJECTION_PX:
        reason = f"the views contradict each other by {rms_px:.2f} px, at most {MAX_REPROJECTION_PX} px are allowed; did the board or a camera move?"
        raise CalibrationError("E-CAL-03", reason=reason)
    rms_um, scale, pixel_um = _held_out_error(fit, [view.common() for view in held_out], target)
    if not rms_um <= MAX_HELD_OUT_PX * pixel_um:
        reason = f"corners that were not used are {rms_um:.0f} um off, at most {MAX_HELD_OUT_PX * pixel_um:.0f} um are allowed"
        raise CalibrationError("E-CAL-03", reason=reason)
    if abs(scale - 1) > MAX_SCALE_ERROR:
        raise CalibrationError("E-CAL-03", reason=f"boards that were not used measure {100 * (scale - 1):+.2f} % of their size too much")
    tell(Progress("calibrate", 1.0))
    return StereoCalibrationFit(fit.left, fit.right, len(fitted), len(held_out), rms_px, rms_um, scale, coverage, left_out)


Pair = tuple[NDArray[np.int64], Array, Array]


@dataclass(frozen=True, slots=True, eq=False)
class _PairFit:
    left: CameraModel
    right: CameraModel
    rotations: list[Array]
    translations: list[Array]
    errors_px: list[Array]
    """By view."""


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


def _calibrate_clean(pairs: Sequence[Pair], starts: Sequence[CameraModel], size_px: tuple[int, int], target: CharucoTarget) -> tuple[_PairFit, int]:
    """The joint fit without misread corners, and their number.

    Every round judges all corners anew, for a misread one bends the first fit and makes its neighbours look wrong.
    """
    fit = _calibrate_pair(pairs, starts, size_px, target)
    left_out = 0
    for _ in range(_ROUNDS):
        views = zip(fit.rotations, fit.translations, pairs, strict=True)
        judged = [np.abs(_errors(fit, turn, t, pair, target)).max(axis=1) for turn, t, pair in views]
        limit = max(_OUTLIER * float(np.median(np.concatenate(judged))), _OUTLIER_PX)
        good = [size <= limit for size in judged]
        wrong = sum(int(np.count_nonzero(~g)) for g in good)
        if wrong == left_out:
            break
        if min(int(np.count_nonzero(g)) for g in good) < MIN_CORNERS // 2:
            raise CalibrationError("E-CAL-01", reason="the views contradict each other: did the board or a camera move?")
        left_out = wrong
        kept = [(ids[g], left[g], right[g]) for g, (ids, left, right) in zip(good, pairs, strict=True)]
        fit = _calibrate_pair(kept, [fit.left, fit.right], size_px, target)
    return fit, left_out


def _calibrate_pair(pairs: Sequence[Pair], starts: Sequence[CameraModel], size_px: tuple[int, int], target: CharucoTarget) -> _PairFit:
    points = target.object_points.astype(np.float32)
    solution = cv2.stereoCalibrateExtended(
        [points[ids] for ids, _, _ in pairs],
        [left.astype(np.float32) for _, left, _ in pairs],
        [right.astype(np.float32) for _, _, right in pairs],
        starts[0].matrix.copy(),
        starts[0].distortion.copy(),
        starts[1].matrix.copy(),
        starts[1].distortion.copy(),
        size_px,
        np.eye(3),
        np.zeros(3),
        flags=cv2.CALIB_USE_INTRINSIC_GUESS | cv2.CALIB_FIX_K3,
        criteria=(cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 100, 1e-9),
    )
    _, left_matrix, left_distortion, right_matrix, right_distortion, rotation, translation, _, _, rvecs, tvecs, _ = solution
    left = CameraModel(np.asarray(left_matrix, np.float64), _five(left_distortion), np.eye(3), np.zeros(3), size_px)
    right = CameraModel(np.asarray(right_matrix, np.float64), _five(right_distortion), np.asarray(rotation), np.ravel(translation), size_px)
    rotations = [np.asarray(cv2.Rodrigues(r)[0], np.float64) for r in rvecs]
    fit = _PairFit(left, right, rotations, [np.ravel(t) for t in tvecs], [])
    fit.errors_px.extend(_errors(fit, turn, t, pair, target) for turn, t, pair in zip(fit.rotations, fit.translations, pairs, strict=True))
    return fit


def _errors(fit: _PairFit, rotation: Array, translation: Array, pair: Pair, target: CharucoTarget) -> Array:
    """Reprojection errors of a view, (n, 4) px: left x, y, right x, y."""
    ids, left_px, right_px = pair
    in_rig = target.object_points[ids] @ rotation.T + translation
    return np.hstack([fit.left.project(in_rig) - left_px, fit.right.project(in_rig) - right_px])


def _five(distortion: object) -> Array:
    return np.ravel(np.asarray(distortion, np.float64))[:5]


def _coverage(views: Sequence[BoardView], size_px: tuple[int, int]) -> float:
    cells = np.zeros((6, 8), bool)
    for view in views:
        at = view.corners_px / size_px * (8, 6)
        cells[at[:, 1].astype(int).clip(0, 5), at[:, 0].astype(int).clip(0, 7)] = True
    return float(cells.mean())


def _largest_tilt_deg(rotations: Sequence[Array]) -> float:
    normals = np.array([rotation[:, 2] for rotation in rotations])
    return float(np.degrees(np.arccos(np.clip(normals @ normals.T, -1, 1))).max())


def _held_out_error(fit: _PairFit, held_out: Sequence[Pair], target: CharucoTarget) -> tuple[float, float, float]:
    """Rms error in um and scale of the held-out boards, and the size of a pixel at their distance in um."""
    triangulator = Triangulator(StereoCalibration(fit.left, fit.right, TurntableAxis(np.zeros(3), np.array([0, -1.0, 0])), "", 0, 0.0, 0.0))
    squares, count, measured, known, depths = 0.0, 0, 0.0, 0.0, []
    for ids, left_px, right_px in held_out:
        sigma = np.ones(len(ids))
        triangulated = triangulator.triangulate(left_px, right_px, sigma, sigma)
        epipolar = np.abs(triangulated.epipolar_residual_px)
        read = epipolar <= max(_OUTLIER * float(np.median(epipolar)), _OUTLIER_PX)  # as a scan would reject a misread pair
        found, board = triangulated.points[read], target.object_points[ids[read]]
        laid = fit_rigid(found, board).apply(found)
        squares += float(np.sum((laid - board) ** 2))
        count += len(found)
        about = board - board.mean(axis=0)
        measured += float(np.sum(about * (laid - laid.mean(axis=0))))
        known += float(np.sum(about * about))
        depths.append(float(found[:, 2].mean()))
    pixel_um = 1e3 * float(np.mean(depths)) / min(fit.left.matrix[0, 0], fit.left.matrix[1, 1])
    return 1e3 * float(np.sqrt(squares / count)), measured / known, pixel_um
