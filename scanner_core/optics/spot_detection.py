"""Finds the laser spot in a frame and locates it to a fraction of a pixel.

Threshold from the frame's own background, outer contours of what is above it, gates on size, elongation, saturation
and the image border, and one of three centroids.

Nearly every frame holds one spot: the rows round the brightest pixel are searched, and of all others no more than the
maximum is asked for, which costs half a threshold of the frame and leaves the processor's cache alone.  Where that is not
all, a search for one byte finds the first and the last bright row, and only between them contours are looked for.

Contours instead of labelled components: on a dark frame they cost a tenth of the time.  In a box of a spot's size it is the
labels that cost a third of the contours, and where they count one blob, the box is its own.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_background import Background, estimate_background
from scanner_core.optics.spot_border import border_centroid
from scanner_core.optics.spot_centroid import Moments, PixelNoise, PixelWeights
from scanner_core.optics.spot_fit import PIXEL_VARIANCE_PX2, REACH_SIGMA, fit_gaussian

Image = NDArray[np.uint8]
Box = Sequence[int]
"""Left, top, width and height, px."""


@dataclass(frozen=True, slots=True)
class SpotDetectorParameters:
    """What counts as a laser spot.

    Attributes
    ----------
    threshold_sigmas : 3 to 10; threshold above the mean background in its standard deviations.  At 4.5 a frame of
        604 x 294 holds less than one stray noise pixel, and a lone pixel fails `min_area_px`
    min_contrast_dn : 1 to 100 DN; the threshold is never closer to the background than this, so that the rounding to
        8 bits of a noiseless, dark frame makes no blobs
    min_peak_dn : 2 to 255 DN above the background; a dimmer spot is located to no better than a quarter of a pixel
    min_area_px : 1 to 100; a lone pixel is a hot pixel or noise, and tells nothing about where in the pixel the spot is
    max_area_px : up to 100,000; larger is a lamp or the beam's halo on a near surface
    max_elongation : 1.5 to 20; ratio of the principal sigmas (pixel size allowed for), the spot on a surface that is
        seen at 80 degrees stays below
    saturation_dn : 128 to 255 DN; from here on a pixel's value says only "at least"
    max_saturated_px : 0 to 1000; a flat top of up to so many pixels costs less than 0.03 px, a larger one hides the peak
    max_censored_px : 0 to 1000; the same for the centroid ``gaussian``, which takes a clipped pixel for "at least"; beyond,
        the place rests on the spot's faint foot, which is no Gaussian in any real lens
    dominance : 1.5 to 100; the brightest blob is taken if its flux is so many times that of the next
    max_background_dn : 1 to 254 DN; above it room light drowns the spot
    read_noise_dn : 0 to 20 DN; standard deviation of a dark pixel before it is rounded to 8 bits, used where the frame's own
        background is less noisy (clipped at 0)
    shot_dn : 0 to 10 DN; one photoelectron, so that ``var(I) = read noise^2 + shot_dn (I - background)``: 255 DN for a
        full well of 10,000 electrons is 0.0255
    floor_px : 0 to 1 px; what limits a centroid beside the pixels' noise, until the scan's own residuals tell (see
        :mod:`~scanner_core.optics.noise_model`); not part of a spot's uncertainty.  Speckle moves a centroid by
        0.65 lambda / (2 pi sin u) on the surface (Dorsch, Haeusler & Herrmann, Appl. Opt. 33, 1994), which is
        ``0.65 lambda N / (pi p)`` pixels at f-number N and pixel pitch p whatever the distance: 0.045 px rms over x and y
        at f/4 and 10 x 15.6 um, 0.15 px at 3.45 um
    centroid : ``weighted``, the centre of gravity with weights matched to the noise (see `spot_centroid`): fast, within 6 % of
        the Cramer-Rao bound; ``gaussian``, the maximum-likelihood fit (see `spot_fit`): at the bound, also for saturated
        spots, where ``weighted`` makes use of it too; ``border``, as published (see `spot_border`): several times less
        certain, and it locks to the pixels when the spot is small
    border_level : 0.05 to 0.9; height of that contour between background and peak.  The publication does not state its
        own; the higher it is, the stronger a spot smaller than a pixel locks
    """

    threshold_sigmas: float = 4.5
    min_contrast_dn: float = 4.0
    min_peak_dn: float = 10.0
    min_area_px: int = 2
    max_area_px: int = 600
    max_elongation: float = 4.0
    saturation_dn: int = 254
    max_saturated_px: int = 6
    max_censored_px: int = 30
    dominance: float = 4.0
    max_background_dn: float = 100.0
    read_noise_dn: float = 1.0
    shot_dn: float = 0.0255
    floor_px: float = 0.045
    centroid: Literal["weighted", "gaussian", "border"] = "weighted"
    border_level: float = 0.2

    def __post_init__(self) -> None:
        for name, (low, high) in _RANGES.items():
            value = getattr(self, name)
            if not low <= value <= high:
                raise UsageError("E-USE-01", what=f"'{name}' of the spot detector is {value}", do=f"choose a value from {low} to {high}")
        if self.centroid not in ("weighted", "gaussian", "border"):
            raise UsageError("E-USE-01", what=f"'centroid' of the spot detector is '{self.centroid}'", do="choose weighted, gaussian or border")


_RANGES: dict[str, tuple[float, float]] = {
    "threshold_sigmas": (3, 10),
    "min_contrast_dn": (1, 100),
    "min_peak_dn": (2, 255),
    "min_area_px": (1, 100),
    "max_area_px": (2, 100_000),
    "max_elongation": (1.5, 20),
    "saturation_dn": (128, 255),
    "max_saturated_px": (0, 1000),
    "max_censored_px": (0, 1000),
    "dominance": (1.5, 100),
    "max_background_dn": (1, 254),
    "read_noise_dn": (0, 20),
    "shot_dn": (0, 10),
    "floor_px": (0, 1),
    "border_level": (0.05, 0.9),
}

_MARGIN_PX = 2
"""Pixels measured round a blob's box: the weights reach down below the threshold that bounds it."""

