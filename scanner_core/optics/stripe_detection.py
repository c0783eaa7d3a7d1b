"""Finds the laser line in a frame and locates it to a fraction of a pixel, wherever it crosses a row or a column of pixels.

In a smoothed copy of the frame the line is a ridge.  A row that the ridge passes has a maximum of intensity there; its slope
follows from the second derivatives, ``dx/dy = -S_xy / S_xx`` (on the ridge ``S_x = 0``).  The frame's own pixels along that row are then
fitted by a Gaussian, weighted by their noise, clipped pixels left out.  Columns likewise.  A line that runs along the rows is
seen by the columns, and between both directions by either; so folds, where a row meets the line several times, give several
peaks, and every piece of a line is sampled about once a pixel whatever its direction.

What the lens's blur along the line does to the places is corrected afterwards, see :mod:`~scanner_core.optics.stripe_curve`.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.optics.spot_background import estimate_background
from scanner_core.optics.spot_centroid import PixelNoise

Array = NDArray[np.float64]
Image = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class StripeDetectorParameters:
    """What counts as the laser line.

    Attributes
    ----------
    min_peak_dn : 2 to 255 DN of the smoothed frame over the background
    threshold_sigmas : 3 to 20; and at least so many standard deviations of the background
    least_sigma_px, most_sigma_px : of the line across itself, pixel included
    max_slope : 1 to 5; a profile more slanted than this belongs to the other direction
    max_growth : 0.05 to 3 per px; where light changes faster along the line than this, the line ends
    max_saturated_px : 0 to 20 clipped pixels of a profile
    max_misfit : 1.5 to 1000; chi square of a profile over its degrees of freedom, before what speckle does to it
    speckle : 0 to 1; relative standard deviation of a pixel's light by speckle, for that chi square alone
    saturation_dn, read_noise_dn, shot_dn : of the sensor, see :class:`~scanner_core.optics.spot_detection.SpotDetectorParameters`
    """

    min_peak_dn: float = 12.0
    threshold_sigmas: float = 6.0
    least_sigma_px: float = 0.4
    most_sigma_px: float = 2.5
    max_slope: float = 2.0
    max_growth: float = 0.6
    max_saturated_px: int = 3
    max_misfit: float = 6.0
    speckle: float = 0.12
    saturation_dn: int = 254
    read_noise_dn: float = 1.4
    shot_dn: float = 0.0125

    def __post_init__(self) -> None:
        for name, (low, high) in _RANGES.items():
            value = getattr(self, name)
            if not low <= value <= high:
                raise UsageError("E-USE-01", what=f"'{name}' of the line detector is {value}", do=f"choose a value from {low} to {high}")


_RANGES: dict[str, tuple[float, float]] = {
    "min_peak_dn": (2, 255),
    "threshold_sigmas": (3, 20),
    "least_sigma_px": (0.1, 5),
    "most_sigma_px": (0.2, 10),
    "max_slope": (1, 5),
    "max_growth": (0.05, 3),
    "max_saturated_px": (0, 20),
    "max_misfit": (1.5, 1000),
    "speckle": (0, 1),
    "saturation_dn": (128, 255),
    "read_noise_dn": (0, 20),
    "shot_dn": (0, 10),
}


@dataclass(frozen=True, slots=True, eq=False)
class StripePeaks:
    """Where the line crosses rows and columns of pixels.

    Attributes
    ----------
    xy : (n, 2) px; one of the two is whole, the other was measured
    along_row : (n,) bool: x was measured, in a row; else y, in a column
    slope : (n,) of the line: how far the measured coordinate moves with the other one
    growth : (n,) share by which the light changes along the line, per px of the whole coordinate
    sigma_px : (n,) standard deviation of the profile
    peak_dn : (n,) of the fitted profile over the background
    variance_px2 : (n,) of the measured coordinate by the pixels' noise
    saturated_px : (n,) clipped pixels of the profile
    """

    xy: Array
    along_row: NDArray[np.bool_]
    slope: Array
    growth: Array
    sigma_px: Array
    peak_dn: Array
    variance_px2: Array
    saturated_px: NDArray[np.int32]

    def __len__(self) -> int:
        return len(self.xy)

    def select(self, which: NDArray[np.bool_] | NDArray[np.int64]) -> StripePeaks:
        """The peaks of a mask or of numbers."""
        return StripePeaks(*(getattr(self, column.name)[which] for column in fields(self)))

    def tangents(self) -> Array:
        """(n, 2) unit vectors along the line."""
        along = np.where(self.along_row[:, None], np.c_[self.slope, np.ones(len(self))], np.c_[np.ones(len(self)), self.slope])
        return np.asarray(along / np.linalg.norm(along, axis=1, keepdims=True), np.float64)

    def across_variance_px2(self) -> Array:
        """(n,) variance of the line's place across itself."""
        return np.asarray(self.variance_px2 / (1 + self.slope**2), np.float64)

    @staticmethod
    def joined(parts: list[StripePeaks]) -> StripePeaks:
        """All peaks of several."""
        return StripePeaks(*(np.concatenate([getattr(part, column.name) for part in parts]) for column in fields(StripePeaks)))


