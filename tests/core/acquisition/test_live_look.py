"""What the aiming person sees, on rendered frames of the virtual rig."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from scanner_core.acquisition.live_look import SIDES, LiveEye
from scanner_core.clock import SteppedClock
from scanner_core.devices.camera import Frame
from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.epipolar_line import epipolar_line
from scanner_core.optics.spot import Spot
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens import Specimen, load_specimen

DIRECTIONS = [(float(x), float(y)) for y in np.linspace(1.5, 5.5, 4) for x in np.linspace(-3, 5, 10)]


class Beam:
    """One direction a second."""

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(*DIRECTIONS[int(time_s)], 0.0, 1.0)


@cache
def _heart() -> Specimen:
    return load_specimen("heart")


def _pairs(specular: float) -> tuple[VirtualBench, Iterator[tuple[Frame, Frame]]]:
    preset = replace(PRESETS["bench"], specular=specular)
    bench = VirtualBench(preset, _heart(), SteppedClock(), Beam(), seed=3)

    def frames() -> Iterator[tuple[Frame, Frame]]:
        for i in range(len(DIRECTIONS)):
            left, right = (Frame(bench.image(side, i + 0.1, preset.exposure_ms, 1.0, i), i, float(i), SIDES[side]) for side in (0, 1))
            yield left, right

    return bench, frames()


@pytest.fixture(scope="module")
def config() -> RigConfig:
    return load_preset("bench")


def _away_px(line: np.ndarray, x: float, y: float) -> float:
    """Of a pixel from a polyline."""
    start, along = line[:-1], np.diff(line, axis=0)
    to = np.array([x, y]) - start
    share = np.clip((to * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
    return float(np.hypot(*(to - share[:, None] * along).T).min())


def test_the_epipolar_line_passes_the_spot_within_a_pixel(config: RigConfig) -> None:
    bench, pairs = _pairs(0.02)
    eye, away = LiveEye(config, bench.truth_calibration()), []
    for left, right in pairs:
        look = eye.look(left, right, 0.0)
        if look.verdict == "measured":
            for side in SIDES:
                accepted = look.looks[side].accepted
                assert accepted is not None
                away.append(_away_px(look.lines[side], accepted.x_px, accepted.y_px))
    assert len(away) > 40
    assert max(away) < 1.0


def test_what_one_frame_cannot_tell_the_other_camera_settles_at_the_spots(config: RigConfig) -> None:
    bench, pairs = _pairs(0.9)
    eye, settled = LiveEye(config, bench.truth_calibration()), 0
    for left, right in pairs:
        look = eye.look(left, right, 0.0)
        for side in SIDES:
            frame_look = look.looks[side]
            if look.verdict == "measured" and not isinstance(frame_look.seen, Spot):
                settled += 1
                assert frame_look.accepted is not None
                assert any(candidate.reason == "epipolar" for candidate in frame_look.candidates)
            if look.verdict in ("epipolar", "outside_volume", "table"):
                assert frame_look.accepted is None
                assert any(candidate.reason == look.verdict for candidate in frame_look.candidates)
    assert settled > 3


def test_without_a_calibration_there_are_spots_and_no_lines(config: RigConfig) -> None:
    _, pairs = _pairs(0.02)
    look = LiveEye(config, None).look(*next(pairs), 0.0)
    assert (look.verdict, dict(look.lines)) == ("", {})
    assert all(look.looks[side].accepted for side in SIDES)


def test_a_line_that_misses_the_picture_is_empty(config: RigConfig) -> None:
    calibration = config.calibration
    assert isinstance(calibration, StereoCalibration)
    away = replace(calibration.right, rotation=np.diag([-1.0, 1.0, -1.0]) @ calibration.right.rotation)
    assert epipolar_line(calibration.left, away, (300.0, 150.0)).shape == (0, 2)
