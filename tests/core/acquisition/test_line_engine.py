"""Matching along epipolar lines, the laser's planes, and the verdicts, on curves whose places in space are known."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.line_engine import LineEngine, LinePoints
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.laser_plane import PanAxis, swept_planes
from scanner_core.optics.stripe_detection import StripeFrame, StripePeaks
from scanner_core.optics.stripe_matching import StripeMatcher
from tests.core.optics.stripes import perfect_peaks

Array = NDArray[np.float64]

RIG = load_preset("bench")
LASER = np.array(RIG.laser.position_mm)
FRAMES, TABLE_DEG = 24, 40.0


@cache
def calibration() -> StereoCalibration:
    assert RIG.calibration is not None
    return RIG.calibration


def in_plane(pan_deg: float, heights: Array, depth: float) -> Array:
    """Points (n, 3) of the table frame in the laser's plane at a pan, `depth` mm beyond the axis as seen from the laser, at these heights."""
    azimuth = np.radians(180 + pan_deg)
    out = np.hypot(*LASER[:2]) + depth
    return np.asarray(np.c_[LASER[0] + out * np.cos(azimuth) + 0 * heights, LASER[1] + out * np.sin(azimuth) + 0 * heights, heights])


def peaks_of(pieces: list[Array], side: int) -> StripePeaks:
    """How a perfect detector sees pieces of the line, given in the table frame."""
    to_rig = calibration().rig_to_table().inverse()
    camera = (calibration().left, calibration().right)[side]
    return perfect_peaks([camera.project(to_rig.apply(piece)) for piece in pieces])


def frames_of(pieces_of_pan: list[tuple[list[Array], list[Array]]]) -> list[tuple[StripeFrame, StripeFrame]]:
    """Frames of what the left and what the right camera sees."""
    return [(StripeFrame(peaks_of(left, 0), {}), StripeFrame(peaks_of(right, 1), {})) for left, right in pieces_of_pan]


def wall(pan_deg: float) -> list[Array]:
    """An upright piece and one behind it, higher."""
    return [in_plane(pan_deg, np.linspace(4, 22, 1500), -6.0), in_plane(pan_deg, np.linspace(26, 40, 1500), 8.0)]


def evaluated(frames: list[tuple[StripeFrame, StripeFrame]]) -> LinePoints:
    return LineEngine(RIG, calibration()).evaluate(frames, TABLE_DEG)


def pans() -> Array:
    return np.linspace(-2, 2, FRAMES)


def in_table(found: LinePoints) -> Array:
    return RigidTransform.about_z(TABLE_DEG).apply(found.points)


def balanced(found: LinePoints, frames: list[tuple[StripeFrame, StripeFrame]]) -> bool:
    return sum(found.verdicts.values()) == sum(len(frame.peaks) for pair in frames for frame in pair)


def test_points_of_perfect_peaks_lie_where_the_line_was() -> None:
    frames = frames_of([(wall(pan), wall(pan)) for pan in pans()])
    found = evaluated(frames)
    assert found.verdicts["measured"] > 0.9 * sum(found.verdicts.values())
    assert balanced(found, frames)
    points = in_table(found) - LASER
    pan = np.degrees(np.arctan2(-points[:, 1], -points[:, 0]))
    assert np.abs(pan - pans()[found.frame]).max() < 1e-3
    reach = np.hypot(points[:, 0], points[:, 1]) - np.hypot(*LASER[:2])
    assert np.minimum(np.abs(reach + 6), np.abs(reach - 8)).max() < 2e-3


def test_a_double_hit_lies_beside_the_planes_and_is_rejected() -> None:
    """A reflection makes a second line 15 mm beside the plane, seen by both cameras: alone on its epipolar lines, and wrong."""

    def seen(pan: float) -> list[Array]:
        return [*wall(pan), in_plane(pan, np.linspace(45, 52, 700), 0.0) + np.array([0.0, 15.0, 0.0])]

    frames = frames_of([(seen(pan), seen(pan)) for pan in pans()])
    found = evaluated(frames)
    assert found.verdicts["off_plane"] > 50
    assert balanced(found, frames)
    assert in_table(found)[:, 2].max() < 41


