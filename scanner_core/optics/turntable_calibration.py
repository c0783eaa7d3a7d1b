"""Where the turntable's axis is, from a board that lies flat on it at known angles.

All corners of all angles are fitted at once by a pose of the board at 0 degrees, a direction and a place of the axis,
and an error of the reported angle for each view, each corner weighted by its triangulation covariance.  The angles are
free because nothing about the axis is lost by it (the views themselves tell how far the table has turned, to a
thousandth of a degree), so that backlash and lost steps do not pull on the axis; they are stated instead.  The board is
as bent as the stereo calibration has found it to be.

The sense of rotation and the angle's scale are checked first against the angles that the controller reported, on the
poses of the board alone: an axis can be fitted to a table that turns the wrong way, and every scan would then be torn.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from scanner_core.errors import CalibrationError
from scanner_core.geometry.fitting import fit_rigid
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_view import MIN_CORNERS
from scanner_core.optics.bundle_adjustment import STEREO, moved_cameras
from scanner_core.optics.calibration import TurntableAxis
from scanner_core.optics.stereo_calibration import Pair, StereoCalibrationFit
from scanner_core.optics.stereo_view import StereoView
from scanner_core.optics.triangulation import CameraPair, Triangulator

Array = NDArray[np.float64]

MIN_ANGLES = 6
MAX_GAP_DEG = 120.0
"""Largest gap between neighbouring angles: an arc of a few degrees leaves the axis' place undetermined."""
MAX_ANGLE_RMS_DEG = 0.1
MAX_POSITION_RMS_UM = 300.0
MAX_BOARD_TILT_DEG = 10.0
"""A board that leans more does not lie flat."""
_SCALE_TOLERANCE = 0.02
"""Deviation of the turned from the reported angle that is still put down to noise, 2 %."""
_ANGLE_PRIOR_DEG = 1.0
"""Of a view's error of angle: no more than what keeps board and angles from turning together."""
_LEAST_SIGMA_PX = 1e-3
"""Corners without noise (in tests) must not divide by zero."""


@dataclass(frozen=True, slots=True, eq=False)
class TableView:
    """The board on the table: what both cameras see, and the table's angle as the controller reported it."""

    table_deg: float
    stereo: StereoView


@dataclass(frozen=True, slots=True, eq=False)
class TurntableFit:
    """The axis, and how sure it is.

    Attributes
    ----------
    axis : in the rig frame
    table_deg, angle_errors_deg : (n,) the reported angles, and how far the table stood beyond them, less their median
    noise_covariance : (6, 6) of the axis' origin (mm) and direction, from the scatter of the views alone
    induced : (k, 6) how origin and direction move with each of the k steps of the stereo parameters that were asked for
    """

    axis: TurntableAxis
    table_deg: Array
    angle_errors_deg: Array
    noise_covariance: Array
    induced: Array


@dataclass(frozen=True, slots=True, eq=False)
class _Measured:
    table_deg: float
    points: Array
    """(n, 3) mm, rig frame."""
    whitening: Array
    """(n, 3, 3): whitening @ residual has unit variance."""
    board: Array
    """(n, 3) mm, the same corners in the board's frame."""


