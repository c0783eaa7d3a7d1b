"""The middle of the window: the 3D view with its header; a calm sentence until the 3D view is there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QAction, QColor, QLinearGradient, QPainter, QPaintEvent
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QStackedLayout, QToolButton, QVBoxLayout, QWidget

from app.theme import look
from app.views.height_colours import HEIGHT, SUPPORTED, UNCERTAINTY, UNSUPPORTED
from app.views.parts import label, seam

if TYPE_CHECKING:
    from app.views.scene_view import SceneView


class Stage(QWidget):
    """Header (title, what is seen, legend, view buttons) over the 3D view."""

    def __init__(self, actions: Sequence[QAction]) -> None:
        super().__init__()
        self.setProperty("role", "ground")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._title = label("", "title")
        self._facts = label("", "muted")
        self._facts.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.legend = Legend()
        head = QWidget()
        head.setProperty("role", "panel")
        head.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        line = QHBoxLayout(head)
        line.setContentsMargins(16, 0, 10, 0)
        line.setSpacing(8)
        line.addWidget(self._title)
        line.addWidget(self._facts, 1)
        line.addWidget(self.legend)
        tools = QHBoxLayout()
        tools.setSpacing(0)
        line.addLayout(tools)
        for action in actions:
            tool = QToolButton()
            tool.setDefaultAction(action)
            tool.setIconSize(QSize(18, 18))
            tool.setAccessibleName(action.text().replace("&", ""))
            tools.addWidget(tool)
        head.setFixedHeight(46)
        waiting = label(self.tr("Preparing the 3D view…"), "muted")
        waiting.setAlignment(Qt.AlignmentFlag.AlignCenter)
        # The first OpenGL widget in a window has its native window made anew, which flickers and loses the focus: have
        # one from the start.
        self._first_of_its_kind = QOpenGLWidget(self)
        self._first_of_its_kind.setFixedSize(1, 1)
        self._first_of_its_kind.hide()
        self._stack = QStackedLayout()
        self._stack.addWidget(waiting)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(head)
        box.addWidget(seam())
        box.addLayout(self._stack, 1)

    def put_scene(self, scene: QWidget) -> None:
        """The 3D view is there."""
        self._stack.addWidget(scene)
        self._stack.setCurrentWidget(scene)

    def show_title(self, title: str) -> None:
        self._title.setText(title)

    def show_facts(self, facts: str) -> None:
        self._facts.setText(facts)


class Legend(QWidget):
    """A colour map with the meaning of its ends; hidden while nothing is coloured."""

    def __init__(self) -> None:
        super().__init__()
        self._stops: tuple[str, ...] = HEIGHT
        self._low = self._high = ""
        self.setFixedSize(160, 34)
        self.hide()

    def show_height(self, low_mm: float, high_mm: float) -> None:
        self._show(HEIGHT, f"{low_mm:.1f}", f"{high_mm:.1f} mm")

    def show_uncertainty(self, low_um: float, high_um: float) -> None:
        self._show(UNCERTAINTY, f"{low_um:.0f}", f"{high_um:.0f} µm")

    def show_support(self, scanned: str, not_scanned: str) -> None:
        """Two colours with their words."""
        self._show((), scanned, not_scanned)

    def show_scene(self, scene: SceneView | None, *, points: bool) -> None:
        """What the 3D view is coloured by; `points` are to be seen in it."""
        if scene is None:
            self.hide()
            return
        bounds, range_um = scene.cloud.bounds_mm, (scene.mesh if scene.aside is None else scene.aside).range_um
        if range_um is not None:
            self.show_uncertainty(*range_um)
        elif scene.aside is not None:
            self.hide()
        elif bounds is not None and points:
            self.show_height(float(bounds[0, 2]), float(bounds[1, 2]))
        elif scene.mesh.surface is not None and not scene.mesh.surface.growing:
            self.show_support(self.tr("scanned"), self.tr("not scanned"))
        else:
            self.hide()

    def _show(self, stops: tuple[str, ...], low: str, high: str) -> None:
        if (stops, low, high) != (self._stops, self._low, self._high) or self.isHidden():
            self._stops, self._low, self._high = stops, low, high
            self.show()
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        font = painter.font()
        font.setPixelSize(11)
        painter.setFont(font)
        if not self._stops:
            for left, colour, word in ((0, SUPPORTED, self._low), (self.width() // 2 - 8, UNSUPPORTED, self._high)):
                painter.fillRect(left, 13, 9, 9, QColor(colour))
                painter.setPen(QColor(look.muted))
                painter.drawText(left + 15, 22, word)
            return
        bar = QRect(0, 7, self.width() - 1, 6)
        fill = QLinearGradient(bar.left(), 0, bar.right(), 0)
        for i, stop in enumerate(self._stops):
            fill.setColorAt(i / (len(self._stops) - 1), QColor(stop))
        painter.fillRect(bar, fill)
        painter.setPen(QColor(look.muted))
        words = self.rect().adjusted(0, 16, -1, 0)
        painter.drawText(words, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop, self._low)
        painter.drawText(words, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop, self._high)