def test_two_folds_on_one_epipolar_line_are_told_apart_by_the_plane() -> None:
    """Two pieces at the same epipolar lines: every peak has two candidates in the volume, and the plane leaves the right one."""

    def folded(pan: float) -> list[Array]:
        front = in_plane(pan, np.linspace(10, 24, 1500), -12.0)
        centre = 0.5 * sum(camera_centres())
        behind = centre + (front - centre) * 1.06  # along the rays from the middle between the cameras, moved into the plane
        around = behind - LASER
        turn = np.radians(180 + pan) - np.arctan2(around[:, 1], around[:, 0])
        c, s = np.cos(turn), np.sin(turn)
        return [front, LASER + np.c_[c * around[:, 0] - s * around[:, 1], s * around[:, 0] + c * around[:, 1], around[:, 2]]]

    matcher = StripeMatcher(calibration(), 0.02)
    one = folded(1.0)
    candidates = matcher.match(peaks_of(one, 0), peaks_of(one, 1))
    assert np.bincount(candidates.place).max() == 2, "no epipolar line meets both pieces"
    frames = frames_of([([*folded(pan), in_plane(pan, np.linspace(40, 60, 1500), 0.0)],) * 2 for pan in pans()])
    found = evaluated(frames)
    points = in_table(found) - LASER
    pan = np.degrees(np.arctan2(-points[:, 1], -points[:, 0]))
    assert np.abs(pan - pans()[found.frame]).max() < 0.02
    assert found.verdicts["measured"] > 0.85 * sum(found.verdicts.values())
    assert balanced(found, frames)


def test_what_one_camera_sees_alone_is_hidden() -> None:
    frames = frames_of([(wall(pan), wall(pan)[:1]) for pan in pans()])
    found = evaluated(frames)
    assert found.verdicts["hidden"] > 100
    assert balanced(found, frames)
    assert in_table(found)[:, 2].max() < 23


def test_too_few_points_tell_no_plane_and_give_no_points() -> None:
    frames = frames_of([(wall(0.0)[1:], wall(0.0)[1:])])
    found = evaluated(frames)
    assert len(found.points) == 0
    assert set(found.verdicts) <= {"no_plane", "hidden"}
    assert balanced(found, frames)
    assert len(evaluated([]).points) == 0


def test_covariances_say_how_the_points_scatter() -> None:
    rng = np.random.default_rng(7)
    sigma = 0.05
    frames = []
    for left, right in frames_of([(wall(pan), wall(pan)) for pan in pans()]):
        noisy = []
        for frame in (left, right):
            xy = frame.peaks.xy.copy()
            shift = rng.normal(0, sigma, len(xy))
            xy[frame.peaks.along_row, 0] += shift[frame.peaks.along_row]
            xy[~frame.peaks.along_row, 1] += shift[~frame.peaks.along_row]
            noisy.append(StripeFrame(StripePeaks(xy, *(getattr(frame.peaks, name) for name in frame.peaks.__slots__[1:])), {}))
        frames.append((noisy[0], noisy[1]))
    engine = LineEngine(RIG, calibration(), floor_px=sigma, per_px=1)
    found = engine.evaluate(frames, TABLE_DEG)
    points = in_table(found) - LASER
    reach = np.hypot(points[:, 0], points[:, 1]) - np.hypot(*LASER[:2])
    error = np.where(np.abs(reach + 6) < np.abs(reach - 8), reach + 6, reach - 8)
    covariances = RigidTransform.about_z(TABLE_DEG).rotate_covariances(found.covariances)
    across = -points[:, :2] / np.linalg.norm(points[:, :2], axis=1, keepdims=True)
    stated = np.sqrt(np.einsum("ni,nij,nj->n", across, covariances[:, :2, :2], across))
    assert found.noise_factor == pytest.approx(1.0, abs=0.25)
    assert float(np.std(error / stated)) == pytest.approx(1.0, abs=0.25)


def test_the_pan_axis_is_found_from_a_nominal_one_that_is_off_by_centimetres() -> None:
    rng = np.random.default_rng(1)
    frame = np.repeat(np.arange(FRAMES), 40)
    points = np.concatenate([np.concatenate([in_plane(pan, rng.uniform(0, 30, 20), depth) for depth in rng.uniform(-20, 20, 2)]) for pan in pans()])
    points = points + rng.normal(0, 0.02, points.shape)
    wrong = rng.random(len(points)) < 0.05
    points[wrong] += rng.normal(0, 5, (int(wrong.sum()), 3))
    nominal = PanAxis(LASER + np.array([12.0, -9.0, 0.0]), np.array([0.02, -0.03, 1.0]) / np.linalg.norm([0.02, -0.03, 1.0]))
    planes = swept_planes(points, np.full(len(points), 0.02), frame, FRAMES, nominal)
    assert planes is not None
    beside = planes.beside_mm(points, frame)
    assert planes.scatter_mm < 0.03
    assert np.abs(beside[~wrong]).max() < 0.15
    assert np.abs(beside[wrong]).mean() > 1


def camera_centres() -> list[Array]:
    to_table = calibration().rig_to_table()
    return [to_table.apply(camera.centre_mm()[None])[0] for camera in (calibration().left, calibration().right)]
