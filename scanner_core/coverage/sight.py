"""What the beam and the cameras reach of a surface at one table angle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """The places (v) of a surface, as seen at one table angle.

    Attributes
    ----------
    table_deg : the angle
    beam_deg : (v, 2) pan X and tilt Y that point the beam at each place
    beam_free, left_free, right_free : (v,) nothing of the object stands between the place and the beam's pivot, the camera.  Rays are
        cast only for what may matter: False also where the place does not face all three or is out of view, and for the cameras
        where the beam does not get
    cosines : (v, 3) of the angle between the outward normal and the direction to the beam's pivot, the left and the right
        camera; negative where the place faces away
    in_view : (v,) inside both images, the volume and the beam's range
    point_sd_um : (v,) standard deviation of one measured point along the normal, as predicted; NaN where it is not measurable
    """

    table_deg: float
    beam_deg: Array
    beam_free: Mask
    left_free: Mask
    right_free: Mask
    cosines: Array
    in_view: Mask
    point_sd_um: Array

    @property
    def measurable(self) -> Mask:
        """(v,) the beam gets there and both cameras see it."""
        return np.isfinite(self.point_sd_um)
