"""Before a person shows the board: what is needed, which length is known, and where the board's face lies."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QButtonGroup, QDoubleSpinBox, QGridLayout, QRadioButton, QVBoxLayout, QWidget

from app.controllers.calibration import ByHand
from app.settings import Settings
from app.views.parts import button, column, label, row, seam


class ByHandPanel(QWidget):
    """Calls `start(by_hand)` or `back()`; what was entered is remembered."""

    def __init__(self, settings: Settings, start: Callable[[ByHand], None], back: Callable[[], None]) -> None:
        super().__init__()
        self._settings, self._start = settings, start
        self.kinds = {
            "bar": QRadioButton(self.tr("Certified length bar")),
            "print": QRadioButton(self.tr("Print measured with a caliper")),
            "none": QRadioButton(self.tr("Neither: the scale stays unverified")),
        }
        group = QButtonGroup(self)
        for made in self.kinds.values():
            group.addButton(made)
        self.bar_mm = _millimetres(10.0, 2000.0, 3, settings.length_mm, self.tr("Certified length of the bar"))
        self.print_mm = _millimetres(20.0, 2000.0, 2, settings.print_width_mm, self.tr("Printed row of squares, outer edge to outer edge"))
        self.thickness_mm = _millimetres(0.0, 100.0, 2, settings.board_thickness_mm, self.tr("Thickness of the board"))
        self.kinds.get(settings.length_kind, self.kinds["bar"]).setChecked(True)
        group.buttonToggled.connect(lambda *_: self._show_fields())
        lengths = QGridLayout()
        lengths.setHorizontalSpacing(18)
        lengths.setVerticalSpacing(8)
        lengths.setColumnStretch(0, 1)
        for line, (name, field) in enumerate((("bar", self.bar_mm), ("print", self.print_mm), ("none", None))):
            lengths.addWidget(self.kinds[name], line, 0)
            if field is not None:
                lengths.addWidget(field, line, 1)
        thick = row(label(self.tr("Thickness of the board"), ""), 1, self.thickness_mm)
        steps = (
            self.tr("1.  Light the board well and evenly; the cameras set their exposure by themselves."),
            self.tr("2.  Hold it into the volume, each time tilted another way and at another place. Rest it until the view is taken."),
            self.tr("3.  With a length bar: hold that likewise, both ends in sight."),
            self.tr("4.  Lay the board on the table and take your hands away: the table turns by itself."),
        )
        self._begin = button(self.tr("Start"), "primary", self._begin_now, "calibrate")
        box = QVBoxLayout(self)
        box.setContentsMargins(36, 34, 36, 24)
        box.setSpacing(0)
        box.addWidget(label(self.tr("Calibrate by hand"), "headline"))
        box.addSpacing(6)
        about = self.tr("You show the printed board to both cameras; it takes about ten minutes. The laser stays off.")
        box.addWidget(label(about, "muted", wrap=True))
        box.addSpacing(18)
        box.addLayout(column(*(label(step, wrap=True) for step in steps), spacing=8))
        box.addSpacing(20)
        box.addWidget(seam())
        box.addSpacing(16)
        box.addWidget(label(self.tr("Known length"), "section"))
        box.addSpacing(10)
        box.addLayout(lengths)
        box.addSpacing(8)
        box.addWidget(label(self.tr("The print: its whole row of squares, from outer edge to outer edge."), "faint", wrap=True))
        box.addSpacing(18)
        box.addLayout(thick)
        box.addSpacing(4)
        box.addWidget(label(self.tr("From the table to the printed face: it places the origin on the table."), "faint", wrap=True))
        box.addStretch(1)
        box.addLayout(row(self._begin, button(self.tr("Back"), "", back), 1))
        self._show_fields()

    def _show_fields(self) -> None:
        self.bar_mm.setEnabled(self.kinds["bar"].isChecked())
        self.print_mm.setEnabled(self.kinds["print"].isChecked())

    def _begin_now(self) -> None:
        settings = self._settings
        settings.length_kind = next(name for name, made in self.kinds.items() if made.isChecked())
        settings.length_mm, settings.print_width_mm = self.bar_mm.value(), self.print_mm.value()
        settings.board_thickness_mm = self.thickness_mm.value()
        bar_mm = settings.length_mm if settings.length_kind == "bar" else None
        print_mm = settings.print_width_mm if settings.length_kind == "print" else None
        self._start(ByHand(bar_mm, print_mm, settings.board_thickness_mm))


def _millimetres(low: float, high: float, decimals: int, value: float, name: str) -> QDoubleSpinBox:
    made = QDoubleSpinBox()
    made.setRange(low, high)
    made.setDecimals(decimals)
    made.setValue(value)
    made.setSuffix(" mm")
    made.setAlignment(Qt.AlignmentFlag.AlignRight)
    made.setMinimumHeight(30)
    made.setMinimumWidth(140)
    made.setAccessibleName(name)
    return made
