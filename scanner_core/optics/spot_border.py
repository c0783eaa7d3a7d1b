"""The published centroid: middle of the area within a contour whose border is interpolated between pixels.

It uses the few pixels on the contour alone, so its random error is several times that of a fit, and a spot smaller than
a pixel drags it to the pixels' centres.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.spot_centroid import PixelNoise

Array = NDArray[np.float64]


def border_centroid(pixels: Array, level_dn: float, noise: PixelNoise) -> tuple[float, float, float, float] | None:
    """Middle of the area above a level, interpolated along rows for x and along columns for y.

    Parameters
    ----------
    pixels : (h, w) with at least one pixel below the level all round the spot
    level_dn : height of the contour

    Returns
    -------
    x, y : px, from the first pixel
    variance_x, variance_y : by the noise of the pixels on both sides of every crossing, px^2: a crossing at the part f
        between values a and b has the variance ``((1 - f)^2 var(a) + f^2 var(b)) / (a - b)^2`` and moves the middle by its
        distance to it over the length of all lines.  What the pixel grid adds is not in it:
        it is the same in every repetition, and a scan's own residuals tell it
    None where the spot touches the window.
    """
    found: list[tuple[float, float]] = []
    for lines in (pixels, pixels.T):
        middle = _middle(lines, level_dn, noise)
        if middle is None:
            return None
        found.append(middle)
    (x, variance_x), (y, variance_y) = found
    return x, y, variance_x, variance_y


def _middle(lines: Array, level: float, noise: PixelNoise) -> tuple[float, float] | None:
    """Middle along the lines and its variance."""
    crossings: list[tuple[float, float]] = []
    total = weighted = 0.0
    for line in lines.tolist():
        above = [i for i, value in enumerate(line) if value > level]
        if not above or above[0] == 0 or above[-1] == len(line) - 1:
            continue
        start = _crossing(line, above[0], -1, level, noise)
        end = _crossing(line, above[-1], 1, level, noise)
        total += end[0] - start[0]
        weighted += 0.5 * (end[0] ** 2 - start[0] ** 2)
        crossings += [start, end]
    if not total > 0:
        return None
    middle = weighted / total
    return middle, math.fsum((place - middle) ** 2 * variance for place, variance in crossings) / total**2


def _crossing(line: list[float], inside: int, side: int, level: float, noise: PixelNoise) -> tuple[float, float]:
    """Where the level is crossed between a pixel and its neighbour on a side (-1 or 1), and the variance of that, px and px^2."""
    a, b = line[inside], line[inside + side]
    part = (a - level) / (a - b)
    var_a, var_b = (noise.dark_dn2 + noise.shot_dn * max(value - noise.background_dn, 0.0) for value in (a, b))
    return inside + side * part, ((1 - part) ** 2 * var_a + part * part * var_b) / (a - b) ** 2
