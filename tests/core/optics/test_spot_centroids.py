"""The three centroids against the Cramer-Rao bound and against what they say of themselves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_background import estimate_background
from scanner_core.optics.spot_centroid import Moments, PixelNoise
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters
from scanner_core.optics.spot_fit import fit_gaussian
from tests.bench.optics.spot_accuracy import measure
from tests.bench.optics.spot_images import BENCH, WORKSHOP, Sensor, SpotShape, bound, expose
from tests.core.optics.spots import PARAMETERS, SHAPE, light

COUNT = 300
SPREAD = 4 / np.sqrt(2 * COUNT)
"""Four standard deviations of a rms of so many errors."""


@pytest.mark.parametrize("sensor", [BENCH, WORKSHOP], ids=["bench", "workshop"])
@pytest.mark.parametrize("shape", [SpotShape(0.85, 0.85, 250.0), SpotShape(0.85, 2.0, 120.0), SpotShape(2.0, 1.2, 50.0)], ids=str)
@pytest.mark.parametrize(("centroid", "most"), [("weighted", 1.08), ("gaussian", 1.02)])
def test_centroid_reaches_the_bound_and_knows_its_error(centroid: str, most: float, shape: SpotShape, sensor: Sensor) -> None:
    row = measure(shape, sensor, centroid, COUNT, seed=11)
    assert row.found == 1.0
    assert (row.over_bound < most).all()  # chance is left out of it, see `measure`
    assert abs(row.stated_over_actual - 1) < 0.06
    assert (np.abs(row.split_over_actual - 1) < 0.08).all()
    assert (np.abs(row.sigma_over_true - 1) < 0.03).all()


@pytest.mark.parametrize("centroid", ["gaussian", "weighted"])
def test_clipped_spot_is_fitted_near_the_bound_of_what_is_left_of_it(centroid: str) -> None:
    row = measure(SpotShape(1.0, 0.8, 450.0), BENCH, centroid, COUNT, seed=12)
    assert row.found == 1.0
    assert (row.over_bound < 1.03 + SPREAD).all()
    assert abs(row.stated_over_actual - 1) < 0.05 + SPREAD / np.sqrt(2)
    assert (np.abs(row.sigma_over_true - 1) < 0.02).all()


def test_border_centroid_is_several_times_less_certain_and_says_so() -> None:
    row = measure(SpotShape(1.0, 1.0, 250.0), BENCH, "border", COUNT, seed=13)
    assert (row.over_bound > 3).all()
    assert abs(row.stated_over_actual - 1) < 0.1 + SPREAD


def test_bound_agrees_with_the_closed_form_of_a_finely_sampled_spot() -> None:
    """Read noise alone, sigma large: var(x) = noise^2 sigma_x 2 / (pi peak^2 sigma_y)."""
    shape = SpotShape(3.0, 2.5, 100.0)
    x, y = bound(shape, Sensor(1.4, 0.0), (50, 50))
    noise = np.sqrt(1.4**2 + 1 / 12)
    sx, sy = shape.optical
    assert x == pytest.approx(noise / 100 * np.sqrt(2 * sx / (np.pi * sy)), rel=0.02)
    assert y == pytest.approx(noise / 100 * np.sqrt(2 * sy / (np.pi * sx)), rel=0.02)


@settings(max_examples=30, deadline=None)
@given(
    st.floats(-0.5, 0.5),
    st.floats(-0.5, 0.5),
    st.floats(0.8, 2.5),
    st.floats(0.8, 2.5),
    st.floats(60.0, 500.0),
    st.sampled_from(["weighted", "gaussian"]),
)
def test_noiseless_spot_is_where_it_is(dx: float, dy: float, sigma_x: float, sigma_y: float, peak_dn: float, centroid: str) -> None:
    parameters = SpotDetectorParameters(read_noise_dn=BENCH.read_dn, shot_dn=BENCH.shot_dn, floor_px=0.0, centroid=centroid, max_saturated_px=60)
    image = np.clip(np.round(8 + light(80 + dx, 60 + dy, sigma_x, sigma_y, peak_dn)), 0, 255).astype(np.uint8)
    found = SpotDetector(parameters).detect(image)
    assert isinstance(found, Spot)
    assert abs(found.x_px - 80 - dx) < 0.02
    assert abs(found.y_px - 60 - dy) < 0.02
    assert 0.95 < found.sigma_x_px / np.sqrt(sigma_x**2 + 1 / 12) < 1.06
    assert 0.95 < found.sigma_y_px / np.sqrt(sigma_y**2 + 1 / 12) < 1.06


def test_sigma_grows_with_the_spot_from_a_fraction_of_a_pixel_on() -> None:
    rng = np.random.default_rng(3)
    for centroid in ("weighted", "gaussian"):
        detector = SpotDetector(SpotDetectorParameters(floor_px=0.0, min_area_px=1, centroid=centroid))
        sigmas = []
        for sigma in (0.3, 0.45, 0.6, 0.75, 0.9, 1.1):
            seen = []
            for _ in range(25):
                x, y = 80 + rng.uniform(-0.5, 0.5), 60 + rng.uniform(-0.5, 0.5)
                found = detector.detect(expose(light(x, y, sigma, sigma, 220 * min(1.0, (0.9 / sigma) ** 0.5), SHAPE), BENCH, rng))
                assert isinstance(found, Spot)
                seen.append(found.sigma_x_px)
            sigmas.append(np.mean(seen))
        assert (np.diff(sigmas) > 0.04).all()


def test_fit_that_cannot_converge_says_so() -> None:
    noise = PixelNoise(8.0, 2.0, 0.0125, 254)
    flat = np.full((9, 9), 8, np.uint8)
    start = Moments(4.0, 4.0, 1.0, 1.0, 0.0, 0.01, 0.01, 1.0, 1, 0)
    assert fit_gaussian(flat, 4.0, 4.0, start, noise) is None


def test_background_leaves_out_what_is_bright_and_counts_the_rounding() -> None:
    image = expose(np.zeros((294, 604)), BENCH, np.random.default_rng(1))
    image[40:90, 100:260] = 200
    background = estimate_background(image)
    assert background.mean_dn == pytest.approx(8.0, abs=0.1)
    assert background.sd_dn == pytest.approx(np.sqrt(1.4**2 + 1 / 12), rel=0.05)


def test_weighted_and_gaussian_differ_by_less_than_their_uncertainty_on_the_same_frame() -> None:
    rng = np.random.default_rng(5)
    ratios = []
    for _ in range(50):
        x, y = 80 + rng.uniform(-0.5, 0.5), 60 + rng.uniform(-0.5, 0.5)
        image = expose(light(x, y, 1.0, 0.8, 150.0), BENCH, rng)
        fast, precise = (SpotDetector(p).detect(image) for p in (PARAMETERS, replace(PARAMETERS, centroid="gaussian")))
        assert isinstance(fast, Spot)
        assert isinstance(precise, Spot)
        ratios.append((fast.x_px - precise.x_px) / precise.standard_uncertainty_px)
    assert np.sqrt(np.mean(np.square(ratios))) < 0.5
