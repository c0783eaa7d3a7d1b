"""The part of the Edit page that measures: a way to measure in hand, and the list of what was measured."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QButtonGroup, QPushButton, QVBoxLayout, QWidget

from app.services import Services
from app.views import format as fmt
from app.views import measure_words
from app.views.length_field import LengthField
from app.views.parts import BigNumber, button, column, label, row, scrolled, seam

if TYPE_CHECKING:
    from scanner_core.geometry.mesh import TriangleMesh
    from scanner_core.measuring.distance import Place
    from scanner_core.measuring.section import SectionSize

Array = NDArray[np.float64]
_NORMALS = {"z": (0.0, 0.0, 1.0), "x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0)}


class MeasurePanel(QWidget):
    """`looks_changed` when other lines are to be drawn."""

    looks_changed = Signal()

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._measurements, self._case = services.measurements, services.case
        self._start: Place | None = None
        self._point: Array | None = None
        self._section: SectionSize | None = None
        self._mesh: TriangleMesh | None = None
        self._able = False
        words = {"distance": self.tr("Distance"), "section": self.tr("Section"), "canal": self.tr("Canal"), "volume": self.tr("Volume")}
        group = QButtonGroup(self)
        self.ways: dict[str, QPushButton] = {}
        for way, text in words.items():
            made = button(text, "choice", partial(self._choose, way))
            made.setCheckable(True)
            group.addButton(made)
            self.ways[way] = made
        self.ways["distance"].setChecked(True)
        self.hint = label("", "muted", wrap=True)
        self._area, self._perimeter = BigNumber(self.tr("mm² area")), BigNumber(self.tr("mm perimeter"))
        across = QButtonGroup(self)
        self.across: dict[str, QPushButton] = {}
        for axis, text in (("z", self.tr("Level")), ("x", self.tr("Across x")), ("y", self.tr("Across y"))):
            made = button(text, "choice", self._turn)
            made.setCheckable(True)
            across.addButton(made)
            self.across[axis] = made
        self.across["z"].setChecked(True)
        self.place = LengthField(self.tr("Place"), self.tr(" mm"), lambda _: self._cut(), decimals=2)
        self.section = QWidget()
        inner = column(row(*self.across.values(), spacing=6), self.place, row(self._area, self._perimeter, spacing=6), spacing=8)
        inner.setContentsMargins(0, 0, 0, 0)
        self.section.setLayout(inner)
        self.do = button("", "primary", self._do)
        self.stop = button(self.tr("Cancel"), "", self._measurements.cancel)
        self._list = QWidget()
        self._rows = QVBoxLayout(self._list)
        self._rows.setContentsMargins(0, 0, 6, 0)
        self._rows.setSpacing(6)
        self.copy = button(self.tr("Copy as text"), "", self._copy)
        pairs = list(self.ways.values())
        box = column(
            row(*pairs[:2], spacing=6),
            row(*pairs[2:], spacing=6),
            self.hint,
            self.section,
            self.do,
            self.stop,
            seam(),
            label(self.tr("Measured"), "section"),
            scrolled(self._list),
            self.copy,
            spacing=8,
        )
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self._measurements.changed.connect(self._show_items)
        self._measurements.cut.connect(self._show_cut)
        self._show_items()

    @property
    def way(self) -> str:
        """What is measured: ``distance``, ``section``, ``canal`` or ``volume``."""
        return next(name for name, made in self.ways.items() if made.isChecked())

    def show_content(self, mesh: TriangleMesh | None, *, able: bool) -> None:
        """What can be measured on: a surface, or with None the points alone; nothing where it is not `able`."""
        if mesh is not self._mesh:
            self._start = self._point = self._section = None
        self._mesh, self._able = mesh, able
        for name, made in self.ways.items():
            made.setEnabled(able and (name == "distance" or mesh is not None))
        if mesh is None and self.way != "distance":
            self.ways["distance"].setChecked(True)
        if self.way == "section" and self._section is None:
            self._begin_section()
        self._show()

    def point(self, place: Place) -> None:
        """A person points at a place."""
        if self.way == "distance":
            start, self._start = self._start, place
            if start is not None:
                self._start = None
                self._measurements.distance(start, place)
        elif self.way == "section":
            self._point = place.point
            self.place.set_value(float(place.point @ self._normal))
            self._cut()
        elif self.way == "canal" and self._mesh is not None:
            self._measurements.canal(self._mesh, place.point)
        self._show()
        self.looks_changed.emit()

    def lines_now(self) -> list[Array]:
        """(k, 3) mm, of what is being measured."""
        if self.way == "section" and self._section is not None:
            return list(self._section.contours)
        if self.way == "distance" and self._start is not None:
            cross = 0.5 * np.array([np.eye(3), -np.eye(3)])
            return [self._start.point + cross[:, axis] for axis in range(3)]
        return []

    # -------------------------------------------------------------------------------- inside
    @property
    def _normal(self) -> Array:
        return np.array(_NORMALS[next(name for name, made in self.across.items() if made.isChecked())])

    def _choose(self, way: str) -> None:
        self._start = None
        if way == "section":
            self._begin_section()
        self._show()
        self.looks_changed.emit()

    def _begin_section(self) -> None:
        """Through the middle of the surface, until a person points at a place."""
        if self._mesh is not None:
            low, high = self._mesh.bounds()
            self._point = 0.5 * (low + high)
            self._turn()

    def _turn(self) -> None:
        if self._mesh is None or self._point is None:
            return
        low, high = (float(end @ self._normal) for end in self._mesh.bounds())
        self.place.set_range(low, high)
        self.place.set_value(float(self._point @ self._normal))
        self._cut()

    def _cut(self) -> None:
        if self._mesh is not None and self._point is not None:
            normal = self._normal
            self._point = self._point + (self.place.value - float(self._point @ normal)) * normal
            self._measurements.section(self._mesh, self._point, normal)

    def _show_cut(self, found: SectionSize | None) -> None:
        self._section = found
        self._show()
        self.looks_changed.emit()

    def _do(self) -> None:
        way, mesh = self.way, self._mesh
        if mesh is None:
            return
        if way == "section" and self._section is not None:
            self._measurements.keep_section(self._section, self._normal)
        elif way == "canal":
            self._measurements.canal(mesh, None)
        elif way == "volume":
            self._measurements.volume(mesh)

    def _show(self) -> None:
        way, mesh, busy = self.way, self._mesh, self._measurements.busy
        self.hint.setText(self._sentence())
        self.section.setVisible(way == "section" and mesh is not None)
        found = self._section
        area = None if found is None else found.area_mm2
        self._area.show_number("–" if area is None else fmt.decimal(area, 1))
        self._perimeter.show_number("–" if found is None else fmt.decimal(found.perimeter_mm, 2))
        words = {"section": self.tr("Keep this section"), "canal": self.tr("Measure the canal"), "volume": self.tr("Measure the volume")}
        self.do.setText(words.get(way, ""))
        self.do.setVisible(way in words and mesh is not None and not busy)
        self.do.setEnabled(way != "section" or found is not None)
        self.stop.setVisible(busy)

    def _sentence(self) -> str:
        if not self._able:
            return self.tr("Scan an object or open a case first.")
        if self._measurements.busy:
            return self.tr("Measuring…")
        if self._measurements.nothing == "canal":
            return self.tr("No canal was found there. Click the tip of the canal on the surface.")
        if self._measurements.nothing == "volume":
            return self.tr("The surface is not closed, so it encloses no volume.")
        if self._mesh is None:
            first = self.tr("Click two points. Sections, canal and volume are measured on the surface: reconstruct it first.")
            return first if self._start is None else self.tr("Click the second place.")
        return {
            "distance": self.tr("Click two places on the surface.") if self._start is None else self.tr("Click the second place."),
            "section": self.tr("Click a place, or move the plane."),
            "canal": self.tr("From the highest point, or click the tip of the canal."),
            "volume": self.tr("What the closed surface encloses."),
        }[self.way]

    def _show_items(self) -> None:
        while self._rows.count():
            taken = self._rows.takeAt(0)
            if taken is not None and (gone := taken.widget()) is not None:
                gone.hide()
                gone.deleteLater()
        items = self._measurements.items
        for number, item in enumerate(items):
            earlier = item.get("mesh") != self._measurements.mesh
            words = measure_words.title(item), measure_words.value(item), self._rest(item, earlier=earlier)
            self._rows.addWidget(_Row(number + 1, *words, self._remover(number)))
        if not items:
            self._rows.addWidget(label(self.tr("Nothing yet."), "faint"))
        self._rows.addStretch(1)
        self.copy.setEnabled(bool(items))
        self._show()
        self.looks_changed.emit()

    def _rest(self, item: Mapping[str, Any], *, earlier: bool) -> str:
        told = measure_words.rest(item)
        return self.tr("{told}. Of another surface than the one that is shown.").format(told=told) if earlier else told

    def _remover(self, number: int) -> QPushButton:
        made = button(self.tr("Remove"), "link", partial(self._measurements.remove, number))
        made.setAccessibleName(self.tr("Remove measurement {n}").format(n=number + 1))
        return made

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText("\n".join(measure_words.line_words(item) for item in self._measurements.items))


class _Row(QWidget):
    """One measurement: what, how much, and what else is known."""

    def __init__(self, number: int, title: str, value: str, rest: str, remove: QPushButton) -> None:
        super().__init__()
        name = label(f"{number}  {title}", "muted")
        told = label(value)
        told.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        box = column(row(name, 1, told, remove, spacing=8), spacing=1)
        if rest:
            box.addWidget(label(rest, "faint", wrap=True))
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.setAccessibleName(f"{title} {value} {rest}")
