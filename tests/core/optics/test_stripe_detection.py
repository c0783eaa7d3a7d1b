"""The line detector against images whose curve is known."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import ndtr

from scanner_core.errors import UsageError
from scanner_core.optics.stripe_detection import StripeDetector, StripeDetectorParameters
from tests.core.optics.stripes import aside, exposed, stripe_signal

Array = NDArray[np.float64]

SIZE, BLUR = (72, 64), (0.957, 0.777)
DETECTOR = StripeDetector()


def line(slope: float, offset: float = 0.0) -> Array:
    """Upright where the slope is 0, through the middle of the image, cut before its border."""
    t = np.linspace(-26, 26, 3001)
    xy = np.c_[36 + offset + slope * t, 32 + t] if abs(slope) <= 1 else np.c_[36 + t, 32 + offset + t / slope]
    return np.asarray(xy[(xy[:, 0] > 9) & (xy[:, 0] < 63) & (xy[:, 1] > 6) & (xy[:, 1] < 58)])


@pytest.mark.parametrize("slope", [0.0, -0.9, 2.0])
def test_a_straight_line_is_found_without_bias_whatever_its_direction(slope: float) -> None:
    rng = np.random.default_rng(3)
    errors = []
    for offset in np.linspace(0, 0.9, 6):
        curve = line(slope, offset)
        peaks = DETECTOR.detect(exposed(stripe_signal(curve, SIZE, BLUR, 150), rng)).peaks
        middle = peaks.select(np.linalg.norm(peaks.xy - (36, 32), axis=1) < 16)
        assert len(middle) > 40
        errors.append(aside(middle.xy, curve))
    error = np.concatenate(errors)
    assert abs(error.mean()) < 0.01
    assert error.std() < 0.06


def test_the_profile_fit_reaches_the_cramer_rao_bound() -> None:
    detector = StripeDetector(StripeDetectorParameters(rounds=1, per_px=1))
    rng = np.random.default_rng(5)
    curve = line(0.0, 0.3)
    signal = stripe_signal(curve, SIZE, BLUR, 150)
    edges = (np.arange(SIZE[0] + 1) - 0.5 - 36.3) / BLUR[0]
    slope = np.diff(np.exp(-0.5 * edges**2)) / BLUR[0]
    slope *= signal[32].max() / np.diff(ndtr(edges)).max() / np.sqrt(2 * np.pi)
    bound = 1 / np.sqrt((slope**2 / (1.4**2 + 1 / 12 + 0.0125 * signal[32])).sum())
    errors, stated = [], []
    for _ in range(20):
        peaks = detector.detect(exposed(signal, rng)).peaks
        middle = peaks.select(np.abs(peaks.xy[:, 1] - 32) < 15)
        errors.append(middle.xy[:, 0] - 36.3)
        stated.append(middle.variance_px2 - (0.3 * middle.drawn_px) ** 2)
    assert np.concatenate(errors).std() < 1.15 * bound
    assert np.sqrt(np.concatenate(stated).mean()) == pytest.approx(bound, rel=0.1)


def test_the_blur_along_a_bent_line_is_taken_out() -> None:
    """A lens draws a circle of 9 px inwards by some 0.05 px and more; what is left is a fraction of it."""
    angle = np.linspace(-0.7, 0.7, 4001)
    curve = np.c_[25 + 9 * np.cos(angle), 32 + 9 * np.sin(angle)]
    image = exposed(stripe_signal(curve, SIZE, BLUR, 180), np.random.default_rng(0))
    left = {}
    for rounds in (1, 5):
        peaks = StripeDetector(StripeDetectorParameters(rounds=rounds)).detect(image).peaks
        middle = peaks.select(peaks.along_row & (np.abs(peaks.xy[:, 1] - 32) < 4))
        left[rounds] = float((np.linalg.norm(middle.xy - (25, 32), axis=1) - 9).mean())
    assert left[1] < -0.03
    assert abs(left[5]) < 0.4 * abs(left[1])


def test_light_that_grows_along_a_slanted_line_does_not_draw_it_aside() -> None:
    curve = line(0.8)
    signal = stripe_signal(curve, SIZE, BLUR, 180, np.exp(0.08 * (curve[:, 1] - 32)))
    peaks = DETECTOR.detect(exposed(signal, np.random.default_rng(1))).peaks
    middle = peaks.select(np.linalg.norm(peaks.xy - (40, 37), axis=1) < 9)
    assert len(middle) > 15
    assert abs(aside(middle.xy, curve).mean()) < 0.02


def test_a_fold_gives_two_peaks_in_a_row() -> None:
    t = np.linspace(8, 56, 2001)
    signal = stripe_signal(np.c_[np.full(2001, 24.4), t], SIZE, BLUR, 150) + stripe_signal(np.c_[np.full(2001, 41.7), t], SIZE, BLUR, 60)
    peaks = DETECTOR.detect(exposed(signal, np.random.default_rng(2))).peaks
    in_row = peaks.xy[peaks.along_row & (peaks.xy[:, 1] == 32)][:, 0]
    assert np.sort(in_row) == pytest.approx([24.4, 41.7], abs=0.12)


def test_clipped_pixels_are_left_out_and_too_many_reject_the_peak() -> None:
    curve = line(0.0, 0.2)
    signal = stripe_signal(curve, SIZE, BLUR, 330)
    found = DETECTOR.detect(exposed(signal, np.random.default_rng(4)))
    middle = found.peaks.select(np.abs(found.peaks.xy[:, 1] - 32) < 12)
    assert (middle.saturated_px > 0).all()
    assert abs((middle.xy[:, 0] - 36.2).mean()) < 0.06
    strict = StripeDetector(StripeDetectorParameters(max_saturated_px=0)).detect(exposed(signal, np.random.default_rng(4)))
    assert strict.rejected["saturated"] > 20


def test_a_dark_frame_and_a_flat_lamp_hold_no_line() -> None:
    rng = np.random.default_rng(6)
    assert len(DETECTOR.detect(exposed(np.zeros((64, 72)), rng)).peaks) == 0
    lamp = stripe_signal(np.array([[36.0, 32.0]]), SIZE, (7.0, 7.0), 180)
    assert len(DETECTOR.detect(exposed(lamp, rng)).peaks) == 0


def test_parameters_out_of_range_are_refused() -> None:
    with pytest.raises(UsageError):
        StripeDetectorParameters(min_peak_dn=0.5)
