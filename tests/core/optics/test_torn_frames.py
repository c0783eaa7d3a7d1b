"""Torn frames are told from whole ones by their noise."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.torn_frames import TornFrames


def _frame(rng: np.random.Generator) -> NDArray[np.uint8]:
    """A dark frame of 8 bits with a spot."""
    image = rng.normal(12.0, 1.5, (294, 604))
    x, y = np.meshgrid(np.arange(604), np.arange(294))
    image += 180 * np.exp(-((x - 300) ** 2 + (y - 200) ** 2) / 4)
    return np.clip(np.round(image), 0, 255).astype(np.uint8)


def test_whole_frames_are_not_torn() -> None:
    rng, frames = np.random.default_rng(3), TornFrames()
    assert not any(frames.torn(_frame(rng)) for _ in range(200))


def test_what_another_frame_has_left_is_seen() -> None:
    rng, frames = np.random.default_rng(4), TornFrames()
    before, torn = _frame(rng), _frame(rng)
    torn[147:] = before[147:]
    assert not frames.torn(before)
    assert frames.torn(torn)
    assert frames.torn(torn), "the same frame again"
    assert not frames.torn(_frame(rng))


def test_garbage_is_seen() -> None:
    rng = np.random.default_rng(5)
    torn = _frame(rng)
    torn[147:] = rng.integers(0, 256, (147, 604), np.uint8)
    assert TornFrames().torn(torn)


def test_of_quiet_rows_nothing_is_said() -> None:
    frames, dark = TornFrames(), np.zeros((48, 64), np.uint8)
    assert not any(frames.torn(dark) for _ in range(3))
    assert not TornFrames().torn(np.full((48, 64), 255, np.uint8))
