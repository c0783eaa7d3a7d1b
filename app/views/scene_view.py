"""The 3D view: points, mesh, table.  The only file that touches pyvistaqt's QtInteractor.

What was learned the hard way: multisampling costs four times the picture on software rendering; the interactor must be
closed by hand; a screenshot needs a ``render()`` before it, a living picture only an ``update()``.  Import this module
in a thread first: pyvista alone takes seconds.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QCloseEvent, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget
from pyvistaqt import QtInteractor
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from app.theme import GROUND, MUTED, RAISED, SEAM
from app.views.cloud_actor import CloudActor
from app.views.mesh_actor import MeshActor
from app.views.parts import label
from app.views.surface import Surface
from app.views.vtk_arrays import bytes_of
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.view_directions import seen_from

GRID_MM = 10.0
_REFIT = 1.15
"""The camera follows a growing cloud in steps of this factor, until a person moves it."""


class SceneClosedError(RuntimeError):
    """The 3D view was used after it had been closed."""


class SceneView(QWidget):
    """Points coloured by height, a mesh, the turntable, and the three axes."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._engine: Any = QtInteractor(self, auto_update=False, multi_samples=0, line_smoothing=False)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(self._engine)
        self._scale = label(self.tr("grid {mm:.0f} mm").format(mm=GRID_MM), "faint")
        self._scale.setParent(self)
        self._scale.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._scale.hide()
        self.cloud = CloudActor()
        self.mesh = MeshActor()
        self._table: pv.Actor | None = None
        self._live = False
        self._moving = False
        self._dirty = True
        self._follow = True
        self._fitted_mm: NDArray[np.float64] | None = None
        self._begun_s = 0.0
        self.paint_s = 0.0
        """How long the last picture took."""
        self.pictures = 0
        self._prepare(self._engine)

    # -------------------------------------------------------------------------------- what is shown
    def show_table(self, radius_mm: float) -> None:
        """The turntable as a disc with a grid of 10 mm, and the room above it as the first view."""
        engine = self._open()
        if self._table is not None:
            engine.remove_actor(self._table, render=False)
        self._table = engine.add_mesh(_table_lines(radius_mm), color=SEAM, line_width=1, lighting=False, render=False, pickable=False)
        self._scale.show()
        if not len(self.cloud) and self.mesh.surface is None:
            self._frame(np.array([[-radius_mm, -radius_mm, 0.0], [radius_mm, radius_mm, 1.2 * radius_mm]]) * 0.75)
        self._dirty = True

    def append_points(self, points: NDArray[np.float64], towards: NDArray[np.float64]) -> None:
        """Add points (n, 3) mm, object frame, seen from the directions `towards` (n, 3)."""
        self._open()
        self.cloud.append(points, towards)
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
        views = np.zeros(len(cloud), np.int32) if cloud.views is None else cloud.views
        self.append_points(cloud.points, seen_from(views, int(views.max(initial=0)) + 1))

    def clear(self) -> None:
        """No points, no mesh; the camera follows what comes next."""
        self._open()
        self.cloud.clear()
        self.mesh.show(None)
        self._follow, self._fitted_mm = True, None
        self._dirty = True

    def show_mesh(self, surface: Surface | None) -> None:
        self._open()
        self.mesh.show(surface)
        if surface is not None and not len(self.cloud):
            self._follow_bounds(np.array(surface.mesh.bounds()))
        self._dirty = True

    def set_points_visible(self, on: bool) -> None:
        self.cloud.actor.SetVisibility(on)
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

    @property
    def still(self) -> bool:
        """Nothing moves: there is time for the whole cloud."""
        return not (self._live or self._moving)

    @property
    def closed(self) -> bool:
        return self._engine is None

    def light_live(self, normals: NDArray[np.float64], generation: int) -> None:
        self.cloud.light_live(normals, generation)
        self._dirty = True

    def light_all(self, normals: NDArray[np.float64], generation: int) -> None:
        self.cloud.show_still(normals, generation)
        self._dirty = True

    # -------------------------------------------------------------------------------- camera
    def view_fit(self) -> None:
        bounds = self._bounds()
        if bounds is not None:
            self._frame(bounds, keep_direction=True)
        self._follow = True

    def view_front(self) -> None:
        self._look((1.0, 0.0, 0.0), (0.0, 0.0, 1.0))

    def view_top(self) -> None:
        self._look((0.0, 0.0, 1.0), (-1.0, 0.0, 0.0))

    @property
    def camera_position(self) -> tuple[float, float, float]:
        """Where the camera stands, mm, object frame."""
        x, y, z = self._open().camera.position
        return x, y, z

    # -------------------------------------------------------------------------------- painting
    def paint(self) -> float:
        """Ask for a picture if something changed; the time that the last one took, in seconds."""
        if self._dirty and self._engine is not None and self.isVisible():
            self._dirty = False
            self.cloud.fit_point_size(self.devicePixelRatioF())
            self._engine.update()
        return self.paint_s

    def warm_up(self) -> None:
        """The first picture, out of sight: it has the graphics set up, which takes a quarter of a second."""
        self._open().grabFramebuffer()

    def grab_picture(self) -> NDArray[np.uint8]:
        """The scene as (H, W, 3) bytes, drawn anew."""
        engine = self._open()
        self.cloud.fit_point_size(self.devicePixelRatioF())
        engine.render()
        reader = vtkWindowToImageFilter()
        reader.SetInput(engine.render_window)
        reader.ReadFrontBufferOff()
        reader.Update()
        image = reader.GetOutput()
        width, height, _ = image.GetDimensions()
        pixels: NDArray[np.uint8] = bytes_of(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1].copy()
        return pixels

    def close_scene(self) -> None:
        """Release the graphics; may be called again."""
        engine, self._engine = self._engine, None
        if engine is not None:
            engine.close()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        size = self._scale.sizeHint()
        self._scale.setGeometry(self.width() - size.width() - 12, self.height() - size.height() - 8, size.width(), size.height())
        self._scale.raise_()

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        self.close_scene()
        super().closeEvent(event)

    # -------------------------------------------------------------------------------- inside
    def _open(self) -> Any:
        if self._engine is None:
            raise SceneClosedError("the 3D view is closed")
        return self._engine

    def _prepare(self, engine: Any) -> None:
        engine.set_background(GROUND, top=RAISED)
        engine.enable_terrain_style(mouse_wheel_zooms=True)
        engine.add_actor(self.cloud.actor, render=False)
        engine.add_actor(self.mesh.actor, render=False)
        engine.add_axes(line_width=2, color=MUTED, x_color="#e0857a", y_color="#7fc98f", z_color="#7aa7e8", viewport=(0.0, 0.0, 0.14, 0.17))
        engine.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        interactor = engine.iren.interactor
        interactor.AddObserver("StartInteractionEvent", lambda *_: self._interact(True))
        interactor.AddObserver("EndInteractionEvent", lambda *_: self._interact(False))
        window = engine.render_window
        window.AddObserver("StartEvent", lambda *_: self._begin_picture())
        window.AddObserver("EndEvent", lambda *_: self._end_picture())

    def _interact(self, moving: bool) -> None:
        self._moving = moving
        self._follow = False
        self.cloud.thin_for_motion(moving)
        self._dirty = True

    def _begin_picture(self) -> None:
        self._begun_s = time.perf_counter()

    def _end_picture(self) -> None:
        self.paint_s = time.perf_counter() - self._begun_s
        self.pictures += 1

    def _bounds(self) -> NDArray[np.float64] | None:
        surface = self.mesh.surface
        parts = (self.cloud.bounds_mm, None if surface is None else np.array(surface.mesh.bounds()))
        both = [part for part in parts if part is not None]
        return np.array([np.min([b[0] for b in both], axis=0), np.max([b[1] for b in both], axis=0)]) if both else None

    def _follow_bounds(self, bounds: NDArray[np.float64] | None) -> None:
        if bounds is None or not self._follow or self._moving:
            return
        old = self._fitted_mm
        if old is not None and ((bounds[0] >= old[0]).all() and (bounds[1] <= old[1]).all()):
            return
        middle, half = bounds.mean(axis=0), 0.5 * np.maximum(bounds[1] - bounds[0], 4.0) * _REFIT
        self._fitted_mm = np.array([middle - half, middle + half])
        self._frame(self._fitted_mm, keep_direction=True)

    def _look(self, direction: tuple[float, float, float], up: tuple[float, float, float]) -> None:
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
