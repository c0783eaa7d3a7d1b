"""Which variances explain squared residuals best: maximum likelihood for normal residuals, robust against strays.

Residuals beyond three standard deviations are clipped there, and the clipped mean square is made up for, so that a few
mismatches or edges count as little as they should.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_CLIP = 3.0
_CLIPPED_VARIANCE = 0.9950
"""Of a standard normal variate clipped at three: E[min(z^2, 9)]."""
MEDIAN_SQUARE = 0.4549
"""Median of the square of a standard normal variate."""
_ROUNDS = 30


def variance_components(squares: Array, parts: Array, start: Array, known: Array | float = 0.0) -> Array:
    """Factors (m,) >= 0 of variances whose sum explains squared residuals.

    Iterated, weighted non-negative least squares.

    Parameters
    ----------
    squares : (n,) squared residuals
    parts : (n, m) variances; the residuals' variance is ``known + parts @ factors``
    start : (m,) first factors
    known : (n,) the part that is not in question
    """
    from scipy.optimize import nnls

    scale = np.maximum(parts.mean(axis=0), 1e-300)
    unit = parts / scale
    factors = start * scale
    least = 1e-12 * float(squares.max(initial=0.0)) + 1e-300
    for _ in range(_ROUNDS):
        variance = np.maximum(known + unit @ factors, least)
        clipped = np.minimum(squares, _CLIP**2 * variance) / _CLIPPED_VARIANCE
        before = factors
        factors = nnls(unit / variance[:, None], (clipped - known) / variance)[0]
        if np.abs(factors - before).max() < 1e-4 * float(variance.mean()):
            break
    return np.asarray(factors / scale, np.float64)
