"""The joint covariance of a whole calibration, as modes: cameras, relative pose, scale and axis with all that ties them.

The stereo parameters and the board's shape come with their covariance from the bundle adjustment.  The known length ties
them together once more (a wrong focal length that makes the bar longer makes the scale smaller), and whatever is wrong with
the cameras and the board is carried into the axis, for the same corners are triangulated with them.  To this come what
is the axis' own (the noise of its views) and the uncertainty of the known length.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.board import LengthBar
from scanner_core.optics.bundle_adjustment import STEREO, moved_cameras
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_uncertainty import PARAMETERS, truncated_modes
from scanner_core.optics.length_scale import BarImages
from scanner_core.optics.stereo_calibration import StereoCalibrationFit
from scanner_core.optics.stereo_view import StereoView
from scanner_core.optics.turntable_calibration import TurntableFit

Array = NDArray[np.float64]

_NOTHING = 1e-10
"""Eigenvalues of a correlation matrix below this are rounding."""


def stereo_steps(fit: StereoCalibrationFit, bar_views: Sequence[StereoView], bar: LengthBar | None) -> Array:
    """Steps (k, 24 + 3 m) of the stereo parameters and the marks whose outer products add up to their covariance.

    Each keeps the mean length of the bar in the views that have set the scale.
    """
    steps = square_root(fit.covariance)
    if bar is None or not bar_views:
        return steps
    images = BarImages.of(bar_views, bar)
    length = float(images.lengths(fit.left, fit.right).mean())
    for step in steps:
        longer = float(images.lengths(*moved_cameras(fit.left, fit.right, step[:STEREO])).mean()) / length - 1
        step[STEREO - 3 : STEREO] -= longer * fit.right.translation
        step[STEREO:] -= longer * fit.marks.ravel()
    return steps


def joint_modes(calibration: StereoCalibration, steps: Array, axis: TurntableFit, scale_ppm: float) -> Array:
    """Modes (k, 30) of a calibration, truncated to what moves points.

    Parameters
    ----------
    steps : of the stereo parameters, the same that `axis` was asked for
    scale_ppm : standard uncertainty of all lengths
    """
    own = square_root(axis.noise_covariance)
    modes = np.zeros((len(steps) + len(own) + 1, PARAMETERS))
    modes[: len(steps), :STEREO], modes[: len(steps), STEREO:] = steps[:, :STEREO], axis.induced
    modes[len(steps) : -1, STEREO:] = own
    modes[-1, STEREO - 3 : STEREO] = 1e-6 * scale_ppm * calibration.right.translation
    modes[-1, STEREO : STEREO + 3] = 1e-6 * scale_ppm * calibration.turntable.origin
    return truncated_modes(calibration, modes)


def square_root(covariance: Array) -> Array:
    """Rows whose outer products add up to a covariance (n, n)."""
    spread = np.sqrt(np.diag(covariance))
    known = spread > 0
    rows = np.zeros((int(np.count_nonzero(known)), len(covariance)))
    if not known.any():
        return rows
    values, vectors = np.linalg.eigh(covariance[np.ix_(known, known)] / np.outer(spread[known], spread[known]))
    rows[:, known] = (vectors * np.sqrt(np.maximum(values, 0.0))).T * spread[known]
    return np.asarray(rows[values > _NOTHING * values.max()], np.float64)
