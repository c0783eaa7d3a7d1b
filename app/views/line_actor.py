"""Thick lines over a surface: outlines of areas, contours of a section."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.views.height_colours import rgb
from app.views.vtk_arrays import copied, copied_ids


class LineActor:
    """Segments of one colour, or none."""

    def __init__(self, colour: str, width: float) -> None:
        """`width` in pixels of the screen."""
        self._width = width
        self._mapper = vtkPolyDataMapper()
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        self._mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-4.0, -8.0)
        self.actor = vtkActor()
        self.actor.SetMapper(self._mapper)
        self.actor.SetVisibility(False)
        self.actor.PickableOff()
        look = self.actor.GetProperty()
        look.SetColor(*(value / 255 for value in rgb(colour)))
        look.LightingOff()
        look.SetRenderLinesAsTubes(False)
        self.set_pixel_ratio(1.0)

    def set_pixel_ratio(self, ratio: float) -> None:
        self.actor.GetProperty().SetLineWidth(self._width * ratio)

    def show_segments(self, points: NDArray[np.float64], segments: NDArray[np.int64]) -> None:
        """Segments (n, 2) between points (p, 3) mm."""
        self.actor.SetVisibility(bool(len(segments)))
        if not len(segments):
            return
        places = vtkPoints()
        places.SetData(copied(points.astype(np.float32)))
        cells = vtkCellArray()
        cells.SetData(copied_ids(np.arange(0, 2 * len(segments) + 1, 2, dtype=np.int64)), copied_ids(segments.astype(np.int64).ravel()))
        poly = vtkPolyData()
        poly.SetPoints(places)
        poly.SetLines(cells)
        self._mapper.SetInputData(poly)

    def show_poly(self, poly: Any) -> None:
        """Lines that VTK has made, or None."""
        self.actor.SetVisibility(poly is not None)
        if poly is not None:
            self._mapper.SetInputData(poly)


def outline(triangles: NDArray[np.int64], vertices: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """Segments (n, 2): the border of the triangles all of whose corners are among `vertices`; `count` vertices in all."""
    member = np.zeros(count, np.bool_)
    member[vertices] = True
    inside = triangles[member[triangles].all(axis=1)]
    edges = np.concatenate([inside[:, [0, 1]], inside[:, [1, 2]], inside[:, [2, 0]]])
    edges.sort(axis=1)
    keys, times = np.unique(edges[:, 0] * count + edges[:, 1], return_counts=True)
    border = keys[times == 1]
    return np.column_stack([border // count, border % count])
