"""Views of the calibration board by the known rig, as corner positions with noise."""

from __future__ import annotations

import numpy as np

from scanner_core.geometry.fitting import fit_rigid
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_detection import BoardView
from scanner_core.optics.bundle_adjustment import STEREO
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_uncertainty import displacements
from scanner_core.optics.stereo_calibration import StereoCalibrationFit
from scanner_core.optics.stereo_view import StereoView
from scanner_core.optics.triangulation import Triangulator
from scanner_core.optics.turntable_calibration import TableView
from tests.core.optics.rigs import DISTANCE_MM

TARGET = CharucoTarget()
MIDDLE = np.array([*(0.5 * np.array(TARGET.size_mm)), 0.0])


def bent(bow_mm: float, twist_mm: float = 0.0, scale: float = 1.0, ink_mm: float = 0.0) -> np.ndarray:
    """The marks of a board that stands out by `bow_mm` in its middle, is twisted, printed too large, and with misplaced ink."""
    flat = TARGET.object_points
    u, v = (2 * flat[:, :2] / TARGET.size_mm - 1).T
    marks = MIDDLE + scale * (flat - MIDDLE)
    marks[:, 2] = -bow_mm * (1 - 0.5 * u**2 - 0.5 * v**2) - twist_mm * u * v
    marks[:, :2] += ink_mm * np.random.default_rng(5).standard_normal((len(marks), 2))
    return marks


BENT = bent(0.3)


def known_fit(calibration: StereoCalibration, marks: np.ndarray = TARGET.object_points) -> StereoCalibrationFit:
    """Cameras and board that are known without error."""
    return StereoCalibrationFit(
        left=calibration.left,
        right=calibration.right,
        views=20,
        held_out_views=5,
        views_left_out=0,
        reprojection_rms_px=0.0,
        held_out_rms_um=0.0,
        held_out_scale=1.0,
        coverage=1.0,
        corners_left_out=0,
        marks=marks,
        board_bend_mm=float(np.ptp(marks[:, 2])),
        corner_sigma_px=np.full((2, 2), 0.1),
        covariance=np.zeros((STEREO + 3 * len(marks),) * 2),
        with_k3=False,
    )


def view_of(
    calibration: StereoCalibration, pose: RigidTransform, noise_px: float, rng: np.random.Generator, marks: np.ndarray = TARGET.object_points
) -> StereoView:
    """What both cameras see of marks at `pose` (board to rig frame)."""
    views = []
    for camera in (calibration.left, calibration.right):
        pixels = camera.project(pose.apply(marks))
        ids = np.flatnonzero(((pixels > 3) & (pixels < np.array(camera.size_px) - 4)).all(axis=1))
        views.append(BoardView(ids, pixels[ids] + rng.normal(0, noise_px, (len(ids), 2))))
    return StereoView(*views)


def _axes(calibration: StereoCalibration) -> tuple[np.ndarray, np.ndarray]:
    """Columns x, y, z of a board that faces the middle between the cameras, and of one that lies face up on the table."""
    up = calibration.turntable.direction
    away = calibration.left.rotation[2] + calibration.right.rotation[2]
    away /= np.linalg.norm(away)
    down = (up @ away) * away - up
    down /= np.linalg.norm(down)
    x = np.cross(down, away)
    return np.stack([x, down, away], axis=1), np.stack([x, np.cross(-up, x), -up], axis=1)


def shown(
    calibration: StereoCalibration, count: int, noise_px: float, seed: int, tilt_deg: float = 35.0, marks: np.ndarray = TARGET.object_points
) -> list[StereoView]:
    """The board (or any plate with `marks`) held into the volume `count` times."""
    rng = np.random.default_rng(seed)
    facing, _ = _axes(calibration)
    views = []
    for _ in range(count):
        rotation = facing @ RigidTransform.from_vector(np.radians(rng.uniform(-tilt_deg, tilt_deg, 3)), np.zeros(3)).rotation
        place = np.array([0, 0, DISTANCE_MM]) + rng.uniform(-60, 60, 3)
        views.append(view_of(calibration, RigidTransform(rotation, place - rotation @ marks.mean(axis=0)), noise_px, rng, marks))
    return views


