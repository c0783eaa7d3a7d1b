"""A surface that still has holes as VTK draws it: what is scanned is solid, what is not is a net within a bright rim.

Solid and net differ in form, so that nobody needs to tell their colours apart; through the net one sees the inside of the
scanned part, which is darker.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkProperty

from app.palettes import DARK
from app.views.holed_surface import HoledSurface
from app.views.surface_colours import SUPPORTED, UNSUPPORTED, rgb
from app.views.vtk_arrays import copied, copied_ids

_BEHIND = (1.5, 4.0)
"""How far the surface stands behind the points that lie on it: factor and units of the polygon offset."""


class HoledActor:
    """One surface or none, in three parts."""

    def __init__(self) -> None:
        self._surface: HoledSurface | None = None
        self._on = True
        self._scanned, self._net, self._rim = vtkActor(), vtkActor(), vtkActor()
        self.actors = (self._scanned, self._net, self._rim)
        for actor in self.actors:
            actor.SetMapper(vtkPolyDataMapper())
            actor.SetVisibility(False)
            actor.SetPickable(False)
        mapper: Any = self._scanned.GetMapper()
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(*_BEHIND)
        look = self._scanned.GetProperty()
        look.SetInterpolationToPhong()
        _colour(look, SUPPORTED)
        look.SetAmbient(0.12)
        look.SetDiffuse(0.7)
        inside = vtkProperty()
        inside.DeepCopy(look)
        inside.SetDiffuse(0.25)
        self._scanned.SetBackfaceProperty(inside)
        net = self._net.GetProperty()
        net.SetRepresentationToWireframe()
        net.LightingOff()
        _colour(net, UNSUPPORTED)
        rim = self._rim.GetProperty()
        rim.LightingOff()
        rim.SetLineWidth(2.5)
        _colour(rim, DARK.warning)

    @property
    def surface(self) -> HoledSurface | None:
        return self._surface

    def show(self, surface: HoledSurface | None) -> None:
        """Draw this one from now on, or none."""
        self._surface = surface
        self._set_visible()
        if surface is None:
            return
        places = vtkPoints()
        places.SetData(copied(surface.vertices))
        normals = copied(surface.normals)
        for actor, cells in zip(self.actors, (surface.scanned, surface.open, surface.rim), strict=True):
            poly = vtkPolyData()
            poly.SetPoints(places)
            if cells.shape[1] == 2:
                poly.SetLines(_cells(cells))
            else:
                poly.SetPolys(_cells(cells))
                poly.GetPointData().SetNormals(normals)
            mapper: Any = actor.GetMapper()
            mapper.SetInputData(poly)

    def show_at_all(self, on: bool) -> None:
        self._on = on
        self._set_visible()

    def _set_visible(self) -> None:
        for actor in self.actors:
            actor.SetVisibility(self._on and self._surface is not None)


def _cells(corners: NDArray[np.int64]) -> vtkCellArray:
    made = vtkCellArray()
    size = corners.shape[1]
    made.SetData(copied_ids(np.arange(0, corners.size + 1, size, dtype=np.int64)), copied_ids(corners.ravel()))
    return made


def _colour(look: vtkProperty, colour: str) -> None:
    red, green, blue = (channel / 255 for channel in rgb(colour))
    look.SetColor(red, green, blue)
