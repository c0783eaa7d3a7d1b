"""The 3D view: points, mesh, table.  Import this module in a thread first: pyvista alone takes seconds."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget

from app.theme import is_dark, look
from app.views.aside import Aside
from app.views.cloud_actor import CloudActor
from app.views.cloud_points import CloudPoints, Floats
from app.views.comparison_camera import ComparisonCamera
from app.views.holed_actor import HoledActor
from app.views.holed_surface import HoledSurface
from app.views.interactor import InteractorView
from app.views.mesh_actor import MeshActor
from app.views.parts import label
from app.views.point_colour import PointColour
from app.views.surface import Surface
from scanner_core.acquisition.live_points import LivePoints
from scanner_core.geometry.point_cloud import PointCloud

GRID_MM = 10.0
AXES = {True: ("#e0857a", "#7fc98f", "#7aa7e8"), False: ("#b5382b", "#23803b", "#2b5fb8")}
"""Colours of the axes on a dark and on a light ground."""
_REFIT = 1.15
"""The camera follows a growing cloud in steps of this factor, until a person moves it."""


class SceneView(InteractorView):
    """Points coloured by what a person chose, a mesh, the turntable, and the three axes."""

    coloured = Signal()
    """The colours of the points mean something else."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._meant: tuple[object, ...] = ()
        self._scale = label(self.tr("grid {mm:.0f} mm").format(mm=GRID_MM), "faint")
        self._scale.setParent(self)
        self._scale.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._scale.hide()
        self.cloud = CloudActor()
        self.mesh = MeshActor()
        self.holed = HoledActor()
        self._table: pv.Actor | None = None
        self._live = False
        self._begun_points_s = 0.0
        self._hidden: list[Any] = []
        self._follow = True
        self._shown = {"points": True, "surface": True}
        self.aside: Aside | None = None
        """What stands in the place of points and surface."""
        self._fitted_mm: NDArray[np.float64] | None = None
        engine = self._open()
        self._flight = ComparisonCamera(engine.camera)
        engine.add_actor(self.cloud.actor, render=False)
        self.cloud.chunks.put_into(engine.renderer)
        for actor in (self.mesh.actor, *self.holed.actors):
            engine.add_actor(actor, render=False)
        self.restyle()

    def restyle(self) -> None:
        """In the colours of the palette in use."""
        super().restyle()
        engine = self._open()
        x, y, z = AXES[is_dark()]
        engine.add_axes(line_width=2, color=look.muted, x_color=x, y_color=y, z_color=z, viewport=(0.0, 0.0, 0.14, 0.17))
        self.cloud.restyle(dark=is_dark())
        if self._table is not None:
            self._table.prop.color = look.seam

    # -------------------------------------------------------------------------------- what is shown
    def show_table(self, radius_mm: float) -> None:
        """The turntable as a disc with a grid of 10 mm, and the room above it as the first view."""
        engine = self._open()
        if self._table is not None:
            engine.remove_actor(self._table, render=False)
        self._table = engine.add_mesh(_table_lines(radius_mm), color=look.seam, line_width=1, lighting=False, render=False, pickable=False)
        self._scale.show()
        if not len(self.cloud) and self.mesh.surface is None:
            self._frame(np.array([[-radius_mm, -radius_mm, 0.0], [radius_mm, radius_mm, 1.2 * radius_mm]]) * 0.75)
        self._dirty = True

    def append_points(self, points: LivePoints) -> None:
        """Add points that were just measured."""
        self._open()
        now_s = time.monotonic()
        if not len(self.cloud):
            self._begun_points_s = now_s
        self.cloud.append(CloudPoints.of_scan(points, now_s - self._begun_points_s))
        self.cloud.see_views(points.views)
        self._follow_bounds(self.cloud.bounds_mm)
        self._dirty = True

    def replace_cloud(self, cloud: PointCloud) -> None:
        """These points instead of those that are shown; the camera stays."""
        self._open()
        self.cloud.clear()
        follow, self._follow = self._follow, False
        self.show_cloud(cloud)
        self._follow = follow

    def show_cloud(self, cloud: PointCloud) -> None:
        """All points of a case at once."""
        self._open()
        self.cloud.hold(cloud)
        self._follow_bounds(self.cloud.bounds_mm)
        self._dirty = True

    def clear(self) -> None:
        """No points, no mesh; the camera follows what comes next."""
        self._open()
        self.cloud.clear()
        self.mesh.show(None)
        self.holed.show(None)
        self._follow, self._fitted_mm = True, None
        self._dirty = True

    def show_live_surface(self, surface: HoledSurface | None) -> None:
        """The coarse surface of the points so far; none while there is a mesh."""
        self._open()
        self.holed.show(surface if self.mesh.surface is None else None)
        self._dirty = True

    def set_surface_visible(self, on: bool) -> None:
        """Whether mesh and live surface are shown."""
        self._shown["surface"] = on
        self._show_parts()

    def show_mesh(self, surface: Surface | None) -> None:
        self._open()
        self.mesh.show(surface)
        if surface is not None:
            self.holed.show(None)
        if surface is not None and not len(self.cloud):
            self._follow_bounds(np.array(surface.mesh.bounds()))
        self._dirty = True

    def set_points_visible(self, on: bool) -> None:
        self._shown["points"] = on
        self._show_parts()

    def show_aside(self, aside: Aside | None) -> None:
        """Something else in the place of points and surface; None for these again.  The camera stays where all of it was in sight."""
        engine = self._open()
        if self.aside is not None:
            for actor in self.aside.actors:
                engine.remove_actor(actor, render=False)
        fresh = aside is not None and aside is not self.aside
        self.aside = aside
        if aside is not None:
            for actor in aside.actors:
                engine.add_actor(actor, render=False, reset_camera=False)
        self._show_parts()
        if fresh:
            self.view_fit()

    def _show_parts(self) -> None:
        here = self.aside is None
        self.cloud.actor.SetVisibility(here and self._shown["points"])
        self.mesh.show_at_all(here and self._shown["surface"])
        self.holed.show_at_all(here and self._shown["surface"])
        self._dirty = True

    def set_points_quiet(self, on: bool) -> None:
        self.cloud.quiet(on)
        self._dirty = True

    def set_edges(self, on: bool) -> None:
        self.mesh.show_edges(on)
        self._dirty = True

    def set_uncertainty(self, on: bool) -> None:
        self.mesh.show_uncertainty(on)
        self._dirty = True

    def set_live(self, live: bool) -> None:
        """Whether something still moves by itself."""
        self._live = live
        self.cloud.grow(live)
        self._dirty = True

    @property
    def live(self) -> bool:
        """Something moves by itself."""
        return self._live

    @property
    def still(self) -> bool:
        """Nothing moves: there is time for the whole cloud."""
        return not (self._live or self._moving)

    def light_live(self, normals: Floats, density: Floats, generation: int) -> None:
        """See :meth:`CloudActor.light_live`."""
        self.cloud.light_live(normals, density, generation)
        self._dirty = True

    def colour_points_by(self, by: PointColour) -> None:
        self.cloud.colour_by(by)
        self._dirty = True

    # -------------------------------------------------------------------------------- camera
    def touch(self) -> None:
        """Something in the 3D view looks otherwise."""
        self._dirty = True

    def fly_to(self, points: NDArray[np.float64], normal: NDArray[np.float64]) -> None:
        """Begin a flight to where points (n, 3) mm are seen from the side that a direction (3,) tells, and a little from above."""
        self._follow = False
        towards = normal + np.array([0.0, 0.0, 0.35 if normal[2] > -0.5 else 0.0])
        self._flight.face(towards, points, self.width() / max(self.height(), 1))
        self._dirty = True

    def paint(self) -> float:
        if self._engine is not None and self._flight.advance():
            self._engine.renderer.ResetCameraClippingRange()
            self._dirty = True
        return super().paint()

    def view_fit(self) -> None:
        bounds = self._bounds()
        if bounds is not None:
            self._frame(bounds, keep_direction=True)
        self._follow = True

    def view_front(self) -> None:
        self._look((1.0, 0.0, 0.0), (0.0, 0.0, 1.0))

    def view_top(self) -> None:
        self._look((0.0, 0.0, 1.0), (-1.0, 0.0, 0.0))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        size = self._scale.sizeHint()
        self._scale.setGeometry(self.width() - size.width() - 12, self.height() - size.height() - 8, size.width(), size.height())
        self._scale.raise_()

    # -------------------------------------------------------------------------------- inside
    def _prepare_picture(self) -> None:
        self.cloud.prepare(self.devicePixelRatioF())
        meant = (self.cloud.by, self.cloud.views, *self.cloud.shown_range())
        if meant != self._meant:
            self._meant = meant
            self.coloured.emit()
        if self.aside is not None:
            self.aside.fit_pixels(self.devicePixelRatioF())

    @property
    def unfinished(self) -> bool:
        """There are more points to draw into the picture that is there."""
        if self.aside is not None:
            return self.still and self.aside.slices is not None and self.aside.slices.pending
        return self.still and self.cloud.chunks.pending and bool(self.cloud.actor.GetVisibility())

    def _begin_whole(self) -> None:
        self.cloud.chunks.restart()
        if self.aside is not None and self.aside.slices is not None:
            self.aside.slices.restart()

    def _begin_slice(self) -> None:
        self._hidden = [actor for actor in self._open().renderer.GetActors() if actor.GetVisibility()]
        for actor in self._hidden:
            actor.SetVisibility(False)
        if self.aside is None:
            self.cloud.chunks.show_next(self.cloud.by)
        elif self.aside.slices is not None:
            self.aside.slices.show_next()

    def _end_slice(self, seconds: float) -> None:
        if self.aside is None:
            self.cloud.chunks.hide(seconds)
        elif self.aside.slices is not None:
            self.aside.slices.hide(seconds)
        for actor in self._hidden:
            actor.SetVisibility(True)
        self._hidden = []

    def _interact(self, moving: bool) -> None:
        super()._interact(moving)
        self._flight.stop()
        self._follow = False
        self.cloud.thin_for_motion(moving)

    def _bounds(self) -> NDArray[np.float64] | None:
        if self.aside is not None:
            return self.aside.bounds_mm
        surface = self.mesh.surface
        parts = (self.cloud.bounds_mm, None if surface is None else np.array(surface.mesh.bounds()))
        both = [part for part in parts if part is not None]
        return np.array([np.min([b[0] for b in both], axis=0), np.max([b[1] for b in both], axis=0)]) if both else None

    def _follow_bounds(self, bounds: NDArray[np.float64] | None) -> None:
        if bounds is None or not self._follow or self._moving or self.aside is not None:
            return
        old = self._fitted_mm
        if old is not None and ((bounds[0] >= old[0]).all() and (bounds[1] <= old[1]).all()):
            return
        middle, half = bounds.mean(axis=0), 0.5 * np.maximum(bounds[1] - bounds[0], 4.0) * _REFIT
        self._fitted_mm = np.array([middle - half, middle + half])
        self._frame(self._fitted_mm, keep_direction=True)

    def _look(self, direction: tuple[float, float, float], up: tuple[float, float, float]) -> None:
        self._flight.stop()
        camera = self._open().camera
        camera.position = tuple(np.array(camera.focal_point) + np.array(direction) * camera.distance)
        camera.up = up
        bounds = self._bounds()
        if bounds is not None:
            self._frame(bounds, keep_direction=True)
        self._open().renderer.ResetCameraClippingRange()
        self._dirty = True

    def _frame(self, bounds: NDArray[np.float64], keep_direction: bool = False) -> None:
        engine = self._open()
        camera = engine.camera
        if not keep_direction:
            camera.focal_point = (0.0, 0.0, 0.0)
            camera.position = (1.0, -0.75, 0.55)
            camera.up = (0.0, 0.0, 1.0)
        engine.renderer.ResetCamera(*np.asarray(bounds, float).T.ravel().tolist())
        camera.zoom(1.15)
        engine.renderer.ResetCameraClippingRange()
        self._dirty = True


def _table_lines(radius_mm: float) -> pv.PolyData:
    """Two rings and a grid of 10 mm inside them, at z = 0."""
    turn = np.linspace(0, 2 * np.pi, 121)
    rings = [np.stack([r * np.cos(turn), r * np.sin(turn), np.zeros_like(turn)], axis=1) for r in (radius_mm, radius_mm + 1.0)]
    lines = []
    for offset in np.arange(-np.floor(radius_mm / GRID_MM) * GRID_MM, radius_mm, GRID_MM):
        half = float(np.sqrt(max(radius_mm**2 - offset**2, 0.0)))
        lines += [np.array([[-half, offset, 0.0], [half, offset, 0.0]]), np.array([[offset, -half, 0.0], [offset, half, 0.0]])]
    parts = [*rings, *lines]
    cells, first = [], 0
    for part in parts:
        cells.append(np.r_[len(part), np.arange(first, first + len(part))])
        first += len(part)
    return pv.PolyData(np.concatenate(parts).astype(np.float32), lines=np.concatenate(cells))
