"""Frames of spots at known places, for the tests of the detector."""

from __future__ import annotations

import numpy as np

from scanner_core.optics.spot_detection import SpotDetectorParameters
from tests.bench.optics.spot_images import BENCH, expose, signals

SHAPE = (120, 160)
PARAMETERS = SpotDetectorParameters(read_noise_dn=BENCH.read_dn, shot_dn=BENCH.shot_dn, floor_px=0.0)


def light(x: float, y: float, sigma_x: float, sigma_y: float, peak_dn: float, shape: tuple[int, int] = SHAPE) -> np.ndarray:
    """One spot without noise, DN over black; the sigmas are the light's own."""
    return signals(np.array([x]), np.array([y]), (sigma_x, sigma_y), peak_dn, shape[::-1])[0]


def frame(*spots: tuple[float, float, float, float], seed: int = 0, shape: tuple[int, int] = SHAPE) -> np.ndarray:
    """A noisy frame with round spots (x, y, sigma, peak)."""
    total = np.zeros(shape)
    for x, y, sigma, peak in spots:
        total += light(x, y, sigma, sigma, peak, shape)
    return expose(total, BENCH, np.random.default_rng(seed))