def calibrate_turntable(
    fit: StereoCalibrationFit, views: Sequence[TableView], target: CharucoTarget, *, board_thickness_mm: float = 0.0, steps: Array | None = None
) -> TurntableFit:
    """The axis in the rig frame, pointing up, its origin where it meets the table.

    Parameters
    ----------
    fit : the calibrated cameras, and the board as they have found it
    views : the board flat on the table, face up, at six or more angles around the turn
    target : the board as it was drawn; it says how far the board goes on beyond its corners, where it rests on the table
    board_thickness_mm : from the table's surface to the printed face
    steps : (k, 24 + 3 m) changes of the stereo parameters and the board's marks whose effect on the axis is asked for

    Returns
    -------
    TurntableFit
        The axis' residuals are what single views still deviate from the common axis: `angle_rms_deg` about the axis
        (errors of the reported angle), and `position_rms_um` per coordinate of the board's centre.

    Raises
    ------
    CalibrationError
        E-CAL-01 when the views do not determine an axis, or the table does not turn as it reports; E-CAL-03 when the
        residuals are too large.
    """
    usable = [view for view in views if len(view.stereo.common()[0]) >= MIN_CORNERS]
    if len(usable) < MIN_ANGLES:
        reason = f"{len(usable)} of {len(views)} views show the board on the table to both cameras, at least {MIN_ANGLES} are needed"
        raise CalibrationError("E-CAL-01", reason=reason)
    turned = np.sort([view.table_deg % 360 for view in usable])
    gap_deg = float(np.diff(np.append(turned, turned[0] + 360)).max())
    if gap_deg > MAX_GAP_DEG:
        raise CalibrationError("E-CAL-01", reason=f"no view of the board on the table over {gap_deg:.0f} degrees of the turn")

    measured = [_measure(fit, view) for view in usable]
    poses = [fit_rigid(view.board, view.points) for view in measured]
    direction = _direction(poses, measured)
    _check_sense(poses, measured, direction)
    turn = _Turn(measured, direction, poses, target, board_thickness_mm)
    found, jacobian = turn.solve()
    axis = turn.axis(found, fit.marks)
    pose = turn.unpack(found)[2]
    tilt_deg = float(np.degrees(np.arccos(np.clip(-pose.rotation[:, 2] @ axis[3:], -1, 1))))
    if tilt_deg > MAX_BOARD_TILT_DEG:
        raise CalibrationError("E-CAL-01", reason=f"the board leans by {tilt_deg:.0f} degrees against the table's axis; lay it flat on the table")
    errors_deg = turn.unpack(found)[3]
    errors_deg = errors_deg - np.median(errors_deg)
    angle_rms_deg, position_rms_um = float(np.sqrt(np.mean(errors_deg**2))), turn.position_rms_um(found)
    if not (angle_rms_deg <= MAX_ANGLE_RMS_DEG and position_rms_um <= MAX_POSITION_RMS_UM):
        worst = int(np.argmax(np.abs(errors_deg)))
        reason = (
            f"the table strays by {angle_rms_deg:.2f} degrees and {position_rms_um:.0f} um from turning about one axis, "
            f"most at {measured[worst].table_deg:.0f} degrees by {errors_deg[worst]:+.2f} degrees"
        )
        raise CalibrationError("E-CAL-03", reason=reason)

    residual = turn.residual(found)
    corners = 3 * sum(len(view.points) for view in measured)
    scatter = float(residual[:corners] @ residual[:corners]) / max(corners - 10, 1)
    normal = np.linalg.inv(jacobian.T @ jacobian)
    by_unknown = np.stack([turn.axis(found + step, fit.marks) - axis for step in 1e-4 * np.eye(len(found))]) / 1e-4
    induced = np.zeros((0 if steps is None else len(steps), 6))
    pairs = [view.stereo.common() for view in usable]
    for row, step in enumerate(() if steps is None else steps):
        moved = turn.moved_by(found, fit, pairs, step)
        change = -normal @ (jacobian.T @ (moved - residual))
        marks = fit.marks + step[STEREO:].reshape(-1, 3)
        induced[row] = turn.axis(found + change, marks) - axis
    return TurntableFit(
        TurntableAxis(axis[:3] - turn.down_to_table_mm(found, fit.marks) * axis[3:], axis[3:], angle_rms_deg, position_rms_um),
        np.array([view.table_deg for view in measured]),
        errors_deg,
        scatter * by_unknown.T @ normal @ by_unknown,
        induced,
    )


def _triangulator(fit: StereoCalibrationFit, step: Array | None = None) -> Triangulator:
    return Triangulator(fit if step is None else CameraPair(*moved_cameras(fit.left, fit.right, step)))


def _measure(fit: StereoCalibrationFit, view: TableView) -> _Measured:
    ids, left_px, right_px = view.stereo.common()
    sigma_px = np.maximum(np.sqrt((fit.corner_sigma_px**2).mean(axis=1)), _LEAST_SIGMA_PX)
    found = _triangulator(fit).triangulate(left_px, right_px, *(np.full(len(ids), sigma) for sigma in sigma_px))
    whitening = np.linalg.inv(np.linalg.cholesky(found.covariances))
    return _Measured(view.table_deg, found.points, whitening, fit.marks[ids])


def _turns(poses: Sequence[RigidTransform], measured: Sequence[_Measured]) -> tuple[Array, Array]:
    """Rotation vectors (n, 3) in degrees between views, and the reported angles (n,), of pairs 20 to 160 degrees apart."""
    vectors, angles = [], []
    for i, a in enumerate(measured):
        for j in range(i):
            angle = (a.table_deg - measured[j].table_deg + 180) % 360 - 180
            if 20 <= abs(angle) <= 160:
                turn = RigidTransform(poses[i].rotation @ poses[j].rotation.T, np.zeros(3))
                skew = turn.rotation - turn.rotation.T
                vector = np.array([skew[2, 1], skew[0, 2], skew[1, 0]])
                vectors.append(vector / max(float(np.linalg.norm(vector)), 1e-12) * turn.angle_deg())
                angles.append(angle)
    return np.array(vectors), np.array(angles)


