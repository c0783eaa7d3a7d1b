"""What the calibration's millimetres rest on: a certified length held before the cameras.

A print that is two parts in a thousand too large makes a rig that measures everything two parts in a thousand too small,
and nothing in the images of the board can tell: the board's size and the baseline grow together.  A second length can.
Half of its views set the scale; the others, which took no part, judge it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import CalibrationError
from scanner_core.optics.board import CharucoTarget, LengthBar
from scanner_core.optics.calibration import ScaleReference
from scanner_core.optics.camera_model import CameraModel
from scanner_core.optics.stereo_calibration import StereoCalibrationFit
from scanner_core.optics.stereo_view import StereoView
from scanner_core.optics.triangulation import CameraPair, Triangulator

Array = NDArray[np.float64]

MIN_BAR_VIEWS = 4
"""Two that set the scale and two that judge it."""
MAX_RATIO = 0.01
"""A board whose size differs by more was not printed too large, it was described wrongly."""
MAX_HELD_OUT_PPM = 150.0
"""Largest believable error of the held-out bars: 22 um on 150 mm."""
_SIGMAS = 3.0
"""A held-out error within three standard uncertainties is no evidence, however large: noisy cameras need more views."""
_WORST_PPM = 500.0
"""Beyond this the calibration is of no use, whatever the uncertainty."""
UNVERIFIED_PPM = 1200.0
"""Standard uncertainty of the size of a print that nobody has measured: within 0.2 % either way, evenly likely."""


@dataclass(frozen=True, slots=True, eq=False)
class BarScale:
    """What the bar says.

    Attributes
    ----------
    factor : by which all lengths of the fit have to be multiplied
    reference : for the calibration
    fitted : the views that set the scale
    """

    factor: float
    reference: ScaleReference
    fitted: list[StereoView]


def measure_bar(left: CameraModel, right: CameraModel, views: Sequence[StereoView], bar: LengthBar) -> Array:
    """The bar's length by every view that shows both of its groups whole to both cameras, (n,) mm."""
    return BarImages.of(views, bar).lengths(left, right)


@dataclass(frozen=True, slots=True, eq=False)
class BarImages:
    """The corners of both groups in the views that show them whole, (n, 2, k, 2) px: view, group, corner."""

    left_px: Array
    right_px: Array

    @classmethod
    def of(cls, views: Sequence[StereoView], bar: LengthBar) -> BarImages:
        needed = np.concatenate(bar.groups())
        pairs = []
        for view in views:
            ids, left_px, right_px = view.common()
            if np.isin(needed, ids).all():
                rows = np.searchsorted(ids, needed)
                pairs.append((left_px[rows], right_px[rows]))
        left, right = (np.array([pair[side] for pair in pairs]).reshape(len(pairs), 2, len(needed) // 2, 2) for side in (0, 1))
        return cls(left, right)

    def lengths(self, left: CameraModel, right: CameraModel) -> Array:
        """Distance of the groups' middles by every view, (n,) mm."""
        triangulator = Triangulator(CameraPair(left, right))
        ones = np.ones(self.left_px.size // 2)
        points = triangulator.triangulate(self.left_px.reshape(-1, 2), self.right_px.reshape(-1, 2), ones, ones).points
        middles = points.reshape(*self.left_px.shape[:3], 3).mean(axis=2)
        return np.asarray(np.linalg.norm(middles[:, 0] - middles[:, 1], axis=1), np.float64)


def scale_by_bar(fit: StereoCalibrationFit, views: Sequence[StereoView], bar: LengthBar, target: CharucoTarget) -> BarScale:
    """The scale by the first, third, ... view of the bar, judged by the others.

    Raises
    ------
    CalibrationError
        E-CAL-01 when the bar was seen too rarely; E-CAL-04 when the board's squares are not what they were said to be; E-CAL-03 when the
        held-out views do not measure the certified length.
    """
    whole = [view for view in views if len(measure_bar(fit.left, fit.right, [view], bar))]
    if len(whole) < MIN_BAR_VIEWS:
        reason = f"{len(whole)} of {len(views)} views show the length bar whole to both cameras, at least {MIN_BAR_VIEWS} are needed"
        raise CalibrationError("E-CAL-01", reason=reason)
    fitted, judging = whole[0::2], whole[1::2]
    measured = measure_bar(fit.left, fit.right, fitted, bar)
    factor = bar.length_mm / float(measured.mean())
    if abs(factor - 1) > MAX_RATIO:
        measured_mm, given_mm = f"{factor * target.square_mm:.2f}", f"{target.square_mm:.2f}"
        raise CalibrationError("E-CAL-04", measured_mm=measured_mm, given_mm=given_mm, bar_mm=f"{bar.length_mm:.3f}")
    judged = factor * measure_bar(fit.left, fit.right, judging, bar)
    # One scatter of both halves about their own means: four lengths alone say little of their own spread.
    freedom = len(measured) + len(judged) - 2
    spread_mm = float(np.sqrt((np.square(factor * (measured - measured.mean())).sum() + np.square(judged - judged.mean()).sum()) / freedom))
    set_ppm = 1e6 * float(np.hypot(bar.uncertainty_mm, spread_mm / np.sqrt(len(measured)))) / bar.length_mm
    error_ppm = 1e6 * (float(judged.mean()) / bar.length_mm - 1)
    error_u_ppm = 1e6 * spread_mm * float(np.sqrt(1 / len(measured) + 1 / len(judged))) / bar.length_mm
    limit_ppm = min(_WORST_PPM, max(MAX_HELD_OUT_PPM, _SIGMAS * error_u_ppm))
    if abs(error_ppm) > limit_ppm:
        reason = (
            f"the bar of {bar.length_mm:.3f} mm, where it took no part, measures {1e-3 * error_ppm * bar.length_mm:+.0f} um too much, "
            f"at most {1e-3 * limit_ppm * bar.length_mm:.0f} um are allowed"
        )
        raise CalibrationError("E-CAL-03", reason=reason)
    return BarScale(factor, ScaleReference("bar", bar.length_mm, set_ppm, factor, (error_ppm, error_u_ppm)), fitted)
