"""A calibration that does not tell its uncertainty (those of older versions) still gives points."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scanner_core.case.observation import ObservationTable
from scanner_core.case.points import triangulate_observations
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset, parse_rig


def bench() -> RigConfig:
    return load_preset("bench")


def table(rig: RigConfig, count: int) -> ObservationTable:
    calibration = rig.calibration
    assert calibration is not None
    rng = np.random.default_rng(5)
    points = calibration.rig_to_object(0.0).inverse().apply(rng.uniform((-20, -20, 5), (20, 20, 40), (count, 3)))
    noise, size = np.full(count, 0.02), np.tile([1.0, 0.8], (count, 1))
    pixels = [camera.project(points) + rng.normal(0, 0.02, (count, 2)) for camera in (calibration.left, calibration.right)]
    ids = np.arange(count)
    return ObservationTable(ids, np.zeros(count, np.int32), np.zeros(count), *pixels, noise, noise, size, size)


def test_without_modes_the_calibration_s_part_is_left_out() -> None:
    rig = bench()
    assert rig.calibration is not None
    old = replace(rig.calibration, modes=None, scale=None)
    text = dump_rig(rig.with_calibration(old))
    again = parse_rig(text, "old").calibration
    assert again is not None
    assert again.modes is None
    now = triangulate_observations(table(rig, 300), rig, rig.calibration).cloud
    then = triangulate_observations(table(rig, 300), rig, again).cloud
    assert now.covariances is not None
    assert then.covariances is not None
    np.testing.assert_allclose(then.points, now.points)
    assert (np.linalg.eigvalsh(now.covariances - then.covariances) > -1e-12).all()
    assert (now.covariances - then.covariances).trace(axis1=1, axis2=2).min() > 0


def test_a_handful_of_points_is_as_uncertain_as_the_rig_s_floor_says() -> None:
    rig = load_preset("paper-2003")
    assert rig.calibration is not None
    few = triangulate_observations(table(rig, 50), rig, rig.calibration)
    assert few.noise.pairs == 0
    sharper = replace(rig, spot=replace(rig.spot, floor_px=0.02))
    assert few.cloud.covariances is not None
    again = triangulate_observations(table(rig, 50), sharper, rig.calibration).cloud
    assert again.covariances is not None
    assert few.cloud.covariances.trace(axis1=1, axis2=2).mean() > 10 * again.covariances.trace(axis1=1, axis2=2).mean()
