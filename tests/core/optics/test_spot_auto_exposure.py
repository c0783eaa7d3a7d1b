from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.acquisition.exposing import expose_automatically
from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Frame
from scanner_core.optics.auto_exposure import ExposureLimits, ExposureReading, ExposureVerdict, combine_readings, propose_exposure
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens import load_specimen
from tests.bench.optics.spot_images import BENCH, expose
from tests.core.optics.spots import PARAMETERS, light
from tests.core.virtual.conftest import ScriptedMotion

LIMITS = ExposureLimits(0.05, 16.0)
DETECTOR = SpotDetector(PARAMETERS)


@dataclass
class Scene:
    """A camera before a spot and a lamp: signals in DN per ms at 0 dB."""

    spot_dn_per_ms: float
    lamp_dn_per_ms: float = 0.0
    exposure_ms: float = 2.0
    gain_db: float = 0.0
    hot_pixel: bool = False
    grabs: int = 0

    def grab(self) -> Frame:
        self.grabs += 1
        level = self.exposure_ms * 10 ** (self.gain_db / 20)
        signal = level * (light(80.2, 60.4, 1.0, 0.8, self.spot_dn_per_ms) + self.lamp_dn_per_ms)
        image = expose(signal, BENCH, np.random.default_rng(self.grabs))
        if self.hot_pixel:
            image[10, 10] = 255
        return Frame(image, self.grabs, 0.0, "left")


@pytest.mark.parametrize("spot", [400.0, 90.0, 20.0, 9.0, 1.0])
@pytest.mark.parametrize("hot_pixel", [False, True], ids=["", "hot pixel"])
def test_peak_ends_between_70_and_85_percent_within_a_few_steps(spot: float, hot_pixel: bool) -> None:
    camera = Scene(spot, hot_pixel=hot_pixel)
    result = expose_automatically(camera, DETECTOR, LIMITS)
    assert result.verdict is ExposureVerdict.GOOD
    assert len(result.readings) <= 5
    assert 0.70 * 255 <= result.readings[-1].peak_dn <= 0.85 * 255
    assert result.readings[-1].background_dn < 0.05 * 255
    assert camera.gain_db == 0.0 or camera.exposure_ms == LIMITS.longest_ms


@pytest.mark.parametrize(
    ("camera", "verdict", "word"),
    [
        (Scene(0.3), ExposureVerdict.TOO_DARK, "dark"),
        (Scene(0.0), ExposureVerdict.TOO_DARK, "dark"),
        (Scene(60_000.0), ExposureVerdict.SATURATED, "bright"),
        (Scene(80.0, lamp_dn_per_ms=20.0), ExposureVerdict.BACKGROUND, "lamp"),
        (Scene(80.0, lamp_dn_per_ms=5000.0), ExposureVerdict.BACKGROUND, "lamp"),
        (Scene(0.0, lamp_dn_per_ms=60.0), ExposureVerdict.BACKGROUND, "lamp"),
    ],
    ids=["faint", "no laser", "burnt", "lamp", "lamp alone at first", "lamp and no laser"],
)
def test_what_cannot_be_reached_is_named(camera: Scene, verdict: ExposureVerdict, word: str) -> None:
    result = expose_automatically(camera, DETECTOR, LIMITS)
    assert result.verdict is verdict
    assert word in result.verdict.advice


@pytest.mark.parametrize(
    ("peak_dn", "background_dn", "verdict"),
    [
        (200.0, 8.0, ExposureVerdict.GOOD),
        (60.0, 8.0, ExposureVerdict.TOO_DARK),
        (9.5, 9.5, ExposureVerdict.TOO_DARK),
        (255.0, 8.0, ExposureVerdict.SATURATED),
    ],
)
def test_a_camera_that_does_not_tell_its_exposure_is_judged_and_left_alone(peak_dn: float, background_dn: float, verdict: ExposureVerdict) -> None:
    proposal = propose_exposure(ExposureReading(0.0, 0.0, peak_dn, int(peak_dn == 255), background_dn), LIMITS)
    assert (proposal.verdict, proposal.exposure_ms, proposal.gain_db) == (verdict, 0.0, 0.0)


@settings(max_examples=100, deadline=None)
@given(st.floats(1.0, 4000.0), st.floats(0.06, 16.0), st.floats(0.0, 24.0))
def test_rule_converges_from_anywhere_and_prefers_exposure_to_gain(spot_dn_per_ms: float, exposure_ms: float, gain_db: float) -> None:
    for _ in range(8):
        signal = spot_dn_per_ms * exposure_ms * 10 ** (gain_db / 20)
        clipped = 0 if signal <= 246 else math.ceil(2 * math.pi * math.log(signal / 246))
        proposal = propose_exposure(ExposureReading(exposure_ms, gain_db, min(8 + signal, 255.0), clipped, 8.0), LIMITS)
        if proposal.verdict is not ExposureVerdict.CHANGE:
            break
        exposure_ms, gain_db = proposal.exposure_ms, proposal.gain_db
        assert LIMITS.shortest_ms <= exposure_ms <= LIMITS.longest_ms
        assert LIMITS.lowest_gain_db <= gain_db <= LIMITS.highest_gain_db
        assert gain_db == 0.0 or exposure_ms == LIMITS.longest_ms
    assert proposal.verdict is ExposureVerdict.GOOD


def test_several_frames_count_by_their_bright_ones_and_the_usual_background() -> None:
    readings = [ExposureReading(2.0, 0.0, peak, 0, background) for peak, background in ((100.0, 8.0), (180.0, 8.2), (150.0, 40.0))]
    assert combine_readings(readings) == ExposureReading(2.0, 0.0, 180.0, 0, 8.2)


def test_camera_of_the_virtual_rig_is_exposed_for_its_specimen() -> None:
    bench = VirtualBench(PRESETS["bench"], load_specimen("sphere"), SteppedClock(), ScriptedMotion(), seed=2)
    for side in ("left", "right"):
        with bench.camera(side) as camera:
            camera.exposure_ms = 0.1
            result = expose_automatically(camera, DETECTOR, ExposureLimits(0.01, 1e3 / camera.rate_hz))
            assert result.verdict is ExposureVerdict.GOOD
            assert len(result.readings) <= 4
            assert camera.exposure_ms > 0.5


@pytest.mark.parametrize(
    ("peak_dn", "background_dn", "verdict"),
    [
        (200.0, 3.0, ExposureVerdict.GOOD),
        (60.0, 3.0, ExposureVerdict.TOO_DARK),
        (240.0, 3.0, ExposureVerdict.SATURATED),
        (200.0, 40.0, ExposureVerdict.BACKGROUND),
    ],
)
def test_a_camera_that_does_not_tell_its_exposure_is_judged_and_not_set(peak_dn: float, background_dn: float, verdict: ExposureVerdict) -> None:
    proposal = propose_exposure(ExposureReading(0.0, 0.0, peak_dn, 0, background_dn), LIMITS)
    assert (proposal.verdict, proposal.exposure_ms, proposal.gain_db) == (verdict, 0.0, 0.0)
