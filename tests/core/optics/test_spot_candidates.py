from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import erf

from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_candidates import OUTSHONE, SpotCandidate, look_at
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters

SHAPE = (294, 604)
DETECTOR = SpotDetector(SpotDetectorParameters(max_area_px=120))


def _blob(x: float, y: float, sigma_x: float, sigma_y: float, peak_dn: float) -> np.ndarray:
    def over_pixels(n: int, centre: float, sigma: float) -> np.ndarray:
        edges = (np.arange(n + 1) - 0.5 - centre) / (sigma * np.sqrt(2))
        return np.asarray(np.diff(erf(edges)) / 2)

    flux_dn = 2 * np.pi * sigma_x * sigma_y * peak_dn
    return np.asarray(flux_dn * np.outer(over_pixels(SHAPE[0], y, sigma_y), over_pixels(SHAPE[1], x, sigma_x)))


def _frame(*blobs: np.ndarray, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    light = sum(blobs, np.zeros(SHAPE))
    return np.clip(np.round(8 + light + rng.normal(size=SHAPE) * np.sqrt(1.5**2 + 0.0255 * light)), 0, 255).astype(np.uint8)


def _at(candidates: tuple[SpotCandidate, ...], x: float, y: float, within_px: float = 3.0) -> SpotCandidate:
    """The one candidate at a place."""
    (found,) = [c for c in candidates if np.hypot(c.x_px - x, c.y_px - y) < within_px]
    return found


GOOD = _blob(300.3, 150.6, 1.2, 1.0, 180)


@pytest.mark.parametrize(
    ("blob", "place", "reason"),
    [
        (_blob(100, 60, 1.1, 1.1, 8.5), (100, 60), "too_dim"),
        (_blob(100, 60, 0.25, 0.25, 60), (100, 60), "too_small"),
        (_blob(100, 60, 9, 9, 120), (100, 60), "too_large"),
        (_blob(100, 60, 6.5, 0.8, 90), (100, 60), "elongated"),
        (_blob(100, 60, 1.8, 1.8, 900), (100, 60), "saturated"),
        (_blob(0.0, 60, 1.2, 1.2, 90), (0.5, 60), "cut_by_edge"),
        (_blob(100, 60, 1.1, 1.0, 25), (100, 60), OUTSHONE),
    ],
)
def test_each_reason_stands_at_its_blob(blob: np.ndarray, place: tuple[float, float], reason: str) -> None:
    seen = look_at(_frame(GOOD, blob), DETECTOR)
    assert _at(seen.candidates, *place).reason == reason
    if reason != "saturated":  # that glares more than the spot, but is none: the spot is taken all the same
        assert len(seen.candidates) == 2
    assert _at(seen.candidates, 300.3, 150.6, 0.1).accepted


def test_two_equal_spots_are_both_ambiguous() -> None:
    look = look_at(_frame(GOOD, _blob(100, 60, 1.2, 1.0, 170)), DETECTOR)
    assert look.accepted is None
    assert isinstance(look.seen, SpotMiss)
    assert [c.reason for c in look.candidates] == ["ambiguous", "ambiguous"]


def test_a_lamp_is_one_large_candidate_and_room_light_none() -> None:
    lamp = np.zeros(SHAPE)
    lamp[20:220, 400:590] = 140
    assert _at(look_at(_frame(GOOD, lamp), DETECTOR).candidates, 494.5, 119.5).reason == "too_large"
    bright = look_at(np.clip(_frame(GOOD).astype(int) + 120, 0, 255).astype(np.uint8), DETECTOR)
    assert (bright.seen, bright.candidates) == (SpotMiss(MissReason.TOO_BRIGHT, 255.0), ())


def test_the_ellipse_lies_as_the_spot_does() -> None:
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    turn = np.radians(30)
    along = (x - 300) * np.cos(turn) + (y - 150) * np.sin(turn)
    across = -(x - 300) * np.sin(turn) + (y - 150) * np.cos(turn)
    (found,) = look_at(_frame(170 * np.exp(-0.5 * ((along / 3) ** 2 + (across / 1.4) ** 2))), DETECTOR).candidates
    long, short, angle = found.ellipse()
    assert long == pytest.approx(3, rel=0.08)
    assert short == pytest.approx(1.4, rel=0.08)
    assert angle == pytest.approx(30, abs=2)


BLOBS = st.tuples(st.floats(-2, 606), st.floats(-2, 296), st.floats(0.3, 8), st.floats(0.3, 8), st.floats(3, 600))


@settings(max_examples=40, deadline=None)
@given(st.lists(BLOBS, max_size=5), st.integers(0, 99))
def test_what_is_accepted_is_what_a_scan_takes(blobs: list[tuple[float, float, float, float, float]], seed: int) -> None:
    image = _frame(*(_blob(*blob) for blob in blobs), seed=seed)
    look, seen = look_at(image, DETECTOR), DETECTOR.detect(image)
    assert look.seen == seen
    accepted = [c for c in look.candidates if c.accepted]
    if isinstance(seen, Spot):
        assert len(accepted) == 1
        assert np.hypot(accepted[0].x_px - seen.x_px, accepted[0].y_px - seen.y_px) < 0.5
    else:
        assert accepted == []
        if seen.reason is MissReason.AMBIGUOUS:
            assert sum(c.reason == "ambiguous" for c in look.candidates) >= 2


def test_limits_of_size_are_heeded() -> None:
    tight = SpotDetector(replace(DETECTOR.parameters, min_area_px=90))
    assert [c.reason for c in look_at(_frame(GOOD), tight).candidates] == ["too_small"]
