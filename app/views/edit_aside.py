"""The points of a case as they are edited: those that are left, those that would be taken out, those that were.

Import it when the 3D view is there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.controllers.editing import EditedPoints
from app.theme import is_dark
from app.views.line_actor import LineActor, segments
from app.views.point_slices import PointSlices, show_rows
from app.views.surface_colours import rgb
from app.views.vtk_arrays import copied, shared

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MARKED: Final = "#f06bd0"
"""What would be taken out; of another lightness than what is left, too."""
_LEFT: Final = {True: "#cfc9ba", False: "#8f979f"}
_OUT: Final = {True: "#596470", False: "#c3c9cf"}
"""By whether the ground is dark."""
_MOST, _MOST_AT_ONCE = 500_000, 30_000
"""Points that are drawn, and that are drawn in one go: the others follow in slices once nothing moves."""
_SIZES = ((8_000, 5.0), (60_000, 4.0), (10**9, 3.0))
_BOX_EDGES = np.array([(0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7), (0, 4), (1, 5), (2, 6), (3, 7)])


class EditAside:
    """All points of one case, and a box or a plane among them."""

    range_um = None

    def __init__(self, points: EditedPoints) -> None:
        self.points = points
        self._places = points.cloud.points.astype(np.float32)
        self._colours = np.empty((len(points), 3), np.uint8)
        self._shown = np.arange(len(points), dtype=np.int64)
        self._moving = False
        self._drawn = 0
        places = vtkPoints()
        places.SetData(shared(self._places))
        self._scalars = shared(self._colours)
        self._poly = vtkPolyData()
        self._poly.SetPoints(places)
        self._poly.GetPointData().SetNormals(copied(points.towards))
        self._poly.GetPointData().SetScalars(self._scalars)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._poly)
        mapper.SetColorModeToDirectScalars()
        self._actor = vtkActor()
        self._actor.SetMapper(mapper)
        look = self._actor.GetProperty()
        look.SetRepresentationToPoints()
        look.SetAmbient(0.35)
        look.SetDiffuse(0.75)
        self.slices = PointSlices(self._poly, look)
        self._shape = (LineActor("#10151a", 3.2, behind=True), LineActor(MARKED, 1.5))
        self.show(np.zeros(len(points), np.bool_), None, out_too=False)

    @property
    def actors(self) -> Sequence[Any]:
        return [self._actor, self.slices.actor, *(line.actor for line in self._shape)]

    @property
    def bounds_mm(self) -> Array | None:
        return self.points.bounds_mm

    def fit_pixels(self, ratio: float) -> None:
        size = next(size for most, size in _SIZES if self._drawn <= most)
        self._actor.GetProperty().SetPointSize(ratio * size)
        for line in self._shape:
            line.set_pixel_ratio(ratio)

    def show(self, out: Mask, marked: Mask | None, *, out_too: bool) -> None:
        """Which points (n,) are out, which are marked; those that are out are shown only with `out_too`."""
        dark = is_dark()
        self._colours[:] = rgb(_LEFT[dark])
        if out_too:
            self._colours[out] = rgb(_OUT[dark])
        if marked is not None:
            self._colours[marked] = rgb(MARKED)
        self._scalars.Modified()
        self._shown = np.arange(len(out), dtype=np.int64) if out_too else np.flatnonzero(~out)
        self._draw()

    def thin(self, moving: bool) -> None:
        """Fewer points while the camera moves."""
        self._moving = moving
        self._draw()

    def show_box(self, corners: Array | None) -> None:
        """The edges of a box by its corners (8, 3) mm, x the quickest; None for none."""
        poly = None if corners is None else segments(corners[_BOX_EDGES[:, 0]], corners[_BOX_EDGES[:, 1]])
        self._show_shape(poly)

    def show_plane(self, corners: Array | None) -> None:
        """A grid over a plane by its corners (4, 3) mm, one after the other round it; None for none."""
        if corners is None:
            self._show_shape(None)
            return
        share = np.linspace(0.0, 1.0, 5)[:, None]
        a, b, c, d = corners
        along, across = (a + share * (b - a), d + share * (c - d)), (a + share * (d - a), b + share * (c - b))
        self._show_shape(segments(np.concatenate([along[0], across[0]]), np.concatenate([along[1], across[1]])))

    def _show_shape(self, poly: Any) -> None:
        for line in self._shape:
            line.show_poly(poly)

    def _draw(self) -> None:
        rows = self._shown[:: max(1, -(-len(self._shown) // _MOST))]
        stride = max(1, -(-len(rows) // _MOST_AT_ONCE))
        first = rows[::stride]
        show_rows(self._poly, first)
        rest = [] if self._moving else [rows[begin::stride] for begin in range(1, stride)]
        self.slices.put(np.concatenate(rest) if rest else np.empty(0, np.int64))
        self._drawn = len(first) if self._moving else len(rows)
