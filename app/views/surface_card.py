"""One of the two surfaces: its name, its size, the unit of its numbers, and what was noticed about it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QComboBox, QFrame, QToolButton

from app.comparison_draft import LoadedSurface
from app.theme import icon
from app.views import format as fmt
from app.views.facts import Fact, Facts
from app.views.parts import button, column, label, row
from app.views.remarks import Remarks

UNITS = ("mm", "cm", "m", "inch")


class SurfaceCard(QFrame):
    """Calls `replace()`, `remove()`, `unit(name)`, and `stop()` while a file is read."""

    def __init__(
        self,
        title: str,
        *,
        replace: Callable[[], None],
        remove: Callable[[], None],
        unit: Callable[[str], None],
        stop: Callable[[], None],
    ) -> None:
        super().__init__()
        self._name = label("", wrap=True, selectable=True)
        self._name.setStyleSheet("font-weight: 600;")
        self._replace = button("", "link", replace)
        self.stop = button(self.tr("Cancel"), "link", stop)
        self._remove = QToolButton()
        self._remove.setIcon(icon("cross", "muted"))
        self._remove.setToolTip(self.tr("Take this surface out"))
        self._remove.setAccessibleName(self.tr("Take this surface out"))
        self._remove.clicked.connect(lambda: remove())
        self._facts = Facts()
        self._unit_title = label(self.tr("Unit of the file"), "muted")
        self.unit = QComboBox()
        for name in UNITS:
            self.unit.addItem(self._unit_word(name), name)
        self.unit.setAccessibleName(self.tr("Unit of the file"))
        self.unit.setFixedWidth(120)
        self.unit.activated.connect(lambda _: unit(str(self.unit.currentData())))
        self._unit_title.setBuddy(self.unit)
        self._reason = label("", "faint", wrap=True)
        self._doubts = Remarks()
        head = row(label(title, "section"), 1, self.stop, self._replace, self._remove, spacing=8)
        box = column(head, self._name, self._facts, row(self._unit_title, 1, self.unit), self._reason, self._doubts, spacing=5)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_surface(None, None)

    def show_surface(self, loaded: LoadedSurface | None, reading: str | None) -> None:
        """What was read, what is being read, or neither."""
        there = loaded is not None and reading is None
        for part in (self._remove, self._facts, self._unit_title, self.unit):
            part.setVisible(there)
        self.stop.setVisible(reading is not None)
        self._replace.setVisible(reading is None)
        self._replace.setText(self.tr("Choose…") if loaded is None else self.tr("Replace…"))
        if loaded is None or reading is not None:
            self._name.setText(self.tr("Reading {name}…").format(name=reading) if reading else self.tr("none yet"))
            self._reason.hide()
            self._doubts.show_doubts(())
            return
        surface = loaded.surface
        self._name.setText(surface.name)
        self._name.setToolTip(str(loaded.path or ""))
        low, high = surface.mesh.bounds()
        size = " × ".join(fmt.decimal(length, 1) for length in high - low)
        facts: list[Fact] = [
            (self.tr("Triangles"), fmt.count(len(surface.mesh.triangles)), ""),
            (self.tr("Size"), self.tr("{size} mm").format(size=size), ""),
        ]
        date = surface.origin.get("date")
        if date:
            facts.insert(0, (self.tr("Date"), fmt.day(str(date)), ""))
        self._facts.show_facts(facts)
        self.unit.setCurrentIndex(self.unit.findData(surface.unit))
        self.unit.setEnabled(loaded.path is not None)
        self._reason.setText(self.tr("as you said") if loaded.unit is not None else surface.unit_reason)
        self._reason.show()
        self._doubts.show_doubts(surface.doubts)

    def _unit_word(self, name: str) -> str:
        return {"mm": self.tr("millimetres"), "cm": self.tr("centimetres"), "m": self.tr("metres"), "inch": self.tr("inches")}[name]

    @property
    def doubts(self) -> str:
        return self._doubts.text
