"""Least squares over chosen vertices, point to plane both ways, until nothing moves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment_uncertainty import AlignmentUncertainty, alignment_uncertainty
from scanner_core.comparison.coarse_fit import motion_step
from scanner_core.comparison.fit_rows import MutualPairing
from scanner_core.comparison.stable_region import find_stable
from scanner_core.comparison.surface_pairing import Mask, Pairs
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]

LEAST_VERTICES = 12
"""Fewer do not carry six unknowns."""
_ROUNDS, _SETTLED_MM = 12, 1e-3
_LAST_ROUNDS, _STILL_MM = 8, 5e-5
_CORRELATED_MM = 0.7
"""Correlation length from which whitening the equations is tried; interpolation alone makes 0.3."""


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """Attributes
    ----------
    transform : after to before
    pairs : at this pose
    used : (v_after,) bool, vertices that carried it
    uncertainty : None where it was not asked for, or too little was left to fit on
    """

    transform: RigidTransform
    pairs: Pairs
    used: Mask
    uncertainty: AlignmentUncertainty | None = None


def fit_stable(pairing: MutualPairing, start: RigidTransform, cancelled: IsCancelled) -> Fit:
    """Finds the stable region and fits on it, in turn, until it settles."""
    transform = start
    pairs = pairing.forward.at(transform)
    stable = find_stable(pairing.forward, pairs)
    for _ in range(_ROUNDS):
        _check(cancelled)
        if stable.sum() < LEAST_VERTICES:
            break
        step = motion_step(pairs.points[stable], pairs.normals[stable], pairs.distances[stable], np.ones(int(stable.sum())))
        moved = _moved(step, pairs.points[stable])
        transform = step @ transform
        pairs = pairing.forward.at(transform)
        stable = find_stable(pairing.forward, pairs)
        if moved < _SETTLED_MM:
            break
    return Fit(transform, pairs, stable)


def fit_chosen(pairing: MutualPairing, start: RigidTransform, chosen: Mask, cancelled: IsCancelled, *, whitened: bool = False) -> Fit:
    """All chosen vertices (v_after,) that have a counterpart, and those of the before surface opposite to them."""
    transform = start
    pairs = pairing.forward.at(transform)
    for _ in range(_LAST_ROUNDS):
        _check(cancelled)
        if (chosen & pairs.facing).sum() < LEAST_VERTICES:
            break
        rows = pairing.rows(transform, pairs, chosen, whitened=whitened)
        step = rows.step()
        transform = step @ transform
        pairs = pairing.forward.at(transform)
        if _moved(step, rows.points) < _STILL_MM:
            break
    return Fit(transform, pairs, chosen & pairs.facing)


def fit_best(pairing: MutualPairing, start: RigidTransform, chosen: Mask, rng: np.random.Generator, cancelled: IsCancelled) -> Fit:
    """As `fit_chosen`, with its uncertainty.

    Where the noise is alike over a length, the same fit is made on whitened equations too, and the one with the smaller
    stated uncertainty is kept (generalized least squares, Aitken 1936, by a filter).
    """
    plain = with_uncertainty(pairing, fit_chosen(pairing, start, chosen, cancelled), chosen, rng)
    if plain.uncertainty is None or plain.uncertainty.correlation_length_mm < _CORRELATED_MM:
        return plain
    _check(cancelled)
    white = with_uncertainty(pairing, fit_chosen(pairing, plain.transform, chosen, cancelled, whitened=True), chosen, rng, whitened=True)
    if white.uncertainty is None or white.uncertainty.stable_um >= plain.uncertainty.stable_um:
        return plain
    # noise and its correlation are said of the distances themselves
    return Fit(white.transform, white.pairs, white.used, white.uncertainty.of_noise(plain.uncertainty))


def with_uncertainty(pairing: MutualPairing, fit: Fit, chosen: Mask, rng: np.random.Generator, *, whitened: bool = False) -> Fit:
    """The fit with the uncertainty that its leftover distances imply."""
    if fit.used.sum() < LEAST_VERTICES:
        return fit
    rows = pairing.rows(fit.transform, fit.pairs, chosen, whitened=whitened)
    return Fit(fit.transform, fit.pairs, fit.used, alignment_uncertainty(rows, rng))


def _moved(step: RigidTransform, points: Array) -> float:
    return float(np.abs(step.apply(points) - points).max(initial=0.0))


def _check(cancelled: IsCancelled) -> None:
    if cancelled():
        raise Cancelled
