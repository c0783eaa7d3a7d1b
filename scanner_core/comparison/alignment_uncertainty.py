"""How far an alignment can be trusted, from the noise that it left over and how that noise hangs together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.noise_correlation import measure_correlation

Array = NDArray[np.float64]

_MOST_POINTS = 40_000


@dataclass(frozen=True, slots=True, eq=False)
class AlignmentUncertainty:
    """Attributes
    ----------
    covariance : (6, 6) of rotation vector (rad, about `centre`) and translation (mm)
    centre : (3,) mm
    noise_um : of one distance
    correlation_length_mm : of it, along the surface
    stable_um : rms standard uncertainty of the place of the points that carry the alignment
    scale_ratio, scale_ratio_uncertainty : size of after over size of before
    """

    covariance: Array
    centre: Array
    noise_um: float
    correlation_length_mm: float
    stable_um: float
    scale_ratio: float
    scale_ratio_uncertainty: float


def place_covariances(covariance: Array, centre: Array, points: Array) -> Array:
    """Covariance (n, 3, 3) mm^2 of the place of points (n, 3) under a motion's covariance (6, 6)."""
    about = points - centre
    turning = np.zeros((len(points), 3, 6))
    turning[:, 0, 1], turning[:, 0, 2] = about[:, 2], -about[:, 1]
    turning[:, 1, 0], turning[:, 1, 2] = -about[:, 2], about[:, 0]
    turning[:, 2, 0], turning[:, 2, 1] = about[:, 1], -about[:, 0]
    turning[:, :, 3:] = np.eye(3)
    return np.asarray(turning @ covariance @ turning.transpose(0, 2, 1), np.float64)


def alignment_uncertainty(points: Array, normals: Array, distances: Array, areas: Array, rng: np.random.Generator) -> AlignmentUncertainty:
    """Of a weighted least-squares fit whose leftover distances are `distances` (n,) mm.

    The estimate is ``H^-1 sum_i w_i J_i e_i``; its covariance is ``H^-1 (sum_ij w_i w_j J_i J_j^T c(i, j)) H^-1`` with the
    measured covariance c of the noise (the "sandwich" of White 1980, with neighbours as in Conley, J. Econometrics 92, 1999).
    A seventh unknown, a change of size, is estimated beside the six and reported, never applied.
    """
    if len(points) > _MOST_POINTS:  # fewer points of the same surface, each for more of it; the noise of one stays what it is
        scale = len(points) / _MOST_POINTS
        chosen = np.sort(rng.choice(len(points), _MOST_POINTS, replace=False))
        points, normals, distances, areas = points[chosen], normals[chosen], distances[chosen], areas[chosen]
    else:
        scale = 1.0
    centre = np.average(points, axis=0, weights=areas)
    about = points - centre
    radius = max(float(np.sqrt(np.mean(about**2))), 1e-9)
    size = np.einsum("ni,ni->n", about, normals)  # the distance grows by this for every unit of relative size
    jacobian = np.concatenate([np.cross(about, normals) / radius, normals, size[:, None] / radius], axis=1)
    weighted = jacobian * areas[:, None]
    noise, near = measure_correlation(points, distances, rng)
    variance = noise.sd_mm**2
    scatter = variance * weighted.T @ weighted / scale
    if len(noise.covariance):
        reach = float(noise.edges_mm[-1])
        close = near.apart_mm < reach
        bin_of = np.minimum((near.apart_mm[close] / reach * len(noise.covariance)).astype(np.int64), len(noise.covariance) - 1)
        left, right = weighted[near.centre[close]], weighted[near.other[close]]
        pairs = near.scale * (left * noise.covariance[bin_of][:, None]).T @ right
        scatter = scatter + 0.5 * (pairs + pairs.T)
    unit = np.array([1 / radius] * 3 + [1.0] * 3)
    six = _sandwich(weighted[:, :6].T @ jacobian[:, :6], scatter[:6, :6])
    covariance = six * np.outer(unit, unit)
    information = weighted.T @ jacobian
    seven = _sandwich(information, scatter)
    change = np.linalg.pinv(information, rcond=1e-9) @ (weighted.T @ distances)
    places = place_covariances(covariance, centre, points)
    stable = float(np.sqrt(np.average(np.trace(places, axis1=1, axis2=2), weights=areas)))
    ratio_sd = float(np.sqrt(max(seven[6, 6], 0.0))) / radius
    return AlignmentUncertainty(covariance, centre, 1e3 * noise.sd_mm, noise.length_mm, 1e3 * stable, 1.0 + float(change[6]) / radius, ratio_sd)


def _sandwich(information: Array, scatter: Array) -> Array:
    """Directions that nothing determines get the variance of the worst that is determined, times a hundred million."""
    values, vectors = np.linalg.eigh(information)
    values = np.maximum(values, 1e-9 * max(float(values[-1]), 1e-300))
    inverse = (vectors / values) @ vectors.T
    # a scatter estimated from pairs need not be positive; what is negative is sampling noise
    s, v = np.linalg.eigh(scatter)
    return np.asarray(inverse @ ((v * np.maximum(s, 0)) @ v.T) @ inverse, np.float64)
