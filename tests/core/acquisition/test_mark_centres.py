"""Sphere fits of known radius against truth, and which balls a table position shows against rays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.aim_correction import corrected_laser
from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.mark_centres import mark_centres
from scanner_core.acquisition.mark_rows import beam_of, mark_rows, seen_marks, visiting
from scanner_core.case.observation import ObservationTable
from scanner_core.devices.marks_config import shipped_marks
from scanner_core.devices.rig import VolumeConfig, load_preset
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.rim_balls import true_centres_mm

Array = NDArray[np.float64]
RIG = replace(load_preset("bench"), marks=shipped_marks("bench"))
MARKS, CALIBRATION = RIG.marks, RIG.calibration
assert MARKS is not None
assert CALIBRATION is not None


def observed(points: Array, table_deg: float, noise_px: float, seed: int) -> ObservationTable:
    """Centroids of points (n, 3) mm, object frame, by the calibration itself."""
    assert CALIBRATION is not None
    rng, n = np.random.default_rng(seed), len(points)
    in_rig = CALIBRATION.rig_to_object(table_deg).inverse().apply(points)
    left, right = (camera.project(in_rig) + noise_px * rng.normal(size=(n, 2)) for camera in (CALIBRATION.left, CALIBRATION.right))
    ones = np.ones(n)
    sizes = np.tile([1.0, 0.8], (n, 1))
    return ObservationTable(np.arange(n), np.zeros(n, np.int32), table_deg * ones, left, right, 0.03 * ones, 0.03 * ones, sizes, sizes)


def facing(centre: Array, table_deg: float, count: int, rng: np.random.Generator) -> Array:
    """Points of a ball that beam and cameras see."""
    assert MARKS is not None
    towards = RigidTransform.about_z(-table_deg).rotate(np.array([0.8, 0.0, 0.6]))
    directions = towards + 0.45 * rng.uniform(-1, 1, (count, 3))
    return np.asarray(centre + MARKS.ball_radius_mm * directions / np.linalg.norm(directions, axis=1)[:, None], np.float64)


def test_centres_are_found_beside_strays_and_their_uncertainty_is_honest() -> None:
    assert MARKS is not None
    assert CALIBRATION is not None
    ratios = []
    for seed in range(30):
        rng, table_deg = np.random.default_rng(seed), 20.0 * seed
        truth = true_centres_mm(MARKS)[:2]
        points = np.concatenate([facing(centre, table_deg, 44, rng) for centre in truth])
        points[::9] += rng.uniform(-3, 3, (len(points[::9]), 3))
        found = mark_centres(observed(points, table_deg, 0.035, seed), RIG, CALIBRATION)
        assert [centre.number for centre in found] == [0, 1]
        for centre, true in zip(found, truth, strict=True):
            off = centre.centre - true
            assert np.abs(off).max() < 0.1
            ratios.append(float(off @ np.linalg.solve(centre.covariance, off)))
    assert 1.0 < np.mean(ratios) < 4.5  # 3, less the overdispersion of real speckle


def test_what_is_no_ball_gives_none() -> None:
    assert MARKS is not None
    assert CALIBRATION is not None
    rng = np.random.default_rng(1)
    flat = true_centres_mm(MARKS)[0] + np.c_[rng.uniform(-3, 3, (60, 2)), np.zeros(60)]
    few = facing(true_centres_mm(MARKS)[1], 0.0, 6, rng)
    found = mark_centres(observed(np.concatenate([flat, few]), 0.0, 0.03, 1), RIG, CALIBRATION)
    assert all(centre.number == 0 for centre in found)
    assert all(np.sqrt(np.trace(centre.covariance)) > 0 for centre in found)


@pytest.mark.parametrize("obstacle", [VolumeConfig(61.0, 99.0), VolumeConfig(38.0, 11.0)])
def test_hidden_balls_are_those_behind_the_cylinder(obstacle: VolumeConfig) -> None:
    assert MARKS is not None
    assert CALIBRATION is not None
    eyes = [np.array(RIG.laser.position_mm), *(camera.centre_mm() for camera in PRESETS["bench"].cameras)]
    for table_deg in range(0, 360, 10):
        places = RigidTransform.about_z(table_deg).apply(MARKS.places_mm())
        expected = []
        for number, place in enumerate(places):
            hidden = False
            for eye in eyes:
                ray = place + np.linspace(0, 1, 4000)[:, None] * (eye - place)
                hidden |= bool(((np.hypot(ray[:, 0], ray[:, 1]) < obstacle.radius_mm + 1) & (ray[:, 2] < obstacle.height_mm + 1)).any())
            if not hidden:
                expected.append(number)
        assert seen_marks(RIG, CALIBRATION, MARKS.places_mm(), float(table_deg), obstacle) == expected


def test_rows_stay_within_the_limits_and_on_the_ball() -> None:
    assert MARKS is not None
    place = MARKS.places_mm()[0]
    rows = mark_rows(RIG, RIG.laser, [place], visiting(MARKS.ball_radius_mm, 0.6, 1), 0, 100, 60.0)
    assert [row.first_id for row in rows] == np.cumsum([100, *(row.count for row in rows[:-1])]).tolist()
    for row in rows:
        for x in (row.x_from_deg, row.x_to_deg):
            away = np.array(beam_angles(RIG.laser, place[None])[0]) - [x, row.y_deg]
            assert np.radians(np.abs(away)).max() * 400 < MARKS.ball_radius_mm
            assert RIG.limits.x_deg[0] <= x <= RIG.limits.x_deg[1]
    ids = np.array([row.first_id + row.count - 1 for row in rows])
    np.testing.assert_allclose(beam_of(rows, ids), [[row.x_to_deg, row.y_deg] for row in rows])


def test_the_beam_is_found_from_what_it_lit() -> None:
    true = replace(RIG.laser, position_mm=(357.0, -1.7, 303.9), target_mm=(0.6, 0.9, 24.5))
    places = np.random.default_rng(1).normal(size=(60, 3)) * 2 + np.repeat([[90, 0, 4], [-30, 85, 4], [-40, -80, 4]], 20, axis=0)
    found = corrected_laser(RIG.laser, places, beam_angles(true, places))
    elsewhere = np.array([[0.0, 90.0, 4.0], [-90.0, 10.0, 4.0], [60.0, -60.0, 4.0]])
    off_mm = np.radians(np.abs(beam_angles(found, elsewhere) - beam_angles(true, elsewhere))).max() * 450
    before_mm = np.radians(np.abs(beam_angles(RIG.laser, elsewhere) - beam_angles(true, elsewhere))).max() * 450
    assert off_mm < 0.3 < before_mm
