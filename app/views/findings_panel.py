"""Where it differs and by how much: the ranked areas, the marked tooth, the statistics."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDoubleSpinBox, QPushButton, QStackedWidget, QWidget

from app.services import Services
from app.views import format as fmt
from app.views.area_list import AreaList
from app.views.comparison_words import JAWS, fine_millimetres, millimetres, motion_words, translated
from app.views.facts import Fact, Facts
from app.views.parts import BigNumber, button, column, give_role, label, row, scrolled, seam
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import Jaw


class FindingsPanel(QWidget):
    """One of the three panels beside the picture."""

    tool_wanted = Signal(str)
    """``tooth``, ``lasso_add``, ``lasso_remove``, or ``look`` for none."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self._count = BigNumber(self.tr("areas"))
        self._level = BigNumber(self.tr("mm detectable"))
        self._above = BigNumber("")
        self.areas = AreaList()
        self._none = label("", "muted", wrap=True)
        self._facts = Facts()
        self._below = QStackedWidget()
        self._below.addWidget(self.areas)
        self._below.addWidget(scrolled(self._facts))
        self._views: list[QPushButton] = []
        for place, text in enumerate((self.tr("Areas"), self.tr("Numbers"))):
            made = button(text, "link", partial(self._turn, place))
            self._views.append(made)
        self._jaws: dict[Jaw, QPushButton] = {}
        for jaw, word in JAWS.items():
            choice = button(translated(word), "choice", partial(self._say_jaw, jaw))
            choice.setCheckable(True)
            self._jaws[jaw] = choice
        self._jaw_words = label(self.tr("Which jaw?"), "muted")
        self.threshold = QDoubleSpinBox()
        self.threshold.setRange(0.02, 5.0)
        self.threshold.setSingleStep(0.05)
        self.threshold.setDecimals(2)
        self.threshold.setSuffix(self.tr(" mm"))
        self.threshold.setKeyboardTracking(False)
        self.threshold.setMinimumHeight(30)
        self.threshold.setFixedWidth(120)
        self.threshold.setAccessibleName(self.tr("Threshold"))
        self.threshold.setToolTip(self.tr("From which change on it matters: the line on the map"))
        self.threshold.valueChanged.connect(lambda value: services.comparing.draft.edit("threshold", tolerance_um=round(1000 * value)))
        self.tooth = button(self.tr("Mark a tooth"), "choice", self._mark)
        self.tooth.setCheckable(True)
        self.tooth.setToolTip(self.tr("Click it: the mark grows to its edge, and its motion is told"))
        self._lassos: dict[str, QPushButton] = {}
        for name, text in (("lasso_add", self.tr("Add")), ("lasso_remove", self.tr("Take off"))):
            made = button(text, "choice", partial(self._lasso, name))
            made.setCheckable(True)
            self._lassos[name] = made
        self._unmark = button(self.tr("Remove the mark"), "link", services.comparing.tooth.unmark)
        self._motion = label("", "", wrap=True, selectable=True)
        self._motion.setStyleSheet("font-weight: 600;")
        threshold = label(self.tr("Threshold"), "muted")
        threshold.setBuddy(self.threshold)
        box = column(
            row(self._count, self._above, self._level, spacing=6),
            row(*self._views, 1, spacing=16),
            self._none,
            spacing=8,
        )
        box.addWidget(self._below, 1)
        for part in (
            seam(),
            row(self._jaw_words, 1, *self._jaws.values(), spacing=6),
            row(threshold, 1, self.threshold),
            row(self.tooth, *self._lassos.values(), 1, self._unmark, spacing=6),
        ):
            box.addWidget(part) if isinstance(part, QWidget) else box.addLayout(part)
        box.addWidget(self._motion)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self._turn(0)
        self.show_comparison(None)

    def show_comparison(self, comparison: Comparison | None) -> None:
        """An answer, or none."""
        self.show_choice()
        self.areas.show_areas(() if comparison is None else comparison.areas)
        self._none.setVisible(comparison is not None and not comparison.areas)
        if comparison is None:
            for number in (self._count, self._level, self._above):
                number.show_number(fmt.NO_VALUE)
            self._above.show_unit(self.tr("mm² above threshold"))
            self._facts.show_facts(())
            return
        from scanner_core.comparison.area_bar import AreaBar

        bar = AreaBar.of(comparison.deviation)
        words = self.tr("No area of {area} mm² or more differs by more than {n} mm (smoothed). The map shows smaller differences.")
        self._none.setText(words.format(area=f"{bar.extent_mm2:g}", n=millimetres(bar.deviation_um)))
        found = comparison.deviation.statistics
        self._count.show_number(str(len(comparison.areas)))
        threshold_um = comparison.parameters.tolerance_um
        above_mm2 = found.area_above_mm2.get(str(round(threshold_um)))
        self._level.show_number(fine_millimetres(comparison.deviation.detection_level_um))
        self._above.show_number(fmt.NO_VALUE if above_mm2 is None else f"{above_mm2:.0f}")
        self._above.show_unit(self.tr("mm² above {n} mm").format(n=millimetres(threshold_um)))
        self._facts.show_facts(self._numbers(comparison))

    def show_choice(self) -> None:
        """Jaw and threshold as they were said, and the marked tooth."""
        comparing = self._services.comparing
        choice = comparing.draft.choice
        for jaw, made in self._jaws.items():
            made.setChecked(jaw is choice.jaw)
        self.threshold.blockSignals(True)
        self.threshold.setValue(choice.tolerance_um / 1000)
        self.threshold.blockSignals(False)
        self.tooth.setEnabled(comparing.answers.comparison is not None and not comparing.points.active)
        marked = choice.tooth is not None
        for part in (*self._lassos.values(), self._unmark):
            part.setVisible(marked)
        motion = comparing.tooth.motion
        self._motion.setText(motion_words(motion) if motion is not None else comparing.tooth.words)
        self._motion.setVisible(bool(self._motion.text()))

    def show_tool(self, tool: str) -> None:
        """The tool that is in hand."""
        self.tooth.setChecked(tool == "tooth")
        for name, made in self._lassos.items():
            made.setChecked(name == tool)

    @property
    def texts(self) -> dict[str, str]:
        return self._facts.texts | {"motion": self._motion.text(), "count": self._count.text}

    # -------------------------------------------------------------------------------- inside
    def _numbers(self, comparison: Comparison) -> list[Fact]:
        found = comparison.deviation.statistics
        lengths: list[tuple[str, float | None]] = [
            (self.tr("Mean, signed"), found.mean_um),
            (self.tr("rms"), found.rms_um),
            (self.tr("Half below"), found.p50_um),
            (self.tr("95 % below"), found.p95_um),
            (self.tr("99 % below"), found.p99_um),
            (self.tr("Greatest"), found.max_um),
            (self.tr("Hausdorff of counterparts, after to before"), found.hausdorff_after_to_before_um),
            (self.tr("Hausdorff of counterparts, before to after"), found.hausdorff_before_to_after_um),
        ]
        levels: list[tuple[str, float | None]] = [
            (self.tr("Detection level here"), comparison.deviation.detection_level_um),
            (self.tr("Detection level of the rig"), comparison.null_level_um),
        ]
        facts: list[Fact] = [
            (name, self.tr("{n} mm").format(n=millimetres(value, signed=place == 0)), "")
            for place, (name, value) in enumerate(lengths)
            if value is not None
        ]
        facts += [(name, self.tr("{n} mm").format(n=fine_millimetres(value)), "") for name, value in levels if value is not None]
        facts += [
            (self.tr("Above {n} mm").format(n=millimetres(float(level))), self.tr("{n} mm²").format(n=f"{area:.0f}"), "")
            for level, area in sorted(found.area_above_mm2.items(), key=lambda entry: float(entry[0]))
        ]
        facts.append((self.tr("Without counterpart"), self.tr("{n} %").format(n=fmt.percent(found.no_counterpart_fraction)), ""))
        return facts

    def _turn(self, place: int) -> None:
        self._below.setCurrentIndex(place)
        for number, made in enumerate(self._views):
            give_role(made, "link" if number == place else "quiet-link")

    def _say_jaw(self, jaw: Jaw) -> None:
        self._services.comparing.draft.edit("jaw", jaw=jaw)
        self.show_choice()

    def _mark(self) -> None:
        self.tool_wanted.emit("tooth" if self.tooth.isChecked() else "look")

    def _lasso(self, name: str) -> None:
        self.tool_wanted.emit(name if self._lassos[name].isChecked() else "look")
