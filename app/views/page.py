"""What all pages have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from app.views.parts import label

if TYPE_CHECKING:
    from app.services import Services
    from app.views.aside import Aside
    from app.views.scene_view import SceneView

INSPECTOR_WIDTH = 300


class Page(QWidget):
    """One step of the work.  `wanted(page id)` asks the window for another page."""

    wanted = Signal(str)
    intent = Signal(str)
    """Asks the window for an action of the action table."""
    noted = Signal(str, str)
    """Something worth knowing and what to do, for the banner."""
    aside_changed = Signal()
    """What :meth:`aside` tells is another thing, or looks otherwise."""
    flight = Signal(object, object)
    """Have the camera of the 3D view fly to points (n, 3) mm, seen from a direction (3,)."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.services = services
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)

    def entered(self) -> None:
        """The page is shown from now on."""

    def tick(self) -> None:
        """Called by the pump; takes out what came for this page."""

    def paint_scene(self) -> float:
        """For the pump, of a page with a 3D view of its own: ask for a picture; how many seconds the last one took."""
        return 0.0

    def close_scene(self) -> None:
        """Release the graphics of a 3D view of its own."""

    def aside(self) -> Aside | None:
        """What the 3D view shows beside this page in the place of the case; None for the case.  Called when there is a 3D view."""
        return None

    def meet_scene(self, scene: SceneView) -> None:
        """The page stands beside the 3D view from now on; called whenever it is shown.  What it did to it the page takes back when it is hidden."""

    def facts(self) -> str:
        """What is told beside the title of the 3D view, of what :meth:`aside` shows; empty for the facts of the case."""
        return ""

    def look(self, view: str) -> bool:
        """Turn a 3D view of its own: ``fit``, ``front`` or ``top``; False when there is none."""
        return False

    def focusNextPrevChild(self, forwards: bool) -> bool:  # noqa: N802 - Qt's name
        """Where the keys go on Tab, or when the part that has them is hidden or disabled: then they stay on the page, with none of its parts.

        Qt would give them to the next part in the order, which may be a step in the rail: it would look chosen, and the next Space would go there.
        """
        lost = QApplication.focusWidget()
        if lost is not None and self.isAncestorOf(lost) and (lost.isHidden() or not lost.isEnabled()) and self.isVisible():
            self.setFocus(Qt.FocusReason.OtherFocusReason)
            return True
        return super().focusNextPrevChild(forwards)

    def inspector(self, title: str) -> QVBoxLayout:
        """The layout of a page that stands beside the 3D view."""
        self.setFixedWidth(INSPECTOR_WIDTH)
        box = QVBoxLayout(self)
        box.setContentsMargins(16, 13, 16, 14)
        box.setSpacing(9)
        box.addWidget(label(title, "title"))
        return box


class MakePage(Protocol):
    """The class of a page."""

    def __call__(self, services: Services) -> Page: ...
