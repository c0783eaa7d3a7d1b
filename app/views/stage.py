"""The middle of the window: the 3D view with its header; a calm sentence until the 3D view is there."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QStackedLayout, QToolButton, QVBoxLayout, QWidget

from app.views.legend import Legend
from app.views.parts import label, seam


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
