"""Robust weights: which observations do not belong to the surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.reconstruction.cloud_scale import CloudScale

Array = NDArray[np.float64]

_FULL, _NONE = 3.0, 5.0
"""Residuals up to the first, in sigma, count fully, from the second on not at all."""


def robust_weights(residuals_mm: Array, scale: CloudScale, *, patient: bool = True) -> Array:
    """1 up to 3 sigma, 0 from 5 sigma on, with sigma from the median of the residuals after the fit, (n,).

    With patience, points that agree with their neighbours are no outliers however far they are: the surface has not got there yet, for
    example into a slit.  They keep their weight if they are sampled as densely as the rest.
    """
    sigma = max(1.4826 * float(np.median(np.abs(residuals_mm))), 0.1 * scale.spacing_mm)
    weights = np.clip((_NONE - np.abs(residuals_mm) / sigma) / (_NONE - _FULL), 0, 1)
    far = np.flatnonzero(weights < 1) if patient else np.zeros(0, np.int64)
    around = np.median(residuals_mm[scale.neighbours[far]], axis=1)
    agree = (np.abs(residuals_mm[far] - around) < _FULL * sigma) & (scale.reach_mm[far] < 2 * np.median(scale.reach_mm))
    weights[far[agree]] = 1.0
    weights[scale.isolated] = 0.0
    return np.asarray(weights)