@dataclass(frozen=True, slots=True, eq=False)
class StripeFrame:
    """What a frame holds of the line: its peaks, and how many were rejected by which reason."""

    peaks: StripePeaks
    rejected: dict[str, int]


_SMOOTH_PX = 0.8
_HALF = 6
"""Half width of a profile, px."""
_BORDER = _HALF + 1
_ROUNDS = 6
_OFFSETS = np.arange(-_HALF, _HALF + 1, dtype=np.float64)


class StripeDetector:
    """Locates the laser line in single frames.  Keeps nothing between them, so threads may share it."""

    def __init__(self, parameters: StripeDetectorParameters | None = None) -> None:
        self.parameters = parameters or StripeDetectorParameters()

    def detect(self, image: Image) -> StripeFrame:
        """The line in an image (H, W) uint8."""
        p = self.parameters
        background = estimate_background(image)
        noise = PixelNoise.of(background, p.read_noise_dn, p.shot_dn, p.saturation_dn)
        floor = background.mean_dn + max(p.min_peak_dn, p.threshold_sigmas * background.sd_dn)
        box = _lit_box(image, floor, _BORDER)
        if box is None:
            return StripeFrame(_NONE, {})
        left, top, right, bottom = box
        part = np.ascontiguousarray(image[top:bottom, left:right])
        ridges = _Derivatives.of(part)
        found, rejected = [], dict[str, int]()
        for turned in (False, True):
            peaks, lost = self._along_rows(part.T if turned else part, ridges.turned() if turned else ridges, floor, noise)
            if turned:
                peaks = StripePeaks(peaks.xy[:, ::-1], ~peaks.along_row, *(getattr(peaks, column.name) for column in fields(StripePeaks)[2:]))
            found.append(peaks)
            for reason, count in lost.items():
                rejected[reason] = rejected.get(reason, 0) + count
        peaks = StripePeaks.joined(found)
        peaks.xy[:] += (left, top)
        return StripeFrame(peaks, rejected)

    def _along_rows(self, pixels: Image, derivatives: _Derivatives, floor: float, noise: PixelNoise) -> tuple[StripePeaks, dict[str, int]]:
        p = self.parameters
        ridge = derivatives.value
        middle = ridge[1:-1, 1:-1]
        top = (middle > ridge[1:-1, :-2]) & (middle >= ridge[1:-1, 2:]) & (middle > floor)
        rows, columns = np.nonzero(top)
        rows, columns = rows + 1, columns + 1
        inside = (columns >= _HALF) & (columns < ridge.shape[1] - _HALF)
        rejected = {"cut_by_edge": int((~inside).sum())}
        rows, columns = rows[inside], columns[inside]

        here, s_x, s_y, s_xx, s_xy = (each[rows, columns].astype(np.float64) for each in derivatives.by_row())
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = -s_xy / s_xx
            # the light's change from row to row on the ridge itself, which lies beside the middle of the pixel
            growth = (s_y - s_xy * s_x / s_xx) / (here - noise.background_dn)
        steep = ~(np.abs(slope) <= p.max_slope) | ~(s_xx < 0)  # the other direction sees it better
        rows, columns, slope, growth = rows[~steep], columns[~steep], slope[~steep], growth[~steep]

        reach = columns[:, None] + np.arange(-_HALF, _HALF + 1)
        profile = pixels[rows[:, None], reach].astype(np.float64)
        used = _own_slope(ridge[rows[:, None], reach].astype(np.float64), noise)
        clipped = (profile >= noise.saturation_dn) & used
        fit = _gaussian_profiles(profile - noise.background_dn, used & ~clipped, noise, np.sqrt(1 + slope**2), p.speckle)

        across = fit.sigma / np.sqrt(1 + slope**2)
        saturated = clipped.sum(axis=1)
        reasons = {
            "lost": ~fit.settled,
            "saturated": saturated > p.max_saturated_px,
            "too_wide": across > p.most_sigma_px,
            "too_narrow": across < p.least_sigma_px,
            "too_dim": fit.peak < p.min_peak_dn,
            "misshapen": fit.misfit > p.max_misfit,
            "line_end": np.abs(growth) > p.max_growth,
        }
        good = np.ones(len(rows), np.bool_)
        for reason, which in reasons.items():
            rejected[reason] = int((good & which).sum())
            good &= ~which
        xy = np.c_[columns + fit.centre, rows].astype(np.float64)
        peaks = StripePeaks(xy, np.ones(len(rows), np.bool_), slope, growth, fit.sigma, fit.peak, fit.variance, saturated.astype(np.int32))
        return peaks.select(good), {reason: count for reason, count in rejected.items() if count}


