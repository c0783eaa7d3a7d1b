"""Moves beam and table by hand, step by step, while both cameras look."""

from __future__ import annotations

from functools import partial

from PySide6.QtWidgets import QButtonGroup, QGridLayout, QPushButton, QVBoxLayout, QWidget

from app.controllers.assistant import AssistantController
from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.views.parts import button, label, row

STEPS_DEG = (0.2, 1.0, 5.0, 30.0)


class JogPanel(QWidget):
    """Six arrows, the size of a step, and the spot's switch."""

    def __init__(self, assistant: AssistantController) -> None:
        super().__init__()
        self._assistant = assistant
        self.step_deg = STEPS_DEG[1]
        words = {
            ("x", 1): (self.tr("Beam left"), "←"),
            ("x", -1): (self.tr("Beam right"), "→"),
            ("y", 1): (self.tr("Beam up"), "↑"),
            ("y", -1): (self.tr("Beam down"), "↓"),
            ("table", 1): (self.tr("Table counter-clockwise"), "↺"),
            ("table", -1): (self.tr("Table clockwise"), "↻"),
        }
        self.arrows: dict[tuple[str, int], QPushButton] = {}
        for (axis, sign), (name, sign_text) in words.items():
            made = button(sign_text, "", partial(self._move, axis, sign))
            made.setAccessibleName(name)
            made.setToolTip(name)
            made.setFixedSize(46, 36)
            self.arrows[axis, sign] = made
        cross = QGridLayout()
        cross.setSpacing(4)
        for (axis, sign), place in {("y", 1): (0, 1), ("x", 1): (1, 0), ("x", -1): (1, 2), ("y", -1): (2, 1)}.items():
            cross.addWidget(self.arrows[axis, sign], *place)
        self.steps: dict[float, QPushButton] = {}
        group = QButtonGroup(self)
        for step in STEPS_DEG:
            made = button(f"{step:g}°", "choice", partial(self._choose, step))
            made.setCheckable(True)
            made.setChecked(step == self.step_deg)
            made.setAccessibleName(self.tr("Steps of {n} degrees").format(n=f"{step:g}"))
            group.addButton(made)
            self.steps[step] = made
        self.spot = button(self.tr("Show the spot"), "choice", self._light)
        self.spot.setCheckable(True)
        self.stop = button(self.tr("Stop moving"), "", assistant.hand.cancel)
        side = QVBoxLayout()
        side.setSpacing(8)
        side.addLayout(row(*self.steps.values(), 1, spacing=4))
        side.addLayout(row(label(self.tr("Table"), "muted"), self.arrows["table", 1], self.arrows["table", -1], 1))
        side.addLayout(row(self.spot, self.stop, 1))
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(10)
        box.addWidget(label(self.tr("By hand"), "section"))
        line = row(cross, side, spacing=22)
        line.setStretch(1, 1)
        box.addLayout(line)

    def show_snapshot(self, snapshot: AssistantSnapshot) -> None:
        """Whether there is anything to move."""
        free = snapshot.opened and snapshot.running is Job.NONE
        for part in (*self.arrows.values(), self.spot, self.stop):
            part.setEnabled(free)
        if not free or not self._assistant.hand.spot_wanted:
            self.spot.setChecked(False)

    def _choose(self, step_deg: float) -> None:
        self.step_deg = step_deg

    def _move(self, axis: str, sign: int) -> None:
        self._assistant.hand.jog(**{f"{axis}_deg": sign * self.step_deg})

    def _light(self) -> None:
        self._assistant.hand.light(self.spot.isChecked())
