"""Many points that are drawn in slices into the picture that is there, once nothing moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty

from app.views.vtk_arrays import copied_ids

_AIM_S = 0.04
"""A slice should take about so long."""
_LEAST, _MOST = 2_000, 60_000
"""Points of a slice."""


def show_rows(poly: vtkPolyData, rows: NDArray[np.int64]) -> None:
    """Have of all points only those drawn."""
    cells = vtkCellArray()
    if len(rows):
        cells.SetData(copied_ids(np.array([0, len(rows)], np.int64)), copied_ids(rows))
    poly.SetVerts(cells)
    poly.Modified()


class PointSlices:
    """Some of the points of another actor, which has coordinates, normals and colours; visible in their slice of the picture alone."""

    def __init__(self, poly: vtkPolyData, look: vtkProperty) -> None:
        self._poly = vtkPolyData()
        self._poly.SetPoints(poly.GetPoints())
        self._poly.GetPointData().SetNormals(poly.GetPointData().GetNormals())
        self._poly.GetPointData().SetScalars(poly.GetPointData().GetScalars())
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._poly)
        mapper.SetColorModeToDirectScalars()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.SetProperty(look)
        self.actor.SetVisibility(False)
        self._rows = np.empty(0, np.int64)
        self._done, self._at_once = 0, 10_000

    @property
    def pending(self) -> bool:
        """Some of them are not in the picture yet."""
        return self._done < len(self._rows)

    def put(self, rows: NDArray[np.int64]) -> None:
        """Which points; the picture holds none of them."""
        self._rows, self._done = rows, 0

    def restart(self) -> None:
        """The picture holds none of them."""
        self._done = 0

    def show_next(self) -> None:
        """Have the next slice of the picture draw some more."""
        show_rows(self._poly, self._rows[self._done : self._done + self._at_once])
        self.actor.SetVisibility(True)

    def hide(self, seconds: float) -> None:
        """They are drawn, which took so long: the next slice draws more or fewer."""
        self.actor.SetVisibility(False)
        self._done += self._at_once
        share = min(max(_AIM_S / max(seconds, 1e-3), 0.5), 1.5)
        self._at_once = min(max(round(share * self._at_once), _LEAST), _MOST)