@dataclass(frozen=True, slots=True, eq=False)
class _Derivatives:
    """A smoothed image and its derivatives, (h, w) each."""

    value: NDArray[np.float32]
    x: NDArray[np.float32]
    y: NDArray[np.float32]
    xx: NDArray[np.float32]
    xy: NDArray[np.float32]
    yy: NDArray[np.float32]

    @staticmethod
    def of(image: Image) -> _Derivatives:
        """By derivatives of a Gaussian (Steger 1998), scaled so that those of a parabola are exact."""
        pixels = image.astype(np.float32)
        none, one, two = _KERNELS
        filtered = (cv2.sepFilter2D(pixels, -1, a, b, borderType=cv2.BORDER_REPLICATE) for a, b in ((none, none), (one, none), (none, one), (two, none), (one, one), (none, two)))
        return _Derivatives(*(np.asarray(each, np.float32) for each in filtered))

    def turned(self) -> _Derivatives:
        """Of the transposed image."""
        return _Derivatives(self.value.T, self.y.T, self.x.T, self.yy.T, self.xy.T, self.xx.T)

    def by_row(self) -> tuple[NDArray[np.float32], ...]:
        """What a row's peaks need: value, x, y, xx, xy."""
        return self.value, self.x, self.y, self.xx, self.xy


def _gaussian_kernels(sigma: float, half: int) -> tuple[Array, Array, Array]:
    """A Gaussian and its first two derivatives as correlation kernels."""
    t = np.arange(-half, half + 1, dtype=np.float64)
    bell = np.exp(-0.5 * (t / sigma) ** 2)
    bell /= bell.sum()
    first = t * bell / (t * t * bell).sum()
    second = (t * t - (t * t * bell).sum()) * bell
    return bell, first, 2 * second / (t * t * second).sum()


_KERNELS = _gaussian_kernels(_SMOOTH_PX, 4)


