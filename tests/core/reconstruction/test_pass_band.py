from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from scanner_core.reconstruction.pass_band import FREEDOM, VARIANCE, VARIANCE_LOST_AGAIN, passed


def factor(x: float) -> float:
    """From the equations of a wave: pull u - d, penalty x^2 (1 - s) with the target passing s = 1 / (1 + x)^2 of the bend."""
    return 1 / (1 + x**2 * (1 - (1 + x) ** -2))


@pytest.mark.parametrize(
    ("constant", "power"),
    [(FREEDOM, lambda r: r), (VARIANCE, lambda r: r**2), (VARIANCE_LOST_AGAIN, lambda r: (r * (1 - r)) ** 2)],
)
def test_constants_against_adaptive_integration(constant: float, power: object) -> None:
    assert callable(power)
    whole = quad(lambda x: power(factor(x)), 0, 10, limit=200)[0] + quad(lambda x: power(factor(x)), 10, np.inf, limit=200)[0]
    assert constant == pytest.approx(whole / (4 * np.pi), rel=2e-3)


def test_constants_against_the_sum_over_the_waves_of_a_square() -> None:
    """A periodic square of side L carries the wave numbers 2 pi (i, j) / L."""
    side, bandwidth = 60.0, 1.0
    i, j = np.meshgrid(np.arange(-400, 401), np.arange(-400, 401))
    x = bandwidth**2 * (2 * np.pi / side) ** 2 * (i**2 + j**2)
    r = passed(x)
    assert r.sum() / (side / bandwidth) ** 2 == pytest.approx(FREEDOM, rel=0.01)
    assert (r**2).sum() / (side / bandwidth) ** 2 == pytest.approx(VARIANCE, rel=0.01)
    assert ((r * (1 - r)) ** 2).sum() / (side / bandwidth) ** 2 == pytest.approx(VARIANCE_LOST_AGAIN, rel=0.02)


def test_long_waves_pass_and_short_ones_do_not() -> None:
    x = np.geomspace(1e-3, 1e3, 200)
    assert np.all(np.diff(passed(x)) < 0)
    assert passed(np.array([1e-3]))[0] == pytest.approx(1, abs=1e-6)
    assert passed(np.array([1e3]))[0] == pytest.approx(1e-6, rel=0.01)
