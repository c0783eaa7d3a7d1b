"""What every 3D view is made of: a widget around pyvistaqt's QtInteractor.  The only file that touches it.

What was learned the hard way: multisampling costs four times the picture on software rendering; the interactor must be
closed by hand; a screenshot needs a ``render()`` before it, a living picture only an ``update()``.  Left to itself the
interactor draws at every movement of the mouse and once more when Qt paints, also when only a widget above it has
changed; and it obeys keys of VTK's own ("q" ends it).  Import this module in a thread first: pyvista alone takes seconds.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QCloseEvent, QKeyEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget
from pyvistaqt import QtInteractor
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from app.theme import look
from app.views.viewpoint import Viewpoint
from app.views.vtk_arrays import bytes_of, reals_of


class SceneClosedError(RuntimeError):
    """The 3D view was used after it had been closed."""


class _Engine(QtInteractor):
    """A QtInteractor that draws only when it was asked to, and leaves the keys to the window."""

    stale = True
    """The scene has changed since it was drawn; otherwise the last picture is shown again."""
    drawing = False
    """Qt has the widget drawn."""

    def paintGL(self) -> None:  # noqa: N802 - Qt's name
        interactor = self.iren.interactor
        if self.stale:
            self.stale = False
            interactor.EnableRenderOn()
        self.drawing = True
        base: Any = super()
        base.paintGL()
        self.drawing = False
        interactor.EnableRenderOff()

    def resizeGL(self, width: int, height: int) -> None:  # noqa: N802 - Qt's name
        self.stale = True
        base: Any = super()
        base.resizeGL(width, height)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        event.ignore()


class InteractorView(QWidget):
    """A 3D view that is drawn by its :meth:`paint`, at most once a call, and by nothing else."""

    moved = Signal(bool)
    """A person begins (True) or ends to move the camera."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._engine: Any = None
        self._engine = _Engine(self, auto_update=False, multi_samples=0, line_smoothing=False)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(self._engine)
        self._moving = False
        self._dirty = True
        self._begun_s = 0.0
        self._more = self._adding = False
        self._drawn_from: tuple[object, ...] = ()
        self.paint_s = 0.0
        """How long the last picture took."""
        self.pictures = 0
        engine = self._open()
        engine.enable_terrain_style(mouse_wheel_zooms=True)
        engine.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        interactor = engine.iren.interactor
        interactor.EnableRenderOff()
        interactor.AddObserver("StartInteractionEvent", lambda *_: self._interact(True))
        interactor.AddObserver("EndInteractionEvent", lambda *_: self._interact(False))
        interactor.AddObserver("RenderEvent", lambda *_: self._asked())
        window = engine.render_window
        window.AddObserver("StartEvent", lambda *_: self._begin_picture())
        window.AddObserver("EndEvent", lambda *_: self._end_picture())

    @property
    def closed(self) -> bool:
        return self._engine is None

    @property
    def camera_position(self) -> tuple[float, float, float]:
        """Where the camera stands, mm, object frame."""
        x, y, z = self._open().camera.position
        return x, y, z

    def paint(self) -> float:
        """Ask for a picture if something changed, or for more of one that is not complete; the time that the last one took, in seconds."""
        if self._engine is not None and self.isVisible() and (self._dirty or self.unfinished):
            self._more = not self._dirty
            if self._dirty:
                self._dirty = False
                self._prepare_picture()
            self._engine.stale = True
            self._engine.update()
        return self.paint_s

    def whole_view(self) -> Viewpoint:
        """The camera with the whole widget as its picture."""
        return Viewpoint.of(self._open().camera, 0.0, 0.0, self.width(), self.height())

    def lend_mouse(self, watcher: QObject) -> None:
        """The watcher sees the events of the picture first, as an event filter."""
        self._open().installEventFilter(watcher)

    def take_mouse_back(self, watcher: QObject) -> None:
        """The reverse; does nothing when the view is closed."""
        if self._engine is not None:
            self._engine.removeEventFilter(watcher)
            self._engine.unsetCursor()

    def show_cursor(self, shape: Qt.CursorShape) -> None:
        """The pointer over the picture."""
        self._open().setCursor(shape)

    def warm_up(self) -> None:
        """The first picture, out of sight: it has the graphics set up, which takes a quarter of a second."""
        self._open().grabFramebuffer()

    def grab_picture(self) -> NDArray[np.uint8]:
        """The scene as (H, W, 3) bytes, drawn anew, and all of it."""
        engine = self._open()
        self._prepare_picture()
        engine.render()
        self._dirty = False
        self._adding = True
        while self._adding and self.unfinished:
            self._more = True
            engine.render_window.Render()
        reader = vtkWindowToImageFilter()
        reader.SetInput(engine.render_window)
        reader.ReadFrontBufferOff()
        reader.ShouldRerenderOff()
        reader.Update()
        image = reader.GetOutput()
        width, height, _ = image.GetDimensions()
        pixels: NDArray[np.uint8] = bytes_of(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1].copy()
        return pixels

    def grab_depth(self) -> NDArray[np.float32]:
        """How far what is seen is at every device pixel (H, W), 0 near to 1 far, of the scene drawn anew; of the uppermost layer."""
        engine = self._open()
        self._prepare_picture()
        engine.render()
        window = engine.render_window
        width, height = window.GetSize()
        depth = vtkFloatArray()
        window.GetZbufferData(0, 0, width - 1, height - 1, depth)
        return reals_of(depth).reshape(height, width)[::-1].copy()

    def close_scene(self) -> None:
        """Release the graphics; may be called again."""
        engine, self._engine = self._engine, None
        if engine is not None:
            engine.close()

    def restyle(self) -> None:
        """In the colours of the palette in use: at the end of a scene's constructor, and whenever that changes."""
        self._open().set_background(look.scene_low, top=look.scene_high)
        self._dirty = True

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        if event.type() == QEvent.Type.PaletteChange and not self.closed:
            self.restyle()
        super().changeEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        self.close_scene()
        super().closeEvent(event)

    # -------------------------------------------------------------------------------- for the scenes
    def _prepare_picture(self) -> None:
        """Called before every picture."""

    @property
    def unfinished(self) -> bool:
        """There is more to draw into the picture that is there."""
        return False

    def _begin_slice(self) -> None:
        """Called before the picture is drawn on: let only that be visible which is still missing."""

    def _end_slice(self, seconds: float) -> None:
        """Called after it."""

    def _begin_whole(self) -> None:
        """Called before a picture is drawn anew."""

    def _interact(self, moving: bool) -> None:
        """A person begins or ends to move the camera."""
        self._moving = moving
        self._dirty = True
        self.moved.emit(moving)

    def _open(self) -> Any:
        if self._engine is None:
            raise SceneClosedError("the 3D view is closed")
        return self._engine

    # -------------------------------------------------------------------------------- inside
    def _asked(self) -> None:
        if self._engine is not None and not self._engine.drawing:
            self._dirty = True

    def _stand(self) -> tuple[object, ...]:
        """From where and how large the picture is."""
        engine = self._open()
        return engine.camera.GetMTime(), *engine.render_window.GetSize()

    def _keep(self, on: bool) -> None:
        """Whether colours and depths of the last picture stay."""
        renderer = self._open().renderer
        renderer.SetPreserveColorBuffer(on)
        renderer.SetPreserveDepthBuffer(on)

    def _begin_picture(self) -> None:
        self._begun_s = time.perf_counter()
        self._adding, self._more = self._more and not self._dirty and self._drawn_from == self._stand(), False
        self._keep(self._adding)
        if self._adding:
            self._begin_slice()
        else:
            self._begin_whole()

    def _end_picture(self) -> None:
        self.paint_s = time.perf_counter() - self._begun_s
        if self._adding:
            self._end_slice(self.paint_s)
            self._keep(False)
        self._drawn_from = self._stand()
        self.pictures += 1
