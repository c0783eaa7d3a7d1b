"""Maximum-likelihood fit of a Gaussian spot, integrated over the pixels, clipped pixels censored.

The model is ``I = F gx(i) gy(j) + b`` with ``gx(i) = Phi((i + 1/2 - x) / sx) - Phi((i - 1/2 - x) / sx)`` and six
parameters: flux F, place x, y, standard deviations sx, sy and background b (Winick, "Cramer-Rao lower bounds on the
performance of charge-coupled-device optical position estimators", JOSA A 3, 1986, has the model and its bound; Smith et
al., "Fast, single-molecule localization that achieves theoretically minimum uncertainty", Nat. Methods 7, 2010, the
iteration).  A pixel's variance is ``dark + shot (I - b)`` at the model's value, not at the observed one, which would weigh
down every pixel whose noise is positive.

A pixel at saturation is censored: it contributes the probability of "at least", ``Phi((I - c) / sd)``, with score
``h / sd`` and information ``h (h + z) / sd^2``, ``h(z) = phi(z) / Phi(z)`` (Tobin, Econometrica 26, 1958).

Fisher scoring from the weighted centroid, whose error is a few per cent above the bound, ends after two or three steps.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.spot_centroid import Moments, PixelNoise

Array = NDArray[np.float64]

PIXEL_VARIANCE_PX2 = 1 / 12
"""Second moment of a pixel's own box."""

REACH_SIGMA = 3.0
"""Half width of the window; what lies beyond holds 1e-3 of the information on the place."""
_STEPS = 12
_TOLERANCE = 0.1
"""A step of x and y below this part of their standard uncertainty is the last: the next would be of its square."""
_SHAPE_TOLERANCE = 0.03
"""The same for flux and sigmas, relative: a clipped spot begins far from its shape, even where its place is right."""

_SMALLEST_SIGMA_PX, _LARGEST_SIGMA_PX = 0.1, 30.0
_SQRT_HALF, _DENSITY = math.sqrt(0.5), 1 / math.sqrt(2 * math.pi)
_EDGES = np.arange(1024) - 0.5


@dataclass(slots=True)
class GaussianFit:
    """A fitted spot; places count from the window's first pixel.

    Attributes
    ----------
    x, y : px
    sigma_x, sigma_y : of the light before the pixels' integration, px
    variance_x, variance_y : of x and y by the pixels' noise, px^2: the inverse of the Fisher information at the fit
    flux_dn, background_dn : of the model
    """

    x: float
    y: float
    sigma_x: float
    sigma_y: float
    variance_x: float
    variance_y: float
    flux_dn: float
    background_dn: float


def fit_gaussian(pixels: NDArray[np.uint8], x: float, y: float, start: Moments, noise: PixelNoise) -> GaussianFit | None:
    """Fit a spot in a window (h, w) uint8 from a first place in it and its moments; None when it does not converge."""
    height, width = pixels.shape
    values = pixels.ravel().astype(np.float64)
    censored = np.flatnonzero(values >= noise.saturation_dn) if start.saturated_px else None
    ceiling = noise.saturation_dn - 0.5
    sx = math.sqrt(max(start.xx - PIXEL_VARIANCE_PX2, 0.04))
    sy = math.sqrt(max(start.yy - PIXEL_VARIANCE_PX2, 0.04))
    b = noise.background_dn
    flux = 2 * math.pi * math.sqrt(max(start.xx * start.yy, PIXEL_VARIANCE_PX2**2)) * max(float(values.max()) - b, 1.0)
    edges = np.empty(width + height + 2)
    up, across = np.empty((6, height, 1)), np.empty((6, 1, width))
    for _ in range(_STEPS):
        np.subtract(_EDGES[: width + 1], x, out=edges[: width + 1])
        edges[: width + 1] /= sx
        np.subtract(_EDGES[: height + 1], y, out=edges[width + 1 :])
        edges[width + 1 :] /= sy
        below = np.array([math.erf(edge) for edge in (edges * _SQRT_HALF).tolist()])
        density = _DENSITY * np.exp(-0.5 * edges * edges)
        by_place, by_sigma = np.diff(density), np.diff(edges * density)
        share = np.diff(below)
        # shares of the pixels, and their derivatives by place and by sigma; the element between the axes is void
        gx, gy = 0.5 * share[:width], 0.5 * share[width + 1 :]
        fgx, fgy = flux * gx, flux * gy
        across[0, 0], across[1, 0], across[2, 0] = gx, by_place[:width] * (-1 / sx), fgx
        across[3, 0], across[4, 0], across[5, 0] = by_sigma[:width] * (-1 / sx), fgx, 1.0
        up[0, :, 0], up[1, :, 0], up[2, :, 0] = gy, fgy, by_place[width + 1 :] * (-1 / sy)
        up[3, :, 0], up[4, :, 0], up[5, :, 0] = fgy, by_sigma[width + 1 :] * (-1 / sy), 1.0
        jacobian = (up * across).reshape(6, -1)
        signal = flux * jacobian[0]
        variance = noise.dark_dn2 + noise.shot_dn * signal
        residual = values - signal
        residual -= b
        information = 1 / variance
        score = residual * information
        if censored is not None:
            h, z = _mills(signal[censored] + b - ceiling, variance[censored])
            score[censored] = h / np.sqrt(variance[censored])
            information[censored] *= h * (h + z)
        try:
            covariance = np.linalg.inv((jacobian * information) @ jacobian.T)
        except np.linalg.LinAlgError:
            return None
        by_flux, dx, dy, dsx, dsy, db = (covariance @ (jacobian @ score)).tolist()
        variance_x, variance_y = float(covariance[1, 1]), float(covariance[2, 2])
        if not (variance_x > 0 and variance_y > 0):
            return None
        # a step that would leave the model's domain is cut short
        shorten = min(1.0, *(limit / abs(step) for step, limit in ((dx, 1.0), (dy, 1.0), (dsx, 0.5 * sx), (dsy, 0.5 * sy)) if step))
        if by_flux < -0.5 * flux:
            shorten = min(shorten, -0.5 * flux / by_flux)
        x, y, sx, sy = x + shorten * dx, y + shorten * dy, sx + shorten * dsx, sy + shorten * dsy
        flux, b = flux + shorten * by_flux, b + shorten * db
        if not (-0.5 <= x <= width - 0.5 and -0.5 <= y <= height - 0.5 and sx < _LARGEST_SIGMA_PX and sy < _LARGEST_SIGMA_PX):
            return None
        sx, sy = max(sx, _SMALLEST_SIGMA_PX), max(sy, _SMALLEST_SIGMA_PX)
        settled = dx * dx < _TOLERANCE**2 * variance_x and dy * dy < _TOLERANCE**2 * variance_y
        if settled and shorten == 1.0 and max(abs(by_flux / flux), abs(dsx / sx), abs(dsy / sy)) < _SHAPE_TOLERANCE:
            return GaussianFit(x, y, sx, sy, variance_x, variance_y, flux, b)
    return None


def _mills(above_dn: Array, variance_dn2: Array) -> tuple[Array, Array]:
    """``phi(z) / Phi(z)`` and z for models so far above the ceiling."""
    z = np.clip(above_dn / np.sqrt(variance_dn2), -30.0, 30.0)
    below = np.array([math.erfc(-value * _SQRT_HALF) for value in z.tolist()])
    return 2 * _DENSITY * np.exp(-0.5 * z * z) / below, z
