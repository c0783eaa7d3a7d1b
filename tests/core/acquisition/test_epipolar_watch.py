"""A step of the epipolar residuals is named soon, and nothing else is taken for one."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.epipolar_watch import EpipolarWatch, ResidualStep

Array = NDArray[np.float64]
WIDTH = 604.0
SDS = pytest.mark.parametrize("sd_px", [0.045, 0.10, 0.16], ids=["bench", "noisier", "paper-2003"])


def _scan(points: int, sd_px: float, seed: int, left_over_px: float = 0.03) -> tuple[Array, Array, Array]:
    """Centroids that wander over the object row by row, and residuals with a smooth mean over the image."""
    rng = np.random.default_rng(seed)
    row = np.arange(points) // 40
    x = 200 + 5.0 * (np.arange(points) % 40) + rng.normal(0, 1, points)
    y = 80 + 3.0 * ((row * 13) % 40)
    left, right = np.c_[x, y], np.c_[x + 20 * np.sin(row), y + 1.0]
    mean = left_over_px * np.sin(2 * np.pi * (x - 200) / 300) * np.cos(np.pi * (y - 80) / 120)
    return left, right, mean + rng.normal(0, sd_px, points)


def _run(watch: EpipolarWatch, left: Array, right: Array, residual: Array, sd_px: float) -> list[tuple[int, ResidualStep]]:
    """Steps with the number of points that had been seen when they were named."""
    steps = []
    for begin in range(0, len(residual), 16):
        part = slice(begin, begin + 16)
        ids = np.arange(begin, begin + len(residual[part]))
        step = watch.add(ids, left[part], right[part], residual[part], np.full(len(ids), sd_px))
        if step is not None:
            steps.append((begin + len(ids), step))
    return steps


@SDS
def test_a_bump_of_a_fifth_of_a_pixel_is_named_within_200_points(sd_px: float) -> None:
    for seed, at in ((1, 40), (2, 700), (3, 3000)):
        left, right, residual = _scan(at + 400, sd_px, seed)
        residual[at:] += 0.2 / np.sqrt(2)
        steps = _run(EpipolarWatch(WIDTH), left, right, residual, sd_px)
        assert len(steps) == 1
        named, step = steps[0]
        assert at < named <= at + 200
        assert step.image_shift_px == pytest.approx(0.2, abs=0.09)
        assert abs(step.trigger_id - at) < 60


@SDS
def test_long_clean_scans_give_no_alarm(sd_px: float) -> None:
    left, right, residual = _scan(40_000, sd_px, 4)
    watch = EpipolarWatch(WIDTH)
    assert _run(watch, left, right, residual, sd_px) == []
    mean, sd, expected = watch.spread_px()
    assert abs(mean) < 0.02
    assert sd == pytest.approx(expected, rel=0.15)
    assert watch.scatter == pytest.approx(1.0, abs=0.1)


def test_two_bumps_are_two_steps() -> None:
    left, right, residual = _scan(6000, 0.05, 5)
    residual[1500:] += 0.15
    residual[4000:] -= 0.3
    steps = [step for _, step in _run(EpipolarWatch(WIDTH), left, right, residual, 0.05)]
    assert [step.residual_px > 0 for step in steps] == [True, False]


def test_strays_are_no_step() -> None:
    left, right, residual = _scan(5000, 0.05, 6)
    residual[::9] = 5.0
    assert _run(EpipolarWatch(WIDTH), left, right, residual, 0.05) == []


def test_more_scatter_than_expected_is_seen() -> None:
    left, right, residual = _scan(3000, 0.15, 7)
    watch = EpipolarWatch(WIDTH)
    _run(watch, left, right, residual, 0.05)
    assert watch.scatter > 1.7
