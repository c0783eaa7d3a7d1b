from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.spot_tracking import WHOLE_FRAME_EVERY, SpotTracker
from tests.core.optics.spots import PARAMETERS, frame

DETECTOR = SpotDetector(PARAMETERS)
START = (80.3, 60.2, 1.0, 150.0)


def _settled() -> SpotTracker:
    tracker = SpotTracker(DETECTOR)
    assert isinstance(tracker.detect(frame(START)), Spot)
    assert tracker.whole_frames == 1
    return tracker


def _same(one: Spot | SpotMiss, other: Spot | SpotMiss) -> None:
    """Equal, but for what a background that differs by its own uncertainty does."""
    assert type(one) is type(other)
    if isinstance(one, Spot) and isinstance(other, Spot):
        assert abs(one.x_px - other.x_px) < 0.1 * other.standard_uncertainty_px
        assert abs(one.y_px - other.y_px) < 0.1 * other.standard_uncertainty_px
        assert one.standard_uncertainty_px == pytest.approx(other.standard_uncertainty_px, rel=0.05)
        assert one.area_px == pytest.approx(other.area_px, abs=4)
    elif isinstance(one, SpotMiss) and isinstance(other, SpotMiss):
        assert one.reason is other.reason


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 10_000), st.lists(st.tuples(st.floats(-9, 9), st.floats(-9, 9), st.floats(30, 240)), min_size=3, max_size=12))
def test_tracked_and_whole_frames_agree_on_a_spot_that_wanders(seed: int, steps: list[tuple[float, float, float]]) -> None:
    tracker, x, y = _settled(), START[0], START[1]
    for i, (dx, dy, peak_dn) in enumerate(steps):
        x, y = x + dx, y + dy
        image = frame((x, y, 1.0, peak_dn), seed=seed + i)
        _same(tracker.detect(image), DETECTOR.detect(image))


def test_window_is_used_while_the_spot_moves_evenly_and_the_whole_frame_comes_back() -> None:
    tracker = SpotTracker(DETECTOR)
    for i in range(2 * WHOLE_FRAME_EVERY):
        image = frame((20 + 1.5 * i, 60.0, 1.0, 150.0), seed=i)
        _same(tracker.detect(image), DETECTOR.detect(image))
    assert tracker.whole_frames == 2


@pytest.mark.parametrize(
    "image",
    [
        frame(),
        frame((20.0, 20.0, 1.0, 150.0)),
        frame((START[0] + 10, *START[1:]), (START[0] - 6, *START[1:])),
        frame((START[0], START[1], 1.0, 20.0), (20.0, 20.0, 1.0, 230.0)),
        frame((START[0] + 18, *START[1:])),
        np.full((120, 160), 200, np.uint8),
        np.full((120, 160), 255, np.uint8),
        np.zeros((120, 160), np.uint8),
    ],
    ids=["dark", "jumped", "two in the window", "dimmed, another elsewhere", "cut by the window", "bright", "white", "black"],
)
def test_whatever_is_doubtful_in_the_window_is_left_to_the_whole_frame(image: np.ndarray) -> None:
    tracker = _settled()
    _same(tracker.detect(image), DETECTOR.detect(image))
    assert tracker.whole_frames == 2


def test_stray_outside_of_the_window_is_seen_by_the_next_whole_frame() -> None:
    tracker = _settled()
    images = [frame(START, (20.0, 20.0, 1.0, 150.0), seed=i) for i in range(WHOLE_FRAME_EVERY)]
    seen = [tracker.detect(image) for image in images]
    assert all(isinstance(found, Spot) and round(found.x_px) == 80 for found in seen[:-1])
    assert isinstance(seen[-1], SpotMiss)
    assert seen[-1].reason is MissReason.AMBIGUOUS
    _same(tracker.detect(images[0]), DETECTOR.detect(images[0]))  # and is not forgotten while it lasts


def test_forgetting_begins_with_a_whole_frame() -> None:
    tracker = _settled()
    tracker.forget()
    tracker.detect(frame(START))
    assert tracker.whole_frames == 2


def test_spot_near_the_border_is_followed_out_of_the_frame() -> None:
    tracker = SpotTracker(DETECTOR)
    for i in range(12):
        image = frame((12.0 - 1.5 * i, 60.0, 1.0, 150.0), seed=i)
        _same(tracker.detect(image), DETECTOR.detect(image))
