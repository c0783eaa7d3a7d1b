"""What both cameras see: live while nothing is checked, or the pictures of a check."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QGridLayout, QWidget

from app.palettes import DARK
from app.views.assistant_words import picture_name
from app.views.camera_preview import CameraPreview
from app.views.check_names import check_name
from app.views.parts import button, column, label, row
from scanner_core.devices.camera import Frame

if TYPE_CHECKING:
    from scanner_core.commissioning.rig_check import RigCheck

_HIGHEST = 230
_REACH = 9.0


class CheckPicture(CameraPreview):
    """A picture with the spot's place marked; zooms like every preview."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.setMaximumHeight(_HIGHEST)
        self.mark_px: tuple[float, float] | None = None

    def show_picture(self, image: NDArray[np.uint8], mark_px: tuple[float, float] | None, miss: str) -> None:
        """(h, w) uint8, and where the spot was found in it, or a word for that it was not."""
        self.mark_px = mark_px
        self.show_frame(Frame(image, 0, 0.0, ""))
        self._miss = miss

    def _overlay(self, painter: QPainter) -> None:
        if self.mark_px is None or self._image is None:
            return
        target = self._target()
        scale = target.width() / self._image.width()
        at = QPointF(target.left() + (self.mark_px[0] + 0.5) * scale, target.top() + (self.mark_px[1] + 0.5) * scale)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(DARK.accent), 1.6))
        painter.drawEllipse(at, _REACH, _REACH)
        if self._zoom < 3:
            self._lens(painter, self.mark_px, at)


class AssistantPictures(QWidget):
    """Two columns, the left camera and the right one."""

    def __init__(self) -> None:
        super().__init__()
        self._title = label("", "section")
        self.to_live = button(self.tr("Live"), "link", self.show_live)
        self._grid = QGridLayout()
        self._grid.setSpacing(8)
        self._grid.setColumnStretch(0, 1)
        self._grid.setColumnStretch(1, 1)
        self.live = {"left": CheckPicture(self.tr("Camera left")), "right": CheckPicture(self.tr("Camera right"))}
        for place, preview in enumerate(self.live.values()):
            self._grid.addWidget(preview, 0, place)
        self.shown: dict[str, CheckPicture] = {}
        self.check: RigCheck | None = None
        box = column(row(self._title, 1, self.to_live), self._grid, spacing=10)
        box.setAlignment(self._grid, Qt.AlignmentFlag.AlignTop)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_live()

    def show_live(self) -> None:
        """What they see now."""
        self._drop()
        self.check = None
        self._title.setText(self.tr("What the cameras see"))
        self.to_live.hide()
        for preview in self.live.values():
            preview.show()

    def show_check(self, made: RigCheck) -> None:
        """The pictures of a check, a row each kind."""
        self._drop()
        self.check = made
        self._title.setText(check_name(made.check.name))
        self.to_live.show()
        for preview in self.live.values():
            preview.hide()
        kinds: list[str] = []
        for name, image in made.pictures.items():
            side, _, kind = name.partition(" ")
            if kind not in kinds:
                kinds.append(kind)
            picture = CheckPicture(picture_name(side, kind))
            dark = bool(made.spots_px) and kind != "dark" and name not in made.spots_px
            picture.show_picture(image, made.spots_px.get(name), self.tr("no spot") if dark else "")
            self._grid.addWidget(picture, 1 + kinds.index(kind), int(side == "right"))
            self.shown[name] = picture

    def clear_live(self) -> None:
        for preview in self.live.values():
            preview.clear()

    def _drop(self) -> None:
        for picture in self.shown.values():
            self._grid.removeWidget(picture)
            picture.deleteLater()
        self.shown = {}
