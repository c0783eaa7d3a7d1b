"""Which point of a surface a line of sight meets first, what a brush covers, what of a lasso's content is visible."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPolygonF
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

from app.views.viewpoint import Viewpoint
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
Vertices = NDArray[np.int64]
_LIFT_MM = 0.05
"""A vertex is visible when nothing lies between the eye and a point so far above it."""


@dataclass(frozen=True, slots=True, eq=False)
class Hit:
    """Where a line of sight meets the surface: the point (3,), its triangle's corners (3,) and their weights there (3,)."""

    point: Array
    corners: Vertices
    weights: Array

    @property
    def vertex(self) -> int:
        """The corner that is nearest to the point."""
        return int(self.corners[self.weights.argmax()])


class SurfacePicker:
    """Rays into one surface."""

    def __init__(self, mesh: TriangleMesh, poly: Any, normals: NDArray[np.float32]) -> None:
        """`poly` is the surface as VTK has it, `normals` (v, 3) are those of its vertices."""
        self._mesh = mesh
        self._normals = normals
        self._locator: Any = vtkStaticCellLocator()  # vtkOBBTree takes a thousand times as long for a ray
        self._locator.SetDataSet(poly)
        self._locator.BuildLocator()

    def hit(self, start: Array, end: Array) -> Hit | None:
        """The first triangle between two points (3,) mm."""
        t, sub, cell = mutable(0.0), mutable(0), mutable(-1)
        point, place = [0.0] * 3, [0.0] * 3
        if not self._locator.IntersectWithLine(start.tolist(), end.tolist(), 1e-6, t, point, place, sub, cell):
            return None
        weights = np.array([1 - place[0] - place[1], place[0], place[1]])
        return Hit(np.array(point), self._mesh.triangles[int(cell)], weights)

    def brush(self, hit: Hit, radius_mm: float) -> Vertices:
        """Vertices within the radius of a point and on the same side of the tooth."""
        away = self._mesh.vertices - hit.point
        near = np.nonzero(np.einsum("ij,ij->i", away, away) <= radius_mm**2)[0]
        facing = self._normals[near] @ self._normals[hit.vertex] > -0.2
        return np.asarray(near[facing], np.int64)

    def lasso(self, outline: Array, view: Viewpoint) -> Vertices:
        """Visible vertices within an outline (n, 2), pixels."""
        places = view.project(self._mesh.vertices)
        low, high = outline.min(axis=0), outline.max(axis=0)
        inside = ((places >= low) & (places <= high)).all(axis=1)
        inside &= self._normals @ view.direction < 0.0
        polygon = QPolygonF([QPointF(x, y) for x, y in outline])
        candidates = [i for i in np.nonzero(inside)[0].tolist() if polygon.containsPoint(QPointF(*places[i]), Qt.FillRule.OddEvenFill)]
        return np.array([i for i in candidates if self._visible(i, places[i], view)], np.int64)

    def visible(self, point: Array, view: Viewpoint) -> bool:
        """Whether nothing of the surface lies before a point (3,) just above it."""
        (x, y), *_ = view.project(point[None])
        near, _ = view.ray(x, y)
        return self.hit(near, point) is None

    def _visible(self, vertex: int, place: Array, view: Viewpoint) -> bool:
        near, _ = view.ray(place[0], place[1])
        return self.hit(near, self._mesh.vertices[vertex] + _LIFT_MM * self._normals[vertex]) is None
