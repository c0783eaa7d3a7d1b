"""How far an alignment can be trusted, from the noise that it left over and how that noise hangs together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.fit_rows import FitRows
from scanner_core.comparison.noise_correlation import NoiseCorrelation, measure_correlation

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class AlignmentUncertainty:
    """Attributes
    ----------
    covariance : (6, 6) of rotation vector (rad, about `centre`) and translation (mm)
    centre : (3,) mm
    noise : that the fit left over
    stable_um : rms standard uncertainty of the place of the points that carry the alignment
    scale_ratio, scale_ratio_uncertainty : size of after over size of before
    """

    covariance: Array
    centre: Array
    noise: NoiseCorrelation
    stable_um: float
    scale_ratio: float
    scale_ratio_uncertainty: float


def alignment_uncertainty(rows: FitRows, rng: np.random.Generator) -> AlignmentUncertainty:
    """Of a weighted least-squares fit, from what it left over.

    The estimate is ``H^-1 sum_i w_i J_i e_i``; its covariance is ``H^-1 (sum_ij w_i w_j J_i J_j^T c(i, j)) H^-1`` with the
    measured covariance c of the noise (the "sandwich" of White 1980, over neighbours as in Conley, J. Econometrics 92, 1999).
    A seventh unknown, a change of size, is estimated beside the six and reported, never applied.
    """
    information = (rows.jacobian * rows.weights[:, None]).T @ rows.jacobian
    pulls = rows.distances * rows.weights
    noise = measure_correlation(rows.points, pulls, rng)
    scatter = noise.variance * rows.jacobian.T @ rows.jacobian
    if len(noise.covariance):
        centre, other, covariance = noise.correlated()
        pairs = noise.near.scale * (rows.jacobian[centre] * covariance[:, None]).T @ rows.jacobian[other]
        scatter = scatter + 0.5 * (pairs + pairs.T)
    growth = -np.linalg.pinv(information, rcond=1e-9, hermitian=True) @ (rows.jacobian.T @ pulls)
    six, seven = _sandwich(information[:6, :6], scatter[:6, :6]), _sandwich(information, scatter)
    return state(rows, noise, six, float(growth[6]), float(seven[6, 6]))


def state(rows: FitRows, noise: NoiseCorrelation, covariance: Array, growth: float, growth_variance: float) -> AlignmentUncertainty:
    """In natural units, from the covariance (6, 6) of the unknowns and the seventh, all in units of the rows' jacobian."""
    unit = np.array([1 / rows.radius] * 3 + [1.0] * 3)
    # the distances follow a motion less than the jacobian says, so that the same pull moves the fit by more
    covariance = covariance / rows.response**2 * np.outer(unit, unit)
    places = place_covariances(covariance, rows.centre, rows.points)
    return AlignmentUncertainty(
        covariance=covariance,
        centre=rows.centre,
        noise=noise,
        stable_um=1e3 * float(np.sqrt(np.mean(np.trace(places, axis1=1, axis2=2)))),
        # the growth that would take the distances away is what the after surface lacks
        scale_ratio=1.0 / (1.0 + growth / rows.response / rows.radius),
        scale_ratio_uncertainty=float(np.sqrt(growth_variance)) / rows.response / rows.radius,
    )


def place_covariances(covariance: Array, centre: Array, points: Array) -> Array:
    """Covariance (n, 3, 3) mm^2 of the place of points (n, 3) under a motion's covariance (6, 6)."""
    about = points - centre
    turning = np.zeros((len(points), 3, 6))
    turning[:, 0, 1], turning[:, 0, 2] = about[:, 2], -about[:, 1]
    turning[:, 1, 0], turning[:, 1, 2] = -about[:, 2], about[:, 0]
    turning[:, 2, 0], turning[:, 2, 1] = about[:, 1], -about[:, 0]
    turning[:, :, 3:] = np.eye(3)
    return np.asarray(turning @ covariance @ turning.transpose(0, 2, 1), np.float64)


def _sandwich(information: Array, scatter: Array) -> Array:
    """``information^-1 scatter information^-1``; a direction that nothing determines becomes very uncertain, not certain."""
    values, vectors = np.linalg.eigh(information)
    inverse = (vectors / np.maximum(values, 1e-9 * max(float(values[-1]), 1e-300))) @ vectors.T
    # a scatter measured on a part of the pairs need not be positive: what is negative is its sampling noise
    s, v = np.linalg.eigh(scatter)
    return np.asarray(inverse @ ((v * np.maximum(s, 0.0)) @ v.T) @ inverse, np.float64)
