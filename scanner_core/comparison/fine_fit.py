"""Least squares over chosen vertices, point to plane, until nothing moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.coarse_fit import motion_step
from scanner_core.comparison.stable_region import find_stable
from scanner_core.comparison.surface_pairing import Mask, Pairs, SurfacePairing
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled, IsCancelled

Array = NDArray[np.float64]

LEAST_VERTICES = 12
"""Fewer do not carry six unknowns."""
_ROUNDS = 20
_STILL_MM = 2e-5


def step_on(pairing: SurfacePairing, pairs: Pairs, chosen: Mask) -> RigidTransform:
    """The motion that takes the distances of the chosen vertices away, each weighed by its area."""
    return motion_step(pairs.points[chosen], pairs.normals[chosen], pairs.distances[chosen], pairing.areas[chosen])


def fit_stable(pairing: SurfacePairing, start: RigidTransform, cancelled: IsCancelled) -> tuple[RigidTransform, Pairs, Mask]:
    """The frame AUTO: finds the stable region and fits on it alone, in turn; transform, pairs and region."""
    transform = start
    pairs = pairing.at(transform)
    stable = find_stable(pairing, pairs)
    for _ in range(_ROUNDS):
        if cancelled():
            raise Cancelled
        if stable.sum() < LEAST_VERTICES:
            return transform, pairs, stable
        step = step_on(pairing, pairs, stable)
        transform = step @ transform
        pairs = pairing.at(transform)
        if _moved(step, pairs, stable) < _STILL_MM * 10:
            break
        stable = find_stable(pairing, pairs)
    return transform, pairs, stable & pairs.facing


def fit_chosen(pairing: SurfacePairing, start: RigidTransform, chosen: Mask, cancelled: IsCancelled) -> tuple[RigidTransform, Pairs, Mask]:
    """The frames WHOLE and MASK: all chosen vertices that have a counterpart; transform, pairs and those vertices."""
    transform = start
    pairs = pairing.at(transform)
    for _ in range(_ROUNDS):
        if cancelled():
            raise Cancelled
        used = chosen & pairs.facing
        if used.sum() < LEAST_VERTICES:
            return transform, pairs, used
        step = step_on(pairing, pairs, used)
        transform = step @ transform
        pairs = pairing.at(transform)
        if _moved(step, pairs, used) < _STILL_MM:
            break
    return transform, pairs, chosen & pairs.facing


def _moved(step: RigidTransform, pairs: Pairs, chosen: Mask) -> float:
    points = pairs.points[chosen]
    return float(np.abs(step.apply(points) - points).max(initial=0.0))
