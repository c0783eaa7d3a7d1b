"""What a camera saw of the laser spot in one frame."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple


class MissReason(Enum):
    """Why a frame holds no usable spot."""

    NO_SPOT = "no_spot"
    TOO_DIM = "too_dim"
    TOO_SMALL = "too_small"
    TOO_LARGE = "too_large"
    ELONGATED = "elongated"
    SATURATED = "saturated"
    CUT_BY_EDGE = "cut_by_edge"
    AMBIGUOUS = "ambiguous"
    TOO_BRIGHT = "too_bright"
    TORN = "torn"
    OUT_OF_STEP = "out_of_step"
    """The cameras run freely, and no frame of the other one lies near enough to this instant."""


class Spot(NamedTuple):
    """A laser spot's image; a tuple, because one is made of every frame and a frozen dataclass takes four times as long.

    Attributes
    ----------
    x_px, y_px : centroid; the centre of the first pixel is (0, 0)
    sigma_x_px, sigma_y_px : standard deviations of the light along x and y, what the threshold cut off made up for as in a
        Gaussian; the pixel's own width (0.29 px) is part of them
    peak_dn : brightest pixel, 0 to 255
    flux_dn : sum above the threshold
    area_px : pixels above the threshold
    standard_uncertainty_px : of each coordinate, k = 1
    """

    x_px: float
    y_px: float
    sigma_x_px: float
    sigma_y_px: float
    peak_dn: float
    flux_dn: float
    area_px: int
    standard_uncertainty_px: float


@dataclass(frozen=True, slots=True)
class SpotMiss:
    """No usable spot, and why: an expected value, not an error.

    Attributes
    ----------
    peak_dn : brightest pixel of what was rejected, 0 to 255
    candidates : the spots among which the frame alone cannot tell, brightest first, when the reason is `AMBIGUOUS`: each
        passed all gates, and the other camera's may decide by the epipolar residual.  Empty for any other reason
    """

    reason: MissReason
    peak_dn: float = 0.0
    candidates: tuple[Spot, ...] = ()
