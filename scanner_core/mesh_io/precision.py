"""Whether coordinates survive in single precision, which many mesh formats and programs keep."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_STEP_MM = 1e-4
_STEP_SHARE = 1e-5


def single_step_mm(vertices: NDArray[np.float64]) -> float:
    """Distance between neighbouring float32 numbers at the largest coordinate of (v, 3) vertices, in their unit."""
    if len(vertices) == 0:
        return 0.0
    return float(np.spacing(np.float32(np.abs(vertices).max())))


def single_is_enough(vertices: NDArray[np.float64]) -> bool:
    """Whether float32 moves no vertex visibly: by steps below 0.1 um, and below the hundred-thousandth of the extent.

    Within a metre of the origin that is true of everything that can be held in a hand.
    """
    step = single_step_mm(vertices)
    return step == 0.0 or step <= min(_STEP_MM, _STEP_SHARE * float(np.ptp(vertices, axis=0).max()))


def decimals(vertices: NDArray[np.float64]) -> int:
    """Significant digits with which text keeps (v, 3) vertices: those of float32 where they are enough, else of float64."""
    return 9 if single_is_enough(vertices) else 16
