"""Which of two cameras stands to the left, by points that both have seen.

With a calibration the answer is in the epipolar residuals: they are small in the right order only.  Without one it is in the epipoles:
two cameras that look inwards at an object see each other, far outside of their images, the left one on its right and the right one
on its left (Hartley & Zisserman, Multiple View Geometry, ch. 9).  Few points of a shallow object do not tell; then neither does this.
"""

from __future__ import annotations

from collections.abc import Iterable

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.commissioning.sighting import Sighting
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.triangulation import CameraPair, Triangulator

Array = NDArray[np.float64]

_LEAST_PAIRS = 14
_PARTS = 5
_FITS_PX = 2.0
_CONTRAST = 4.0


def pairs_of(sightings: Iterable[Sighting]) -> tuple[Array, Array]:
    """The places (n, 2) px in the left and in the right image of all points that both cameras have seen."""
    seen = [(a.x_px, a.y_px, b.x_px, b.y_px) for s in sightings if (a := s.spots["left"]) is not None and (b := s.spots["right"]) is not None]
    places = np.array(seen, np.float64).reshape(-1, 4)
    return places[:, :2].copy(), places[:, 2:].copy()


def exchanged(left_px: Array, right_px: Array, size_px: tuple[int, int], calibration: StereoCalibration | None) -> bool | None:
    """True when what is called the left camera stands to the right of the other; None when the points do not tell.

    Parameters
    ----------
    left_px, right_px : (n, 2) the same points in both images
    size_px : of the images
    """
    if calibration is not None and len(left_px) >= 1:
        straight, crossed = _residual(calibration, left_px, right_px), _residual(calibration, right_px, left_px)
        if min(straight, crossed) < _FITS_PX and max(straight, crossed) > _CONTRAST * min(straight, crossed):
            return crossed < straight
        return None
    if len(left_px) < _LEAST_PAIRS:
        return None
    part = np.arange(len(left_px)) % _PARTS
    answers = {_by_epipoles(left_px[part != k], right_px[part != k], size_px) for k in range(_PARTS)}
    answers.add(_by_epipoles(left_px, right_px, size_px))
    return answers.pop() if len(answers) == 1 else None


def _residual(calibration: StereoCalibration, left_px: Array, right_px: Array) -> float:
    residual = Triangulator(CameraPair(calibration.left, calibration.right)).epipolar_residual(left_px, right_px)
    return float(np.median(np.abs(np.nan_to_num(residual, nan=np.inf))))


def _by_epipoles(left_px: Array, right_px: Array, size_px: tuple[int, int]) -> bool | None:
    matrix, _ = cv2.findFundamentalMat(left_px, right_px, cv2.FM_8POINT)
    if matrix is None or matrix.shape != (3, 3):
        return None
    u, _, vt = np.linalg.svd(matrix)
    middle = 0.5 * np.array(size_px)
    sides = []
    for x, y, w in (vt[2], u[:, 2]):
        place = np.array([x, y]) / w - middle if abs(w) > 1e-12 else np.array([np.inf, 0.0])
        if not abs(place[0]) > middle[0]:  # within the image: it is none
            return None
        sides.append(np.sign(place[0]))
    return None if sides[0] == sides[1] else bool(sides[0] < 0)
