"""A cloud of unorganized points, with what is known of each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class PointCloud:
    """Measured points in the object frame.

    Attributes
    ----------
    points : (n, 3) float64, mm
    covariances : (n, 3, 3) float64, mm^2, or None when nothing is known of the noise (a cloud from a file)
    views : (n,) int32, the view (table position) in which a point was measured, or None
    trigger_ids : (n,) int64, the planned measurement that a point came from, or None
    table_deg : (n,) float64, the table angle at which a point was measured; None where it tells no direction of the
        points' frame: in a cloud from a file, or of several mounts
    places : (n,) int32, of a laser line, the number of a point's peak in its frame: several points have one trigger id; or None
    epipolar_sigmas : (n,) float64, signed epipolar residual over its standard deviation, or None
    """

    points: NDArray[np.float64]
    covariances: NDArray[np.float64] | None = None
    views: NDArray[np.int32] | None = None
    trigger_ids: NDArray[np.int64] | None = None
    table_deg: NDArray[np.float64] | None = None
    places: NDArray[np.int32] | None = None
    epipolar_sigmas: NDArray[np.float64] | None = None

    def __len__(self) -> int:
        return len(self.points)

    def select(self, which: NDArray[np.bool_] | NDArray[np.int64]) -> PointCloud:
        """The points of a mask or of indices, with all that is known of them."""
        return PointCloud(
            self.points[which],
            None if self.covariances is None else self.covariances[which],
            None if self.views is None else self.views[which],
            None if self.trigger_ids is None else self.trigger_ids[which],
            None if self.table_deg is None else self.table_deg[which],
            None if self.places is None else self.places[which],
            None if self.epipolar_sigmas is None else self.epipolar_sigmas[which],
        )
