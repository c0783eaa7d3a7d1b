"""The laser's spot as what a lit image has more than a dark one: whatever else the cameras see, and however bright, drops out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Camera

Image = NDArray[np.float32]

_SIGMAS = 6.0
_LEAST_DN = 4.0
_LEAST_NOISE_DN = 0.3
_LEAST_AREA_PX = 2
_MOST_AREA = 0.03
"""Part of the image above which it is no spot: the beam lights the whole scene, or the lamp was switched meanwhile."""
_DOMINANCE = 1.5
_MAD = 1.4826
_SAMPLE = 50_000
"""Pixels that tell the noise."""


@dataclass(frozen=True, slots=True)
class DifferenceSpot:
    """A spot in a difference image.

    Attributes
    ----------
    x_px, y_px : its centre of gravity; the centre of the first pixel is (0, 0)
    peak_dn, flux_dn : brightest pixel and sum of the difference
    noise_dn : robust standard deviation of the difference elsewhere
    """

    x_px: float
    y_px: float
    peak_dn: float
    flux_dn: float
    noise_dn: float


def mean_image(camera: Camera, frames: int, between: Callable[[], object]) -> Image:
    """Mean of so many frames (H, W) in DN; one more comes first and is not used: it may have begun before its light was there.

    `between` is called after every frame: a lit laser has to be looked after.

    Raises
    ------
    DeviceError
    """
    total: Image | None = None
    camera.grab()
    for _ in range(frames):
        between()
        image = camera.grab().image.astype(np.float32)
        total = image if total is None else total + image
    between()
    if total is None:
        raise ValueError("a mean of no frames")
    return np.asarray(total / frames, np.float32)


def difference_spot(lit: Image, dark: Image) -> DifferenceSpot | None:
    """The one spot in ``lit - dark``, both (H, W) in DN, or None where there is none, or several as bright."""
    difference = cv2.subtract(lit, dark)
    step = max(3, round((difference.size / _SAMPLE) ** 0.5))
    sample = difference[::step, ::step]
    middle = float(np.median(sample))
    noise = max(_LEAST_NOISE_DN, _MAD * float(np.median(np.abs(sample - middle))))
    bright = (difference > middle + max(_LEAST_DN, _SIGMAS * noise)).astype(np.uint8)
    if not _LEAST_AREA_PX <= cv2.countNonZero(bright) <= _MOST_AREA * difference.size:
        return None
    left, top, width, height = cv2.boundingRect(bright)  # of a large image little is bright
    bright, light = bright[top : top + height, left : left + width], difference[top : top + height, left : left + width]
    count, labels, stats, _ = cv2.connectedComponentsWithStats(bright)
    flux = np.bincount(labels.ravel(), weights=(light - middle).ravel(), minlength=count)
    flux[0] = 0.0
    order = np.argsort(flux)[::-1]
    best = int(order[0])
    if best == 0 or stats[best, cv2.CC_STAT_AREA] < _LEAST_AREA_PX:
        return None
    if count > 2 and flux[best] < _DOMINANCE * flux[order[1]]:
        return None
    rows, columns = np.nonzero(labels == best)
    weight = light[rows, columns] - middle
    total = float(weight.sum())
    x, y = left + float(weight @ columns) / total, top + float(weight @ rows) / total
    return DifferenceSpot(x, y, float(weight.max()), total, noise)


def picture(image: Image) -> NDArray[np.uint8]:
    """For a person, (H, W); what is below 0 is black."""
    return np.clip(np.round(image), 0, 255).astype(np.uint8)
