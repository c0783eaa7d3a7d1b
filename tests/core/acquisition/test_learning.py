"""Sizes are learned on the virtual rig from spots that both cameras agree on, whatever was set before."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from scanner_core.acquisition.exposing import light
from scanner_core.acquisition.learning import learn_sizes
from scanner_core.acquisition.live_look import SIDES, LiveEye, LiveLook
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.devices.camera import Frame
from scanner_core.devices.rig import load_preset
from scanner_core.devices.wrapped_camera import WrappedCamera
from scanner_core.jobs.progress import Cancelled
from scanner_core.virtual.specimens import Specimen, load_specimen

MIDDLE_DEG = (0.0, -1.2)


@cache
def _sphere() -> Specimen:
    return load_specimen("sphere")


@pytest.fixture
def rig() -> Iterator[Callable[..., OpenRig]]:
    with ExitStack() as stack:

        def made() -> OpenRig:
            config = load_preset("bench")
            wrong = replace(config, spot=replace(config.spot, min_area_px=90, max_area_px=95))  # nothing would be a spot
            opened_rig = stack.enter_context(open_rig(wrong, _sphere(), seed=5))
            opened_rig.motion.aim(*MIDDLE_DEG)
            return opened_rig

        yield made


def ghosted(frame: Frame) -> Frame:
    """A window before the lens mirrors the spot: out of focus, a third as bright, farther to the right."""
    peak = int(frame.image.max())
    if peak < 60:
        return frame
    row, column = (int(at) for at in np.unravel_index(int(frame.image.argmax()), frame.image.shape))
    top, left = max(row - 20, 0), max(column + 120 - 20, 0)
    y, x = np.mgrid[top : min(row + 21, 294), left : min(column + 120 + 21, 604)]
    light = 0.35 * peak * np.exp(-0.5 * (((x - (column + 120)) / 5) ** 2 + ((y - row) / 4) ** 2))
    image = frame.image.copy()
    image[y, x] = np.clip(image[y, x] + light, 0, 255).astype(np.uint8)
    return replace(frame, image=image)


class Ghosted(WrappedCamera):
    def grab(self) -> Frame:
        return ghosted(super().grab())


def test_learned_limits_hold_the_good_spots_and_refuse_a_reflection(rig: Callable[..., OpenRig]) -> None:
    made = rig()
    learned = learn_sizes(replace(made, left=Ghosted(made.left), right=Ghosted(made.right)))
    assert learned.limits is not None
    assert len(learned.strays_px) > 20
    spot = replace(made.config.spot, min_area_px=2, max_area_px=600)
    before, after = LiveEye(made.config, made.calibration, spot), LiveEye(made.config, made.calibration, learned.limits.of(spot))
    good: list[bool] = []
    verdicts, strays = [], []
    for x, y in np.random.default_rng(7).uniform(-0.9, 0.9, (40, 2)):
        light(made, (MIDDLE_DEG[0] + float(x), MIDDLE_DEG[1] + float(y)))
        left, right = made.left.grab(), made.right.grab()
        bare, look = before.look(left, right, 0.0), after.look(ghosted(left), ghosted(right), 0.0)
        if bare.verdict == "measured":
            verdicts.append(look.verdict)
            good += [learned.limits.holds(c.area_px) for side in SIDES for c in bare.looks[side].candidates if c.accepted]
            strays += [c.reason for side in SIDES for c in look.looks[side].candidates if c.area_px > 100]
    assert len(good) > 50
    assert np.mean(good) >= 0.99
    assert len(strays) > 40
    assert set(strays) == {"too_large"}
    assert verdicts.count("measured") >= 0.95 * len(verdicts)


def test_the_beam_comes_back_and_stays_lit(rig: Callable[..., OpenRig]) -> None:
    made = rig()
    fractions: list[float] = []
    looks: list[LiveLook] = []
    learn_sizes(made, progress=lambda told: fractions.append(told.fraction), on_look=looks.append)
    status = made.motion.status()
    assert np.allclose((status.x_deg, status.y_deg), MIDDLE_DEG, atol=1e-3)
    assert status.laser_power > 0
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    assert len(looks) > 40


def test_it_can_be_cancelled_and_learns_nothing_beside_the_object(rig: Callable[..., OpenRig]) -> None:
    made = rig()
    with pytest.raises(Cancelled):
        learn_sizes(made, cancelled=lambda: True)
    made.motion.aim(15.0, 15.0)
    learned = learn_sizes(made)
    assert (learned.limits, learned.spots_px) == (None, ())
