"""The dark level of a frame and its noise, from the frame itself."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

_SAMPLE_PX, _SAMPLE_ROWS = 4000, 6
"""Pixels looked at, in whole rows and at least so many: their standard deviation is known to 1.1 %, their mean to a sixtieth of
it.  Rows, because a row is what the memory delivers at a time and what OpenCV reads in place."""

_ROUNDS = 4
_CLIP_SD, _CLIP_DN = 4.5, 2.0
"""What is farther above the mean is left out; never closer than 2 DN, so that the rounding of a dark, noiseless frame clips nothing."""

_LIT_SD_DN, _CLIP_LIT_SD = 8.0, 2.0
"""No sensor is so noisy: something bright is in the sample, up to a fifth of which this clips."""


class Background(NamedTuple):
    """Mean and standard deviation of the dark pixels, DN; the standard deviation holds the rounding to 8 bits."""

    mean_dn: float
    sd_dn: float


def estimate_background(image: NDArray[np.uint8]) -> Background:
    """Background of an image (H, W) uint8: mean and deviation of a regular sample, what is bright in it left out."""
    sample = image[_sampled_rows(*image.shape)]
    means, sds = cv2.meanStdDev(sample)
    limit = cv2.minMaxLoc(sample)[1]
    for left in range(_ROUNDS, -1, -1):
        mean, sd = means.item(), sds.item()
        clip = math.floor(mean + max((_CLIP_SD if sd < _LIT_SD_DN else _CLIP_LIT_SD) * sd, _CLIP_DN))
        if clip >= limit or not left:
            break
        limit = clip
        means, sds = cv2.meanStdDev(sample, mask=cv2.threshold(sample, limit, 255, cv2.THRESH_BINARY_INV)[1])
    return Background(mean, sd)


@lru_cache(maxsize=16)
def _sampled_rows(height: int, width: int) -> slice:
    step = max(1, height // max(_SAMPLE_ROWS, _SAMPLE_PX // width))
    return slice(step // 2, None, step)
