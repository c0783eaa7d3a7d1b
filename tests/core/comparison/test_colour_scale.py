"""The scale of deviations: symmetric, stepped, and readable by the colour-blind."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from scanner_core.comparison.colour_scale import NO_COUNTERPART, WITHIN_LEVEL, DeviationScale

Array = NDArray[np.float64]

# Machado, Oliveira, Fernandes, A Physiologically-based Model for Simulation of Color Vision Deficiency, IEEE TVCG 15 (2009), severity 1
_SIGHT = {
    "full": np.eye(3),
    "protanopia": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    "deuteranopia": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]),
    "tritanopia": np.array([[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]),
}
_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def _lab(colours: NDArray[np.uint8], sight: str) -> Array:
    """CIE L*a*b* (D65) of sRGB colours as they look to such eyes."""
    share = colours / 255
    light = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    xyz = np.clip(light @ _SIGHT[sight].T, 0, 1) @ _XYZ.T / _XYZ.sum(axis=1)
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)


def _distances(a: Array, b: Array) -> Array:
    return np.asarray(np.linalg.norm(a[:, None] - b[None], axis=2), np.float64)


@pytest.mark.parametrize("sight", _SIGHT)
@pytest.mark.parametrize("steps", [4, 8])
def test_the_signs_stay_apart_for_every_kind_of_sight(sight: str, steps: int) -> None:
    bands = _lab(DeviationScale(1000, steps, 50, 250).band_colours, sight)
    inward, outward = bands[:steps][::-1], bands[steps:]
    assert _distances(inward, outward).min() > 40  # a difference of 10 is seen at a glance
    grey = _lab(np.array([WITHIN_LEVEL], np.uint8), sight)
    assert _distances(bands, grey).min() > 12
    for side in (inward, outward):
        assert (np.diff(side[:, 0]) < -2).all()  # darker with every step
    assert np.abs(inward[:, 0] - outward[:, 0]).max() < 16  # neither sign looks the greater


@given(st.floats(20, 1000), st.floats(1, 5000), st.floats(0, 500))
def test_fitting_holds_the_values_and_the_threshold(threshold: float, spread: float, level: float) -> None:
    values = np.array([-spread, -0.3 * spread, np.nan, 0.0, 0.8 * spread])
    scale = DeviationScale.fitting(values, level, threshold)
    assert 4 <= scale.steps <= 8
    assert scale.limit_um >= 2 * threshold * (1 - 1e-9)
    assert scale.limit_um >= np.nanpercentile(np.abs(values), 99) * (1 - 1e-9)
    assert np.allclose(scale.edges_um, -scale.edges_um[::-1])
    width = scale.limit_um / scale.steps
    assert np.log2(width / (0.5 * threshold)) == pytest.approx(round(np.log2(width / (0.5 * threshold))))
    if width <= threshold * (1 + 1e-9):
        assert np.abs(scale.edges_um - threshold).min() < 1e-6 * threshold


def test_no_value_gives_a_scale_of_twice_the_threshold() -> None:
    scale = DeviationScale.fitting(np.full(5, np.nan), 30, 250)
    assert (scale.limit_um, scale.steps) == (500, 4)
    assert [label for _, label in scale.ticks()] == ["−0.50", "−0.375", "−0.25", "−0.125", "0", "+0.125", "+0.25", "+0.375", "+0.50"]


def test_colours_are_stepped_and_grey_where_nothing_is_known() -> None:
    scale = DeviationScale(1000, 4, 50, 250)
    values = np.array([-5000.0, -1000, -999, -251, -249, -50, 0, 50, 51, 249, 251, 999, 5000, np.nan])
    colours = [tuple(int(c) for c in colour) for colour in scale.colours(values)]
    bands = [tuple(int(c) for c in colour) for colour in scale.band_colours]
    assert colours == [bands[0]] * 3 + [bands[2], bands[3]] + [WITHIN_LEVEL] * 3 + [bands[4]] * 2 + [bands[5], bands[7], bands[7], NO_COUNTERPART]
    of_each = scale.colours(np.array([100.0, 100.0]), np.array([99.0, 101.0]))
    assert tuple(of_each[0]) == bands[4]
    assert tuple(of_each[1]) == WITHIN_LEVEL


def test_the_table_agrees_with_the_colours() -> None:
    scale = DeviationScale(500, 4, 60, 250)
    table = scale.table(1000)
    assert np.array_equal(table[[0, 499, 500, 999]], scale.colours(np.array([-499.5, -0.5, 0.5, 499.5])))
