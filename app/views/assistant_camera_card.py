"""A camera that was found: what it sees, what it is called, how it is, and which side it takes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QPushButton, QVBoxLayout, QWidget

from app.controllers.assistant_choice import VIRTUAL, key_of
from app.palettes import DARK
from app.views.assistant_words import camera_details, camera_name, camera_state
from app.views.parts import Lamp, button, label, row
from scanner_core.devices.found_camera import CameraState, FoundCamera

WIDTH = 196
_HEIGHT = 112
_LIFT = 0.6
"""Gamma that makes a dark picture just visible."""


class Thumbnail(QAbstractButton):
    """A small picture that can be pressed; the word of its side in the corner."""

    def __init__(self) -> None:
        super().__init__()
        self._image: QImage | None = None
        self._pixels: NDArray[np.uint8] | None = None
        self.word = ""
        tints = [round(255 * (value / 255) ** _LIFT) for value in range(256)]
        self._colours = [QColor(t, t, t).rgb() for t in tints]
        self.setFixedSize(WIDTH, _HEIGHT)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        return QSize(WIDTH, _HEIGHT)

    def show_image(self, image: NDArray[np.uint8] | None) -> None:
        """(h, w) uint8, or nothing."""
        self._pixels = None if image is None else np.ascontiguousarray(image)  # kept: QImage does not copy
        self._image = None
        if self._pixels is not None:
            height, width = self._pixels.shape
            self._image = QImage(self._pixels.data, width, height, width, QImage.Format.Format_Indexed8)
            self._image.setColorTable(self._colours)
        self.update()

    @property
    def has_picture(self) -> bool:
        return self._image is not None

    def show_side(self, word: str) -> None:
        """``left``, ``right`` in the window's language, or nothing."""
        self.word = word
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        painter.fillRect(self.rect(), QColor(DARK.ground))
        if self._image is None:
            painter.setPen(QColor(DARK.muted))
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.tr("no picture"))
        else:
            scale = min(self.width() / self._image.width(), self.height() / self._image.height())
            width, height = self._image.width() * scale, self._image.height() * scale
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(QRectF((self.width() - width) / 2, (self.height() - height) / 2, width, height), self._image)
        colour = DARK.text if self.hasFocus() else DARK.accent if self.word else DARK.muted if self.underMouse() and self.isEnabled() else DARK.seam
        painter.setPen(QPen(QColor(colour), 2 if self.word or self.hasFocus() else 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        if self.word:
            font = painter.font()
            font.setBold(True)
            painter.setFont(font)
            box = QRectF(1, 1, painter.fontMetrics().horizontalAdvance(self.word) + 18, 24)
            painter.fillRect(box, QColor(DARK.accent))
            painter.setPen(QColor(DARK.on_accent))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.word)


class CameraCard(QWidget):
    """Calls `pressed(found)` for the picture, `side(found, "left" or "right")` for the buttons below it."""

    def __init__(self, found: FoundCamera, pressed: Callable[[FoundCamera], None], side: Callable[[FoundCamera, str], None]) -> None:
        super().__init__()
        self.found = found
        self.thumbnail = Thumbnail()
        self.thumbnail.show_image(found.thumbnail)
        self.thumbnail.clicked.connect(lambda: pressed(found))
        mood, word = camera_state(found)
        self._state = Lamp()
        self._state.show_state(mood, word)
        self._name = label(camera_name(found))
        self._name.setStyleSheet("font-weight: 600;")
        details = camera_details(found)
        self._details = label(details, "muted", wrap=True, selectable=True)
        self._id = label("", "faint", selectable=True)
        self._id.ensurePolished()
        self._id.setText(self._id.fontMetrics().elidedText(found.id, Qt.TextElideMode.ElideMiddle, WIDTH))  # what tells two alike is at the end
        self._id.setToolTip(found.id)
        self.sides: dict[str, QPushButton] = {}
        words = {"left": self.tr("Left"), "right": self.tr("Right")}
        for name, text in words.items():
            made = button(text, "choice", partial(side, found, name))
            made.setCheckable(True)
            made.setAccessibleName(self.tr("{camera} is the {side} camera").format(camera=camera_name(found), side=text.lower()))
            self.sides[name] = made
        self._words = words
        usable = found.state is CameraState.READY
        self.thumbnail.setEnabled(usable)
        self.thumbnail.setCursor(Qt.CursorShape.PointingHandCursor if usable else Qt.CursorShape.ArrowCursor)
        self.thumbnail.setAccessibleName(", ".join(part for part in (camera_name(found), word, details) if part))
        self.setFixedWidth(WIDTH)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(5)
        box.addWidget(self.thumbnail)
        box.addWidget(self._name)
        box.addWidget(self._state)
        box.addWidget(self._details)
        box.addWidget(self._id)
        self._id.setVisible(bool(found.description) and found.driver != VIRTUAL)
        buttons = QWidget()
        beside = row(*self.sides.values())
        beside.setContentsMargins(0, 3, 0, 0)
        buttons.setLayout(beside)
        buttons.setVisible(usable)
        box.addWidget(buttons)
        box.addStretch(1)

    def show_side(self, side: str) -> None:
        """``left``, ``right`` or nothing."""
        self.thumbnail.show_side(self._words.get(side, ""))
        for name, made in self.sides.items():
            made.setChecked(name == side)

    @property
    def key(self) -> tuple[str, str]:
        return key_of(self.found)
