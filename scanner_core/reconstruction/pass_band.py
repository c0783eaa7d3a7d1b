"""What the smoothing spline passes of waves and of noise.

A wave of wave number k passes with the factor

    R(x) = 1 / (1 + x^2 (1 - 1 / (1 + x)^2)),        x = (h k)^2,

on a flat surface with many points; what becomes of noise follows by integration over the wave numbers, ``k dk / 2 pi``, which
is ``dx / 4 pi h^2``.  Against solves with random noise on seven clouds of four shapes the variance is right within 6 % in the mean.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def passed(x: Array) -> Array:
    """The factor R for x = (bandwidth times wave number)^2."""
    return np.asarray(1 / (1 + x**2 * (1 - 1 / (1 + x) ** 2)))


_X = np.geomspace(1e-4, 1e4, 8001)

FREEDOM = float(np.trapezoid(passed(_X), _X)) / (4 * np.pi)
"""Degrees of freedom of the fit in an area of one squared bandwidth."""

VARIANCE = float(np.trapezoid(passed(_X) ** 2, _X)) / (4 * np.pi)
"""Variance of the surface over that of the mean of the points in one squared bandwidth."""

VARIANCE_LOST_AGAIN = float(np.trapezoid((passed(_X) * (1 - passed(_X))) ** 2, _X)) / (4 * np.pi)
"""The same of what the smoother takes away when it is applied to its own answer."""
