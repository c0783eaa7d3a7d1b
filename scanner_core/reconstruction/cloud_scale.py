"""The scales of a cloud before there is a surface: spacing, thickness, isolated points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

Array = NDArray[np.float64]

_NEIGHBOURS = 8
_SAMPLE = 2000


@dataclass(frozen=True, slots=True, eq=False)
class CloudScale:
    """What the points themselves say of their density and noise.

    Attributes
    ----------
    spacing_mm : side of the square that one point stands for, median over the cloud
    noise_mm : thickness of the cloud, one sigma, from planes through neighbourhoods five sigma wide
    reach_mm : (n,) distance of each point to its eighth neighbour
    neighbours : (n, 8) int64, the nearest other points
    isolated : (n,) bool, points so far from others that they cannot be part of a sampled surface
    """

    spacing_mm: float
    noise_mm: float
    reach_mm: Array
    neighbours: NDArray[np.int64]
    isolated: NDArray[np.bool_]

    @property
    def spacings_mm(self) -> Array:
        """Side of the square that each point stands for, (n,)."""
        return np.asarray(self.reach_mm * np.sqrt(np.pi / _NEIGHBOURS))


def measure_scale(points: Array, tree: cKDTree, seed: int) -> CloudScale:
    """Scales of (n, 3) points, mm.

    The thickness is taken at the smallest neighbourhood that is at least five times as wide as it is thick: smaller
    ones follow the noise and read far too low, larger ones read the shape.
    """
    count = min(_NEIGHBOURS, len(points) - 1)
    away, nearest = tree.query(points, k=count + 1)
    reach = away[:, -1]
    typical = float(np.median(reach))
    rng = np.random.default_rng(seed)
    sample = points if len(points) <= _SAMPLE else points[np.sort(rng.choice(len(points), _SAMPLE, replace=False))]
    noise = 0.0
    neighbours = 12
    while True:
        neighbours = min(neighbours, len(points))
        away, which = tree.query(sample, k=neighbours)
        patch = points[which]
        patch = patch - patch.mean(axis=1, keepdims=True)
        spread = np.linalg.eigvalsh(np.einsum("nki,nkj->nij", patch, patch) / max(neighbours - 3, 1))
        noise = float(np.sqrt(np.median(np.maximum(spread[:, 0], 0))))
        radius = float(np.median(away[:, -1]))
        if radius >= 5 * noise or neighbours >= min(len(points), 600):
            break
        neighbours *= 2
    density = neighbours / (np.pi * max(radius, 1e-12) ** 2)
    return CloudScale(float(1 / np.sqrt(density)), noise, reach, nearest[:, 1:].astype(np.int64), reach > 5 * typical)
