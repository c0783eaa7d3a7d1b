"""Frames that hold no usable spot: each is named by its cause, for every centroid."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from scanner_core.errors import UsageError
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters
from tests.bench.optics.spot_images import BENCH, expose
from tests.core.optics.spots import PARAMETERS, SHAPE, frame, light

METHODS = ("weighted", "gaussian", "border")
DETECTORS = [SpotDetector(replace(PARAMETERS, centroid=method)) for method in METHODS]
SPOT = (80.3, 60.2, 1.0, 150.0)


def _lamp(level_dn: float, spot_dn: float = 0.0) -> np.ndarray:
    """A lamp in the picture: a bright disc with a wide glow; and a spot, if any."""
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    glow = level_dn * np.exp(-np.hypot(x - 30, y - 20) / 60)
    disc = 400.0 * (np.hypot(x - 30, y - 20) < 17)
    return expose(glow + disc + light(*SPOT[:2], 1.0, 1.0, spot_dn), BENCH, np.random.default_rng(7))


def _hot(count: int, with_spot: bool) -> np.ndarray:
    image = frame(SPOT) if with_spot else frame()
    rng = np.random.default_rng(8)
    image[2 * rng.integers(2, 25, count), 2 * rng.integers(2, 35, count)] = 255
    return image


def _line(slope: float) -> np.ndarray:
    """A sheet of light, 1 px wide, across the picture."""
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    inside = (x > 20) & (x < 140)
    return expose(150.0 * inside * np.exp(-0.5 * (y - 20 - slope * x) ** 2), BENCH, np.random.default_rng(9))


@pytest.mark.parametrize("detector", DETECTORS, ids=METHODS)
@pytest.mark.parametrize(
    ("image", "reasons"),
    [
        (np.zeros(SHAPE, np.uint8), {MissReason.NO_SPOT}),
        (np.full(SHAPE, 8, np.uint8), {MissReason.NO_SPOT}),
        (frame(), {MissReason.NO_SPOT}),
        (np.full(SHAPE, 255, np.uint8), {MissReason.TOO_BRIGHT}),
        (np.full(SHAPE, 130, np.uint8), {MissReason.TOO_BRIGHT}),
        (_lamp(60.0), {MissReason.TOO_LARGE}),
        (_lamp(900.0, 150.0), {MissReason.TOO_BRIGHT}),
        (frame(SPOT, (30.0, 40.0, 1.0, 140.0)), {MissReason.AMBIGUOUS}),
        (frame((80.0, 60.0, 2.0, 20_000.0)), {MissReason.SATURATED}),
        (_hot(1, with_spot=False), {MissReason.TOO_SMALL}),
        (_hot(40, with_spot=False), {MissReason.TOO_SMALL}),
        (frame((0.3, 60.0, 1.0, 150.0)), {MissReason.CUT_BY_EDGE}),
        (frame((159.0, 60.0, 1.0, 150.0)), {MissReason.CUT_BY_EDGE}),
        (frame((80.0, -0.4, 1.0, 150.0)), {MissReason.CUT_BY_EDGE}),
        (frame((159.4, 119.4, 1.0, 150.0)), {MissReason.CUT_BY_EDGE}),
        (_line(0.0), {MissReason.ELONGATED}),
        (_line(0.4), {MissReason.ELONGATED}),
        (frame((300.0, 150.0, 16.0, 120.0), shape=(294, 604)), {MissReason.TOO_LARGE}),
        (frame((80.0, 60.0, 3.0, 6.5), seed=3), {MissReason.TOO_DIM}),
    ],
    ids=[
        *("black", "grey", "dark", "white", "lit", "lamp", "lamp close by", "two spots", "saturated", "hot pixel", "hot pixels"),
        *("cut left", "cut right", "cut above", "cut in a corner", "level line", "slanting line", "large", "dim"),
    ],
)
def test_cause_is_named(image: np.ndarray, reasons: set[MissReason], detector: SpotDetector) -> None:
    found = detector.detect(image)
    assert isinstance(found, SpotMiss)
    assert found.reason in reasons
    assert bool(found.candidates) == (found.reason is MissReason.AMBIGUOUS)


@pytest.mark.parametrize("detector", DETECTORS, ids=METHODS)
def test_spot_beside_hot_pixels_is_found(detector: SpotDetector) -> None:
    found = detector.detect(_hot(5, with_spot=True))
    assert isinstance(found, Spot)
    assert (round(found.x_px), round(found.y_px)) == (80, 60)


@pytest.mark.parametrize("detector", DETECTORS, ids=METHODS)
def test_spot_in_the_glow_of_a_lamp_is_found_with_an_uncertainty_that_tells(detector: SpotDetector) -> None:
    dark, lit = detector.detect(frame(SPOT)), detector.detect(_lamp(60.0, 150.0))
    assert isinstance(dark, Spot)
    assert isinstance(lit, Spot)
    assert np.hypot(lit.x_px - SPOT[0], lit.y_px - SPOT[1]) < 3 * lit.standard_uncertainty_px
    assert lit.standard_uncertainty_px > 2 * dark.standard_uncertainty_px


@pytest.mark.parametrize("detector", DETECTORS, ids=METHODS)
def test_two_close_spots_are_two_candidates(detector: SpotDetector) -> None:
    found = detector.detect(frame(SPOT, (SPOT[0] + 8, *SPOT[1:])))
    assert isinstance(found, SpotMiss)
    assert found.reason is MissReason.AMBIGUOUS
    assert sorted(round(spot.x_px) for spot in found.candidates) == [80, 88]


@settings(max_examples=30, deadline=None)
@given(arrays(np.uint8, st.tuples(st.integers(1, 40), st.integers(1, 40))), st.sampled_from(DETECTORS))
def test_any_image_has_an_answer(image: np.ndarray, detector: SpotDetector) -> None:
    found = detector.detect(image)
    assert isinstance(found, Spot | SpotMiss)
    for spot in (found,) if isinstance(found, Spot) else found.candidates:
        numbers = (spot.x_px, spot.y_px, spot.sigma_x_px, spot.sigma_y_px, spot.flux_dn, spot.standard_uncertainty_px)
        assert np.isfinite(numbers).all()
        assert -0.5 <= spot.x_px <= image.shape[1] - 0.5
        assert -0.5 <= spot.y_px <= image.shape[0] - 0.5
        assert spot.standard_uncertainty_px > 0


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**31), st.integers(1, 12), st.sampled_from(DETECTORS))
def test_frames_full_of_spots_have_an_answer(seed: int, count: int, detector: SpotDetector) -> None:
    rng = np.random.default_rng(seed)
    spots = [(rng.uniform(-3, 163), rng.uniform(-3, 123), rng.uniform(0.2, 4), 10 ** rng.uniform(1, 3.5)) for _ in range(count)]
    found = detector.detect(frame(*spots, seed=seed))
    assert isinstance(found, Spot | SpotMiss)
    if isinstance(found, SpotMiss):
        assert list(found.candidates) == sorted(found.candidates, key=lambda spot: -spot.flux_dn)


def test_unknown_centroid_is_refused_and_old_keys_are_enough() -> None:
    unknown: dict[str, Any] = {"centroid": "middle"}
    with pytest.raises(UsageError, match="weighted, gaussian or border"):
        SpotDetectorParameters(**unknown)
    old = dict(threshold_sigmas=4.5, min_contrast_dn=4.0, min_peak_dn=10.0, min_area_px=2, max_area_px=600, max_elongation=4.0)
    old |= dict(saturation_dn=254, max_saturated_px=6, dominance=4.0, max_background_dn=100.0, read_noise_dn=1.4, shot_dn=0.0125)
    assert SpotDetectorParameters(**old, floor_px=0.045, centroid="border").max_censored_px == SpotDetectorParameters().max_censored_px
