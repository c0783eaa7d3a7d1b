"""Three points on two mounts: both clouds side by side, the same three places picked on each in the same order."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from app.controllers.mount_picks import POINTS, Side
from app.graphics_import import import_graphics
from app.services import Services
from app.views.mount_words import mount_colour, mount_title, refusal
from app.views.page import Page
from app.views.parts import button, label, row, seam

if TYPE_CHECKING:
    from app.views.pick_view import PickView
    from scanner_core.case.mount_job import FoundMounts


class PickPage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._mounts, self._picks = services.mounts, services.mount_picks
        self.views: dict[Side, PickView] = {}
        self._preparing = False
        self._shown: tuple[FoundMounts, int] | None = None
        self._titles: dict[Side, object] = {}
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        self.what = label("", wrap=True)
        self.what.setStyleSheet("font-weight: 600;")
        self.state = label("", "muted", wrap=True)
        words = QVBoxLayout()
        words.setSpacing(3)
        words.addWidget(label(self.tr("Pick three points"), "title"))
        words.addWidget(self.what)
        words.addWidget(self.state)
        self.start_again = button(self.tr("Start again"), "", self._picks.start_again)
        self.undo = button(self.tr("Undo"), "", lambda: self.intent.emit("undo"), "undo")
        self.undo.setToolTip(self.tr("Take the last point back (Ctrl+Z)"))
        self.back = button(self.tr("Back"), "", lambda: self.wanted.emit("mounts"))
        head = row(words, self.undo, self.start_again, self.back, spacing=10)
        head.setStretch(0, 1)
        head.setContentsMargins(20, 14, 16, 14)
        box.addLayout(head)
        box.addWidget(seam())
        self._sides = QHBoxLayout()
        self._sides.setSpacing(0)
        self._columns: dict[Side, QVBoxLayout] = {}
        self._names = {"fixed": label("", "section"), "moving": label("", "section")}
        for side in ("fixed", "moving"):
            self._columns[side] = column = QVBoxLayout()
            name = self._names[side]
            name.setContentsMargins(16, 8, 16, 8)
            column.setSpacing(0)
            column.addWidget(name)
            whole = QWidget()
            whole.setLayout(column)
            column.setContentsMargins(0, 0, 0, 0)
            self._sides.addWidget(whole, 1)
            if side == "fixed":
                self._sides.addWidget(seam(upright=True))
        box.addLayout(self._sides, 1)
        self._waiting = label(self.tr("Preparing the 3D view…"), "muted")
        self._waiting.setAlignment(Qt.AlignmentFlag.AlignCenter)
        box.addWidget(self._waiting)
        services.mount_picks.changed.connect(self._show_picks)
        services.mounts.changed.connect(self._show_clouds)
        self._show_picks()

    def entered(self) -> None:
        self._picks.begin()
        if self.views:
            self._show_clouds()
        elif not self._preparing:
            self._preparing = True
            self.services.background.run("import-picking", lambda: import_graphics("app.views.pick_view"), lambda _: self._make_views())
        self._show_picks()

    def paint_scene(self) -> float:
        return max((view.paint() for view in self.views.values() if not view.closed), default=0.0)

    def close_scene(self) -> None:
        for view in self.views.values():
            view.close_scene()

    def look(self, view: str) -> bool:
        for each in self.views.values():
            each.view_fit()
        return True

    # -------------------------------------------------------------------------------- the 3D views
    def _make_views(self) -> None:
        from app.views.pick_view import PickView

        names = {"fixed": self.tr("Points of the mounts that lie together"), "moving": self.tr("Points of the mount to be joined")}
        for side, column in self._columns.items():
            view = self.views[side] = PickView(names[side])
            view.picked.connect(lambda point, side=side: self._picks.pick(side, point))
            column.addWidget(view, 1)
        self._waiting.hide()
        self._show_clouds()
        self.views["fixed"].setFocus()

    def _show_clouds(self) -> None:
        """When they are others than those that are shown; both cameras then stand anew."""
        found, mount = self._mounts.found, self._picks.mount
        if mount is None and self._shown is not None:  # it was joined: there one sees how it lies
            self._shown = None
            if self.isVisible():
                self.wanted.emit("mounts")
        if not self.views or found is None or mount is None or (found, mount) == self._shown:
            self._show_picks()
            return
        joined = [cloud for cloud in found.clouds if cloud.pose is not None]
        moving = self._mounts.cloud(mount)
        if moving is None or not joined:
            return
        same = self._shown is not None and self._shown[1] == mount
        self._shown = (found, mount)
        if same:  # tried again: a person goes on from where the cameras stand
            return
        points = np.concatenate([cloud.pose.apply(cloud.points) for cloud in joined if cloud.pose is not None])
        towards = np.concatenate([cloud.pose.rotate(cloud.towards) for cloud in joined if cloud.pose is not None])
        self.views["fixed"].show_points(points, towards, mount_colour(0))
        self.views["moving"].show_points(moving.points, moving.towards, mount_colour(mount))
        self._names["fixed"].setText(self.tr("Where it is known"))
        self._names["moving"].setText(mount_title(mount))
        self._show_picks()

    # -------------------------------------------------------------------------------- showing
    def _show_picks(self) -> None:
        picks, mounts = self._picks, self._mounts
        fixed, moving = picks.picked
        for side, points in (("fixed", fixed), ("moving", moving)):
            if side in self.views:
                self.views[side].show_marks(points)
        self.what.setText(self._task(len(fixed), len(moving)))
        refused = mounts.refused
        self.state.setText("" if refused is None or mounts.running else refusal(refused))
        self.state.setVisible(bool(self.state.text()))
        for made in (self.undo, self.start_again):
            made.setEnabled(bool(fixed or moving) and not mounts.running)

    def _task(self, fixed: int, moving: int) -> str:
        if self._mounts.running:
            return self.tr("Looking whether the mounts fit from there…")
        if self._picks.mount is None:
            return self.tr("All mounts lie together; there is nothing to pick.")
        if fixed == moving == POINTS:
            return self.tr("It did not fit from these points. Take the last one back, or start again with places that you are sure of.")
        if moving < fixed:
            return self.tr("Now click the same place {n} on the right.").format(n=moving + 1)
        where = self.tr("Click place {n} of three on the left, then the same place on the right; far from each other and easy to tell.")
        return where.format(n=fixed + 1)
