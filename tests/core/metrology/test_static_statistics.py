"""The statistics of standing spots against points with known scatter and drift."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.metrology.static_statistics import StaticResult, evaluate_static

SD_UM = np.array([13.9, 11.5, 10.6])
PIXEL_MM = np.array([0.9, 1.4, 0.9, 1.4])
RATE_HZ = 60.0


def _evaluate(drift_um_s: NDArray[np.float64], places: int, rounds: int, each: int, seed: int, mover_um: float = 0.0) -> StaticResult:
    rng = np.random.default_rng(seed)
    place = np.tile(np.repeat(np.arange(places), each), rounds)
    stay = np.repeat(np.arange(places * rounds), each)
    time_s = np.arange(len(place)) / RATE_HZ
    offsets = rng.normal(0, 3000, (places, 3))[place] + rng.normal(0, mover_um, (places * rounds, 3))[stay]
    noise = rng.normal(0, 1, (len(place), 3))
    points = offsets + noise * SD_UM + time_s[:, None] * drift_um_s
    spots = np.c_[rng.normal(300, 0.02, (len(place), 4)), np.full((len(place), 4), 0.8), np.full((len(place), 2), 200.0)]
    return evaluate_static(points, place, stay, time_s, spots, PIXEL_MM, 671.75, len(place) + 5, {"no_spot": 5})


@pytest.mark.parametrize(("places", "rounds", "each"), [(1, 1, 8000), (40, 2, 100)])
def test_scatter_is_found_whatever_the_places(places: int, rounds: int, each: int) -> None:
    result = _evaluate(np.zeros(3), places, rounds, each, seed=1)
    assert result.repeats == 8000
    assert result.planned == 8005
    assert result.places == places
    np.testing.assert_allclose(result.sd_um, SD_UM, rtol=0.03)
    np.testing.assert_allclose(result.repeatability_um, 4 * SD_UM.mean(), rtol=0.03)
    np.testing.assert_allclose(result.centroid_sd_px, 0.02, rtol=0.05)
    np.testing.assert_allclose(result.resolution_um, 20 * np.sqrt((0.9**2 + 1.4**2) / 2), rtol=0.03)


@pytest.mark.parametrize(("places", "rounds", "each"), [(1, 1, 8000), (40, 2, 100)])
def test_a_drift_is_found_within_its_uncertainty(places: int, rounds: int, each: int) -> None:
    drift = np.array([0.4, -0.1, 0.0])
    result = _evaluate(drift, places, rounds, each, seed=2)
    off = (result.drift_um - drift * result.duration_s) / result.drift_uncertainty_um
    assert (np.abs(off) < 3.5).all()
    assert abs(result.drift_um[0]) > 10 * result.drift_uncertainty_um[0]
    np.testing.assert_allclose(result.drift_per_hour_um[0], 1440, rtol=0.1)
    np.testing.assert_allclose(result.sd_without_drift_um, SD_UM, rtol=0.03)


def test_the_drift_s_uncertainty_is_right_also_when_the_mover_misses_its_places() -> None:
    scores = []
    for seed in range(60):
        result = _evaluate(np.array([0.05, 0.0, -0.02]), 40, 2, 20, seed, mover_um=20.0)
        scores.append((result.drift_um - np.array([0.05, 0.0, -0.02]) * result.duration_s) / result.drift_uncertainty_um)
    assert 0.7 < float(np.std(scores)) < 1.6


def test_a_single_long_stay_with_drift_scatters_more_with_it_than_without() -> None:
    result = _evaluate(np.array([0.5, 0.0, 0.0]), 1, 1, 8000, seed=3)
    drifted = 0.5 * result.duration_s / np.sqrt(12)
    np.testing.assert_allclose(result.sd_um[0], np.hypot(SD_UM[0], drifted), rtol=0.03)
    np.testing.assert_allclose(result.sd_without_drift_um[0], SD_UM[0], rtol=0.03)


def test_stays_of_one_or_two_pairs_are_left_out() -> None:
    rng = np.random.default_rng(4)
    place = np.r_[np.zeros(50, int), 1, 1]
    points = rng.normal(0, 1, (52, 3))
    result = evaluate_static(points, place, place, np.arange(52.0), np.ones((52, 10)), PIXEL_MM, 671.75, 52, {})
    assert result.repeats == 50
    assert result.places == 1
    told = result.as_dict()
    assert told["diagonal_fraction"] is None  # spots that do not move at all
    assert told["drift_um"] == pytest.approx(result.drift_length_um, abs=1e-3)
