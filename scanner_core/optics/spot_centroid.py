"""Centre of gravity of a blob with weights that are matched to its noise, and its moments.

A centre of gravity ``sum w(I) x / sum w(I)`` answers to the noise of a pixel at distance x from the centre by
``x w'(I)``, while the efficient estimator of a place answers by ``(dI/dx) / var(I)``, which for a Gaussian spot of
signal s = I - background is ``x s / var(s)``.  With ``var(s) = v0 + g s`` (dark noise and shot noise) both agree for
``w = integral of s / (v0 + g s) ds = (s - c ln(1 + s / c)) / g`` with ``c = v0 / g``; up to a factor
``s^2 / (1 + k s)`` with ``k = g / (2 v0)`` has the same two limits: weights s^2 where dark noise rules, s where shot noise
does.  A threshold of :data:`THRESHOLD_SD` above the background keeps the rectified noise of the far pixels out, and
because the weights leave it with slope 0, no edge of the spot steps from pixel to pixel: that step is what makes the
common weights I - T lock to the pixels (Thomas et al., "Comparison of centroid computation algorithms in a
Shack-Hartmann sensor", MNRAS 371, 2006, have I - T, and I^p without the derivation).

The weights depend on nothing but the pixel's value: a table of 256 rows holds them and all else that is summed, and one
matrix product yields every moment of a blob.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.spot_background import Background

Array = NDArray[np.float64]

THRESHOLD_SD = 1.5
"""Threshold of the weights above the mean background in its standard deviations; between 1 and 2 it hardly matters."""
ROUNDING_DN2 = 1 / 12
"""Variance of the rounding to whole DN."""

_CACHED_PX = 4096
_DN = np.arange(256, dtype=np.float64)
_NODES, _NODE_WEIGHTS = np.polynomial.legendre.leggauss(8)


@dataclass(frozen=True, slots=True)
class PixelNoise:
    """What is known of a frame's pixels.

    Attributes
    ----------
    background_dn : mean of the dark pixels
    dark_dn2 : their variance, rounding included
    shot_dn : ``var(I) = dark_dn2 + shot_dn (I - background_dn)``
    saturation_dn : from this value on a pixel says only "at least"
    """

    background_dn: float
    dark_dn2: float
    shot_dn: float
    saturation_dn: int

    @staticmethod
    def of(background: Background, read_noise_dn: float, shot_dn: float, saturation_dn: int) -> PixelNoise:
        """The frame's own background, at least as noisy as the sensor is known to be (a background clipped at 0 hides it)."""
        dark_dn2 = max(background.sd_dn**2, read_noise_dn**2 + ROUNDING_DN2)
        return PixelNoise(background.mean_dn, dark_dn2, shot_dn, saturation_dn)


@dataclass(slots=True)
class Moments:
    """Of a blob's light in a window, whose first pixel is (0, 0).

    Attributes
    ----------
    x, y : centre of gravity, px
    xx, yy, xy : second central moments, px^2, what the weights sharpen and cut off made up for as in a Gaussian
    variance_x, variance_y : of x and y by the pixels' noise, px^2
    flux_dn : sum of what is above the threshold of the weights
    area_px, saturated_px : pixels above the blob's threshold, and at saturation
    """

    x: float
    y: float
    xx: float
    yy: float
    xy: float
    variance_x: float
    variance_y: float
    flux_dn: float
    area_px: int
    saturated_px: int


class PixelWeights:
    """The table of weights for one background; immutable, so threads may share it.

    Parameters
    ----------
    noise : of the frame's pixels
    threshold_dn : pixels above it are the blob's area
    """

    def __init__(self, noise: PixelNoise, threshold_dn: float) -> None:
        self.noise = noise
        k = noise.shot_dn / (2 * noise.dark_dn2)
        floor = noise.background_dn + THRESHOLD_SD * math.sqrt(noise.dark_dn2)
        v = np.maximum(_DN - floor, 0.0)
        weight = v * v / (1 + k * v)
        slope = v * (2 + k * v) / (1 + k * v) ** 2
        saturated = noise.saturation_dn <= _DN
        variance = noise.dark_dn2 + noise.shot_dn * np.maximum(_DN - noise.background_dn, 0.0)
        variance[saturated] = 0.0  # a clipped pixel passes no noise on
        self._table = np.stack([weight, slope * slope * variance, v, threshold_dn < _DN, saturated], axis=1)
        self._sharpening = _sharpening(_DN - noise.background_dn, floor - noise.background_dn, k).tolist()

    def moments(self, pixels: NDArray[np.uint8], peak_dn: int) -> Moments:
        """Moments of a blob, its window (h, w) uint8 and its brightest pixel given."""
        height, width = pixels.shape
        basis = _basis(height, width) if height * width <= _CACHED_PX else _monomials(height, width)
        (
            (w, q, flux, area, saturated),
            (wx, qx, _, _, _),
            (wy, qy, _, _, _),
            (wxx, qxx, _, _, _),
            (wyy, qyy, _, _, _),
            (wxy, _, _, _, _),
        ) = basis.dot(self._table.take(pixels, 0).reshape(-1, 5)).tolist()
        if w <= 0:
            return Moments(0.5 * (width - 1), 0.5 * (height - 1), 0.0, 0.0, 0.0, math.inf, math.inf, 0.0, int(area), int(saturated))
        per_w, whole = 1 / w, self._sharpening[peak_dn]
        x, y = wx * per_w, wy * per_w
        xx, yy, per_w2 = wxx * per_w - x * x, wyy * per_w - y * y, per_w * per_w
        return Moments(
            x,
            y,
            xx * whole if xx > 0.0 else 0.0,
            yy * whole if yy > 0.0 else 0.0,
            (wxy * per_w - x * y) * whole,
            (qxx - x * (2 * qx - x * q)) * per_w2,
            (qyy - y * (2 * qy - y * q)) * per_w2,
            flux,
            int(area),
            int(saturated),
        )


def _sharpening(peak: Array, threshold: float, k: float) -> Array:
    """Variance of a Gaussian over its second moment with the weights, for peaks (n,) above the background.

    With ``u = r^2 / (2 sigma^2)`` the signal above the threshold is ``v = peak exp(-u) - threshold`` for u from 0 to
    ``ln(peak / threshold)``, and the second moment over sigma^2 is ``integral of w(v) u du / integral of w(v) du``.
    """
    peak = np.maximum(peak, 1.01 * threshold)[:, None]
    u = 0.5 * np.log(peak / threshold) * (1 + _NODES)
    v = peak * np.exp(-u) - threshold
    w = _NODE_WEIGHTS * v * v / (1 + k * v)
    return np.asarray(w.sum(axis=1) / (w * u).sum(axis=1), np.float64)


@lru_cache(maxsize=512)
def _basis(height: int, width: int) -> Array:
    return _monomials(height, width)


def _monomials(height: int, width: int) -> Array:
    """1, x, y, x^2, y^2 and xy at the pixels of a window, (6, height * width)."""
    y, x = np.mgrid[:height, :width].astype(np.float64).reshape(2, -1)
    return np.stack([np.ones_like(x), x, y, x * x, y * y, x * y])
