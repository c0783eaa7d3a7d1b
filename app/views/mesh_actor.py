"""A triangle mesh as VTK draws it: smooth, coloured by what the data support or by its uncertainty."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.views.surface import Surface
from app.views.surface_colours import INFLATING, SUPPORTED, UNCERTAINTY, UNSUPPORTED, rgb, table
from app.views.vtk_arrays import copied, copied_ids


class MeshActor:
    """One mesh or none."""

    def __init__(self) -> None:
        self._surface: Surface | None = None
        self._uncertainty = False
        self._painted: NDArray[np.uint8] | None = None
        self._on = True
        self.range_um: tuple[float, float] | None = None
        """What the ends of the colour map mean, or None when it is not shown."""
        self._mapper = vtkPolyDataMapper()
        lookup = vtkLookupTable()
        lookup.SetTable(copied(table(UNCERTAINTY)))
        self._mapper.SetLookupTable(lookup)
        self._mapper.SetUseLookupTableScalarRange(False)
        self.actor = vtkActor()
        self.actor.SetMapper(self._mapper)
        self.actor.SetVisibility(False)
        look = self.actor.GetProperty()
        look.SetInterpolationToPhong()
        look.SetAmbient(0.12)
        look.SetDiffuse(0.85)
        look.SetSpecular(0.18)
        look.SetSpecularPower(24)
        look.SetEdgeColor(0.16, 0.2, 0.22)

    @property
    def surface(self) -> Surface | None:
        return self._surface

    def show(self, surface: Surface | None) -> None:
        """Draw this one from now on, or none."""
        self._surface = surface
        self.actor.SetVisibility(self._on and surface is not None)
        if surface is None:
            self.range_um = None
            return
        places = vtkPoints()
        places.SetData(copied(surface.mesh.vertices.astype(np.float32)))
        triangles = np.ascontiguousarray(surface.mesh.triangles, np.int64)
        cells = vtkCellArray()
        offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
        cells.SetData(copied_ids(offsets), copied_ids(triangles.ravel()))
        poly = vtkPolyData()
        poly.SetPoints(places)
        poly.SetPolys(cells)
        poly.GetPointData().SetNormals(copied(surface.normals))
        self._mapper.SetInputData(poly)
        self._paint()

    def show_at_all(self, on: bool) -> None:
        self._on = on
        self.actor.SetVisibility(on and self._surface is not None)

    def show_edges(self, on: bool) -> None:
        self.actor.GetProperty().SetEdgeVisibility(on)

    def show_uncertainty(self, on: bool) -> None:
        self._uncertainty = on
        if self._surface is not None:
            self._paint()

    def paint_vertices(self, colours: NDArray[np.uint8] | None) -> None:
        """Colours (v, 3) instead of those of what the data support; None for these again."""
        self._painted = colours
        if self._surface is not None:
            self._paint()

    def _paint(self) -> None:
        surface = self._surface
        assert surface is not None
        attributes = surface.mesh.vertex_attributes
        values = self._mapper.GetInput().GetPointData()
        known = attributes.get("standard_uncertainty_um")
        if self._uncertainty and known is not None and len(known):
            spread = np.asarray(known, np.float32)
            finite = spread[np.isfinite(spread)]
            low, high = (float(v) for v in np.percentile(finite, (1, 99))) if len(finite) else (0.0, 1.0)
            self.range_um = (low, max(high, low + 0.1))
            values.SetScalars(copied(np.nan_to_num(spread, nan=high, posinf=high)))
            self._mapper.SetScalarRange(*self.range_um)
            self._mapper.SetColorModeToMapScalars()
        else:
            self.range_um = None
            values.SetScalars(copied(_by_support(surface) if self._painted is None else self._painted))
            self._mapper.SetColorModeToDirectScalars()
        self._mapper.Modified()


def _by_support(surface: Surface) -> NDArray[np.uint8]:
    """(v, 3)"""
    colours = np.empty((len(surface.mesh.vertices), 3), np.uint8)
    colours[:] = rgb(INFLATING if surface.growing else SUPPORTED)
    supported = surface.mesh.vertex_attributes.get("supported")
    if supported is not None and not surface.growing:
        colours[np.asarray(supported) == 0] = rgb(UNSUPPORTED)
    return colours
