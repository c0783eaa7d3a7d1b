"""Where the turntable's axis is, from a board that lies flat on it at known angles.

All corners of all angles are fitted at once by a pose of the board at 0 degrees, a direction and a place of the axis
(ten unknowns), each corner weighted by its triangulation covariance.  The sense of rotation and the angle's scale are
checked first against the angles that the controller reported, on the poses of the board alone: an axis can be fitted
to a table that turns the wrong way, and every scan would then be torn.
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
from scanner_core.optics.board_detection import MIN_CORNERS
from scanner_core.optics.calibration import TurntableAxis
from scanner_core.optics.stereo_calibration import StereoCalibrationFit, StereoView
from scanner_core.optics.triangulation import Triangulator

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
_CORNER_SIGMA_PX = 0.1
"""Only the ratio between directions matters, the fit's residuals give the scale."""


@dataclass(frozen=True, slots=True, eq=False)
class TableView:
    """The board on the table: what both cameras see, and the table's angle as the controller reported it."""

    table_deg: float
    stereo: StereoView


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
    fit: StereoCalibrationFit, views: Sequence[TableView], target: CharucoTarget, *, board_thickness_mm: float = 0.0
) -> TurntableAxis:
    """The axis in the rig frame, pointing up, its origin where it meets the table.

    Parameters
    ----------
    fit : the calibrated cameras
    views : the board flat on the table, face up, at six or more angles around the turn
    board_thickness_mm : from the table's surface to the printed face

    Returns
    -------
    TurntableAxis
        Its residuals are what single views still deviate from the common axis: `angle_rms_deg` about the axis, and
        `position_rms_um` per coordinate of the board's centre.

    Raises
    ------
    CalibrationError
        E-CAL-01 when the views do not determine an axis, or the table does not turn as it reports; E-CAL-03 when the
        residuals are too large.
    """
    up_guess = np.array([0.0, -1.0, 0.0])
    triangulator = Triangulator(fit.with_turntable(TurntableAxis(np.zeros(3), up_guess), ""))
    measured = [_measure(triangulator, view, target) for view in views if len(view.stereo.common()[0]) >= MIN_CORNERS]
    if len(measured) < MIN_ANGLES:
        reason = f"{len(measured)} of {len(views)} views show the board on the table to both cameras, at least {MIN_ANGLES} are needed"
        raise CalibrationError("E-CAL-01", reason=reason)
    turned = np.sort([view.table_deg % 360 for view in measured])
    gap_deg = float(np.diff(np.append(turned, turned[0] + 360)).max())
    if gap_deg > MAX_GAP_DEG:
        raise CalibrationError("E-CAL-01", reason=f"no view of the board on the table over {gap_deg:.0f} degrees of the turn")

    poses = [fit_rigid(view.board, view.points) for view in measured]
    direction = _direction(poses, measured)
    _check_sense(poses, measured, direction)
    direction, place, pose = _refine(measured, direction, poses)
    tilt_deg = float(np.degrees(np.arccos(np.clip(-pose.rotation[:, 2] @ direction, -1, 1))))
    if tilt_deg > MAX_BOARD_TILT_DEG:
        raise CalibrationError("E-CAL-01", reason=f"the board leans by {tilt_deg:.0f} degrees against the table's axis; lay it flat on the table")
    angle_rms_deg, position_rms_um = _residuals(measured, direction, place, pose)
    if not (angle_rms_deg <= MAX_ANGLE_RMS_DEG and position_rms_um <= MAX_POSITION_RMS_UM):
        reason = f"the table strays by {angle_rms_deg:.2f} degrees and {position_rms_um:.0f} um from turning about one axis"
        raise CalibrationError("E-CAL-03", reason=reason)

    normal = -pose.rotation[:, 2]  # the board's z goes into it, its face looks up
    face = pose.apply(target.object_points.mean(axis=0))
    meets = place + direction * float(normal @ (face - place)) / float(normal @ direction)
    return TurntableAxis(meets - board_thickness_mm * direction, direction, angle_rms_deg, position_rms_um)


def _measure(triangulator: Triangulator, view: TableView, target: CharucoTarget) -> _Measured:
    ids, left_px, right_px = view.stereo.common()
    sigma = np.full(len(ids), _CORNER_SIGMA_PX)
    found = triangulator.triangulate(left_px, right_px, sigma, sigma)
    whitening = np.linalg.inv(np.linalg.cholesky(found.covariances))
    return _Measured(view.table_deg, found.points, whitening, target.object_points[ids])


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


def _refine(measured: Sequence[_Measured], direction: Array, poses: Sequence[RigidTransform]) -> tuple[Array, Array, RigidTransform]:
    """Direction, a point of the axis and the board's pose at 0 degrees by least squares over all corners."""
    across = np.linalg.svd(direction[None])[2][1:]  # two unit vectors at right angles to the axis
    # A first place: the centre that the board's centres turn about, in the plane across the axis.
    centres = np.array([pose.apply(measured[0].board.mean(axis=0)) for pose in poses]) @ across.T
    system = np.c_[2 * centres, np.ones(len(centres))]
    flat = np.linalg.lstsq(system, (centres**2).sum(axis=1), rcond=None)[0][:2]
    middle = np.mean([view.points.mean(axis=0) for view in measured], axis=0)
    if (centres.max(axis=0) - centres.min(axis=0)).max() < 1.0:  # a board centred on the axis draws no circle
        flat = centres.mean(axis=0)
    place0 = flat @ across + (middle @ direction) * direction
    back = _about(direction, place0, -measured[0].table_deg) @ poses[0]

    def unpack(p: Array) -> tuple[Array, Array, RigidTransform]:
        tilted = direction + p[0:2] @ across
        step = RigidTransform.from_vector(p[4:7], p[7:10])
        pose = RigidTransform(step.rotation @ back.rotation, back.translation + step.translation)
        return tilted / np.linalg.norm(tilted), place0 + p[2:4] @ across, pose

    def residual(p: Array) -> Array:
        axis, place, pose = unpack(p)
        parts = []
        for view in measured:
            predicted = (_about(axis, place, view.table_deg) @ pose).apply(view.board)
            parts.append((view.whitening @ (view.points - predicted)[..., None]).ravel())
        return np.concatenate(parts)

    scale = np.r_[1e-3, 1e-3, 0.1, 0.1, 1e-3, 1e-3, 1e-3, 0.1, 0.1, 0.1]
    solution = least_squares(residual, np.zeros(10), x_scale=scale, loss="soft_l1", f_scale=3.0, xtol=1e-12, ftol=1e-12)
    return unpack(solution.x)


def _residuals(measured: Sequence[_Measured], direction: Array, place: Array, pose: RigidTransform) -> tuple[float, float]:
    """Rms over the views of the angle about the axis in degrees, and per coordinate of the board's centre in um."""
    angles, shifts = [], []
    for view in measured:
        predicted = (_about(direction, place, view.table_deg) @ pose).apply(view.board)
        step = fit_rigid(predicted, view.points)
        skew = step.rotation - step.rotation.T
        angles.append(0.5 * float(np.array([skew[2, 1], skew[0, 2], skew[1, 0]]) @ direction))
        shifts.append(view.points.mean(axis=0) - predicted.mean(axis=0))
    return float(np.degrees(np.sqrt(np.mean(np.square(angles))))), 1e3 * float(np.sqrt(np.mean(np.square(shifts))))