def _direction(poses: Sequence[RigidTransform], measured: Sequence[_Measured]) -> Array:
    """The line of all turns, pointing to the side that the board's face looks to."""
    vectors, _ = _turns(poses, measured)
    direction = np.linalg.eigh(vectors.T @ vectors)[1][:, -1]
    face = -np.mean([pose.rotation[:, 2] for pose in poses], axis=0)
    return np.asarray(direction * np.sign(direction @ face), np.float64)


def _check_sense(poses: Sequence[RigidTransform], measured: Sequence[_Measured], direction: Array) -> None:
    vectors, angles = _turns(poses, measured)
    if float(np.median(np.linalg.norm(vectors, axis=1))) < 1.0:
        raise CalibrationError("E-CAL-01", reason="the table reports that it turns, but the board stands still")
    ratios = vectors @ direction / angles
    ratio = float(np.median(ratios))
    spread = float(np.median(np.abs(ratios - ratio)))
    if abs(ratio + 1) < _SCALE_TOLERANCE and spread < _SCALE_TOLERANCE:
        reason = "the table turns clockwise seen from above where it reports counter-clockwise; reverse its axis in the controller's settings"
        raise CalibrationError("E-CAL-01", reason=reason)
    if abs(ratio - 1) > _SCALE_TOLERANCE or spread > _SCALE_TOLERANCE:
        reason = f"the table does not turn as it reports (it turns {ratio:.2f} degrees per degree reported, scattered by {spread:.2f})"
        raise CalibrationError("E-CAL-01", reason=f"{reason}; check its steps per degree and that nothing slips")


def _about(direction: Array, place: Array, angle_deg: float) -> RigidTransform:
    """Rotation about the line through `place`."""
    turn = RigidTransform.from_vector(np.radians(angle_deg) * direction, np.zeros(3))
    return RigidTransform(turn.rotation, place - turn.rotation @ place)


