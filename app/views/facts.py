"""Names on the left, values on the right, a line each."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from app.views.parts import give_role, label

Fact = tuple[str, str, str]
"""Name, value, and the theme's role of the value."""


class Facts(QWidget):
    """As many lines as there are facts."""

    def __init__(self, facts: Sequence[Fact] = ()) -> None:
        super().__init__()
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setVerticalSpacing(8)
        self._grid.setColumnStretch(0, 1)
        self._lines: list[tuple[QLabel, QLabel]] = []
        self.show_facts(facts)

    def show_facts(self, facts: Sequence[Fact]) -> None:
        """These instead of what stands there."""
        while len(self._lines) < len(facts):
            line = label("", "muted"), label("", selectable=True)
            self._grid.addWidget(line[0], len(self._lines), 0)
            self._grid.addWidget(line[1], len(self._lines), 1, Qt.AlignmentFlag.AlignRight)
            self._lines.append(line)
        for place, (name, value) in enumerate(self._lines):
            used = place < len(facts)
            name.setVisible(used)
            value.setVisible(used)
            if used:
                name.setText(facts[place][0])
                value.setText(facts[place][1])
                give_role(value, facts[place][2])

    @property
    def texts(self) -> dict[str, str]:
        """What stands there, by name."""
        return {name.text(): value.text() for name, value in self._lines if not name.isHidden()}
