"""A fit that knows that the noise of neighbouring points is alike."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve
from scipy.spatial.distance import cdist

from scanner_core.comparison.alignment_uncertainty import AlignmentUncertainty, state
from scanner_core.comparison.fit_rows import FitRows
from scanner_core.comparison.noise_correlation import NoiseCorrelation
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_POINTS = 2500
"""As many equations are solved together; where noise is alike over a millimetre, more of them say little more."""


def generalized_step(rows: FitRows, noise: NoiseCorrelation, rng: np.random.Generator) -> tuple[RigidTransform, AlignmentUncertainty]:
    """One step of generalized least squares (Aitken 1936) from a pose that is right to the noise, and its uncertainty.

    Weighs by the inverse covariance ``C = sd^2 (share exp(-h^2 / 2 l^2) + (1 - share) I)`` of a random part of the equations.
    """
    chosen = np.sort(rng.choice(len(rows.points), min(_POINTS, len(rows.points)), replace=False))
    jacobian, points = rows.jacobian[chosen], rows.points[chosen]
    share, length_mm = noise.gaussian()
    covariance = share * np.exp(-0.5 * cdist(points, points, "sqeuclidean") / length_mm**2)
    covariance[np.diag_indices_from(covariance)] = 1.0
    variance = float(np.mean(rows.distances**2))
    weighed = cho_solve(cho_factor(covariance, lower=True, overwrite_a=True, check_finite=False), np.c_[jacobian, rows.distances[chosen]])
    information, pull = jacobian.T @ weighed[:, :7] / variance, jacobian.T @ weighed[:, 7] / variance
    six = _inverse(information[:6, :6])
    with_growth = _inverse(information)
    growth = -float(with_growth[6] @ pull)
    return rows.motion(-six @ pull[:6] / rows.response), state(rows, noise, six, growth, float(with_growth[6, 6]))


def _inverse(information: Array) -> Array:
    """A direction that nothing determines becomes very uncertain."""
    values, vectors = np.linalg.eigh(information)
    return np.asarray((vectors / np.maximum(values, 1e-9 * max(float(values[-1]), 1e-300))) @ vectors.T, np.float64)
