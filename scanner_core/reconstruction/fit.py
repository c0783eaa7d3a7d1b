"""What refinement carries from level to level."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.observations import Observations
from scanner_core.reconstruction.support import MEASURED

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Level:
    """The points as one level sees them."""

    observations: Observations
    scale: CloudScale


@dataclass(slots=True, eq=False)
class Fit:
    """The state that refinement carries from level to level.

    Attributes
    ----------
    mesh : the surface so far
    robust : (n,) weights of the observations, 0 for rejected ones
    noise_mm : sigma along the normal of a typical measurement, from the residuals
    bandwidth_mm : (v,) of the spline
    settled : (v,) bool, whether a wider bandwidth than the narrowest that the mesh can carry has won there
    share : (v,) density of the points over the one that they have among themselves
    residuals_mm : (n,) of the last solve, over the root of the observations' relative variance
    moved_mm : (v,) size of the last step
    homes : (n,) the vertex nearest to the foot of each observation; empty under a soft association
    density : weight of the observations over area, which the bandwidths refer to
    level : the points that `robust` and `residuals_mm` belong to
    least_support : `share` from which on points bear the surface out
    unreached : share of the observations that lie off the surface together with their neighbours, at the end
    stopped_early : the caller wanted no better surface
    """

    mesh: TriangleMesh
    robust: Array
    noise_mm: float
    bandwidth_mm: Array
    settled: Mask
    share: Array
    residuals_mm: Array
    moved_mm: Array
    homes: NDArray[np.int64]
    density: float
    level: Level
    least_support: float = MEASURED
    unreached: float = 0.0
    stopped_early: bool = False

    @property
    def supported(self) -> Mask:
        """(v,) where points bear the surface out."""
        return self.share > self.least_support
