"""Points as a running scan shows them: where they are, and what is known of each at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class LivePoints:
    """n points in the order of their measurement, before the scan's own residuals tell more of their noise.

    Attributes
    ----------
    points : (n, 3) mm, object frame
    table_deg : (n,) angle of the table
    views : (n,) int32
    epipolar_sigmas : (n,) signed epipolar residual over its expected standard deviation; NaN where there is none
    uncertainty_um : (n,) standard uncertainty of one coordinate; NaN where nobody knows
    """

    points: Array
    table_deg: Array
    views: NDArray[np.int32]
    epipolar_sigmas: Array
    uncertainty_um: Array

    @classmethod
    def of_view(
        cls, points: Array, table_deg: float, view: int, epipolar_sigmas: Array | None = None, covariances: Array | None = None
    ) -> LivePoints:
        """Points (n, 3) mm of one place of the table, with covariances (n, 3, 3) mm^2 in any frame."""
        n = len(points)
        unknown = np.full(n, np.nan)
        sigmas = unknown if epipolar_sigmas is None else epipolar_sigmas
        return cls(
            points,
            np.full(n, float(table_deg)),
            np.full(n, view, np.int32),
            sigmas,
            unknown if covariances is None else standard_uncertainty_um(covariances),
        )

    def __len__(self) -> int:
        return len(self.points)


def standard_uncertainty_um(covariances: Array) -> Array:
    """(n,) um: the root mean square over all directions of what covariances (n, 3, 3) mm^2 say."""
    return np.asarray(1e3 * np.sqrt(np.einsum("nii->n", covariances) / 3), np.float64)
