"""What is held fixed, how well that holds, and what another choice would have said."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QPushButton, QWidget

from app.services import Services
from app.views import format as fmt
from app.views.comparison_words import FRAMES, METHODS, fine_millimetres, frame_words, millimetres, translated
from app.views.facts import Fact, Facts
from app.views.parts import button, column, label, row, seam
from app.views.remarks import Remarks
from scanner_core.comparison.alignment import Alignment, FrameShift
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import Frame

if TYPE_CHECKING:
    from scanner_core.comparison.arch_frame import ArchFrame

Region = tuple[str, float]


class AlignmentPanel(QWidget):
    """One of the three panels beside the picture."""

    tool_wanted = Signal(str)
    """``paint``, ``erase``, or ``look`` for none."""
    stable_wanted = Signal(bool)
    """Whether the stable region is to be seen."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self._alignment: Alignment | None = None
        self.frame = QComboBox()
        self.frame.setAccessibleName(self.tr("Held fixed"))
        for frame in Frame:
            self.frame.addItem(frame_words(frame), frame)
        self.frame.activated.connect(lambda _: self._choose_frame(self.frame.currentData()))
        self._about = label("", "faint", wrap=True)
        self.stable = QCheckBox(self.tr("Show the stable region"))
        self.stable.toggled.connect(self.stable_wanted)
        self._tools: dict[str, QPushButton] = {}
        for name, text in (("paint", self.tr("Paint stable")), ("erase", self.tr("Erase"))):
            made = button(text, "choice", partial(self._choose_tool, name))
            made.setCheckable(True)
            self._tools[name] = made
        self.points = button(self.tr("Pick three points on each…"), "link", services.comparing.points.begin)
        self._shifts = label("", "", wrap=True)
        self._facts = Facts()
        self._doubts = Remarks()
        caption = label(self.tr("Held fixed"), "section")
        caption.setBuddy(self.frame)
        box = column(caption, self.frame, self._about, self.stable, row(*self._tools.values(), spacing=6), self.points, seam(), spacing=8)
        for shown in (self._facts, self._shifts, self._doubts):
            box.addWidget(shown)
        box.addStretch(1)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_comparison(None)

    def show_tool(self, tool: str) -> None:
        """The tool that is in hand."""
        for name, made in self._tools.items():
            made.setChecked(name == tool)

    def show_choice(self) -> None:
        """What a person has chosen to be held fixed."""
        choice = self._services.comparing.draft.choice
        self.frame.setCurrentIndex(self.frame.findData(choice.frame))
        self._about.setText(translated(FRAMES[choice.frame][1]))
        picking, answered = self._services.comparing.points.active, self._services.comparing.answers.comparison is not None
        self.points.setEnabled(choice.before is not None and choice.after is not None and not picking)
        for tool in (self.stable, *self._tools.values()):
            tool.setEnabled(answered and not picking)

    def show_comparison(self, comparison: Comparison | None) -> None:
        """The numbers of the answer that is there."""
        self.show_choice()
        for shown in (self._facts, self._shifts):
            shown.setVisible(comparison is not None)
        if comparison is None:
            self._alignment = None
            self._doubts.show_doubts(())
            return
        if comparison.alignment is self._alignment:  # in other terms only
            return
        self._alignment = comparison.alignment
        alignment = comparison.alignment
        method = METHODS.get(alignment.method)
        scale, scale_u = 100 * (alignment.scale_ratio - 1), 200 * alignment.scale_ratio_uncertainty
        estimated = alignment.frame is not Frame.GIVEN  # where nothing was fitted nothing is known of what a fit would be worth
        uncertainty = self.tr("± {n} mm (k = 2)").format(n=fine_millimetres(2 * alignment.uncertainty_um)) if estimated else self.tr("not estimated")
        facts: list[Fact] = [
            (self.tr("Held fixed"), frame_words(alignment.frame), ""),
            (self.tr("Stable share"), self.tr("{n} %").format(n=fmt.percent(alignment.stable_area_fraction)), ""),
            (self.tr("Residual there"), self.tr("{n} mm rms").format(n=fine_millimetres(alignment.rms_um)), ""),
            (self.tr("Uncertainty"), uncertainty, ""),
            (self.tr("Noise of a distance"), self.tr("{n} mm").format(n=fine_millimetres(alignment.noise_um)), ""),
            (self.tr("Size, after to before"), f"{_signed(scale)} ± {fmt.decimal(scale_u, 2)} %", ""),
            (self.tr("With a counterpart"), self.tr("{n} %").format(n=fmt.percent(alignment.overlap)), ""),
            (self.tr("Start found by"), translated(method) if method else alignment.method, ""),
        ]
        self._facts.show_facts(facts)
        self._shifts.setText("")
        before = self._services.comparing.draft.choice.before
        work = partial(_regions, comparison, None if before is None else before.arch)
        self._services.background.run("shifted-regions", work, partial(self._show_shifts, alignment))
        self._doubts.show_doubts((*alignment.doubts, *comparison.pair))

    @property
    def texts(self) -> dict[str, str]:
        return self._facts.texts | {"shifts": self._shifts.text(), "doubts": self._doubts.text}

    def _show_shifts(self, alignment: Alignment, regions: list[Region | None]) -> None:
        """What other frames would have said."""
        if alignment is self._alignment:
            words = [self._shift_words(shift, region) for shift, region in zip(alignment.shifts, regions, strict=True)]
            self._shifts.setText("\n".join(words))

    def _shift_words(self, shift: FrameShift, region: Region | None) -> str:
        if region is None:
            return self.tr("{frame} instead would shift everything by {rms} mm on average, {most} mm at most.").format(
                frame=frame_words(shift.frame), rms=millimetres(shift.rms_um), most=millimetres(shift.max_um)
            )
        words = (
            self.tr("{frame} instead would shift the molars by {n} mm.")
            if region[0] == "molars"
            else self.tr("{frame} instead would shift the front teeth by {n} mm.")
        )
        return words.format(frame=frame_words(shift.frame), n=millimetres(region[1]))

    def _choose_frame(self, frame: Frame) -> None:
        comparing = self._services.comparing
        if frame is Frame.MASK and comparing.draft.choice.mask is None and comparing.answers.comparison is not None:
            # What was found is the painting to begin with.
            comparing.draft.edit("frame", frame=frame, mask=comparing.answers.comparison.alignment.stable.copy())
        else:
            comparing.draft.edit("frame", frame=frame)

    def _choose_tool(self, name: str) -> None:
        self.tool_wanted.emit(name if self._tools[name].isChecked() else "look")


def _regions(comparison: Comparison, arch: ArchFrame | None) -> list[Region | None]:
    """By shift: the teeth that it moves most, and how far; None where that is everything alike."""
    from scanner_core.comparison.shifted_region import shifted_region

    points = comparison.alignment.transform.apply(comparison.after.mesh.vertices)
    return [None if arch is None else shifted_region(shift, points, arch) for shift in comparison.alignment.shifts]


def _signed(percents: float) -> str:
    """+0.12, −0.12; nothing has no sign."""
    return fmt.decimal(percents, 2, signed=True)
