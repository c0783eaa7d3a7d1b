"""A cloud as a few points with outward normals, spread evenly over what was measured: what a search for its pose works on."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_LEAST_NEIGHBOURS, _MOST_NEIGHBOURS = 12, 60
"""Of a normal: as many as a cell holds."""
_MOST_THICK = 0.5
"""Least over middle principal sigma of the neighbours: an edge or both sides of a thin wall have no normal."""
_ROUNDS = 6


@dataclass(frozen=True, eq=False)
class OrientedSample:
    """Points of a measured surface, about one a cell of a cubic grid.

    Attributes
    ----------
    points : (n, 3) mm, the mean of the measured points in the cell
    normals : (n, 3) unit, outward
    towards : (n, 3) unit, where the light came from
    spacing_mm : side of the cells
    """

    points: Array
    normals: Array
    towards: Array
    spacing_mm: float

    @cached_property
    def tree(self) -> cKDTree:
        return cKDTree(self.points)

    @cached_property
    def diameter_mm(self) -> float:
        """Of the bounding box."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    def __len__(self) -> int:
        return len(self.points)

    def moved(self, transform: RigidTransform) -> OrientedSample:
        return OrientedSample(transform.apply(self.points), transform.rotate(self.normals), transform.rotate(self.towards), self.spacing_mm)

    def thinned(self, count: int, rng: np.random.Generator) -> OrientedSample:
        """At most `count` of the points, drawn at random."""
        if len(self) <= count:
            return self
        chosen = np.sort(rng.choice(len(self), count, replace=False))
        return OrientedSample(self.points[chosen], self.normals[chosen], self.towards[chosen], self.spacing_mm)


def spacing_for(points: Array, cells: int) -> float:
    """The side of the cells, mm, with which points (n, 3) mm on a surface fill about `cells` of them."""
    spacing = float(np.linalg.norm(np.ptp(points, axis=0)) / np.sqrt(cells))
    for _ in range(_ROUNDS):
        filled = int(_cells(points, spacing).max(initial=0)) + 1
        spacing *= float(np.sqrt(filled / cells))
    return max(spacing, 1e-6)


def sample_cloud(points: Array, towards: Array, spacing_mm: float) -> OrientedSample:
    """One point for every cell of side `spacing_mm` with measured points; their noise averages out.

    Parameters
    ----------
    points : (n, 3) mm
    towards : (n, 3) unit, from each point to where its light came from or it was seen from
    """
    cell = _cells(points, spacing_mm)
    count = np.bincount(cell).astype(np.float64)
    middle = np.stack([np.bincount(cell, points[:, k]) for k in range(3)], axis=1) / count[:, None]
    # the light of one of the points: between two directions from which light came there may be a wall
    light = np.empty_like(middle)
    light[cell] = towards
    kept = count >= min(3.0, float(np.median(count)))
    middle, light = middle[kept], light[kept]
    neighbours = min(int(np.clip(np.median(count), _LEAST_NEIGHBOURS, _MOST_NEIGHBOURS)), len(points))
    about = points[cKDTree(points).query(middle, neighbours)[1]]
    about -= about.mean(axis=1, keepdims=True)
    principal, axes = np.linalg.eigh(about.transpose(0, 2, 1) @ about)
    normals = axes[:, :, 0] * np.where(np.einsum("ij,ij->i", axes[:, :, 0], light) < 0, -1.0, 1.0)[:, None]
    flat = principal[:, 0] < _MOST_THICK**2 * principal[:, 1]
    return OrientedSample(middle[flat], normals[flat], light[flat], spacing_mm)


def _cells(points: Array, spacing: float) -> NDArray[np.int64]:
    """The number of each point's cell, from 0 without gaps."""
    place = np.floor((points - points.min(axis=0)) / spacing).astype(np.int64)
    size = place.max(axis=0) + 1
    return np.unique((place[:, 0] * size[1] + place[:, 1]) * size[2] + place[:, 2], return_inverse=True)[1].ravel()
