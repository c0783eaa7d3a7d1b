"""What a person asks of a reconstruction: one slider, and behind "Expert" everything else, each undone like any edit."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QCheckBox, QGridLayout, QSlider, QSpinBox, QVBoxLayout, QWidget

from app.draft import Draft, DraftValues
from app.views.parts import button, label, number_field, row
from app.views.reconstruction_words import wish_words
from scanner_core.reconstruction.forecast import Carried
from scanner_core.reconstruction.limits import PASS_BAND, SMOOTHING_ROUNDS, SUPPORT

COARSEST, FINEST = -2, 2
"""Of the slider, in doublings of the triangles."""
NAMES = ("detail", "triangles", "tolerance_um", "smoothing", "pass_band_percent", "support_percent", "open_base", "seed")
_FIELD = 118
_DEFAULT = DraftValues()


class ReconstructionWishes(QWidget):
    """Follows the draft."""

    def __init__(self, draft: Draft) -> None:
        super().__init__()
        self._draft = draft
        self._carried: Carried | None = None
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(COARSEST, FINEST)
        self.slider.setPageStep(1)
        self.slider.setTickPosition(QSlider.TickPosition.TicksBelow)
        self.slider.setTickInterval(1)
        self.slider.setAccessibleName(self.tr("Detail"))
        self.slider.setToolTip(self.tr("The middle is the default: as many triangles as the points carry. Each step halves or doubles them."))
        self.slider.valueChanged.connect(lambda value: draft.edit("detail", value))
        self.words = label("", "muted", wrap=True)
        self.words.setMinimumHeight(36)  # two lines: nothing below it moves with the slider
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.unfold = button(self.tr("Expert…"), "link", self._toggle)
        self.expert = _ExpertFields(draft)
        self.expert.hide()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(4)
        box.addWidget(label(self.tr("Detail"), "section"))
        box.addWidget(self.slider)
        box.addLayout(row(label(self.tr("coarse"), "faint"), 1, label(self.tr("default"), "faint"), 1, label(self.tr("fine"), "faint")))
        box.addWidget(self.words)
        box.addWidget(self.unfold, alignment=Qt.AlignmentFlag.AlignLeft)
        box.addWidget(self.expert)
        draft.changed.connect(self._show)
        self._show()

    def show_carried(self, carried: Carried | None) -> None:
        """What the points give; None when there are none."""
        self._carried = carried
        self._show()

    def _toggle(self) -> None:
        folded = self.expert.isHidden()
        self.expert.setVisible(folded)
        self.unfold.setText(self.tr("Hide expert settings") if folded else self.tr("Expert…"))

    def _show(self, name: str = "") -> None:
        if name and name not in NAMES:
            return
        values = self._draft.values
        self.slider.blockSignals(True)
        self.slider.setValue(values.detail)
        self.slider.blockSignals(False)
        self.slider.setEnabled(not (values.triangles or values.tolerance_um))
        self.words.setText(wish_words(values, self._carried))
        self.slider.setAccessibleDescription(self.words.text())


class _ExpertFields(QWidget):
    """One line a parameter; what is not the default stands in bold."""

    def __init__(self, draft: Draft) -> None:
        super().__init__()
        self._draft = draft
        self._fields: dict[str, QSpinBox] = {
            "triangles": number_field(0, 2_000_000, 1000, self._edit("triangles"), special=self.tr("by detail")),
            "tolerance_um": number_field(0, 1000, 5, self._edit("tolerance_um"), suffix=" µm", special=self.tr("none")),
            "smoothing": number_field(*SMOOTHING_ROUNDS, 1, self._edit("smoothing"), special=self.tr("none")),
            "pass_band_percent": number_field(*_percent(PASS_BAND), 1, self._edit("pass_band_percent"), suffix=" %"),
            "support_percent": number_field(*_percent(SUPPORT), 5, self._edit("support_percent"), suffix=" %"),
            "seed": number_field(0, 999_999, 1, self._edit("seed")),
        }
        words = {
            "triangles": (self.tr("Triangles, at most"), self.tr("Goes before the slider.")),
            "tolerance_um": (
                self.tr("Tolerance"),
                self.tr("As many triangles as it takes that 95 of 100 facets keep this tolerance; goes before the number of triangles."),
            ),
            "smoothing": (
                self.tr("Smoothing rounds"),
                self.tr("Rounds of Taubin's filter in the last phase. Default 3; many of them inflate the surface."),
            ),
            "pass_band_percent": (self.tr("Pass-band"), self.tr("Waves longer than this share of the highest spatial frequency stay. Default 10 %.")),
            "support_percent": (
                self.tr("Support from"),
                self.tr(
                    "Density of the points, of that which they have among themselves, from which on the surface counts as measured. Default 45 %."
                ),
            ),
            "seed": (self.tr("Seed"), self.tr("Of every random choice: the same points and seed give the same surface. Default 0.")),
        }
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 2, 0, 0)
        grid.setVerticalSpacing(5)
        grid.setColumnStretch(0, 1)
        self._captions = {}
        for line, (name, field) in enumerate(self._fields.items()):
            caption = self._captions[name] = label(words[name][0], "muted")
            caption.setBuddy(field)
            field.setFixedWidth(_FIELD)
            field.setAccessibleName(words[name][0])
            for part in (caption, field):
                part.setToolTip(words[name][1])
            grid.addWidget(caption, line, 0)
            grid.addWidget(field, line, 1)
        self._open = QCheckBox(self.tr("Leave open what was not scanned"))
        self._open.setToolTip(self.tr("Without it the surface is closed, as printing needs it; what is bridged is marked as not scanned."))
        self._open.toggled.connect(lambda on: draft.edit("open_base", on))
        self.back = button(self.tr("Back to the defaults"), "link", self._go_back)
        grid.addWidget(self._open, len(self._fields), 0, 1, 2)
        grid.addWidget(self.back, len(self._fields) + 1, 0, 1, 2, Qt.AlignmentFlag.AlignLeft)
        draft.changed.connect(self._show)
        self._show()

    def _edit(self, name: str) -> Callable[[int], None]:
        return lambda value: self._draft.edit(name, value)

    def _go_back(self) -> None:
        self._draft.edit_all({name: getattr(_DEFAULT, name) for name in NAMES}, QCoreApplication.translate("draft", "Back to the defaults"))

    def _show(self, name: str = "") -> None:
        if name and name not in NAMES:
            return
        values = self._draft.values
        for key, field in self._fields.items():
            field.blockSignals(True)
            field.setValue(getattr(values, key))
            field.blockSignals(False)
            usual = getattr(values, key) == getattr(_DEFAULT, key)
            self._captions[key].setStyleSheet("" if usual else "font-weight: 600;")
        self._open.blockSignals(True)
        self._open.setChecked(values.open_base)
        self._open.blockSignals(False)
        self.back.setVisible(any(getattr(values, key) != getattr(_DEFAULT, key) for key in NAMES))


def _percent(ends: tuple[float, float]) -> tuple[int, int]:
    return round(100 * ends[0]), round(100 * ends[1])
