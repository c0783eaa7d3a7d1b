"""Every serial port with what answered on it; one that can move the rig is chosen."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtWidgets import QButtonGroup, QRadioButton, QVBoxLayout, QWidget

from app.controllers.assistant_choice import is_virtual
from app.views.assistant_words import port_details, port_state
from app.views.parts import Lamp, column, label
from scanner_core.devices.discovery import PortAnswer, PortState


class PortLine(QWidget):
    """A port, and what answered."""

    def __init__(self, answer: PortAnswer) -> None:
        super().__init__()
        self.answer = answer
        usable = answer.state is PortState.CONTROLLER
        mood, word = port_state(answer)
        virtual = is_virtual(answer.port.url)
        name = self.tr("Virtual controller") if virtual else answer.port.url
        self.choice = QRadioButton(name)
        self.choice.setEnabled(usable)
        lamp = Lamp()
        lamp.show_state(mood, word)
        details = self.tr("Part of the program: to try the assistant without devices.") if virtual else port_details(answer)
        self.details = label(details, "muted", wrap=True, selectable=True)
        description = label(answer.port.description, "faint")
        description.setVisible(bool(answer.port.description) and answer.port.description != "n/a")
        self.details.setVisible(bool(details))
        self.choice.setAccessibleName(", ".join(part for part in (name, answer.port.description, word, details) if part))
        below = column(lamp, description, self.details, spacing=3)
        below.setContentsMargins(24, 0, 0, 0)
        box = column(self.choice, below, spacing=3)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)


class PortList(QWidget):
    """Calls `chosen(url)` for a port that a person chooses."""

    def __init__(self, chosen: Callable[[str], None]) -> None:
        super().__init__()
        self._chosen = chosen
        self._group = QButtonGroup(self)
        self._group.idClicked.connect(lambda number: chosen(self.lines[number].answer.port.url))
        self.lines: list[PortLine] = []
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._box.setSpacing(14)

    def show_ports(self, answers: Sequence[PortAnswer], chosen: str) -> None:
        """All of them; those that stand there already stay."""
        known = [line.answer for line in self.lines]
        if known != list(answers[: len(known)]):
            for line in self.lines:
                self._group.removeButton(line.choice)
                self._box.removeWidget(line)
                line.deleteLater()
            self.lines = []
        for answer in answers[len(self.lines) :]:
            line = PortLine(answer)
            self._group.addButton(line.choice, len(self.lines))
            self._box.addWidget(line)
            self.lines.append(line)
        self._group.setExclusive(False)  # so that none of them can be chosen
        for line in self.lines:
            line.choice.setChecked(line.answer.port.url == chosen)
        self._group.setExclusive(True)
