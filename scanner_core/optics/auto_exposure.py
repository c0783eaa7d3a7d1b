"""Exposure and gain from what the frames show: the spot's peak at 70 to 85 % of full scale, the background below 5 %.

A spot's signal over the background grows with exposure and gain, so one reading that is neither clipped nor drowned in
noise tells the right setting; the rest of the rule is about readings that are.  Exposure comes first, because gain
amplifies the noise along with the light; gain only what the longest exposure leaves open.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from scanner_core.optics.spot import MissReason, Spot
from scanner_core.optics.spot_background import estimate_background
from scanner_core.optics.spot_detection import Image, SpotDetector

FULL_SCALE_DN = 255.0
LOWEST_PEAK, AIMED_PEAK, HIGHEST_PEAK = 0.70, 0.775, 0.85
"""Of full scale."""
HIGHEST_BACKGROUND = 0.05
"""Of full scale."""
HIGHEST_GAIN_DB = 24.0

_SMALLEST_SIGNAL_DN = 6.0
"""A fainter spot may be noise: its height tells nothing but "more"."""
_LARGEST_STEP = 8.0
_CLIPPED_PER_E = 9.0
"""Clipped pixels of a spot e times as bright as full scale: 2 pi sigma^2 at a sigma of 1.2 px.  Where that is wrong the next
reading tells."""
_SMALLEST_CLIPPED_STEP, _LARGEST_CLIPPED_STEP = 0.7, 0.02
_UNCHANGED = 1.001
"""A change of the light by less is none."""


class ExposureVerdict(Enum):
    """What a reading calls for."""

    GOOD = "good"
    CHANGE = "change"
    TOO_DARK = "too_dark"
    SATURATED = "saturated"
    BACKGROUND = "background"

    @property
    def advice(self) -> str:
        return _ADVICE[self]


_ADVICE = {
    ExposureVerdict.GOOD: "The spot is well exposed.",
    ExposureVerdict.CHANGE: "Exposure or gain has to change.",
    ExposureVerdict.TOO_DARK: "The spot is too dark at the longest exposure and the highest gain: "
    "check the laser and the lens cap, or open the aperture.",
    ExposureVerdict.SATURATED: "The spot is too bright at the shortest exposure: close the aperture or use a weaker laser.",
    ExposureVerdict.BACKGROUND: "The background is too bright beside the spot, whatever the exposure: switch off the lamp or shield the rig.",
}


@dataclass(frozen=True, slots=True)
class ExposureReading:
    """What frames at one setting showed.

    Attributes
    ----------
    exposure_ms, gain_db : of the frames; 0 ms = the camera does not tell
    peak_dn : brightest pixel of the spot, 0 to 255; the background where no spot was seen
    saturated_px : clipped pixels
    background_dn : level of the dark pixels
    """

    exposure_ms: float
    gain_db: float
    peak_dn: float
    saturated_px: int
    background_dn: float


@dataclass(frozen=True, slots=True)
class ExposureLimits:
    """What the camera can do, and the longest exposure that the rig's motion bears."""

    shortest_ms: float
    longest_ms: float
    lowest_gain_db: float = 0.0
    highest_gain_db: float = HIGHEST_GAIN_DB


@dataclass(frozen=True, slots=True)
class ExposureProposal:
    """The next setting; that of the reading unless the verdict is `CHANGE`."""

    verdict: ExposureVerdict
    exposure_ms: float
    gain_db: float


def combine_readings(readings: Sequence[ExposureReading]) -> ExposureReading:
    """One reading of several frames at the same setting: upper decile of the peaks, so that few places clip; median background."""
    ordered = sorted(readings, key=lambda reading: (reading.peak_dn, reading.saturated_px))
    bright = ordered[min(len(ordered) - 1, math.ceil(0.9 * (len(ordered) - 1)))]
    background = float(np.median([reading.background_dn for reading in readings]))
    return ExposureReading(bright.exposure_ms, bright.gain_db, bright.peak_dn, bright.saturated_px, background)


