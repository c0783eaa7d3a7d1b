"""A surface as a few points with normals, spread evenly over its area: what a search for its pose works on."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_LEAST_CONSISTENCY = 0.5
"""A cell whose triangles face every way (both sides of a thin wall, a fold) has no normal."""


@dataclass(frozen=True, eq=False)
class SurfaceSample:
    """Points of a surface, one a cell of a cubic grid.

    Attributes
    ----------
    points : (n, 3) mm, the centroid of the surface within the cell
    normals : (n, 3) unit, outward
    areas : (n,) mm^2 of surface that each stands for
    spacing_mm : side of the cells
    """

    points: Array
    normals: Array
    areas: Array
    spacing_mm: float

    @cached_property
    def tree(self) -> cKDTree:
        return cKDTree(self.points)

    def __len__(self) -> int:
        return len(self.points)

    def moved(self, transform: RigidTransform) -> SurfaceSample:
        return SurfaceSample(transform.apply(self.points), transform.rotate(self.normals), self.areas, self.spacing_mm)

    def mirrored(self) -> SurfaceSample:
        """The mirror image, in the plane x = 0."""
        flip = np.array([-1.0, 1.0, 1.0])
        return SurfaceSample(self.points * flip, self.normals * flip, self.areas, self.spacing_mm)

    def thinned(self, count: int, rng: np.random.Generator) -> SurfaceSample:
        """At most `count` of the points, drawn at random."""
        if len(self) <= count:
            return self
        chosen = np.sort(rng.choice(len(self), count, replace=False))
        scale = len(self) / count
        return SurfaceSample(self.points[chosen], self.normals[chosen], self.areas[chosen] * scale, self.spacing_mm)


def supported_triangles(surface: ComparedSurface) -> NDArray[np.int64]:
    """The triangles of which every corner was measured, (t, 3)."""
    triangles = surface.mesh.triangles
    return triangles[surface.supported[triangles].all(axis=1)]


def sample_surface(surface: ComparedSurface, spacing_mm: float) -> SurfaceSample:
    """One point for every cell of side `spacing_mm` that the surface crosses; noise of single vertices averages out."""
    a, b, c = (surface.mesh.vertices[column] for column in supported_triangles(surface).T)
    vectors = 0.5 * np.cross(b - a, c - a)
    areas = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    centroids = (a + b + c) / 3
    cell = np.floor((centroids - centroids.min(axis=0)) / spacing_mm).astype(np.int64)
    size = cell.max(axis=0) + 1
    number = np.unique((cell[:, 0] * size[1] + cell[:, 1]) * size[2] + cell[:, 2], return_inverse=True)[1].ravel()
    area = np.bincount(number, areas)
    points = np.stack([np.bincount(number, areas * centroids[:, k]) for k in range(3)], axis=1)
    normals = np.stack([np.bincount(number, vectors[:, k]) for k in range(3)], axis=1)
    length = np.sqrt(np.einsum("ij,ij->i", normals, normals))
    kept = (length > _LEAST_CONSISTENCY * area) & (area > 0.05 * spacing_mm**2)
    return SurfaceSample(points[kept] / area[kept, None], normals[kept] / length[kept, None], area[kept], spacing_mm)