class _Turn:
    """The fit of all views; unknowns are the axis' tilt (2, rad) and place (2, mm), the board's pose at 0 degrees (6), and
    an error of every view's angle (rad)."""

    def __init__(
        self, measured: Sequence[_Measured], direction: Array, poses: Sequence[RigidTransform], target: CharucoTarget, thickness_mm: float
    ) -> None:
        self._outline, self._thickness_mm = _Outline(target), thickness_mm
        self._measured, self._direction = measured, direction
        self._table_deg = np.array([view.table_deg for view in measured])
        self._view = np.repeat(np.arange(len(measured)), [len(view.points) for view in measured])
        self._points = np.concatenate([view.points for view in measured])
        self._boards = np.concatenate([view.board for view in measured])
        self._whitening = np.concatenate([view.whitening for view in measured])
        self._across = np.linalg.svd(direction[None])[2][1:]  # two unit vectors at right angles to the axis
        # A first place: the centre that the board's centres turn about, in the plane across the axis.
        centres = np.array([pose.apply(measured[0].board.mean(axis=0)) for pose in poses]) @ self._across.T
        system = np.c_[2 * centres, np.ones(len(centres))]
        flat = np.linalg.lstsq(system, (centres**2).sum(axis=1), rcond=None)[0][:2]
        middle = np.mean([view.points.mean(axis=0) for view in measured], axis=0)
        if (centres.max(axis=0) - centres.min(axis=0)).max() < 1.0:  # a board centred on the axis draws no circle
            flat = centres.mean(axis=0)
        self._place = flat @ self._across + (middle @ direction) * direction
        self._pose = _about(direction, self._place, -measured[0].table_deg) @ poses[0]

    def unpack(self, p: Array) -> tuple[Array, Array, RigidTransform, Array]:
        """Direction, a point of the axis, the board's pose at 0 degrees, and the angles' errors in degrees."""
        tilted = self._direction + p[0:2] @ self._across
        step = RigidTransform.from_vector(p[4:7], p[7:10])
        pose = RigidTransform(step.rotation @ self._pose.rotation, self._pose.translation + step.translation)
        return tilted / np.linalg.norm(tilted), self._place + p[2:4] @ self._across, pose, np.degrees(p[10:])

    def solve(self) -> tuple[Array, Array]:
        """The unknowns, and the Jacobian of the residuals there."""
        start = np.zeros(10 + len(self._measured))
        scale = np.r_[1e-3, 1e-3, 0.1, 0.1, 1e-3, 1e-3, 1e-3, 0.1, 0.1, 0.1, np.full(len(self._measured), 1e-3)]
        solution = least_squares(self.residual, start, x_scale=scale, loss="soft_l1", f_scale=5.0, xtol=1e-12, ftol=1e-12)
        found = np.asarray(solution.x, np.float64)
        columns = [(self.residual(found + step) - self.residual(found - step)) / 2e-5 for step in 1e-5 * np.eye(len(found))]
        return found, np.stack(columns, axis=1)

    def residual(self, p: Array) -> Array:
        """Of all corners in units of their standard uncertainty, then of the angles' prior."""
        return self._against(self._points, self._boards, p)

    def moved_by(self, p: Array, fit: StereoCalibrationFit, pairs: Sequence[Pair], step: Array) -> Array:
        """The residual of the same images (ids and pixels by view) with the stereo parameters and marks moved by `step`."""
        ids, left_px, right_px = (np.concatenate([pair[part] for pair in pairs]) for part in range(3))
        ones = np.ones(len(ids))
        points = _triangulator(fit, step[:STEREO]).triangulate(left_px, right_px, ones, ones).points
        return self._against(points, (fit.marks + step[STEREO:].reshape(-1, 3))[ids], p)

    def _against(self, points: Array, boards: Array, p: Array) -> Array:
        axis, place, pose, errors_deg = self.unpack(p)
        # Rodrigues' rotation about the axis, every corner by its view's angle
        turned = np.radians(self._table_deg + errors_deg)[self._view, None]
        arm = pose.apply(boards) - place
        swung = np.cos(turned) * arm + np.sin(turned) * np.cross(axis, arm) + (1 - np.cos(turned)) * (arm @ axis)[:, None] * axis
        off = (self._whitening @ (points - place - swung)[..., None])[..., 0]
        return np.concatenate([off.ravel(), errors_deg / _ANGLE_PRIOR_DEG])

    def axis(self, p: Array, marks: Array) -> Array:
        """A point of the axis and its direction, (6,); the point is level with the middle of the board's face."""
        direction, place, pose, _ = self.unpack(p)
        level = place + float((pose.apply(marks.mean(axis=0)) - place) @ direction) * direction
        return np.concatenate([level, direction])

    def down_to_table_mm(self, p: Array, marks: Array) -> float:
        """From there down to the table, on which the board rests with the lowest point of its border.

        How well the border is known moves only the datum of all heights; it is kept out of the axis' covariance.
        """
        direction, _, pose, _ = self.unpack(p)
        heights = pose.apply(np.vstack([marks.mean(axis=0), self._outline.points(marks)])) @ direction
        return float(heights[0] - heights[1:].min()) + self._thickness_mm

    def position_rms_um(self, p: Array) -> float:
        """Rms over the views, per coordinate of the board's centre."""
        axis, place, pose, errors_deg = self.unpack(p)
        shifts = []
        for view, error_deg in zip(self._measured, errors_deg, strict=True):
            predicted = (_about(axis, place, view.table_deg + error_deg) @ pose).apply(view.board)
            shifts.append(view.points.mean(axis=0) - predicted.mean(axis=0))
        return 1e3 * float(np.sqrt(np.mean(np.square(shifts))))


class _Outline:
    """The border of a board whose inner corners are known, as a polynomial of degree two continues them."""

    def __init__(self, target: CharucoTarget) -> None:
        (width, height), drawn = target.size_mm, target.object_points
        along, down = np.linspace(0, width, target.columns + 1), np.linspace(0, height, target.rows + 1)
        border = [(x, y) for x in along for y in down if x in (0.0, width) or y in (0.0, height)]
        self._xy = np.array(border)
        self._continued = _quadratic(self._xy, target) @ np.linalg.pinv(_quadratic(drawn[:, :2], target))

    def points(self, marks: Array) -> Array:
        """(k, 3) mm, board frame."""
        return np.column_stack([self._xy, self._continued @ marks[:, 2]])


def _quadratic(xy: Array, target: CharucoTarget) -> Array:
    u, v = (xy / target.size_mm).T
    return np.stack([np.ones(len(u)), u, v, u * u, u * v, v * v], axis=1)
