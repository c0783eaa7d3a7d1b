"""The mouse over the 3D view of a comparison: what is under the pointer, picking, brush, lasso, curtain."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from app.views import format as fmt
from app.views.brush_size import BrushSize
from app.views.comparison_overlay import ComparisonOverlay
from app.views.pointed import Pointed
from app.views.surface_picker import Hit, SurfacePicker
from app.views.viewpoint import Viewpoint

if TYPE_CHECKING:
    from app.views.comparison_scene import ComparisonScene

TOOLS: Final = ("look", "pick", "paint", "erase", "lasso")
_HOVER_MS = 40
_CLICK_PX = 4
_GRIP_PX = 12
_HELD_S = 0.3
"""The space bar pressed for longer than this shows the other surface only while it is down."""


class ComparisonTools(QObject):
    """Sees the engine's mouse events first; what it does not use turns the camera."""

    def __init__(self, scene: ComparisonScene, engine: QWidget, overlay: ComparisonOverlay) -> None:
        super().__init__(scene)
        self._scene, self._engine, self._overlay = scene, engine, overlay
        self._radius_mm = 2.0
        self.brush = BrushSize(scene, self._radius_mm, self._set_radius_mm)
        self._tool = "look"
        self._pressed: QPointF | None = None
        self._drag: str | None = None
        self._last = QPointF()
        self._space_s, self._space_down = 0.0, False
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_HOVER_MS)
        self._timer.timeout.connect(self._hover)
        engine.installEventFilter(self)

    def set_tool(self, tool: str) -> None:
        if tool not in TOOLS:
            raise ValueError(tool)
        self._tool = tool
        self._overlay.brush = None
        self._overlay.lasso = []
        self._overlay.update()
        self.brush.setVisible(tool in ("paint", "erase"))
        self.brush.stand()
        self._engine.setCursor(Qt.CursorShape.ArrowCursor if tool == "look" else Qt.CursorShape.CrossCursor)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        kind = event.type()
        if isinstance(event, QMouseEvent):
            if kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick):
                return self._press(event)
            if kind == QEvent.Type.MouseMove:
                return self._move(event)
            if kind == QEvent.Type.MouseButtonRelease:
                return self._release(event)
        elif isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Space and kind in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
            return self.space(kind == QEvent.Type.KeyPress, repeated=event.isAutoRepeat())
        elif kind == QEvent.Type.Leave:
            self._leave()
        return False

    def space(self, down: bool, *, repeated: bool = False) -> bool:
        """Flicker: a tap shows the other surface, a long press as long as it lasts; elsewhere every press does.  Whether the key was used."""
        if self._scene.mode not in ("flicker", "map", "after", "before"):
            return False
        if repeated or down == self._space_down:
            return True  # also the release of a press that a shortcut of the window took
        self._space_down = down
        now_s = time.perf_counter()
        if down:
            self._space_s = now_s
        if down or self._scene.mode != "flicker" or now_s - self._space_s > _HELD_S:
            self._scene.show_other(not self._scene.shows_other)
        return True

    # -------------------------------------------------------------------------------- mouse
    def _press(self, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton:
            return False
        place = event.position()
        self._pressed = self._last = place
        self._overlay.readout = None
        self._overlay.update()
        rank = self._overlay.tag_at(place)
        if rank is not None:
            self._pressed = None
            self._scene.area_clicked.emit(rank)
            return True
        if self._scene.mode == "curtain" and abs(place.x() - self._scene.curtain_x) <= _GRIP_PX:
            self._drag = "curtain"
        elif self._tool in ("paint", "erase"):
            self._drag = self._tool
            self._stroke(place)
        elif self._tool == "lasso":
            self._drag = "lasso"
            self._overlay.lasso = [place]
        else:
            return False
        return True

    def _move(self, event: QMouseEvent) -> bool:
        place = event.position()
        if self._drag is None:
            if not event.buttons():
                self._last = place
                self._show_brush(place)
                self._show_twin(place)
                if not self._timer.isActive():
                    self._timer.start()
                if self._tool == "look":
                    near = self._scene.mode == "curtain" and abs(place.x() - self._scene.curtain_x) <= _GRIP_PX
                    self._engine.setCursor(Qt.CursorShape.SplitHCursor if near else Qt.CursorShape.ArrowCursor)
            return False
        if self._drag == "curtain":
            amount = min(max(1.0 - place.x() / max(self._scene.width(), 1), 0.0), 1.0)
            self._scene.set_amount(amount)
            self._scene.amount_changed.emit(amount)
        elif self._drag == "lasso":
            self._overlay.lasso.append(place)
            self._overlay.update()
        else:
            self._stroke(place)
            self._show_brush(place)
        self._last = place
        return True

    def _release(self, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton:
            return False
        drag, self._drag = self._drag, None
        pressed, self._pressed = self._pressed, None
        if drag in ("paint", "erase"):
            self._scene.stroke_ended.emit()
        clicked = pressed is not None and (event.position() - pressed).manhattanLength() <= _CLICK_PX
        if drag == "lasso":
            self._close_lasso(clicked)
        if drag in (None, "lasso") and clicked:
            pointed = self.pointed(event.position())
            if pointed is not None:
                self._scene.picked.emit(pointed)
        return drag is not None

    def _leave(self) -> None:
        self._timer.stop()
        self._overlay.brush = self._overlay.readout = self._overlay.twin = None
        self._overlay.update()
        self._scene.hovered.emit(None)

    # -------------------------------------------------------------------------------- tools
    def pointed(self, place: QPointF) -> Pointed | None:
        """What lies under a pixel."""
        found = self._hit(place)
        if found is None:
            return None
        surface, _, hit, _ = found
        values = self._scene.values if surface == "after" else None
        signed = level = None
        if values is not None:
            here = float(values[0][hit.corners] @ hit.weights)
            signed, level = (here if np.isfinite(here) else None), float(values[1][hit.corners] @ hit.weights)
        x, y, z = hit.point.tolist()
        return Pointed(surface, hit.vertex, (x, y, z), signed, level)

    def _hit(self, place: QPointF) -> tuple[str, SurfacePicker, Hit, Viewpoint] | None:
        seen = self._scene.viewpoint(place.x(), place.y())
        picker = None if seen is None else self._scene.picker(seen[0])
        if seen is None or picker is None:
            return None
        hit = picker.hit(*self._scene.ray(seen[1], place.x(), place.y()))
        return None if hit is None else (seen[0], picker, hit, seen[1])

    def _hover(self) -> None:
        if self._scene.closed or self._drag is not None:
            return
        met = self.pointed(self._last)
        self._overlay.readout = (self._last, self._words(met)) if met is not None and self._scene.coloured and met.surface == "after" else None
        self._overlay.update()
        self._scene.hovered.emit(met)

    def _words(self, met: Pointed) -> str:
        """Value and sign, or why there is none."""
        if met.signed_um is None or met.level_um is None:
            return self.tr("no counterpart")
        if abs(met.signed_um) <= met.level_um:
            return self.tr("within ±{mm} mm").format(mm=fmt.decimal(met.level_um / 1000, 2))
        return self.tr("{mm} mm").format(mm=fmt.decimal(met.signed_um / 1000, 2, signed=True))

    def _stroke(self, place: QPointF) -> None:
        """Everything that the brush passes between two events of the mouse."""
        found = self._hit(place)
        pixels = 6.0 if found is None else max(0.5 * self._radius_mm * found[3].pixels_per_mm(found[2].point), 2.0)
        way = place - self._last
        count = max(int(np.hypot(way.x(), way.y()) / pixels), 1)
        covered = []
        for i in range(1, count + 1):
            met = self._hit(self._last + way * (i / count))
            if met is not None and met[0] == "after":
                covered.append(met[1].brush(met[2], self._radius_mm))
        vertices = np.unique(np.concatenate(covered)) if covered else np.zeros(0, np.int64)
        if len(vertices):
            self._scene.painted.emit(vertices, self._drag == "paint")

    def _set_radius_mm(self, radius_mm: float) -> None:
        self._radius_mm = radius_mm

    def _show_brush(self, place: QPointF) -> None:
        if self._tool not in ("paint", "erase"):
            return
        found = self._hit(place)
        met = found is not None and found[0] == "after"
        self._overlay.brush = (place, self._radius_mm * found[3].pixels_per_mm(found[2].point), self._tool == "erase") if found and met else None
        self._overlay.update()

    def _show_twin(self, place: QPointF) -> None:
        """Side by side: the pointer's place in the other picture."""
        half = 0.5 * self._scene.width()
        twin = place + QPointF(half if place.x() < half else -half, 0.0) if self._scene.mode == "side_by_side" else None
        if twin != self._overlay.twin:
            self._overlay.twin = twin
            self._overlay.update()

    def _close_lasso(self, clicked: bool) -> None:
        """What is within; a mere click picks a point instead."""
        path, self._overlay.lasso = self._overlay.lasso, []
        self._overlay.update()
        if clicked:
            return
        middle = path[len(path) // 2]
        seen = self._scene.viewpoint(middle.x(), middle.y())
        picker = self._scene.picker("after")
        if len(path) < 3 or seen is None or picker is None or seen[0] != "after":
            return
        outline = np.array([[p.x(), p.y()] for p in path])
        vertices = picker.lasso(outline, seen[1], self._scene.after_depth(), self._scene.devicePixelRatioF())
        if len(vertices):
            self._scene.lassoed.emit(vertices)
