"""Means over draws, and how far they may be off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import t


@dataclass(frozen=True, slots=True)
class Mean:
    """The mean of `draws` values, its standard error, and its one-sided upper 95 % limit (t distribution)."""

    value: float
    standard_error: float
    upper_95: float
    draws: int


def mean(values: Sequence[float]) -> Mean:
    """Of independent values; with fewer than two of them the error is not known."""
    x = np.asarray(values, np.float64)
    if len(x) < 2:
        return Mean(float(x[0]) if len(x) else float("nan"), float("nan"), float("nan"), len(x))
    error = float(x.std(ddof=1) / np.sqrt(len(x)))
    return Mean(float(x.mean()), error, float(x.mean() + t.ppf(0.95, len(x) - 1) * error), len(x))


def ratio(ours: Sequence[float], theirs: Sequence[float]) -> Mean:
    """The mean of the ratios of pairs that belong together, which is free of what the two have in common."""
    return mean([a / b for a, b in zip(ours, theirs, strict=True)])
