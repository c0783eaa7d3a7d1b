"""Points in buffers of a fixed size that VTK reads in place."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty, vtkShaderProperty

from app.views.cloud_points import CloudPoints, Floats
from app.views.point_colour import PointColour
from app.views.vtk_arrays import copied_ids, shared


class CloudBuffer:
    """Room for so many points, with an actor that draws them."""

    def __init__(self, room: int, lookup: vtkLookupTable, look: vtkProperty, shader: vtkShaderProperty) -> None:
        self.count = 0
        self._step = 1
        self._points, self._normals = np.zeros((room, 3), np.float32), np.zeros((room, 3), np.float32)
        self._values = np.zeros((len(PointColour), room), np.float32)
        self._rows = CloudPoints(self._points, self._normals, self._values)
        self._places = vtkPoints()
        self._places.SetData(shared(self._points))
        self._vtk_normals = shared(self._normals)
        self._vtk_values = {by: shared(self._rows.of(by)) for by in PointColour}
        self._by = PointColour.HEIGHT
        self._poly = vtkPolyData()
        self._poly.SetPoints(self._places)
        self._poly.GetPointData().SetNormals(self._vtk_normals)
        self._poly.GetPointData().SetScalars(self._vtk_values[self._by])
        self._mapper = vtkPolyDataMapper()
        self._mapper.SetInputData(self._poly)
        self._mapper.SetLookupTable(lookup)
        self._mapper.SetUseLookupTableScalarRange(True)
        self.actor = vtkActor()
        self.actor.SetMapper(self._mapper)
        self.actor.SetProperty(look)
        self.actor.SetShaderProperty(shader)
        self._changed()

    @property
    def drawn(self) -> int:
        """Points that a picture of it holds."""
        return -(-self.count // self._step)

    @property
    def rows(self) -> CloudPoints:
        """What is in it; not a copy."""
        return self._rows.rows(slice(self.count))

    def clear(self) -> None:
        self.count, self._step = 0, 1
        self._changed()

    def append(self, points: CloudPoints, normals: Floats) -> None:
        new = slice(self.count, self.count + len(points))
        self._points[new], self._normals[new], self._values[:, new] = points.points, normals, points.values
        self.count = new.stop
        self._points[self.count :] = self._points[0]  # VTK counts unused points into the bounds
        self._changed()

    def halve(self) -> None:
        """Keep every second point."""
        kept = -(-self.count // 2)
        for buffer in (self._points, self._normals, *self._values):
            buffer[:kept] = buffer[: self.count : 2].copy()
        self.count = kept

    def light(self, normals: Floats) -> None:
        """Normals of the first m points."""
        self._normals[: len(normals)] = normals
        self._vtk_normals.Modified()
        self._poly.Modified()

    def put(self, by: PointColour, values: Floats) -> None:
        """Values of the first m points."""
        self._rows.of(by)[: len(values)] = values
        self._vtk_values[by].Modified()
        self._poly.Modified()

    def colour(self, by: PointColour, shown: bool) -> None:
        """By what they are coloured, if they are at all."""
        self._mapper.SetScalarVisibility(shown)
        if by is not self._by:
            self._by = by
            self._poly.GetPointData().SetScalars(self._vtk_values[by])

    def thin(self, step: int) -> None:
        """Draw every so many-th."""
        if max(1, step) != self._step:
            self._step = max(1, step)
            self._changed()

    def _changed(self) -> None:
        drawn = np.arange(0, self.count, self._step, dtype=np.int64)
        cells = vtkCellArray()
        if len(drawn):
            cells.SetData(copied_ids(np.array([0, len(drawn)], np.int64)), copied_ids(drawn))
        self._poly.SetVerts(cells)
        for part in (self._places.GetData(), self._vtk_normals, self._vtk_values[self._by]):
            part.Modified()
        self._places.Modified()
        self._poly.Modified()
