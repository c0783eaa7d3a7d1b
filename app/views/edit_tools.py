"""The mouse over the 3D view of the Edit page: brush, lasso and box draw on it, a click points; what is not used turns the camera."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent, QResizeEvent

from app.views.brush_size import BrushSize
from app.views.comparison_overlay import ComparisonOverlay
from scanner_core.editing.screen_region import BrushStroke, Outline

if TYPE_CHECKING:
    from app.views.scene_view import SceneView
    from scanner_core.editing.sight import Array

TOOLS: Final = ("look", "brush", "lasso", "box", "point")
_CLICK_PX = 4


class EditTools(QObject):
    """Of one 3D view, while the page is shown."""

    begun = Signal()
    """A person begins to draw."""
    drawn = Signal(object)
    """Outline or BrushStroke, in pixels of the view; of a brush one between every two events of the mouse."""
    ended = Signal()
    pointed = Signal(float, float)
    """A click, in pixels."""

    def __init__(self, scene: SceneView, middle_mm: Array) -> None:
        super().__init__(scene)
        self.scene = scene
        self._middle_mm = middle_mm
        self.overlay = ComparisonOverlay(scene)
        self.overlay.setGeometry(scene.rect())
        self.overlay.show()
        self._radius_mm = 1.5
        self._brush = BrushSize(scene, self._radius_mm, self._set_radius_mm)
        self.tool = "look"
        self._back = False
        self._pressed: QPointF | None = None
        self._last = QPointF()
        self._drawing = False
        scene.lend_mouse(self)
        scene.installEventFilter(self)

    def let_go(self) -> None:
        """Leave the view as it was."""
        self.scene.take_mouse_back(self)
        self.scene.removeEventFilter(self)
        for part in (self.overlay, self._brush):
            part.hide()
            part.deleteLater()

    def set_tool(self, tool: str, *, back: bool = False) -> None:
        """One of ``TOOLS``; `back` brings points back."""
        self.tool, self._back = tool, back
        self._drawing = False
        self.overlay.brush, self.overlay.lasso = None, []
        self.overlay.update()
        self._brush.setVisible(tool == "brush")
        self._brush.stand()
        self.scene.show_cursor(Qt.CursorShape.ArrowCursor if tool == "look" else Qt.CursorShape.CrossCursor)

    def set_middle_mm(self, middle_mm: Array) -> None:
        """Where the brush is as wide as it says, (3,)."""
        self._middle_mm = middle_mm

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        if watched is self.scene:
            if isinstance(event, QResizeEvent):
                self.overlay.setGeometry(self.scene.rect())
                self._brush.stand()
            return False
        kind = event.type()
        if isinstance(event, QMouseEvent) and not self.scene.closed:
            if kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick):
                return self._press(event)
            if kind == QEvent.Type.MouseMove:
                return self._move(event)
            if kind == QEvent.Type.MouseButtonRelease:
                return self._release(event)
        elif kind == QEvent.Type.Leave:
            self.overlay.brush = None
            self.overlay.update()
        return False

    # -------------------------------------------------------------------------------- mouse
    def _press(self, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton:
            return False
        self._pressed = self._last = event.position()
        if self.tool not in ("brush", "lasso", "box"):
            return False
        self._drawing = True
        self.begun.emit()
        if self.tool == "brush":
            self._stroke(event.position())
        else:
            self.overlay.lasso = [event.position()]
        return True

    def _move(self, event: QMouseEvent) -> bool:
        place = event.position()
        if self.tool == "brush":
            self.overlay.brush = (place, self._radius_px(), self._back)
            self.overlay.update()
        if not self._drawing or self._pressed is None:
            return False
        if self.tool == "brush":
            self._stroke(place)
        elif self.tool == "lasso":
            self.overlay.lasso.append(place)
        else:
            start = self._pressed
            self.overlay.lasso = [start, QPointF(place.x(), start.y()), place, QPointF(start.x(), place.y())]
        self.overlay.update()
        return True

    def _release(self, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton:
            return False
        pressed, self._pressed = self._pressed, None
        if not self._drawing:
            if self.tool == "point" and pressed is not None and (event.position() - pressed).manhattanLength() <= _CLICK_PX:
                self.pointed.emit(event.position().x(), event.position().y())
            return False
        self._drawing = False
        path, self.overlay.lasso = self.overlay.lasso, []
        self.overlay.update()
        if self.tool != "brush" and len(path) > 2:
            self.drawn.emit(Outline(_pixels(path)))
        self.ended.emit()
        return True

    def _stroke(self, place: QPointF) -> None:
        self.drawn.emit(BrushStroke(_pixels([self._last, place]), self._radius_px()))
        self._last = place

    def _radius_px(self) -> float:
        return self._radius_mm * self.scene.whole_view().pixels_per_mm(self._middle_mm)

    def _set_radius_mm(self, radius_mm: float) -> None:
        self._radius_mm = radius_mm


def _pixels(path: list[QPointF]) -> Array:
    return np.array([[place.x(), place.y()] for place in path])
