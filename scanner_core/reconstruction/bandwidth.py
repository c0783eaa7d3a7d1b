"""How far the surface may be smoothed, place by place: local generalized cross-validation.

A narrow bandwidth follows the noise, a wide one flattens detail; which is worse differs from the edge of a tooth to the gum
beside it.  The score of a bandwidth,

    V(h) = (mean squared residual) / (1 - mean leverage)^2        (Craven and Wahba 1979),

predicts the error for points that were not used.  Both means are taken over the surroundings of each vertex, which are as
wide as is needed to hold enough points, and every vertex takes the bandwidth with the lowest score.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.reconstruction.pass_band import FREEDOM
from scanner_core.reconstruction.spline import SmoothingSpline

Array = NDArray[np.float64]

_WINDOW_BANDWIDTHS = 1.5
_WINDOW_POINTS = 300.0
"""Surroundings reach 1.5 bandwidths, and hold so many points at least: with fewer the score follows the noise, with many more
the bandwidth of a ridge is that of the plain around it (heart: 39 um at 150 points, 42 at 600; one bandwidth for all: 61)."""

_GAMMA = 1.4
"""Degrees of freedom count 1.4 times: plain cross-validation takes too narrow a bandwidth too often (Kim and Gu, "Smoothing spline
Gaussian regression: more scalable computation via efficient approximation", 2004)."""

_KERNEL_AREA = 16 * np.pi
"""Effective area of two implicit diffusion steps of reach 1: four pi times the variance, which is 4 an axis."""


@dataclass(frozen=True, slots=True, eq=False)
class LocalChoice:
    """The bandwidth with the best score at every vertex.

    Attributes
    ----------
    rung : (v,) float64, place on the ladder, 0 for the narrowest, with fractions
    noise_mm : sigma of the measurements, from the residuals of the best choice
    """

    rung: Array
    noise_mm: float


def local_choice(spline: SmoothingSpline, ladder_mm: Array, bandwidth_mm: Array) -> LocalChoice:
    """Choose among bandwidths `ladder_mm` (k, v), narrowest first, where `bandwidth_mm` (v,) is the one in use."""
    spline.prepare_for_many()
    counts = spline.robust * spline.observations.counts
    gather = spline.association.interpolation.T
    area = spline.area
    measured = gather @ counts / area
    spacing = float(1 / np.sqrt(measured @ area / area.sum()))
    sums = spline.surface.diffused(np.column_stack([measured, gather @ spline.weights / area]), np.full(len(area), 2 * spacing), tolerance=1e-2)
    local, precise = np.maximum(sums, 1e-3 / spacing**2).T
    window = np.maximum(_WINDOW_BANDWIDTHS * bandwidth_mm, np.sqrt(_WINDOW_POINTS / (_KERNEL_AREA * local)))
    scores, noises = [], []
    for rung in ladder_mm:
        step = spline.step(rung, tolerance=1e-2)
        squares = spline.squares(step.residuals_mm)
        # The bandwidth is a length at the mean density; where the points are denser, they smooth over less.  A vertex has one degree of
        # freedom at most.  (Against the trace from random signs: within 5 % from 0.4 edges on; under a soft association a third too high.)
        freedom = 1 / np.hypot(rung**2 * np.sqrt(spline.density / precise) / FREEDOM, area)
        noises.append(spline.noise(step.residuals_mm, float(freedom @ area)))
        sums = np.column_stack([gather @ (counts * squares) / area, measured, freedom])
        for _ in range(2):
            sums = spline.surface.diffused(sums, window, tolerance=1e-2)
        number = np.maximum(sums[:, 1], 1e-12)
        scores.append(sums[:, 0] / number / np.maximum(1 - _GAMMA * sums[:, 2] / number, 0.1) ** 2)
    rung = _lowest(np.array(scores))
    share = np.bincount(np.rint(rung).astype(np.int64), spline.area * spline.supported, minlength=len(noises))
    return LocalChoice(rung, float((share * np.array(noises)).sum() / max(float(share.sum()), 1e-12)))


def _lowest(scores: Array) -> Array:
    """Place of the lowest score (k, v) of each column, between the rungs by a parabola, (v,)."""
    best = np.argmin(scores, axis=0)
    inner = np.clip(best, 1, len(scores) - 2) if len(scores) > 2 else best
    if len(scores) <= 2:
        return np.asarray(best, np.float64)
    column = np.arange(scores.shape[1])
    below, at, above = scores[inner - 1, column], scores[inner, column], scores[inner + 1, column]
    bend = below - 2 * at + above
    shift = np.where(bend > 0, 0.5 * (below - above) / np.where(bend > 0, bend, 1.0), 0.0)
    return np.asarray(np.where(best == inner, inner + np.clip(shift, -0.5, 0.5), best), np.float64)