def laid(
    calibration: StereoCalibration,
    count: int,
    noise_px: float,
    seed: int,
    *,
    gain: float = 1.0,
    thickness_mm: float = 0.0,
    arc_deg: float = 360.0,
    off_mm: tuple[float, float] = (6.0, -4.0),
    marks: np.ndarray = TARGET.object_points,
) -> list[TableView]:
    """The board on the table, `off_mm` the middle; the table turns `gain` degrees for each that it reports."""
    rng = np.random.default_rng(seed)
    axis = calibration.turntable
    _, flat = _axes(calibration)
    views = []
    for index in range(count):
        reported_deg = 5.0 + arc_deg * index / count
        rotation = RigidTransform.from_vector(np.radians(gain * reported_deg) * axis.direction, np.zeros(3)).rotation @ flat
        place = axis.origin + thickness_mm * axis.direction
        pose = RigidTransform(rotation, place - rotation @ (MIDDLE + np.array([*off_mm, 0.0])))
        views.append(TableView(reported_deg, view_of(calibration, pose, noise_px, rng, marks)))
    return views


def volume_error_um(found: StereoCalibration, truth: StereoCalibration, half_mm: float = 50.0) -> tuple[float, RigidTransform]:
    """Rms distance of triangulated to true points of a cube on the table after rigid alignment, and that alignment."""
    rng = np.random.default_rng(0)
    in_table = np.c_[rng.uniform(-half_mm, half_mm, (3000, 2)), rng.uniform(0, 2 * half_mm, 3000)]
    points = truth.rig_to_table().inverse().apply(in_table)
    sigma = np.ones(len(points))
    measured = Triangulator(found).triangulate(truth.left.project(points), truth.right.project(points), sigma, sigma).points
    to_truth = fit_rigid(measured, points)
    return float(1e3 * np.sqrt(((to_truth.apply(measured) - points) ** 2).sum(axis=1).mean())), to_truth


def axis_error(found: StereoCalibration, truth: StereoCalibration) -> tuple[float, float]:
    """Angle between the axes in degrees, and how far the found origin lies beside the true axis in um, rigs aligned in the volume."""
    _, to_truth = volume_error_um(found, truth)
    true = truth.turntable.direction
    direction = to_truth.rotate(found.turntable.direction)
    off = np.cross(to_truth.apply(found.turntable.origin) - truth.turntable.origin, true)
    return float(np.degrees(np.arcsin(np.linalg.norm(np.cross(direction, true))))), float(1e3 * np.linalg.norm(off))


def largest_cube_mm(truth: StereoCalibration) -> float:
    """Half the edge of the largest cube, its sides square to the table frame and standing on the table's middle, that both
    cameras see whole."""
    to_rig = truth.rig_to_table().inverse()
    unit = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (0, 2)], float)
    low, high = 0.0, 1000.0
    while high - low > 0.5:
        half = 0.5 * (low + high)
        corners = to_rig.apply(half * unit)
        seen = all(
            ((camera.rotation @ corners.T).T + camera.translation)[:, 2].min() > 1
            and ((pixels := camera.project(corners)) > 0).all()
            and (pixels < np.array(camera.size_px) - 1).all()
            for camera in (truth.left, truth.right)
        )
        low, high = (half, high) if seen else (low, half)
    return low


def scale_error_ppm(found: StereoCalibration, truth: StereoCalibration, half_mm: float = 50.0) -> float:
    """How much too large the calibration measures, in the mean over the volume."""
    in_table, measured = cube_points(found, truth, half_mm)
    about = in_table - in_table.mean(axis=0)
    aligned = fit_rigid(measured, in_table).apply(measured)
    return float(1e6 * ((about * (aligned - aligned.mean(axis=0))).sum() / (about**2).sum() - 1))


def calibration_z(found: StereoCalibration, truth: StereoCalibration, half_mm: float = 50.0) -> np.ndarray:
    """Errors of every tenth point of the cube in the table frame, (300, 3), over the standard uncertainties that the
    calibration's modes predict for them.

    The height of the table, a datum that moves all points alike, is taken out of both.
    """
    in_table, measured = cube_points(found, truth, half_mm)
    error = (measured - in_table)[::10]
    assert found.modes is not None
    moved = displacements(found, found.modes, measured[::10])
    error[:, 2] -= error[:, 2].mean()
    moved[:, :, 2] -= moved[:, :, 2].mean(axis=1, keepdims=True)
    return error / np.sqrt((moved**2).sum(axis=0))


def cube_points(found: StereoCalibration, truth: StereoCalibration, half_mm: float) -> tuple[np.ndarray, np.ndarray]:
    """Points of the cube in the true table frame, and in the found one as perfect images of them are measured, (3000, 3)."""
    rng = np.random.default_rng(0)
    in_table = np.c_[rng.uniform(-half_mm, half_mm, (3000, 2)), rng.uniform(0, 2 * half_mm, 3000)]
    in_rig = truth.rig_to_table().inverse().apply(in_table)
    sigma = np.ones(len(in_rig))
    points = Triangulator(found).triangulate(truth.left.project(in_rig), truth.right.project(in_rig), sigma, sigma).points
    return in_table, found.rig_to_table().apply(points)
