"""Which camera stands to the left: right, exchanged, or not to be told."""

from __future__ import annotations

import numpy as np

from scanner_core.commissioning.sides import exchanged
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.presets import PRESETS

LEFT, RIGHT = PRESETS["bench"].cameras
SIZE = LEFT.size_px


def _points(depth_mm: float, count: int = 30) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(11)
    points = rng.uniform(-1, 1, (count, 3)) * [depth_mm, 25.0, 25.0] + [0.0, 0.0, 25.0]
    noise = [rng.normal(0, 0.05, (count, 2)) for _ in range(2)]
    return LEFT.project(points) + noise[0], RIGHT.project(points) + noise[1]


def test_without_a_calibration_by_the_epipoles() -> None:
    left, right = _points(20.0)
    assert exchanged(left, right, SIZE, None) is False
    assert exchanged(right, left, SIZE, None) is True


def test_few_points_and_flat_objects_do_not_tell() -> None:
    left, right = _points(20.0, 10)
    assert exchanged(left, right, SIZE, None) is None
    left, right = _points(0.0)
    assert exchanged(left, right, SIZE, None) is None


def test_with_a_calibration_by_the_residuals(bench_calibration: StereoCalibration) -> None:
    left, right = _points(20.0, 3)
    assert exchanged(left, right, SIZE, bench_calibration) is False
    assert exchanged(right, left, SIZE, bench_calibration) is True
    assert exchanged(left + np.array([0, 30]), right, SIZE, bench_calibration) is None
