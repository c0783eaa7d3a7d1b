"""A specimen's mesh under many rays at once: what a fan of light needs.

What cannot meet the mesh's bounding box is sorted out in arrays; the rest is cast one by one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.ray_caster import RayCaster

Array = NDArray[np.float64]


class LitMesh:
    """A mesh whose facets stop light from both sides.  One thread at a time."""

    def __init__(self, mesh: TriangleMesh) -> None:
        area = mesh.area_vectors()
        self._normals = area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None]
        self._low, self._high = mesh.bounds()
        self._caster = RayCaster(mesh)

    def first_hits(self, starts: Array, ends: Array) -> tuple[NDArray[np.int64], Array, Array]:
        """First meetings of segments (n, 3) to (n, 3) mm with the surface: numbers of those that meet it (m,), the points (m, 3) mm and
        their facets' outward normals (m, 3)."""
        near = self._near(starts, ends)
        points, facets = self._caster.first_hits(starts[near], ends[near])
        met = facets >= 0
        return near[met], points[met], self._normals[facets[met]]

    def blocked(self, starts: Array, ends: Array) -> NDArray[np.bool_]:
        """(n,) whether the surface meets the segments (n, 3) to (n, 3) mm."""
        met = np.zeros(len(starts), np.bool_)
        near = self._near(starts, ends)
        met[near] = self._caster.blocked(starts[near], ends[near])
        return met

    def _near(self, starts: Array, ends: Array) -> NDArray[np.int64]:
        """Numbers of the segments that meet the bounding box (Kay & Kajiya 1986)."""
        along = ends - starts
        along = np.where(np.abs(along) < 1e-12, 1e-12, along)
        a, b = (self._low - starts) / along, (self._high - starts) / along
        enter, leave = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
        return np.flatnonzero((enter <= np.minimum(leave, 1.0)) & (leave >= 0.0))
