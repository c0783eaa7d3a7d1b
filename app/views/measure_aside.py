"""What is measured on: the surface of a case, or its points, with the measurements drawn on it.  Import it when the 3D view is there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.controllers.editing import EditedPoints
from app.views.drawn_surface import DrawnSurface
from app.views.edit_aside import MARKED
from app.views.line_actor import LineActor, paths
from app.views.mesh_actor import MeshActor
from app.views.mounts_aside import point_actor
from app.views.surface import Surface
from scanner_core.geometry.point_cloud import PointCloud

Array = NDArray[np.float64]
_DONE = "#4cc2ab"
_POINTS = "#cfc9ba"


class MeasureAside:
    """One surface with what drawing and pointing at it need, or points alone."""

    range_um = None
    slices = None

    def __init__(self, surface: tuple[Surface, DrawnSurface] | None, points: EditedPoints | None, left: NDArray[np.bool_] | None) -> None:
        self.surface: Surface | None = None if surface is None else surface[0]
        self.drawn: DrawnSurface | None = None if surface is None else surface[1]
        self.cloud: PointCloud | None = None
        self.pictured: Callable[[], None] = lambda: None
        """Called before every picture."""
        self._mesh, self._point_actor = MeshActor(), None
        bounds = None
        if self.surface is not None:
            self._mesh.show(self.surface)
            bounds = np.array(self.surface.mesh.bounds())
        elif points is not None and left is not None:
            self.cloud = points.cloud.select(left)
            self._point_actor = point_actor(self.cloud.points, np.asarray(points.towards[left], np.float64), _POINTS)
            bounds = points.bounds_mm
        self._bounds = bounds
        self._done = (LineActor("#10151a", 6.0, behind=True), LineActor(_DONE, 3.0))
        self._now = (LineActor("#10151a", 6.0, behind=True), LineActor(MARKED, 3.0))

    @property
    def actors(self) -> Sequence[Any]:
        points = [] if self._point_actor is None else [self._point_actor]
        return [self._mesh.actor, *points, *(line.actor for line in (*self._done, *self._now))]

    @property
    def bounds_mm(self) -> Array | None:
        return self._bounds

    def fit_pixels(self, ratio: float) -> None:
        if self._point_actor is not None:
            self._point_actor.GetProperty().SetPointSize(4.0 * ratio)
        for line in (*self._done, *self._now):
            line.set_pixel_ratio(ratio)
        self.pictured()

    def show_lines(self, done: Sequence[Array], now: Sequence[Array]) -> None:
        """Lines (k, 3) mm of the measurements that are kept, and of the one that is being made."""
        for lines, actors in ((done, self._done), (now, self._now)):
            poly = paths(lines)
            for actor in actors:
                actor.show_poly(poly)
