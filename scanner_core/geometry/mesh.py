"""Triangle meshes."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class TriangleMesh:
    """A triangle mesh; counter-clockwise seen from outside.

    Attributes
    ----------
    vertices : (v, 3) float64, mm
    triangles : (t, 3) int64, indices of vertices
    vertex_attributes : name -> (v,) array, for example ``standard_uncertainty_um`` (float32) and ``supported`` (uint8)
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int64]
    vertex_attributes: dict[str, NDArray[np.generic]] = field(default_factory=dict)

    def corners(self) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """The three corners of every triangle, each (t, 3), mm."""
        a, b, c = (np.take(self.vertices, self.triangles[:, i], axis=0) for i in range(3))  # several times faster than an index
        return a, b, c

    def area_vectors(self) -> NDArray[np.float64]:
        """Outward normals with the length of the triangle's area, (t, 3), mm^2."""
        a, b, c = self.corners()
        return np.asarray(0.5 * np.cross(b - a, c - a), np.float64)

    def areas(self) -> NDArray[np.float64]:
        """(t,), mm^2."""
        vectors = self.area_vectors()
        return np.asarray(np.sqrt(np.einsum("ij,ij->i", vectors, vectors)), np.float64)

    def area(self) -> float:
        """Area of the surface, mm^2."""
        return float(self.areas().sum())

    def volume(self) -> float:
        """Enclosed volume, mm^3; positive when the triangles face outwards."""
        centre = self.vertices.mean(axis=0) if len(self.vertices) else np.zeros(3)
        a, b, c = (corner - centre for corner in self.corners())
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    def vertex_normals(self) -> NDArray[np.float64]:
        """Area-weighted unit normals, (v, 3)."""
        from scipy import sparse  # not at the top: the window stands before scipy is imported

        count = len(self.triangles)
        corners = (np.ones(3 * count), self.triangles.ravel(), np.arange(0, 3 * count + 1, 3))
        around = sparse.csr_array(corners, shape=(count, len(self.vertices))).T
        total = np.asarray(around @ self.area_vectors(), np.float64)
        length = np.sqrt(np.einsum("ij,ij->i", total, total))
        return np.asarray(total / np.maximum(length, 1e-30)[:, None], np.float64)

    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Lowest and highest corner of the bounding box, each (3,), mm."""
        return self.vertices.min(axis=0), self.vertices.max(axis=0)