def propose_exposure(reading: ExposureReading, limits: ExposureLimits) -> ExposureProposal:
    """The next exposure and gain after a reading, or the verdict that ends the search.

    A camera that does not tell its exposure (0 ms: a stream) cannot be set either: its reading is judged as it is.
    """
    if not reading.exposure_ms > 0:
        return _stay(reading, _judged_as_it_is(reading))
    signal = reading.peak_dn - reading.background_dn
    if reading.saturated_px or reading.peak_dn >= FULL_SCALE_DN - 1:
        factor = min(max(AIMED_PEAK * math.exp(-reading.saturated_px / _CLIPPED_PER_E), _LARGEST_CLIPPED_STEP), _SMALLEST_CLIPPED_STEP)
    elif signal < _SMALLEST_SIGNAL_DN:
        factor = _LARGEST_STEP
    elif LOWEST_PEAK * FULL_SCALE_DN <= reading.peak_dn <= HIGHEST_PEAK * FULL_SCALE_DN:
        too_bright = reading.background_dn > HIGHEST_BACKGROUND * FULL_SCALE_DN
        return _stay(reading, ExposureVerdict.BACKGROUND if too_bright else ExposureVerdict.GOOD)
    else:
        # the background may grow with the light, or be the sensor's black level: the next reading tells
        factor = min((AIMED_PEAK * FULL_SCALE_DN - reading.background_dn) / signal, _LARGEST_STEP)
        if factor <= 0:
            factor = 1 / _LARGEST_STEP
    if signal < _SMALLEST_SIGNAL_DN and reading.background_dn > 0.5 * FULL_SCALE_DN:
        factor = 1 / _LARGEST_STEP  # the light that hides the spot is not the laser's
    light = factor * reading.exposure_ms * _amplification(reading.gain_db)
    exposure_ms = min(max(light / _amplification(limits.lowest_gain_db), limits.shortest_ms), limits.longest_ms)
    gain_db = min(max(20 * math.log10(light / exposure_ms), limits.lowest_gain_db), limits.highest_gain_db)
    reached = exposure_ms * _amplification(gain_db) / (reading.exposure_ms * _amplification(reading.gain_db))
    if (reached > _UNCHANGED) if factor > 1 else (reached < 1 / _UNCHANGED):
        return ExposureProposal(ExposureVerdict.CHANGE, exposure_ms, gain_db)
    return _stay(reading, at_the_limit(reading))


def _judged_as_it_is(reading: ExposureReading) -> ExposureVerdict:
    within = LOWEST_PEAK * FULL_SCALE_DN <= reading.peak_dn <= HIGHEST_PEAK * FULL_SCALE_DN and not reading.saturated_px
    return ExposureVerdict.GOOD if within and reading.background_dn <= HIGHEST_BACKGROUND * FULL_SCALE_DN else at_the_limit(reading)


def gain_making_up(exposure_ms: float, gain_db: float, new_exposure_ms: float) -> float:
    """Gain, dB, at which another exposure shows what these show, between none and the highest."""
    return min(max(gain_db + 20 * math.log10(exposure_ms / new_exposure_ms), 0.0), HIGHEST_GAIN_DB)


def at_the_limit(reading: ExposureReading) -> ExposureVerdict:
    """What is wrong with a reading that no other setting can improve."""
    if reading.background_dn > HIGHEST_BACKGROUND * FULL_SCALE_DN:
        return ExposureVerdict.BACKGROUND
    return ExposureVerdict.TOO_DARK if reading.peak_dn < AIMED_PEAK * FULL_SCALE_DN else ExposureVerdict.SATURATED


def read_exposure(image: Image, exposure_ms: float, gain_db: float, detector: SpotDetector) -> ExposureReading:
    """What a frame (H, W) uint8 at a setting shows."""
    seen = detector.detect(image)
    background_dn = estimate_background(image).mean_dn
    unseen = not isinstance(seen, Spot) and seen.reason in (MissReason.NO_SPOT, MissReason.TOO_SMALL)
    peak_dn = background_dn if unseen else seen.peak_dn
    saturation_dn = detector.parameters.saturation_dn
    saturated = int(np.count_nonzero(image >= saturation_dn)) if peak_dn >= saturation_dn else 0
    return ExposureReading(exposure_ms, gain_db, peak_dn, saturated, background_dn)


def _stay(reading: ExposureReading, verdict: ExposureVerdict) -> ExposureProposal:
    return ExposureProposal(verdict, reading.exposure_ms, reading.gain_db)


def _amplification(gain_db: float) -> float:
    return float(10 ** (gain_db / 20))
