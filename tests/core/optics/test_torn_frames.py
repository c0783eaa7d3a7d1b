"""Torn and repeated frames are told from whole ones, also on cameras that show little noise or none."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.optics.torn_frames import TornFrames

Image = NDArray[np.uint8]
SHAPE = (294, 604)


def exposures(seed: int, mean_dn: float = 3.0) -> Iterator[Image]:
    rng = np.random.default_rng(seed)
    while True:
        yield rng.poisson(mean_dn, SHAPE).astype(np.uint8)


def test_whole_frames_pass() -> None:
    torn, camera = TornFrames(), exposures(1)
    assert not any(torn.torn(next(camera)) for _ in range(200))


@pytest.mark.parametrize("cut", [60, 147, 250])
def test_a_part_of_the_last_frame_is_found(cut: int) -> None:
    torn, camera = TornFrames(), exposures(2)
    before = next(camera)
    assert not torn.torn(before)
    mixed = next(camera)
    mixed[cut:] = before[cut:]
    assert torn.torn(mixed)
    assert not torn.torn(next(camera))


def test_random_bytes_are_no_image() -> None:
    torn = TornFrames()
    image = next(exposures(3))
    image[100:] = np.random.default_rng(4).integers(0, 256, image[100:].shape, np.uint8)
    assert torn.torn(image)


def test_a_bright_gradient_is_an_image() -> None:
    torn, camera = TornFrames(), exposures(5)
    slope = np.linspace(0, 250, SHAPE[1]).astype(np.uint8)
    assert not any(torn.torn(np.minimum(next(camera) + slope, 255).astype(np.uint8)) for _ in range(5))


def test_a_dark_camera_with_hot_pixels_is_believed() -> None:
    torn, image = TornFrames(), np.zeros(SHAPE, np.uint8)
    image[:, ::97] = 40  # the same in every frame
    assert not any(torn.torn(image) for _ in range(50))


def test_a_camera_whose_noise_is_below_its_digits_loses_a_few_frames_and_is_believed_then() -> None:
    torn, image = TornFrames(), next(exposures(6))
    told = [torn.torn(image) for _ in range(200)]
    assert sum(told) < 15
    assert not any(told[20:])
