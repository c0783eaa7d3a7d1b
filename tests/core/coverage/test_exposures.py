"""The beam as a third camera: its pivot from the measured points, and places that one camera alone saw."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scanner_core.acquisition.aiming import beam_angles, beam_directions
from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.case.observation import MEASURED, ExposureTable
from scanner_core.coverage.beam_fit import fit_beam
from scanner_core.coverage.exposures import exposures_of
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform

RIG = load_preset("bench")
assert RIG.calibration is not None
CALIBRATION = RIG.calibration
TRUE = replace(RIG.laser, position_mm=(357.0, -1.7, 303.9), target_mm=(0.6, 0.9, 24.5))
TABLE_DEG = 40.0


def test_directions_are_the_reverse_of_angles() -> None:
    told = np.random.default_rng(1).uniform(-10, 10, (50, 2))
    along = beam_directions(TRUE, told)
    np.testing.assert_allclose(np.linalg.norm(along, axis=1), 1.0)
    np.testing.assert_allclose(beam_angles(TRUE, np.array(TRUE.position_mm) + 400 * along), told, atol=1e-9)


def lit(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Places (n, 3) of the table frame, and what the true mover was told to light them; 20 um of play."""
    rng = np.random.default_rng(seed)
    places = np.c_[rng.uniform(-25, 25, (count, 2)), rng.uniform(2, 50, count)]
    return places, beam_angles(TRUE, places) + np.degrees(0.02 / 450) * rng.standard_normal((count, 2))


def test_the_pivot_is_found_from_the_points_also_with_some_wrong_ones() -> None:
    places, told = lit(3000, 2)
    places[::50] += 20.0
    fit = fit_beam(RIG.laser, places, told)
    assert fit is not None
    np.testing.assert_allclose(fit.laser.position_mm, TRUE.position_mm, atol=0.5)  # of 2 to 4 mm
    assert 0.01 < fit.scatter_mm < 0.03
    others, angles = lit(200, 3)
    off = np.cross(beam_directions(fit.laser, angles), others - np.array(fit.laser.position_mm))
    assert np.percentile(np.linalg.norm(off, axis=1), 95) < 0.06


def test_too_few_points_tell_nothing() -> None:
    assert fit_beam(RIG.laser, *lit(50, 1)) is None


def test_a_spot_that_one_camera_saw_has_a_place() -> None:
    places, told = lit(1200, 4)
    order = np.argsort(told[:, 0])
    places, told = places[order], told[order]
    rows = tuple(Row(0, 100 + k, 1, float(y), float(x), float(x)) for k, (x, y) in enumerate(told))
    plan = ScanPlan((ViewPlan(TABLE_DEG, rows),), 60.0)
    in_object = RigidTransform.about_z(-TABLE_DEG).apply(places)
    in_rig = CALIBRATION.rig_to_object(TABLE_DEG).inverse().apply(in_object)
    left, right = CALIBRATION.left.project(in_rig), CALIBRATION.right.project(in_rig)
    kind = np.arange(1200) % 4  # two of four by both, one by each
    left[kind == 2], right[kind == 3] = np.nan, np.nan
    verdict = np.select([kind < 2, kind == 2], [MEASURED, "hidden_left"], "hidden_right").astype(np.object_)
    seen = ExposureTable(100 + np.arange(1200), np.full(1200, TABLE_DEG), verdict, left, right)
    both = np.flatnonzero(kind < 2)
    found = exposures_of(seen, plan, PointCloud(in_object[both], trigger_ids=100 + both), RIG)
    by_one = found.seen_by_one(CALIBRATION)
    expected = np.concatenate([in_object[kind == 3], in_object[kind == 2]])  # the left camera's first
    assert by_one.shape == expected.shape
    assert np.percentile(np.linalg.norm(by_one - expected, axis=1), 95) < 0.1
