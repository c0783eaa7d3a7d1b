"""Finds the laser line in a frame and locates it to a fraction of a pixel, wherever it crosses a row or a column of pixels.

In a smoothed copy of the frame the line is a ridge.  A row that the ridge passes has a maximum of intensity there; its slope
follows from the second derivatives, ``dx/dy = -S_xy / S_xx`` (on the ridge ``S_x = 0``).  The frame's own pixels along that row are then
fitted by a Gaussian, weighted by their noise, clipped pixels left out.  Columns likewise.  A line that runs along the rows is
seen by the columns, and between both directions by either; so folds, where a row meets the line several times, give several
peaks, and every piece of a line is sampled about once a pixel whatever its direction.

A lens blurs the line along itself as well as across.  Where the line is bent, the light of both sides lies on the inner side of the
bend, and where its light grows, a slanted line's row is drawn to the brighter side: a quarter of a pixel on the cusp of a
tooth, inwards in both images, so that the points would lie deep.  The blur between the rows is therefore taken out before a
row is looked at (and that between the columns before a column is); the blur within the row, which makes sub-pixel places
possible, stays.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from math import ceil
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.optics.spot_background import estimate_background
from scanner_core.optics.spot_centroid import PixelNoise

Array = NDArray[np.float64]
Image = NDArray[np.uint8]

SAMPLES_PER_PX = 3
"""Of the line along itself: more than are independent, but a bend is followed more closely."""


@dataclass(frozen=True, slots=True)
class StripeDetectorParameters:
    """What counts as the laser line.

    Attributes
    ----------
    min_peak_dn : 2 to 255 DN of the smoothed frame over the background
    threshold_sigmas : 3 to 20; and at least so many standard deviations of the background
    least_sigma_px, most_sigma_px : of the line across itself, pixel included
    max_slope : 1 to 5; a profile more slanted than this belongs to the other direction
    max_drawn_px : 0.05 to 5; where the lens's blur has drawn a place aside by more, the line is bent too sharply to undo that
    blur_px : standard deviations of the image of a point along x and y, its pixel included: what the lens leaves of a small spot
    rounds : 1 to 20; so often the blur along the line is undone: more leave less of it, and more noise
    per_px : 1 to 4 samples of the line to a pixel along it; those beyond one are no independent ones
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
    max_slope: float = 1.1
    max_growth: float = 0.6
    max_saturated_px: int = 3
    max_misfit: float = 12.0
    speckle: float = 0.12
    max_drawn_px: float = 0.4
    blur_px: tuple[float, float] = (0.957, 0.777)
    rounds: int = 5
    per_px: int = SAMPLES_PER_PX
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
    "max_drawn_px": (0.05, 5),
    "rounds": (1, 20),
    "per_px": (1, 4),
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
    drawn_px : (n,) by how much the lens's blur along the line had moved the measured coordinate
    sigma_px : (n,) standard deviation of the profile
    peak_dn : (n,) of the fitted profile over the background
    variance_px2 : (n,) of the measured coordinate by the pixels' noise
    saturated_px : (n,) clipped pixels of the profile
    """

    xy: Array
    along_row: NDArray[np.bool_]
    slope: Array
    growth: Array
    drawn_px: Array
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
_UNDONE = 0.3
"""Standard uncertainty of what was taken out of a place because of the blur, as a share of it."""
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
        part = image[top:bottom, left:right]
        found, rejected = [], dict[str, int]()
        for turned in (False, True):
            pixels = part.T if turned else part
            dense = _between_rows(pixels.astype(np.float32), p.per_px)
            sharp = deblurred_down(dense, p.per_px * p.blur_px[0 if turned else 1], p.rounds)
            over = np.repeat(pixels >= noise.saturation_dn, p.per_px, axis=0)[: len(dense)]
            peaks, lost = self._along_rows(dense, sharp, over, floor, noise)
            if turned:
                peaks = StripePeaks(peaks.xy[:, ::-1], ~peaks.along_row, *(getattr(peaks, column.name) for column in fields(StripePeaks)[2:]))
            found.append(peaks)
            for reason, count in lost.items():
                rejected[reason] = rejected.get(reason, 0) + count
        peaks = StripePeaks.joined(found)
        peaks.xy[:] += (left, top)
        return StripeFrame(peaks, rejected)

    def _along_rows(
        self, raw: NDArray[np.float32], pixels: NDArray[np.float32], over: NDArray[np.bool_], floor: float, noise: PixelNoise
    ) -> tuple[StripePeaks, dict[str, int]]:
        """The peaks of rows that lie `per_px` to a pixel, before and after the blur was taken out."""
        p = self.parameters
        derivatives = _Derivatives.of(pixels, p.per_px)
        ridge = derivatives.value
        middle = ridge[1:-1, 1:-1]
        top = (middle > ridge[1:-1, :-2]) & (middle >= ridge[1:-1, 2:]) & (middle > floor)
        rows, columns = np.nonzero(top)
        rows, columns = rows + 1, columns + 1
        inside = (columns >= _HALF) & (columns < ridge.shape[1] - _HALF)
        rejected = {"cut_by_edge": int((~inside).sum())}
        rows, columns = rows[inside], columns[inside]

        here, s_x, s_y, s_xx, s_xy = (each[rows, columns].astype(np.float64) for each in derivatives)
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = -s_xy / s_xx
            # the light's change from row to row on the ridge itself, which lies beside the middle of the pixel
            growth = (s_y - s_xy * s_x / s_xx) / (here - noise.background_dn)
        steep = ~(np.abs(slope) <= p.max_slope) | ~(s_xx < 0)  # the other direction sees it better
        rows, columns, slope, growth = rows[~steep], columns[~steep], slope[~steep], growth[~steep]

        reach = columns[:, None] + np.arange(-_HALF, _HALF + 1)
        profile = pixels[rows[:, None], reach].astype(np.float64)
        used = _own_slope(ridge[rows[:, None], reach].astype(np.float64), noise)
        clipped = over[rows[:, None], reach] & used
        fit = _gaussian_profiles(profile - noise.background_dn, used & ~clipped, noise, np.sqrt(1 + slope**2), p.speckle)

        blurred = raw[rows[:, None], reach].astype(np.float64) - noise.background_dn
        drawn = fit.centre - _gaussian_profiles(blurred, used & ~clipped, noise, np.sqrt(1 + slope**2), p.speckle).centre

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
            "bent": np.abs(drawn) > p.max_drawn_px * np.sqrt(1 + slope**2),
        }
        good = np.ones(len(rows), np.bool_)
        for reason, which in reasons.items():
            rejected[reason] = int((good & which).sum())
            good &= ~which
        xy = np.c_[columns + fit.centre, rows / p.per_px]
        variance = fit.variance + (_UNDONE * drawn) ** 2
        whole = np.ones(len(rows), np.bool_)
        peaks = StripePeaks(xy, whole, slope, growth, drawn, fit.sigma, fit.peak, variance, saturated.astype(np.int32))
        return peaks.select(good), {reason: count for reason, count in rejected.items() if count}


class _Derivatives(NamedTuple):
    """A smoothed image and its derivatives by x and y, (h, w) each, per px; by derivatives of a Gaussian (Steger 1998)."""

    value: NDArray[np.float32]
    x: NDArray[np.float32]
    y: NDArray[np.float32]
    xx: NDArray[np.float32]
    xy: NDArray[np.float32]

    @staticmethod
    def of(pixels: NDArray[np.float32], per_px: int) -> _Derivatives:
        """Of an image whose rows lie `per_px` to a pixel."""
        none, one, two = _gaussian_kernels(_SMOOTH_PX, 4)
        down, change = _gaussian_kernels(per_px * _SMOOTH_PX, 4 * per_px)[:2]
        pairs = ((none, down), (one, down), (none, per_px * change), (two, down), (one, per_px * change))
        return _Derivatives(*(np.asarray(cv2.sepFilter2D(pixels, -1, a, b, borderType=cv2.BORDER_REPLICATE), np.float32) for a, b in pairs))


def _between_rows(pixels: NDArray[np.float32], per_px: int) -> NDArray[np.float32]:
    """The image with rows between its rows, `per_px` to a pixel; the lens has left nothing finer that they could miss."""
    if per_px == 1:
        return pixels
    rows = per_px * (len(pixels) - 1) + 1
    matrix = np.array([[1.0, 0.0, 0.0], [0.0, 1.0 / per_px, 0.0]])
    flags = cv2.INTER_LANCZOS4 | cv2.WARP_INVERSE_MAP
    between = cv2.warpAffine(np.ascontiguousarray(pixels), matrix, (pixels.shape[1], rows), flags=flags, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(between, np.float32)


def deblurred_down(image: NDArray[np.float32], sigma_px: float, rounds: int) -> NDArray[np.float32]:
    """An image (h, w) with the lens's blur along its columns mostly taken out: ``sum over k < rounds of (1 - G)^k`` of it (van Cittert 1931).

    Waves of which the blur G leaves the share q keep ``1 - (1 - q)^rounds``.
    """
    bell = _gaussian_kernels(sigma_px, ceil(4 * sigma_px))[0]
    rest, total = image, image.copy()
    for _ in range(rounds - 1):
        rest = rest - cv2.sepFilter2D(rest, -1, np.ones(1), bell, borderType=cv2.BORDER_REPLICATE)
        total += rest
    return total


def _gaussian_kernels(sigma: float, half: int) -> tuple[Array, Array, Array]:
    """A Gaussian and its first two derivatives as correlation kernels."""
    t = np.arange(-half, half + 1, dtype=np.float64)
    bell = np.exp(-0.5 * (t / sigma) ** 2)
    bell /= bell.sum()
    first = t * bell / (t * t * bell).sum()
    second = (t * t - (t * t * bell).sum()) * bell
    return bell, first, 2 * second / (t * t * second).sum()


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


def _no_peaks() -> StripePeaks:
    none, nothing = np.empty(0), np.empty(0, np.bool_)
    return StripePeaks(np.empty((0, 2)), nothing, none, none, none, none, none, none, np.empty(0, np.int32))


_NONE = _no_peaks()
