"""The part of the Edit page that takes points out: tools for the hand, and what takes many at once."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QCheckBox, QPushButton, QWidget

from app.services import Services
from app.views import format as fmt
from app.views.edit_shapes import BaseShape, CropShape, OutlierShape, Shape
from app.views.parts import BigNumber, button, column, label, row, seam

if TYPE_CHECKING:
    from app.views.edit_aside import EditAside

_KEYS = {"brush": "B", "lasso": "S", "box": "X"}


class PointsPanel(QWidget):
    """`tool_changed` when another tool, or the other direction of it, is in hand; `looks_changed` when the 3D view shall look otherwise."""

    tool_changed = Signal()
    looks_changed = Signal()

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._editing = services.editing
        self._count = BigNumber("")
        words = {"brush": self.tr("Brush"), "lasso": self.tr("Lasso"), "box": self.tr("Box")}
        self.tools: dict[str, QPushButton] = {}
        for tool, text in words.items():
            made = button(text, "choice", partial(self._choose_tool, tool))
            made.setCheckable(True)
            self._bind(made, text, _KEYS[tool], partial(self._toggle_tool, tool))
            self.tools[tool] = made
        self.back = _tick(self.tr("Bring points back instead"))
        self.back.toggled.connect(lambda _: self._changed())
        self.through = _tick(self.tr("Also what lies behind"))
        self.through.setToolTip(self.tr("Otherwise only what is in front, as it is seen, is taken"))
        self.through.toggled.connect(lambda _: self.tool_changed.emit())
        self.out_too = _tick(self.tr("Show what was taken out"))
        self.out_too.toggled.connect(lambda _: self.looks_changed.emit())
        self.shapes: dict[str, Shape] = {"crop": CropShape(self._editing), "base": BaseShape(self._editing), "outliers": OutlierShape(self._editing)}
        names = {"crop": self.tr("Crop"), "base": self.tr("Cut the base"), "outliers": self.tr("Outliers")}
        self.choices: dict[str, QPushButton] = {}
        for name, text in names.items():
            made = button(text, "choice", partial(self._choose_shape, name))
            made.setCheckable(True)
            self.choices[name] = made
            self.shapes[name].shape_changed.connect(self.looks_changed)
            self.shapes[name].hide()
        self.invert = button(self.tr("Invert"), "", self._editing.invert)
        self.invert.setToolTip(self.tr("Take out what is left, and bring back what was taken out"))
        self.all_back = button(self.tr("Bring all back"), "", self._bring_all)
        box = column(
            self._count,
            seam(),
            label(self.tr("On the picture"), "section"),
            row(*self.tools.values(), spacing=6),
            self.through,
            self.back,
            self.out_too,
            seam(),
            label(self.tr("Many at once"), "section"),
            row(self.choices["crop"], self.choices["base"], spacing=6),
            row(self.choices["outliers"], spacing=6),
            *self.shapes.values(),
            row(self.invert, self.all_back, spacing=6),
            1,
            spacing=8,
        )
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self._editing.changed.connect(self.show_state)
        self._editing.loaded.connect(self._renew)
        self.show_state()

    @property
    def tool(self) -> str:
        """In hand: ``look``, ``brush``, ``lasso`` or ``box``."""
        return next((name for name, made in self.tools.items() if made.isChecked()), "look")

    @property
    def shape(self) -> str:
        """What proposes: ``crop``, ``base``, ``outliers`` or nothing."""
        return next((name for name, made in self.choices.items() if made.isChecked()), "")

    def drop_shape(self) -> None:
        """No proposal any more."""
        for name, made in self.choices.items():
            made.setChecked(False)
            self.shapes[name].hide()
        self._editing.cancel()
        self._editing.propose(None)
        self.looks_changed.emit()

    def draw_shape(self, aside: EditAside) -> None:
        """The box or the plane among the points."""
        crop, base = self.shapes["crop"], self.shapes["base"]
        assert isinstance(crop, CropShape)
        assert isinstance(base, BaseShape)
        if self.shape == "crop":
            aside.show_box(crop.box().corners())
        else:
            aside.show_plane(base.corners() if self.shape == "base" else None)

    def show_state(self) -> None:
        editing = self._editing
        there, out = len(editing.out), int(editing.out.sum())
        self._count.show_number(fmt.count(out) if there else fmt.NO_VALUE)
        self._count.show_unit(self.tr("of {n} points taken out").format(n=fmt.count(there)))
        able = editing.able
        for part in (*self.tools.values(), *self.choices.values(), self.through, self.back):
            part.setEnabled(able)
        for part in (self.all_back, self.invert, self.out_too):
            part.setEnabled(able and out > 0)

    # -------------------------------------------------------------------------------- inside
    def _bind(self, part: QPushButton, text: str, key: str, call: object) -> None:
        shortcut = QShortcut(QKeySequence(key), self)
        shortcut.setWhatsThis(text)
        assert callable(call)
        shortcut.activated.connect(lambda: call())
        part.setToolTip(f"{text} ({key})")

    def _toggle_tool(self, tool: str) -> None:
        if self.tools[tool].isEnabled():
            self.tools[tool].toggle()
            self._choose_tool(tool)

    def _choose_tool(self, tool: str) -> None:
        for name, made in self.tools.items():
            made.setChecked(name == tool and made.isChecked())
        if self.tool != "look" and self.shape:
            self.drop_shape()
        self.tool_changed.emit()

    def _choose_shape(self, name: str) -> None:
        on = self.choices[name].isChecked()
        self._editing.propose(None)
        for other, made in self.choices.items():
            made.setChecked(other == name and on)
            self.shapes[other].setVisible(other == name and on)
        if on:
            for made in self.tools.values():
                made.setChecked(False)
            self.tool_changed.emit()
            self.shapes[name].begin()
        else:
            self._editing.cancel()
        self.looks_changed.emit()

    def _changed(self) -> None:
        if self.back.isChecked():
            self.out_too.setChecked(True)
        self.tool_changed.emit()

    def _bring_all(self) -> None:
        self._editing.give(self._editing.out)

    def _renew(self) -> None:
        self.drop_shape()
        self.show_state()


def _tick(text: str) -> QCheckBox:
    made = QCheckBox(text)
    made.setProperty("role", "deliberate")
    return made
