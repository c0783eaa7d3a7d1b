"""The laser's spot as what a lit image has more than a dark one: whatever else the cameras see, and however bright, drops out."""

from __future__ import annotations

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


def mean_image(camera: Camera, frames: int) -> Image:
    """Mean of so many frames (H, W) in DN; one more comes first and is not used: it may have begun before its light was there.

    Raises
    ------
    DeviceError
    """
    camera.grab()
    total = camera.grab().image.astype(np.float32)
    for _ in range(frames - 1):
        total += camera.grab().image
    total /= frames
    return total


def difference_spot(lit: Image, dark: Image) -> DifferenceSpot | None:
    """The one spot in ``lit - dark``, both (H, W) in DN, or None where there is none, or several as bright."""
    difference = lit - dark
    sample = difference[::3, ::3]
    middle = float(np.median(sample))
    noise = max(_LEAST_NOISE_DN, _MAD * float(np.median(np.abs(sample - middle))))
    threshold = middle + max(_LEAST_DN, _SIGMAS * noise)
    bright = (difference > threshold).astype(np.uint8)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(bright)
    flux = np.bincount(labels.ravel(), weights=np.where(bright, difference - middle, 0).ravel(), minlength=count)
    flux[0] = 0.0
    order = np.argsort(flux)[::-1]
    best = int(order[0])
    area = int(stats[best, cv2.CC_STAT_AREA])
    if best == 0 or area < _LEAST_AREA_PX or area > _MOST_AREA * difference.size:
        return None
    if count > 2 and flux[best] < _DOMINANCE * flux[order[1]]:
        return None
    rows, columns = np.nonzero(labels == best)
    weight = difference[rows, columns] - middle
    return DifferenceSpot(
        float(weight @ columns / weight.sum()), float(weight @ rows / weight.sum()), float(weight.max()), float(weight.sum()), noise
    )


def picture(image: Image) -> NDArray[np.uint8]:
    """For a person, (H, W); what is below 0 is black."""
    return np.clip(np.round(image), 0, 255).astype(np.uint8)
