from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import erf

from scanner_core.errors import UsageError
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters

SHAPE = (294, 604)
BACKGROUND_DN, READ_DN, SHOT_DN = 8.0, 1.5, 0.0255
PARAMETERS = SpotDetectorParameters(read_noise_dn=READ_DN, shot_dn=SHOT_DN, floor_px=0.0)
DETECTOR = SpotDetector(PARAMETERS)


def _spot(x: float, y: float, sigma_x: float, sigma_y: float, peak_dn: float, shape: tuple[int, int]) -> np.ndarray:
    """A Gaussian integrated over every pixel's square, DN."""

    def over_pixels(n: int, centre: float, sigma: float) -> np.ndarray:
        edges = (np.arange(n + 1) - 0.5 - centre) / (sigma * np.sqrt(2))
        return np.diff(erf(edges)) / 2

    return 2 * np.pi * sigma_x * sigma_y * peak_dn * np.outer(over_pixels(shape[0], y, sigma_y), over_pixels(shape[1], x, sigma_x))


def _expose(light: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    noise = rng.normal(size=light.shape) * np.sqrt(READ_DN**2 + SHOT_DN * light)
    return np.clip(np.round(BACKGROUND_DN + light + noise), 0, 255).astype(np.uint8)


def _frame(*spots: tuple[float, float, float, float], seed: int = 0) -> np.ndarray:
    """A noisy frame with spots (x, y, sigma, peak)."""
    light = np.zeros(SHAPE)
    for x, y, sigma, peak in spots:
        light += _spot(x, y, sigma, sigma, peak, SHAPE)
    return _expose(light, np.random.default_rng(seed))


def _crlb_px(x: float, y: float, sigma_x: float, sigma_y: float, peak_dn: float, shape: tuple[int, int]) -> np.ndarray:
    """Cramer-Rao bound of x and y with unknown brightness, from the Fisher information of every pixel."""
    h = 1e-4
    light = _spot(x, y, sigma_x, sigma_y, peak_dn, shape)
    slopes = [
        (_spot(x + dx, y + dy, sigma_x, sigma_y, peak_dn, shape) - _spot(x - dx, y - dy, sigma_x, sigma_y, peak_dn, shape)).ravel() / (2 * h)
        for dx, dy in ((h, 0), (0, h))
    ]
    jacobian = np.array([*slopes, light.ravel() / peak_dn])
    variance = READ_DN**2 + SHOT_DN * light.ravel() + 1 / 12
    return np.sqrt(np.diag(np.linalg.inv((jacobian / variance) @ jacobian.T)))[:2]


def _series(sigma_x: float, sigma_y: float, peak_dn: float, count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Errors (n, 2), stated uncertainties (n,) and mean Cramer-Rao bound (2,) over random places in the pixel."""
    rng = np.random.default_rng(seed)
    shape = (48, 64)
    errors, stated, bounds = [], [], []
    for _ in range(count):
        x, y = 32 + rng.uniform(-0.5, 0.5), 24 + rng.uniform(-0.5, 0.5)
        found = DETECTOR.detect(_expose(_spot(x, y, sigma_x, sigma_y, peak_dn, shape), rng))
        if isinstance(found, Spot):
            errors.append((found.x_px - x, found.y_px - y))
            stated.append(found.standard_uncertainty_px)
            bounds.append(_crlb_px(x, y, sigma_x, sigma_y, peak_dn, shape))
    return np.array(errors), np.array(stated), np.mean(bounds, axis=0)


@pytest.mark.parametrize(("sigma_x", "sigma_y", "peak_dn"), [(1.0, 1.0, 40.0), (1.0, 1.0, 200.0), (1.4, 1.1, 120.0), (1.0, 0.8, 220.0)])
def test_centroid_is_unbiased_and_near_the_cramer_rao_bound(sigma_x: float, sigma_y: float, peak_dn: float) -> None:
    errors, stated, bound = _series(sigma_x, sigma_y, peak_dn, 400, seed=1)
    assert len(errors) == 400
    rms = np.sqrt((errors**2).mean(axis=0))
    assert (rms <= 1.6 * bound).all()
    assert (np.abs(errors.mean(axis=0)) < 4 * rms / np.sqrt(400)).all()
    assert 0.8 < np.sqrt((errors**2 / stated[:, None] ** 2).mean()) < 1.25


def test_dim_spot_stays_usable_with_an_honest_uncertainty() -> None:
    errors, stated, _ = _series(1.0, 0.8, 16.0, 400, seed=2)
    assert len(errors) > 380
    assert stated.mean() < 0.25
    assert 0.7 < np.sqrt((errors**2 / stated[:, None] ** 2).mean()) < 1.25


def test_spot_reports_its_shape() -> None:
    found = DETECTOR.detect(_frame((300.2, 150.7, 1.5, 180)))
    assert isinstance(found, Spot)
    assert found.sigma_x_px == pytest.approx(np.sqrt(1.5**2 + 1 / 12), rel=0.06)
    assert found.sigma_y_px == pytest.approx(np.sqrt(1.5**2 + 1 / 12), rel=0.06)
    assert found.peak_dn == pytest.approx(180, rel=0.12)
    assert 20 < found.area_px < 80


def _hot_pixel() -> np.ndarray:
    frame = _frame()
    frame[100, 200] = 255
    return frame


def _streak() -> np.ndarray:
    light = _spot(300, 150, 12.0, 0.8, 90, SHAPE)
    return _expose(light, np.random.default_rng(4))


@pytest.mark.parametrize(
    ("frame", "reason"),
    [
        (np.zeros(SHAPE, np.uint8), MissReason.NO_SPOT),
        (_frame((300, 150, 3.0, 6)), MissReason.TOO_DIM),
        (_hot_pixel(), MissReason.TOO_SMALL),
        (_frame((300, 150, 12.0, 120)), MissReason.TOO_LARGE),
        (_streak(), MissReason.ELONGATED),
        (_frame((300, 150, 1.5, 2000)), MissReason.SATURATED),
        (_frame((1.0, 150, 1.2, 150)), MissReason.CUT_BY_EDGE),
        (_frame((300, 292.5, 1.2, 150)), MissReason.CUT_BY_EDGE),
        (_frame((300, 150, 1.0, 150), (400, 80, 1.0, 100)), MissReason.AMBIGUOUS),
        (np.clip(_frame().astype(int) + 150, 0, 255).astype(np.uint8), MissReason.TOO_BRIGHT),
    ],
    ids=lambda value: value.name if isinstance(value, MissReason) else "",
)
def test_every_gate_names_its_reason(frame: np.ndarray, reason: MissReason) -> None:
    found = DETECTOR.detect(frame)
    assert isinstance(found, SpotMiss)
    assert found.reason is reason


def test_noise_alone_is_no_spot() -> None:
    for seed in range(20):
        found = DETECTOR.detect(_frame(seed=seed))
        assert isinstance(found, SpotMiss)
        assert found.reason in (MissReason.NO_SPOT, MissReason.TOO_DIM)


def test_dominant_spot_wins_over_a_weak_reflection() -> None:
    frame = _frame((300, 150, 1.0, 200), (400, 80, 1.0, 30), (101, 33, 1.0, 25))
    found = DETECTOR.detect(frame)
    assert isinstance(found, Spot)
    assert (round(found.x_px), round(found.y_px)) == (300, 150)
    candidates, _ = DETECTOR.candidates(frame, DETECTOR.levels(frame))
    assert [(round(spot.x_px), round(spot.y_px)) for spot in candidates] == [(300, 150), (400, 80), (101, 33)]


def test_ambiguous_spots_come_with_the_miss_brightest_first() -> None:
    frame = _frame((300, 150, 1.0, 120), (400, 80, 1.0, 150))
    found = DETECTOR.detect(frame)
    assert isinstance(found, SpotMiss)
    assert found.reason is MissReason.AMBIGUOUS
    assert [(round(spot.x_px), round(spot.y_px)) for spot in found.candidates] == [(400, 80), (300, 150)]
    assert list(found.candidates) == DETECTOR.candidates(frame, DETECTOR.levels(frame))[0]


def test_hot_pixel_does_not_hide_a_spot() -> None:
    frame = np.maximum(_hot_pixel(), _frame((300, 150, 1.0, 40)))
    found = DETECTOR.detect(frame)
    assert isinstance(found, Spot)
    assert round(found.x_px) == 300


def test_parameters_outside_their_range_are_refused() -> None:
    with pytest.raises(UsageError, match="threshold_sigmas"):
        SpotDetectorParameters(threshold_sigmas=1.0)


def test_border_centroid_follows_a_wide_spot_and_locks_to_pixels_on_a_small_one() -> None:
    detector = SpotDetector(replace(PARAMETERS, centroid="border", min_area_px=1))
    rng = np.random.default_rng(6)
    rms = {}
    for sigma, peak_dn in ((1.4, 190.0), (0.25, 450.0)):
        errors = []
        for _ in range(150):
            x, y = 32 + rng.uniform(-0.5, 0.5), 24 + rng.uniform(-0.5, 0.5)
            found = detector.detect(_expose(_spot(x, y, sigma, sigma, peak_dn, (48, 64)), rng))
            assert isinstance(found, Spot)
            errors.append((found.x_px - x, found.y_px - y))
        rms[sigma] = np.sqrt(np.mean(np.square(errors)))
    assert rms[1.4] < 0.03
    assert 0.05 < rms[0.25] < 0.3


def test_noise_pixels_are_no_dim_spots() -> None:
    frame = np.full(SHAPE, 8, np.uint8)
    frame[::50, ::50] = 14
    found = DETECTOR.detect(frame)
    assert isinstance(found, SpotMiss)
    assert found.reason is MissReason.NO_SPOT


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**31), st.integers(1, 5))
def test_search_of_few_rows_finds_what_contours_of_the_whole_frame_find(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    spots = [(rng.uniform(-3, 607), rng.uniform(-3, 297), rng.uniform(0.3, 5), 10 ** rng.uniform(0.8, 2.8)) for _ in range(count)]
    image = _frame(*spots, seed=seed)
    levels = DETECTOR.levels(image)
    boxes, peak = DETECTOR.boxes(image, levels)
    above = cv2.threshold(image, levels.extent_dn, 255, cv2.THRESH_BINARY)[1]
    every = [cv2.boundingRect(blob) for blob in cv2.findContours(above, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]]
    bright = [(x, y, w, h) for x, y, w, h in every if image[y : y + h, x : x + w].max() > levels.seed_dn]
    assert peak == image.max()
    assert set(bright or every) <= {tuple(box) for box in boxes} <= set(every)
