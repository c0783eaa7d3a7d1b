from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.optics.spot_detection import SpotDetectorParameters
from scanner_core.optics.spot_limits import LEAST_SPOTS, SizeLimits, learn_limits


@settings(max_examples=40, deadline=None)
@given(st.floats(6, 400), st.floats(0.02, 0.5), st.integers(20, 200), st.integers(0, 999))
def test_limits_hold_further_spots_of_the_same_kind(middle_px: float, spread: float, count: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    areas = np.maximum(np.round(middle_px * np.exp(spread * rng.normal(size=4000 + count))), 2)
    limits = learn_limits(areas[:count].tolist())
    assert limits is not None
    assert np.mean([limits.holds(area) for area in areas[count:]]) >= 0.99


@pytest.mark.parametrize("stray_px", [6, 120])
def test_stray_light_within_the_room_is_kept_out(stray_px: int) -> None:
    spots = np.random.default_rng(1).normal(30, 2, 100)
    alone, beside = learn_limits(spots.tolist()), learn_limits(spots.tolist(), [stray_px] * 3)
    assert alone is not None
    assert beside is not None
    assert (alone.holds(9 if stray_px < 30 else stray_px), beside.holds(stray_px)) == (True, False)
    assert all(beside.holds(area) for area in spots)


def test_stray_light_of_the_same_size_costs_no_spot() -> None:
    spots = np.random.default_rng(1).normal(30, 2, 100).tolist()
    assert learn_limits(spots, [29, 31]) == learn_limits(spots)


def test_too_few_teach_nothing() -> None:
    assert learn_limits([20.0] * (LEAST_SPOTS - 1)) is None
    assert learn_limits([20.0] * LEAST_SPOTS) == SizeLimits(4, 80)
    assert SizeLimits(5, 80).of(SpotDetectorParameters()).max_area_px == 80
