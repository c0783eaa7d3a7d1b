"""A cloud on which a person picks numbered points, by a click or by keys.  Import it in a thread first: pyvista takes seconds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QWidget

from app.theme import look
from app.views.comparison_overlay import ComparisonOverlay, Tag
from app.views.interactor import InteractorView
from app.views.mounts_aside import POINT_SIZE, point_actor
from app.views.viewpoint import Viewpoint

Array = NDArray[np.float64]
_CLICK_PX = 4.0
_NEAR_PX = 12.0
"""A click takes the nearest point to the eye within so much of it."""
_STEP_DEG = 15.0
_ABOVE_PX = 22.0


class PickView(InteractorView):
    """One cloud."""

    picked = Signal(object)
    """Where, (x, y, z) mm in the frame of the cloud."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        engine = self._open()
        engine.enable_trackball_style()
        engine.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        engine.setAccessibleName(name)
        engine.setAccessibleDescription(
            self.tr("Turn it with the arrow keys, come nearer with plus and minus, pick the point in the middle with the space bar.")
        )
        self._overlay = ComparisonOverlay(self)
        self._overlay.setGeometry(self.rect())
        self._actor: Any = None
        self._points = self._towards = np.zeros((0, 3))
        self._marks: Sequence[Sequence[float]] = ()
        self._pressed: QPointF | None = None
        engine.installEventFilter(self)
        self.restyle()

    def restyle(self) -> None:
        self._open().set_background(look.panel)
        self._dirty = True

    def show_points(self, points: Array, towards: Array, colour: str) -> None:
        """Points (n, 3) mm with the directions (n, 3) from which they were seen; all of them in sight."""
        engine = self._open()
        if self._actor is not None:
            engine.remove_actor(self._actor, render=False)
        self._points, self._towards = points, towards
        self._actor = point_actor(points, towards, colour)
        engine.add_actor(self._actor, render=False, reset_camera=False)
        camera = engine.camera
        camera.focal_point, camera.position, camera.up = (0.0, 0.0, 0.0), (1.0, -0.75, 0.55), (0.0, 0.0, 1.0)
        self.view_fit()

    def show_marks(self, points: Sequence[Sequence[float]]) -> None:
        """Numbered, mm."""
        self._marks = points
        self._dirty = True

    def view_fit(self) -> None:
        if len(self._points):
            engine = self._open()
            low, high = self._points.min(axis=0), self._points.max(axis=0)
            engine.renderer.ResetCamera(*np.array([low, high]).T.ravel().tolist())
            engine.renderer.ResetCameraClippingRange()
            self._dirty = True

    def point_at(self, x: float, y: float) -> tuple[float, float, float] | None:
        """The foremost point at a pixel that is seen from its front; None beside the cloud."""
        if not len(self._points):
            return None
        view = self._view()
        away = view.project(self._points) - np.array([x, y])
        toward_eye = view.eye - self._points
        there = (np.einsum("ij,ij->i", away, away) < _NEAR_PX**2) & (np.einsum("ij,ij->i", toward_eye, self._towards) > 0)
        near = np.flatnonzero(there)
        if not len(near):
            return None
        a, b, c = self._points[near[np.argmin(-toward_eye[near] @ view.direction)]].tolist()
        return a, b, c

    # -------------------------------------------------------------------------------- the mouse and the keys
    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        kind = event.type()
        if isinstance(event, QMouseEvent) and event.button() == Qt.MouseButton.LeftButton:
            if kind == QEvent.Type.MouseButtonPress:
                self._pressed = event.position()
            elif kind == QEvent.Type.MouseButtonRelease and self._pressed is not None:
                moved = event.position() - self._pressed
                if moved.manhattanLength() <= _CLICK_PX:
                    self._pick(event.position().x(), event.position().y())
        elif isinstance(event, QKeyEvent) and kind == QEvent.Type.KeyPress:
            return self._key(Qt.Key(event.key()))
        elif kind in (QEvent.Type.FocusIn, QEvent.Type.FocusOut):
            self._dirty = True
        return False

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        self._overlay.setGeometry(self.rect())

    def _key(self, key: Qt.Key) -> bool:
        camera = self._open().camera
        turns = {Qt.Key.Key_Left: (-1, 0), Qt.Key.Key_Right: (1, 0), Qt.Key.Key_Up: (0, 1), Qt.Key.Key_Down: (0, -1)}
        if key in turns:
            right, up = turns[key]
            camera.Azimuth(right * _STEP_DEG)
            camera.Elevation(up * _STEP_DEG)
            camera.OrthogonalizeViewUp()
        elif key in (Qt.Key.Key_Plus, Qt.Key.Key_Minus, Qt.Key.Key_Equal):
            camera.Dolly(1 / 1.15 if key == Qt.Key.Key_Minus else 1.15)
        elif key in (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._pick(0.5 * self.width(), 0.5 * self.height())
        else:
            return False
        self._open().renderer.ResetCameraClippingRange()
        self._dirty = True
        return True

    def _pick(self, x: float, y: float) -> None:
        point = self.point_at(x, y)
        if point is not None:
            self.picked.emit(point)

    # -------------------------------------------------------------------------------- drawing
    def _view(self) -> Viewpoint:
        return Viewpoint.of(self._open().camera, 0.0, 0.0, self.width(), self.height())

    def _prepare_picture(self) -> None:
        if self._actor is not None:
            self._actor.GetProperty().SetPointSize(POINT_SIZE * self.devicePixelRatioF())
        places = self._view().project(np.array(self._marks, np.float64)) if len(self._marks) else np.zeros((0, 2))
        self._overlay.points = [QPointF(*place) for place in places]
        above = QPointF(0, -_ABOVE_PX)
        self._overlay.tags = [Tag(str(number), QPointF(*place), QPointF(*place) + above) for number, place in enumerate(places, 1)]
        self._overlay.twin = QPointF(0.5 * self.width(), 0.5 * self.height()) if self._open().hasFocus() else None
        self._overlay.update()
