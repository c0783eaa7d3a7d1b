"""Least squares over chosen vertices, point to plane both ways, until nothing moves."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment_uncertainty import AlignmentUncertainty, alignment_uncertainty
from scanner_core.comparison.correlated_fit import generalized_step
from scanner_core.comparison.fit_rows import MutualPairing
from scanner_core.comparison.stable_region import find_stable
from scanner_core.comparison.surface_pairing import Mask, Pairs
from scanner_core.geometry.motion_step import motion_step
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]

LEAST_VERTICES = 12
"""Fewer do not carry six unknowns."""
_ROUNDS, SETTLED_MM = 12, 1e-3
_LAST_ROUNDS, _STILL_MM = 8, 5e-5
_CORRELATED_MM = 0.7
"""Correlation length from which it is taken into account in the fit itself; interpolation alone makes 0.3."""


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """Attributes
    ----------
    transform : after to before
    pairs, back : forward and backward, at this pose
    used : (v_after,) bool, vertices that carried it
    uncertainty : None where it was not asked for, or too little was left to fit on
    """

    transform: RigidTransform
    pairs: Pairs
    back: Pairs
    used: Mask
    uncertainty: AlignmentUncertainty | None = None


def fit_at(pairing: MutualPairing, transform: RigidTransform, chosen: Mask, last: Fit | None = None) -> Fit:
    """Nothing is fitted: the counterparts at a pose."""
    pairs = pairing.forward.at(transform, None if last is None else last.pairs)
    back = pairing.backward.at(transform.inverse(), None if last is None else last.back)
    return Fit(transform, pairs, back, chosen & pairs.facing)


def fit_stable(pairing: MutualPairing, start: RigidTransform, pairs: Pairs, cancelled: IsCancelled) -> Fit:
    """Finds the stable region and fits on it, in turn, until it settles; `pairs` are the forward ones at the start."""
    transform = start
    stable = find_stable(pairing.forward, pairs)
    for _ in range(_ROUNDS):
        _check(cancelled)
        if stable.sum() < LEAST_VERTICES:
            break
        step = motion_step(pairs.points[stable], pairs.normals[stable], pairs.distances[stable], np.ones(int(stable.sum())))
        moved = _moved(step, pairs.points[stable])
        transform = step @ transform
        pairs = pairing.forward.at(transform, pairs)
        stable = find_stable(pairing.forward, pairs)
        if moved < SETTLED_MM:
            break
    return Fit(transform, pairs, pairing.backward.at(transform.inverse()), stable & pairs.facing)


def fit_chosen(pairing: MutualPairing, start: Fit, chosen: Mask, cancelled: IsCancelled, still_mm: float = _STILL_MM) -> Fit:
    """All chosen vertices (v_after,) that have a counterpart, and those of the before surface opposite to them."""
    fit = Fit(start.transform, start.pairs, start.back, chosen & start.pairs.facing)
    for _ in range(_LAST_ROUNDS):
        _check(cancelled)
        if fit.used.sum() < LEAST_VERTICES:
            break
        rows = pairing.rows(fit.transform, fit.pairs, fit.back, chosen)
        step = rows.step()
        fit = fit_at(pairing, step @ fit.transform, chosen, fit)
        if _moved(step, rows.points) < still_mm:
            break
    return fit


def fit_best(pairing: MutualPairing, start: Fit, chosen: Mask, rng: np.random.Generator, cancelled: IsCancelled) -> Fit:
    """As `fit_chosen`, with its uncertainty; where the noise is alike over a length, with that taken into account."""
    fit = fit_chosen(pairing, start, chosen, cancelled)
    if fit.used.sum() < LEAST_VERTICES:
        return fit
    rows = pairing.rows(fit.transform, fit.pairs, fit.back, chosen)
    plain = alignment_uncertainty(rows, rng)
    if plain.noise.length_mm < _CORRELATED_MM:
        return replace(fit, uncertainty=plain)
    _check(cancelled)
    step, general = generalized_step(rows, plain.noise, rng)
    if general.stable_um >= plain.stable_um:
        return replace(fit, uncertainty=plain)
    return replace(fit_at(pairing, step @ fit.transform, chosen, fit), uncertainty=general)


def with_uncertainty(pairing: MutualPairing, fit: Fit, rng: np.random.Generator) -> Fit:
    """The fit with the uncertainty that its leftover distances imply."""
    return replace(fit, uncertainty=alignment_uncertainty(pairing.rows(fit.transform, fit.pairs, fit.back, fit.used), rng))


def _moved(step: RigidTransform, points: Array) -> float:
    return float(np.abs(step.apply(points) - points).max(initial=0.0))


def _check(cancelled: IsCancelled) -> None:
    if cancelled():
        raise Cancelled
