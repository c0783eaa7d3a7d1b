"""The exposure for a board that a person shows."""

from __future__ import annotations

from typing import cast

import numpy as np
import pytest

from scanner_core.devices.camera import Camera
from scanner_core.optics.board_exposure import BRIGHT_DN, DIM_DN, LONGEST_MS, BoardExposure


class Lamp:
    """A camera before a board of some brightness, in DN a millisecond."""

    def __init__(self, dn_per_ms: float, exposure_ms: float) -> None:
        self._dn_per_ms, self.exposure_ms = dn_per_ms, exposure_ms

    def image(self) -> np.ndarray:
        image = np.zeros((40, 60), np.uint8)
        image[:, 20:] = min(255.0, self._dn_per_ms * self.exposure_ms)
        return image


@pytest.mark.parametrize("dn_per_ms", [1.0, 20.0, 900.0])
def test_the_board_becomes_bright_and_the_camera_is_left_as_it_was(dn_per_ms: float) -> None:
    lamp = Lamp(dn_per_ms, 2.0)
    exposure = BoardExposure([cast(Camera, lamp)])
    for _ in range(40):
        exposure.adapt(0, lamp.image())
    assert DIM_DN <= lamp.image().max() < 255
    settled_ms = lamp.exposure_ms
    exposure.adapt(0, lamp.image())
    assert lamp.exposure_ms == settled_ms
    exposure.restore()
    assert lamp.exposure_ms == 2.0


def test_in_the_dark_it_ends_somewhere() -> None:
    lamp = Lamp(0.01, 2.0)
    exposure = BoardExposure([cast(Camera, lamp)])
    for _ in range(60):
        exposure.adapt(0, lamp.image())
    assert lamp.exposure_ms == LONGEST_MS
    assert BRIGHT_DN > DIM_DN


def test_a_camera_that_does_not_tell_its_exposure_keeps_it() -> None:
    lamp = Lamp(20.0, 0.0)
    exposure = BoardExposure([cast(Camera, lamp)])
    exposure.adapt(0, np.full((40, 60), 255, np.uint8))
    exposure.restore()
    assert lamp.exposure_ms == 0.0
