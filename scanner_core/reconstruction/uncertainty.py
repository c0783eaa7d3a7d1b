"""The predicted error of the fitted surface, from the smoother itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.smoothing import uniform_averaging
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]

_PROBES = 6


def standard_uncertainty(spline: SmoothingSpline, bandwidth_mm: Array, seed: int) -> Array:
    """Standard uncertainty (k = 1) of every vertex along its normal, (v,), mm.

    The spread is what the smoother makes of random noise of the estimated sigma: solved for a few draws and averaged over
    the neighbours, which stands for the diagonal of its covariance.  The bias is what the smoother takes away from its
    own answer when it is applied to it once more.
    """
    count = len(spline.distances_mm)
    sigma = spline.noise_mm * np.sqrt(spline.variance / spline.observations.counts)
    draws = np.random.default_rng(seed + 1).normal(size=(count, _PROBES)) * sigma[:, None]
    flat = np.zeros((len(spline.area), _PROBES))
    answers = spline.solve(bandwidth_mm, draws, flat, tolerance=1e-2)
    variance = (answers**2).mean(axis=1)
    again = spline.solve(bandwidth_mm, np.zeros((count, 1)), spline.curvature[:, None])
    bias = again[:, 0] ** 2
    averaging = uniform_averaging(spline.mesh)
    for _ in range(4):
        variance, bias = 0.5 * (variance + averaging @ variance), 0.5 * (bias + averaging @ bias)
    return np.asarray(np.sqrt(variance + bias))