@dataclass(frozen=True, slots=True, eq=False)
class _Fits:
    """Of n profiles: centre and sigma in px from the middle pixel, peak in DN, the centre's variance, chi square over its degrees of freedom."""

    centre: Array
    sigma: Array
    peak: Array
    variance: Array
    misfit: Array
    settled: NDArray[np.bool_]


def _gaussian_profiles(signal: Array, used: NDArray[np.bool_], noise: PixelNoise, widened: Array, speckle: float) -> _Fits:
    """Gaussians of signals (n, 2 h + 1) DN over the background by weighted least squares (Gauss-Newton), the pixels `used` alone."""
    n = len(signal)
    peak = np.where(used, signal, 0.0).max(axis=1, initial=1.0)
    centre, sigma = np.zeros(n), 1.1 * widened
    last = np.full(n, np.inf)
    inverse, model, weight = np.empty((n, 3, 3)), np.empty_like(signal), np.empty_like(signal)
    for _ in range(_ROUNDS):
        u = (_OFFSETS - centre[:, None]) / sigma[:, None]
        shape = np.exp(-0.5 * u * u)
        model = peak[:, None] * shape
        weight = used / (noise.dark_dn2 + noise.shot_dn * model)
        basis = np.stack([shape, model * u / sigma[:, None], model * u * u / sigma[:, None]], axis=1)  # by peak, centre, sigma
        weighted = basis * weight[:, None, :]
        normal = weighted @ basis.transpose(0, 2, 1)
        normal[:, [0, 1, 2], [0, 1, 2]] *= 1 + 1e-9
        normal += 1e-9 * np.eye(3)
        inverse = np.linalg.inv(normal)
        step = np.einsum("nij,nj->ni", inverse, np.einsum("nik,nk->ni", weighted, signal - model))
        peak = np.clip(peak + step[:, 0], 0.3 * peak, 3 * peak)
        last = np.clip(step[:, 1], -0.7, 0.7)
        centre = centre + last
        sigma = np.clip(sigma + step[:, 2], 0.6 * sigma, 1.6 * sigma)
        sigma = np.clip(sigma, 0.2, 2.0 * _HALF)
    free = np.maximum(used.sum(axis=1) - 3, 1)
    believed = 1 / (1 / np.maximum(weight, 1e-12) + (speckle * model) ** 2)
    misfit = (np.where(used, believed, 0.0) * (signal - model) ** 2).sum(axis=1) / free
    settled = (np.abs(last) < 0.02) & (np.abs(centre) < 1.5) & (used.sum(axis=1) >= 4)
    return _Fits(centre, sigma, peak, inverse[:, 1, 1], misfit, settled)


def _own_slope(ridge: Array, noise: PixelNoise) -> NDArray[np.bool_]:
    """Which pixels (n, 2 h + 1) belong to the maximum in the middle: those before the smoothed profile rises again."""
    rise = 1.5 * np.sqrt(noise.dark_dn2)
    used = np.ones(ridge.shape, np.bool_)
    for side in (-1, 1):
        outwards = ridge[:, _HALF:] if side > 0 else ridge[:, _HALF::-1]
        lowest = np.minimum.accumulate(outwards, axis=1)
        falls = np.logical_and.accumulate(outwards <= lowest + rise, axis=1)
        if side > 0:
            used[:, _HALF:] = falls
        else:
            used[:, _HALF::-1] = falls
    return used


def _lit_box(image: Image, floor: float, margin: int) -> tuple[int, int, int, int] | None:
    """Left, top, right and bottom (exclusive) of what is brighter than `floor`, with a margin inside the image."""
    lit = cv2.threshold(image, floor, 255, cv2.THRESH_BINARY)[1]
    x, y, width, height = cv2.boundingRect(lit)
    if not width:
        return None
    rows, columns = image.shape
    return max(x - margin, 0), max(y - margin, 0), min(x + width + margin, columns), min(y + height + margin, rows)


_NONE = StripePeaks(np.empty((0, 2)), np.empty(0, np.bool_), *(np.empty(0) for _ in range(5)), np.empty(0, np.int32))
