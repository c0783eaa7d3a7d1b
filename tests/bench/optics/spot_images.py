"""Frames of one Gaussian spot at a known place, and the Cramer-Rao bound of that place."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf, ndtr

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Sensor:
    """Black level and read noise in DN before rounding, one photoelectron in DN, and the value at which a pixel clips."""

    read_dn: float
    shot_dn: float
    black_dn: float = 8.0
    ceiling_dn: float = 255.0


BENCH = Sensor(1.4, 1 / 80)
WORKSHOP = Sensor(1.0, 1 / 40)


@dataclass(frozen=True, slots=True)
class SpotShape:
    """A spot of the given standard deviations, the pixel's own box included (as a camera shows it), px.

    `peak_dn` is the height over black of the light before it is integrated over pixels.
    """

    sigma_x: float
    sigma_y: float
    peak_dn: float

    @property
    def optical(self) -> tuple[float, float]:
        """Standard deviations of the light itself."""
        return float(np.sqrt(self.sigma_x**2 - 1 / 12)), float(np.sqrt(self.sigma_y**2 - 1 / 12))


def signals(x: Array, y: Array, sigma: tuple[float, float], peak_dn: float, size: tuple[int, int]) -> Array:
    """Light over black of spots at x, y (n,), integrated over the pixels of frames (n, height, width); size is (width, height)."""

    def shares(places: Array, sigma_px: float, count: int) -> Array:
        edges = (np.arange(count + 1)[None] - 0.5 - places[:, None]) / (sigma_px * np.sqrt(2))
        return np.asarray(0.5 * np.diff(erf(edges), axis=1), np.float64)

    flux = 2 * np.pi * sigma[0] * sigma[1] * peak_dn
    return np.asarray(flux * shares(y, sigma[1], size[1])[:, :, None] * shares(x, sigma[0], size[0])[:, None, :], np.float64)


def expose(light: Array, sensor: Sensor, rng: np.random.Generator) -> NDArray[np.uint8]:
    """Shot noise (normal, its variance that of Poisson counts), read noise, rounding to 8 bits and clipping."""
    noise = rng.standard_normal(light.shape) * np.sqrt(sensor.read_dn**2 + sensor.shot_dn * light)
    return np.clip(np.round(sensor.black_dn + light + noise), 0, sensor.ceiling_dn).astype(np.uint8)


def draw(shape: SpotShape, sensor: Sensor, count: int, rng: np.random.Generator, size: tuple[int, int]) -> tuple[Array, NDArray[np.uint8]]:
    """Places (count, 2) uniform over the middle pixel of windows, and the windows (count, height, width)."""
    places = np.array(size) // 2 + rng.uniform(-0.5, 0.5, (count, 2))
    return places, expose(signals(places[:, 0], places[:, 1], shape.optical, shape.peak_dn, size), sensor, rng)


def framed(windows: NDArray[np.uint8], sensor: Sensor, rng: np.random.Generator, margin: int = 64) -> Iterator[NDArray[np.uint8]]:
    """The windows one by one in a dark frame that is `margin` larger all round; every frame is the same memory."""
    height, width = windows.shape[1:]
    frame = expose(np.zeros((height + 2 * margin, width + 2 * margin)), sensor, rng)
    for window in windows:
        frame[margin : margin + height, margin : margin + width] = window
        yield frame


def bound(shape: SpotShape, sensor: Sensor, size: tuple[int, int], phases: int = 5) -> Array:
    """Cramer-Rao bound of x and y, (2,) px: rms over a grid of places in the pixel.

    Six unknowns (peak, x, y, both optical sigmas, background) from all pixels of the frame, each normal with the variance
    read^2 + shot signal + 1/12 DN^2; what the variance itself tells of the signal (below 1e-4 of the information) is left out.
    A clipped pixel tells "at least": with a = (ceiling - 1/2 - mean) / sd its information is
    ``Phi(a) - a phi(a) + phi(a)^2 / (1 - Phi(a))`` of that of a free one.
    """
    steps = (np.arange(phases) + 0.5) / phases - 0.5
    variances = [_variances(shape, sensor, size, size[0] // 2 + dx, size[1] // 2 + dy) for dx in steps for dy in steps]
    return np.asarray(np.sqrt(np.mean(variances, axis=0)), np.float64)


def efficient_errors(shape: SpotShape, sensor: Sensor, places: Array, windows: NDArray[np.uint8]) -> Array:
    """Errors (n, 2) px that an efficient estimator makes on these very windows (n, height, width), none of them clipped.

    ``(J^T W J)^-1 J^T W (window - mean)`` with the Jacobian J and the weights W of the true spot: unbiased, and its variance is
    the Cramer-Rao bound.  Its rms over the same noise replaces the bound in a ratio, which is then certain to a fraction of
    what the chance of the noise would leave.
    """
    size = windows.shape[2], windows.shape[1]

    def light(dx: float = 0.0, dy: float = 0.0, dsx: float = 0.0, dsy: float = 0.0) -> Array:
        sigma = shape.optical[0] + dsx, shape.optical[1] + dsy
        return signals(places[:, 0] + dx, places[:, 1] + dy, sigma, shape.peak_dn * _flux_kept(shape, sigma), size).reshape(len(places), -1)

    h = 1e-3
    slopes = [(light(**{name: h}) - light(**{name: -h})) / (2 * h) for name in ("dx", "dy", "dsx", "dsy")]
    mean = light()
    jacobian = np.stack([*slopes, mean / shape.peak_dn, np.ones_like(mean)], axis=1)  # (n, 6, pixels)
    weighted = jacobian / (sensor.read_dn**2 + sensor.shot_dn * mean + 1 / 12)[:, None]
    noise = windows.reshape(len(places), -1) - sensor.black_dn - mean
    covariance = np.linalg.inv(weighted @ jacobian.transpose(0, 2, 1))
    return np.asarray((covariance @ (weighted @ noise[:, :, None]))[:, :2, 0], np.float64)


def _flux_kept(shape: SpotShape, sigma: tuple[float, float]) -> float:
    """The peak of a spot of the same flux and another sigma, over that of the shape."""
    return shape.optical[0] * shape.optical[1] / (sigma[0] * sigma[1])


def _variances(shape: SpotShape, sensor: Sensor, size: tuple[int, int], x: float, y: float) -> Array:
    def light(p: Array) -> Array:
        return np.asarray(signals(p[1:2], p[2:3], (p[3], p[4]), p[0], size).ravel() + p[5], np.float64)

    at = np.array([shape.peak_dn, x, y, *shape.optical, 0.0])
    jacobian = np.array([(light(at + step) - light(at - step)) / 2e-4 for step in 1e-4 * np.eye(6)])
    signal = light(at)
    variance = sensor.read_dn**2 + sensor.shot_dn * signal + 1 / 12
    a = np.clip((sensor.ceiling_dn - 0.5 - sensor.black_dn - signal) / np.sqrt(variance), -30, 30)
    density = np.exp(-0.5 * a * a) / np.sqrt(2 * np.pi)
    seen = ndtr(a) - a * density + density**2 / np.maximum(ndtr(-a), 1e-300)
    return np.asarray(np.diag(np.linalg.inv((jacobian * (seen / variance)) @ jacobian.T))[1:3], np.float64)
