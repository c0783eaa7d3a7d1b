"""Many rays at once against a specimen's mesh: what a fan of light needs.

What cannot meet the mesh's bounding box is sorted out in arrays; the rest goes to a cell locator one by one.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.poly_data import poly_data

Array = NDArray[np.float64]


class RayCaster:
    """A mesh whose facets stop light from both sides.  One thread at a time."""

    def __init__(self, mesh: TriangleMesh) -> None:
        area = mesh.area_vectors()
        self._normals = area / np.maximum(np.linalg.norm(area, axis=1), 1e-30)[:, None]
        self._low, self._high = mesh.bounds()
        self._locator = vtkStaticCellLocator()
        self._locator.SetDataSet(poly_data(mesh))
        self._locator.SetNumberOfCellsPerNode(1)
        self._locator.BuildLocator()
        self._cell = vtkGenericCell()
        self._t: Any = reference(0.0)
        self._sub: Any = reference(0)
        self._id: Any = reference(0)
        self._point, self._parametric = [0.0] * 3, [0.0] * 3

    def first_hits(self, starts: Array, ends: Array) -> tuple[NDArray[np.int64], Array, Array]:
        """First meetings of segments (n, 3) to (n, 3) with the surface: numbers of those that meet it (m,), the points (m, 3) and
        their facets' outward normals (m, 3)."""
        rows, points, facets = [], [], []
        candidates = self._near(starts, ends)
        for row, start, end in zip(candidates.tolist(), starts[candidates].tolist(), ends[candidates].tolist(), strict=True):
            if self._meets(start, end):
                rows.append(row)
                points.append(self._point.copy())
                facets.append(int(self._id))
        return np.array(rows, np.int64), np.array(points).reshape(-1, 3), self._normals[facets].reshape(-1, 3)

    def blocked(self, starts: Array, ends: Array) -> NDArray[np.bool_]:
        """(n,) whether the surface meets the segments (n, 3) to (n, 3)."""
        met = np.zeros(len(starts), np.bool_)
        candidates = self._near(starts, ends)
        pairs = zip(candidates.tolist(), starts[candidates].tolist(), ends[candidates].tolist(), strict=True)
        met[[row for row, start, end in pairs if self._meets(start, end)]] = True
        return met

    def _meets(self, start: list[float], end: list[float]) -> bool:
        return bool(self._locator.IntersectWithLine(start, end, 0.0, self._t, self._point, self._parametric, self._sub, self._id, self._cell))

    def _near(self, starts: Array, ends: Array) -> NDArray[np.int64]:
        """Numbers of the segments that meet the bounding box (Kay & Kajiya 1986)."""
        along = ends - starts
        along = np.where(np.abs(along) < 1e-12, 1e-12, along)
        a, b = (self._low - starts) / along, (self._high - starts) / along
        enter, leave = np.minimum(a, b).max(axis=1), np.maximum(a, b).min(axis=1)
        return np.flatnonzero((enter <= np.minimum(leave, 1.0)) & (leave >= 0.0))
