"""A spot as the difference of lit and dark: found where it is, whatever else is in the picture; not found where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.commissioning.difference import difference_spot

SHAPE = (120, 160)


def _scene(seed: int, noise_dn: float = 1.5) -> tuple[np.ndarray, np.ndarray]:
    """Two noisy looks at the same bright, textured scene."""
    rng = np.random.default_rng(seed)
    scene = rng.uniform(10, 180, SHAPE)
    first, second = (scene + rng.normal(0, noise_dn, SHAPE) for _ in range(2))
    return first.astype(np.float32), second.astype(np.float32)


def _spot(x: float, y: float, peak: float, sigma: float = 1.2) -> np.ndarray:
    rows, columns = np.mgrid[: SHAPE[0], : SHAPE[1]]
    return (peak * np.exp(-((columns - x) ** 2 + (rows - y) ** 2) / (2 * sigma**2))).astype(np.float32)


@pytest.mark.parametrize("seed", range(20))
def test_noise_is_no_spot(seed: int) -> None:
    lit, dark = _scene(seed)
    assert difference_spot(lit, dark) is None


@pytest.mark.parametrize("peak", [30.0, 120.0])
def test_a_spot_is_found_in_a_bright_scene(peak: float) -> None:
    lit, dark = _scene(5)
    found = difference_spot(lit + _spot(70.3, 41.8, peak), dark)
    assert found is not None
    assert abs(found.x_px - 70.3) < 0.3
    assert abs(found.y_px - 41.8) < 0.3
    assert found.peak_dn == pytest.approx(peak, rel=0.3)
    assert found.noise_dn == pytest.approx(1.5 * 2**0.5, rel=0.1)


def test_two_as_bright_are_not_one_but_a_reflection_does_not_hide_the_spot() -> None:
    lit, dark = _scene(6)
    assert difference_spot(lit + _spot(40, 40, 80) + _spot(120, 80, 75), dark) is None
    assert difference_spot(lit + _spot(40, 40, 80) + _spot(120, 80, 25), dark) is not None


def test_a_lamp_that_was_switched_on_is_no_spot() -> None:
    lit, dark = _scene(7)
    lamp = np.zeros(SHAPE, np.float32)
    lamp[20:80, 30:120] = 60
    assert difference_spot(lit + lamp, dark) is None
    assert difference_spot(lit + 50, dark) is None
