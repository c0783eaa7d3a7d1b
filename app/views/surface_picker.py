"""Which point of a surface a line of sight meets first, what a brush covers, what is visible, and of it what a lasso holds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QImage, QPainter, QPolygonF
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

    def lasso(self, outline: Array, view: Viewpoint, depth: NDArray[np.float32], ratio: float) -> Vertices:
        """Visible vertices within an outline (n, 2), pixels.

        `depth` is the picture of this surface alone, 0 near to 1 far, `ratio` its pixels to a pixel of the widget.  A ray to
        each of a hundred thousand vertices would take seconds.
        """
        vertices = self._mesh.vertices
        places = view.project(vertices)
        facing = -(self._normals @ view.direction)
        cells = np.floor(places * ratio).astype(np.int64)
        there = ((cells >= 0) & (cells < depth.shape[::-1])).all(axis=1) & (facing > 0.0)
        held = np.nonzero(there)[0]
        columns, rows = cells[held].T
        held = held[_filled(outline * ratio, depth.shape)[rows, columns]]
        columns, rows = cells[held].T
        behind = (vertices[held] - view.back(places[held], 2.0 * depth[rows, columns] - 1.0)) @ view.direction
        # within a pixel the surface falls away, the steeper the more
        slope = np.sqrt(1.0 - np.minimum(facing[held] ** 2, 1.0)) / np.maximum(facing[held], 0.2)
        return np.asarray(held[behind < _LIFT_MM + slope / view.pixels_per_mm(vertices[held].mean(axis=0)) / ratio], np.int64) if len(held) else held

    def seen(self, points: Array, starts: Array) -> int | None:
        """The first of points (n, 3) mm just above the surface that is seen from its start (n, 3) mm."""
        return next((i for i, (start, point) in enumerate(zip(starts, points, strict=True)) if self.hit(start, point) is None), None)


def _filled(outline: Array, shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Which pixels of a picture (h, w) an outline (n, 2) holds."""
    height, width = shape
    image = QImage(width, height, QImage.Format.Format_Grayscale8)
    image.fill(0)
    with QPainter(image) as painter:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(Qt.GlobalColor.white)
        painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in outline.tolist()]), Qt.FillRule.OddEvenFill)
    return np.frombuffer(image.constBits(), np.uint8).reshape(height, -1)[:, :width] > 127
