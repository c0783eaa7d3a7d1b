"""What the ends of a colour map stand for: most of the values, read off a sample of them."""

from __future__ import annotations

import time

import numpy as np

from app.views.cloud_points import CloudPoints
from app.views.point_colour import PointColour

_SAMPLE = 4096
_AGAIN_S = 0.5
RESIDUAL_SIGMAS = 3.0
"""The gate of the residuals."""
_SHARE = (2.0, 98.0)


class ValueRange:
    """Follows a growing cloud, at most twice a second."""

    def __init__(self) -> None:
        self._known: dict[PointColour, tuple[float, tuple[float, float]]] = {}

    def forget(self) -> None:
        """There are other values."""
        self._known.clear()

    def of(self, by: PointColour, points: CloudPoints) -> tuple[float, float]:
        """The lowest and the highest value that are told apart; (0, 0) when none is known."""
        if by is PointColour.RESIDUAL:
            return 0.0, RESIDUAL_SIGMAS
        asked_s, ends = self._known.get(by, (-1.0, (0.0, 0.0)))
        if time.monotonic() - asked_s > _AGAIN_S:
            ends = _ends(by, points)
            self._known[by] = time.monotonic(), ends
        return ends


def _ends(by: PointColour, points: CloudPoints) -> tuple[float, float]:
    values = points.of(by)
    sample = values[:: max(1, len(values) // _SAMPLE)]
    sample = sample[np.isfinite(sample)]
    if not len(sample):
        return 0.0, 0.0
    low, high = np.percentile(sample, (0, 100) if by is PointColour.AGE else _SHARE)
    return float(low), float(max(high, low + 1e-3))
