"""A section through both surfaces: the half that stays, and a contour of each."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from app.views.drawn_surface import DrawnSurface
from app.views.line_actor import LineActor, plane_lines

Array = NDArray[np.float64]
BEFORE_LINE: Final = "#ffe14d"
AFTER_LINE: Final = "#f06bd0"
"""Neither of them a colour of the map; of unlike lightness, too."""


class SectionCut:
    """A plane, or none."""

    def __init__(self) -> None:
        self.lines = (LineActor(BEFORE_LINE, 5.0, behind=True), LineActor(AFTER_LINE, 2.0))
        """The contours before and after: where they coincide, the wide one is the rim of the narrow one."""
        self._origin, self._normal = np.zeros(3), np.zeros(3)
        self._offset_mm = 0.0

    @property
    def active(self) -> bool:
        return bool(self._normal.any())

    @property
    def normal(self) -> Array:
        """(3,) unit; zeros without a section."""
        return self._normal

    @property
    def contour(self) -> Array:
        """(n, 3) mm, points of both contours."""
        return np.concatenate([line.points for line in self.lines])

    def set_plane(self, origin: Array, normal: Array | None) -> None:
        """Through a point (3,) mm across a direction (3,)."""
        self._origin, self._offset_mm = origin, 0.0
        self._normal = np.zeros(3) if normal is None else normal / np.sqrt(normal @ normal)

    def set_offset_mm(self, offset_mm: float) -> None:
        """Along the normal, from where it was set."""
        self._offset_mm = offset_mm

    def show(self, surfaces: tuple[DrawnSurface | None, DrawnSurface | None]) -> None:
        """The contours of the surfaces before and after."""
        for line, surface in zip(self.lines, surfaces, strict=True):
            there = self.active and surface is not None
            line.show_poly(plane_lines(surface.mesh.vertices, surface.mesh.triangles, self._point, self._normal) if surface and there else None)

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
