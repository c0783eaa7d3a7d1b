"""The predicted error of the fitted surface, from the smoother itself.

The *spread* is the share of the noise that the smoother passes (``pass_band``).

The *bias* is the detail that the smoothing took away.  What it would take away from its own answer, R (1 - R), is known; from
that the share that is only noise, R^2 (1 - R)^2 integrated, is subtracted.  Of the true detail (1 - R) it took more than of its
own answer, by a factor that depends on the shape's spectrum: the one here was found on shapes of our own, see ``BIAS_FACTOR``.
Under heavy noise, when the association is soft, the points show nothing of waves shorter than their noise, so that
the answer knows less of what is missing.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.reconstruction.facets import mean_lifts
from scanner_core.reconstruction.pass_band import VARIANCE, VARIANCE_LOST_AGAIN
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]

BIAS_FACTOR = 2.4
"""True detail lost over what is lost once more.  With 2 the scatter of error over uncertainty is 1.26, 1.15, 0.95, 0.98 on two
clouds of an ear, a heart and a dental arch, with 2.5 it is 1.16, 1.06, 0.88, 0.90."""

_BLIND = 1.3
"""Noise over bandwidth below which a soft association still sees all that the bandwidth lets through."""


_DEEPEST_CUT = 0.2
"""Of its bandwidth, the most that the smoother takes from its own answer: on whole surfaces one vertex in a thousand exceeds it."""


def standard_uncertainty(spline: SmoothingSpline, bandwidth_mm: Array) -> Array:
    """Standard uncertainty (k = 1) of every vertex along its normal, (v,), mm; with a bandwidth (v,), mm."""
    surface = spline.surface
    density = spline.association.interpolation.T @ spline.weights / surface.area
    density = surface.diffused(density[:, None], bandwidth_mm, tolerance=1e-2)[:, 0]
    density = np.maximum(density, 0.02 * spline.density)
    # the bandwidth is a length at the mean density; where the points are denser, they smooth over less
    wide = bandwidth_mm**2 * np.sqrt(spline.density / density)
    noise = spline.noise_mm**2 / (density * wide)
    again = spline.solve(bandwidth_mm, np.zeros((len(spline.weights), 1)), spline.curvature[:, None])[:, 0]
    # At a free rim, where no point holds the answer, it can run away.
    again = np.clip(again, -_DEEPEST_CUT * bandwidth_mm, _DEEPEST_CUT * bandwidth_mm)
    lost = surface.diffused((again**2)[:, None], bandwidth_mm, tolerance=1e-2)[:, 0]
    lost = np.maximum(lost - VARIANCE_LOST_AGAIN * noise, 0)
    factor = np.full(len(density), BIAS_FACTOR)
    if spline.association.soft:
        factor *= np.maximum(1, (_BLIND * spline.noise_mm / bandwidth_mm) ** 2)
    lift = mean_lifts(spline.mesh, spline.normals)
    return np.asarray(np.sqrt(VARIANCE * noise + factor**2 * lost + lift**2))
