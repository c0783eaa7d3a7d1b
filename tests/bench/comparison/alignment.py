"""How right an alignment is, and how right what it says of itself."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.aligning import align
from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.errors import ComparisonError
from tests.bench.comparison.scan_pair import ScanPair

Array = NDArray[np.float64]

FOUND_UM = 100.0
"""An alignment this near to the truth has found the pose; what is left is the fine stage's affair."""


@dataclass(frozen=True, slots=True, eq=False)
class AlignmentFigures:
    """Of one pair.

    Attributes
    ----------
    rms_um, max_um : error on what did not move
    stated_um : the alignment's own uncertainty of that
    z : (6,) the true error in the standard deviations of the stated covariance, its axes made independent
    moved_share : share of the stable region that has moved in truth
    refused : the sentence when it was refused; then the rest is NaN
    """

    rms_um: float
    max_um: float
    stated_um: float
    z: Array
    stable_area_fraction: float
    moved_share: float
    seconds: float
    method: str
    reliable: bool
    refused: str = ""

    @property
    def found(self) -> bool:
        return self.rms_um < FOUND_UM


def aligned(pair: ScanPair, parameters: ComparisonParameters | None = None) -> tuple[Alignment | None, AlignmentFigures]:
    """Align a pair and look at the result."""
    begun_s = time.perf_counter()
    try:
        alignment = align(pair.before, pair.after, parameters or ComparisonParameters(), progress=lambda _: None, cancelled=lambda: False)
    except ComparisonError as fault:
        nan = float("nan")
        return None, AlignmentFigures(nan, nan, nan, np.full(6, nan), nan, nan, time.perf_counter() - begun_s, "", False, str(fault))
    seconds = time.perf_counter() - begun_s
    errors = pair.errors_um(alignment.transform)
    return alignment, AlignmentFigures(
        float(np.sqrt((errors**2).mean())),
        float(errors.max()),
        alignment.uncertainty_um,
        standardised(pair, alignment),
        alignment.stable_area_fraction,
        float(1 - pair.stable[alignment.stable].mean()) if alignment.stable.any() else float("nan"),
        seconds,
        alignment.method,
        alignment.reliable,
    )


def standardised(pair: ScanPair, alignment: Alignment) -> Array:
    """The true error of the pose (6,), whitened by the stated covariance: of unit variance when that is right."""
    off = alignment.transform @ pair.transform.inverse()  # true place -> found place, frame of BEFORE
    turn = 0.5 * np.array([off.rotation[2, 1] - off.rotation[1, 2], off.rotation[0, 2] - off.rotation[2, 0], off.rotation[1, 0] - off.rotation[0, 1]])
    error = np.r_[turn, off.apply(alignment.centre) - alignment.centre]
    scale = np.sqrt(np.diag(alignment.covariance))
    factor = np.linalg.cholesky(alignment.covariance / np.outer(scale, scale))
    return np.asarray(np.linalg.solve(factor, error / scale), np.float64)
