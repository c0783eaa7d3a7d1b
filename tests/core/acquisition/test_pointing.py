from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache

import pytest

from scanner_core.acquisition.exposing import light
from scanner_core.acquisition.pointing import NEAR_PX, find_object, point_at
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.devices.rig import load_preset
from scanner_core.jobs.progress import Cancelled
from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.virtual.specimens import load_specimen

_specimen = cache(load_specimen)


@pytest.fixture
def ball() -> Iterator[OpenRig]:
    with open_rig(load_preset("bench").with_calibration(None), _specimen("sphere"), seed=5) as rig:
        yield rig


def _seen(rig: OpenRig, side: str) -> Spot:
    seen = SpotDetector(rig.config.spot).detect((rig.left if side == "left" else rig.right).grab().image)
    assert isinstance(seen, Spot)
    return seen


@pytest.mark.parametrize(("side", "dx", "dy"), [("left", -9, 5), ("right", 9, -4)])
def test_the_spot_comes_to_the_pixel_without_a_calibration(ball: OpenRig, side: str, dx: float, dy: float) -> None:
    light(ball, (0.0, -1.2))
    before = _seen(ball, side)
    target = before.x_px + dx, before.y_px + dy
    left = point_at(ball, side, target)
    assert left is not None
    after = _seen(ball, side)
    assert math.hypot(after.x_px - target[0], after.y_px - target[1]) < NEAR_PX + 0.2
    assert left < NEAR_PX
    assert ball.motion.status().laser_power > 0


def test_a_place_that_is_out_of_sight_leaves_the_spot_where_it_was_seen(ball: OpenRig) -> None:
    light(ball, (0.0, -1.2))
    left = point_at(ball, "left", (2.0, 2.0))
    assert left is not None
    assert left > NEAR_PX
    _seen(ball, "left")


def test_where_no_spot_is_seen_nothing_is_tried(ball: OpenRig) -> None:
    ball.motion.aim(15.0, 15.0)
    assert point_at(ball, "left", (300.0, 150.0)) is None
    with pytest.raises(Cancelled):
        point_at(ball, "left", (300.0, 150.0), lambda: True)


def test_the_object_is_found_from_where_the_beam_misses_it(ball: OpenRig) -> None:
    ball.motion.aim(8.0, 8.0)
    assert find_object(ball)
    _seen(ball, "left")
    _seen(ball, "right")