_BORDER_PX = 1
"""A blob that reaches this close to the border may go on beyond it."""

_FOOT_PX = 4
"""So many rows above and below the bright pixels the foot of their spots is looked for first."""

_ROWS_PX = 8
"""So many rows above and below a frame's brightest pixel its spot is looked for first."""

_NOISE_AREA_PX = 3
"""Dim blobs in boxes below this are the background's noise, of which every frame has some."""

_MAX_BLOBS = 16
"""Blobs looked at per frame, largest first: bounds the time that a frame full of reflections can take."""

_LARGE_BOX = 4
"""Boxes of so many times `max_area_px` are counted before they are measured."""

_LABELLED_PX, _ONE_BLOB = 400, 2
"""Largest box whose blobs are counted by labels, and the labels of one blob and of what is round it."""

_KEPT_LEVELS = 64


@dataclass(frozen=True, slots=True, eq=False)
class SpotLevels:
    """What follows from a frame's background: the thresholds and the weights.

    Attributes
    ----------
    background : of the frame, to a tenth of a DN
    extent_dn : pixels above it belong to a spot
    seed_dn : a spot has a pixel above it; anything else is dim
    weights : of the pixels
    """

    background: Background
    extent_dn: int
    seed_dn: int
    weights: PixelWeights


class SpotDetector:
    """Locates the laser spot in single frames; what it keeps between them is scratch, so threads may share it."""

    def __init__(self, parameters: SpotDetectorParameters | None = None) -> None:
        self.parameters = parameters or SpotDetectorParameters()
        self._least_roundness = self.parameters.max_elongation**2 / (1 + self.parameters.max_elongation**2) ** 2
        self._levels: dict[tuple[int, int], SpotLevels] = {}
        self._scratch = _Scratch()

    def detect(self, image: Image) -> Spot | SpotMiss:
        """The spot in an image (H, W) uint8, or why there is none.

        Several blobs pass as one if the brightest has `dominance` times the flux of the next; else the miss is
        `AMBIGUOUS` and holds them as its candidates.
        """
        spots, miss = self.candidates(image, self.levels(image))
        return self.choose(spots, miss)

    def levels(self, image: Image) -> SpotLevels:
        """Thresholds and weights for a frame (H, W) uint8."""
        background = estimate_background(image)
        key = round(10 * background.mean_dn), round(20 * background.sd_dn)
        levels = self._levels.get(key)
        if levels is None:
            if len(self._levels) >= _KEPT_LEVELS:
                self._levels.clear()
            levels = self._levels[key] = self._of_background(Background(key[0] / 10, key[1] / 20))
        return levels

    def candidates(self, image: Image, levels: SpotLevels) -> tuple[list[Spot], SpotMiss]:
        """Spots by falling flux, and the miss to report when there are none (that of the brightest blob)."""
        if levels.background.mean_dn > self.parameters.max_background_dn:
            return [], SpotMiss(MissReason.TOO_BRIGHT, float(image.max()))
        boxes, peak = self.boxes(image, levels)
        if not boxes:
            return [], SpotMiss(MissReason.NO_SPOT, peak)
        if len(boxes) == 1:
            found, _ = self.measure(image, boxes[0], levels, peak=int(peak))
            return ([found], _NO_SPOT) if isinstance(found, Spot) else ([], found)
        if len(boxes) > _MAX_BLOBS:
            boxes = sorted(boxes, key=lambda box: -box[2] * box[3])[:_MAX_BLOBS]
        spots: list[Spot] = []
        miss, brightest = _NO_SPOT, -1.0
        for i, box in enumerate(boxes):
            gap = min(_gap(box, other) for k, other in enumerate(boxes) if k != i)
            found, flux = self.measure(image, box, levels, min(_MARGIN_PX, gap // 2))
            if isinstance(found, Spot):
                spots.append(found)
            elif flux > brightest:
                miss, brightest = found, flux
        spots.sort(key=lambda spot: -spot.flux_dn)
        return spots, miss

    def choose(self, spots: list[Spot], miss: SpotMiss) -> Spot | SpotMiss:
        """The dominant one of the spots, which are sorted by flux; the miss when there are none."""
        if not spots:
            return miss
        if len(spots) > 1 and spots[0].flux_dn < self.parameters.dominance * spots[1].flux_dn:
            return SpotMiss(MissReason.AMBIGUOUS, spots[0].peak_dn, tuple(spots))
        return spots[0]

    def measure(self, image: Image, box: Box, levels: SpotLevels, margin: int = _MARGIN_PX, peak: int | None = None) -> tuple[Spot | SpotMiss, float]:
        """Gates and centroid of the blob in a box, with `margin` pixels round it, whose brightest is `peak` if it is known.

        Returns also the blob's flux, DN.
        """
        p = self.parameters
        left, top, width, height = box
        rows, columns = image.shape
        x0, y0 = left - margin, top - margin
        if x0 < 0 or y0 < 0:
            x0, y0 = max(x0, 0), max(y0, 0)
        pixels = image[y0 : top + height + margin, x0 : left + width + margin]
        if peak is None:
            peak = int(cv2.minMaxLoc(pixels)[1])
        signal = peak - levels.background.mean_dn
        if signal < p.min_peak_dn and width * height < _NOISE_AREA_PX:
            return SpotMiss(MissReason.NO_SPOT, peak), 0.0
        if pixels.size > _LARGE_BOX * p.max_area_px and _count_above(pixels, levels.extent_dn) > p.max_area_px:
            reason = MissReason.TOO_DIM if signal < p.min_peak_dn else MissReason.TOO_LARGE
            return SpotMiss(reason, peak), cv2.sumElems(pixels)[0] - pixels.size * levels.background.mean_dn
        moments = levels.weights.moments(pixels, peak)
        flux, area = moments.flux_dn, moments.area_px
        if signal < p.min_peak_dn:
            return SpotMiss(MissReason.TOO_DIM, peak), flux
        if area < p.min_area_px:
            return SpotMiss(MissReason.TOO_SMALL, peak), flux
        if area > p.max_area_px:
            return SpotMiss(MissReason.TOO_LARGE, peak), flux
        if left < _BORDER_PX or top < _BORDER_PX or left + width > columns - _BORDER_PX or top + height > rows - _BORDER_PX:
            return SpotMiss(MissReason.CUT_BY_EDGE, peak), flux
        if moments.saturated_px > (p.max_censored_px if p.centroid == "gaussian" else p.max_saturated_px):
            return SpotMiss(MissReason.SATURATED, peak), flux
        xx, yy = moments.xx, moments.yy
        # by trace and determinant, for the smaller of the principal variances over the larger one, r, has r / (1 + r)^2 = det / trace^2;
        # that of a pixel, added to both, keeps a one-pixel row finite
        wide, high = xx + PIXEL_VARIANCE_PX2, yy + PIXEL_VARIANCE_PX2
        if wide * high - moments.xy**2 < self._least_roundness * (wide + high) ** 2:
            return SpotMiss(MissReason.ELONGATED, peak), flux

        x, y, variance_x, variance_y = moments.x, moments.y, moments.variance_x, moments.variance_y
        if p.centroid == "gaussian" or (moments.saturated_px and p.centroid == "weighted"):
            x, y, variance_x, variance_y, xx, yy = _fitted(image, moments, x0, y0, levels.weights.noise)
        elif p.centroid == "border":
            level = max(levels.extent_dn, levels.background.mean_dn + p.border_level * signal)
            middle = border_centroid(pixels.astype(np.float64), level, levels.weights.noise)
            if middle is not None:
                x, y, variance_x, variance_y = middle
        uncertainty = math.sqrt(0.5 * (variance_x + variance_y))
        return Spot(x0 + x, y0 + y, math.sqrt(xx), math.sqrt(yy), float(peak), flux, area, uncertainty), flux

    def boxes(self, image: Image, levels: SpotLevels) -> tuple[list[Box], float]:
        """Boxes of the blobs of a frame, and its brightest pixel, DN: those that reach the seed level if any do, else the dim ones."""
        _, peak, _, (_, row) = cv2.minMaxLoc(image)
        rows, extent, seed = len(image), levels.extent_dn, levels.seed_dn
        if peak <= extent:
            return [], peak
        if peak > seed:
            boxes = None
            top, bottom = max(row - _ROWS_PX, 0), min(row + _ROWS_PX + 1, rows)
            if (top == 0 or cv2.minMaxLoc(image[:top])[1] <= seed) and (bottom == rows or cv2.minMaxLoc(image[bottom:])[1] <= seed):
                boxes = _boxes_between(image, extent, top, bottom)
            if boxes is None:
                top, bottom = self._bright_rows(image, seed)
                boxes = _boxes_between(image, extent, max(top - _FOOT_PX, 0), min(bottom + _FOOT_PX, rows))
            if boxes is not None:
                return boxes, peak
        top, bottom = self._bright_rows(image, extent)
        return _boxes_between(image, extent, max(top - 1, 0), min(bottom + 1, rows)) or [], peak

    def _bright_rows(self, image: Image, level: int) -> tuple[int, int]:
        """First row with a pixel above a level, of which there is one, and the row after the last."""
        memory, above = self._scratch.of(image.shape)
        cv2.threshold(image, level, 255, cv2.THRESH_BINARY, above)
        return memory.find(255) // image.shape[1], memory.rfind(255) // image.shape[1] + 1

    def _of_background(self, background: Background) -> SpotLevels:
        p = self.parameters
        extent = math.floor(background.mean_dn + max(p.threshold_sigmas * background.sd_dn, p.min_contrast_dn))
        seed = max(extent, math.ceil(background.mean_dn + p.min_peak_dn) - 1)
        noise = PixelNoise.of(background, p.read_noise_dn, p.shot_dn, p.saturation_dn)
        return SpotLevels(background, extent, seed, PixelWeights(noise, extent))


_NO_SPOT = SpotMiss(MissReason.NO_SPOT)


def _boxes_between(image: Image, level: int, top: int, bottom: int) -> list[Box] | None:
    """Boxes of the blobs above a level, of which there is one, between two rows of a frame; None where one goes on beyond."""
    above = cv2.threshold(image[top:bottom], level, 255, cv2.THRESH_BINARY)[1]
    x, y, w, h = cv2.boundingRect(above)  # blobs are told apart in it alone: a tenth of the time for a single spot
    if (y == 0 and top > 0) or (y + h == bottom - top and bottom < len(image)):
        return None
    bright = above[y : y + h, x : x + w]
    if w * h <= _LABELLED_PX and cv2.connectedComponents(bright)[0] == _ONE_BLOB:
        return [(x, top + y, w, h)]
    contours = cv2.findContours(bright, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE, offset=(x, top + y))[0]
    return [cv2.boundingRect(contour) for contour in contours]


def _count_above(pixels: Image, level: int) -> int:
    return cv2.countNonZero(cv2.threshold(pixels, level, 255, cv2.THRESH_BINARY)[1])


class _Scratch(threading.local):
    """One thread's room for a binary frame, as an image and as bytes."""

    def __init__(self) -> None:
        self._shape: tuple[int, ...] = ()
        self._memory = bytearray()
        self._image: Image = np.empty((0, 0), np.uint8)

    def of(self, shape: tuple[int, ...]) -> tuple[bytearray, Image]:
        if shape != self._shape:
            self._shape, self._memory = shape, bytearray(math.prod(shape))
            self._image = np.frombuffer(self._memory, np.uint8).reshape(shape)
        return self._memory, self._image


def _fitted(image: Image, moments: Moments, x0: int, y0: int, noise: PixelNoise) -> tuple[float, float, float, float, float, float]:
    """Place from (x0, y0), its variances and the second moments by the Gaussian fit; the weighted ones if it does not converge."""
    x, y = x0 + moments.x, y0 + moments.y
    reach_x = math.ceil(REACH_SIGMA * math.sqrt(max(moments.xx, 0.25)))
    reach_y = math.ceil(REACH_SIGMA * math.sqrt(max(moments.yy, 0.25)))
    left, top = max(round(x) - reach_x, 0), max(round(y) - reach_y, 0)
    pixels = image[top : round(y) + reach_y + 1, left : round(x) + reach_x + 1]
    fit = fit_gaussian(pixels, x - left, y - top, moments, noise)
    if fit is None:
        return moments.x, moments.y, moments.variance_x, moments.variance_y, moments.xx, moments.yy
    xx, yy = fit.sigma_x**2 + PIXEL_VARIANCE_PX2, fit.sigma_y**2 + PIXEL_VARIANCE_PX2
    return fit.x + left - x0, fit.y + top - y0, fit.variance_x, fit.variance_y, xx, yy


def _gap(box: Box, other: Box) -> int:
    """Pixels between two boxes, 0 where they touch or overlap."""
    across = max(other[0] - box[0] - box[2], box[0] - other[0] - other[2])
    along = max(other[1] - box[1] - box[3], box[1] - other[1] - other[3])
    return max(across, along, 0)
