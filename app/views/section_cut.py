"""A section through both surfaces: the half that stays, and a contour of each."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter

from app.views.line_actor import LineActor

Array = NDArray[np.float64]
BEFORE_LINE: Final = "#ffe14d"
AFTER_LINE: Final = "#f06bd0"
"""Neither of them a colour of the map; of unlike lightness, too."""


class SectionCut:
    """A plane, or none."""

    def __init__(self) -> None:
        self.lines = (LineActor(BEFORE_LINE, 3.0), LineActor(AFTER_LINE, 3.0))
        """The contours before and after."""
        self._origin, self._normal = np.zeros(3), np.zeros(3)
        self._offset_mm = 0.0

    @property
    def active(self) -> bool:
        return bool(self._normal.any())

    def set_plane(self, origin: Array, normal: Array | None) -> None:
        """Through a point (3,) mm across a direction (3,)."""
        self._origin, self._offset_mm = origin, 0.0
        self._normal = np.zeros(3) if normal is None else normal / np.sqrt(normal @ normal)

    def set_offset_mm(self, offset_mm: float) -> None:
        """Along the normal, from where it was set."""
        self._offset_mm = offset_mm

    def show(self, polys: tuple[Any, Any]) -> None:
        """The contours of the surfaces before and after, each as VTK has it or None."""
        for line, poly in zip(self.lines, polys, strict=True):
            if not self.active or poly is None:
                line.show_poly(None)
                continue
            plane = vtkPlane()
            plane.SetOrigin(*self._point)
            plane.SetNormal(*self._normal)
            cutter = vtkCutter()
            cutter.SetInputData(poly)
            cutter.SetCutFunction(plane)
            cutter.Update()
            line.show_poly(cutter.GetOutput())

    def kept(self, camera: Any) -> tuple[Array, float]:
        """The half space ``normal . p <= offset`` that is left, the one behind the plane; everything without a section."""
        if not self.active:
            return np.zeros(3), 1.0
        sight = -np.array(camera.GetDirectionOfProjection()) if camera.GetParallelProjection() else np.array(camera.GetPosition()) - self._point
        facing = self._normal if sight @ self._normal >= 0 else -self._normal
        return facing, float(facing @ self._point)

    @property
    def _point(self) -> Array:
        return np.asarray(self._origin + self._offset_mm * self._normal, np.float64)
