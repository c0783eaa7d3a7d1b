"""The middle of the Compare page: what the 3D view shows, the ways to look at two surfaces, and the view itself."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QButtonGroup, QHBoxLayout, QPushButton, QSizePolicy, QSlider, QStackedLayout, QToolButton, QVBoxLayout, QWidget

from app.theme import icon
from app.views.comparison_words import value_words
from app.views.deviation_legend import DeviationLegend
from app.views.parts import button, column, label, row, seam

VIEWS = ("occlusal", "frontal", "left", "right", "lingual", "underside")
_VIEW_KEYS = {"left": "4", "right": "6", "lingual": "9", "underside": "2"}
"""As the keys lie on a number pad; 7 and 1, top and front, are the window's own."""
_MODE_KEYS = {"map": "M", "side_by_side": "S", "curtain": "C", "blend": "B", "morph": "O"}
_WITH_AMOUNT = ("curtain", "blend", "morph")


class CompareStage(QWidget):
    """Header, 3D view, and the bar of ways to look."""

    mode_wanted = Signal(str)
    amount_wanted = Signal(float)
    view_wanted = Signal(str)
    section_wanted = Signal(bool)
    section_moved = Signal(float)
    """Share of the way across the surface, 0 to 1."""

    def __init__(self) -> None:
        super().__init__()
        self.setProperty("role", "ground")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.mode = "map"
        self._title = label(self.tr("Comparison"), "title")
        self.value = label("", "muted")
        self.value.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.legend = DeviationLegend()
        head = _bar()
        head.setFixedHeight(46)
        line = QHBoxLayout(head)
        line.setContentsMargins(16, 0, 10, 0)
        line.setSpacing(10)
        line.addWidget(self._title)
        line.addWidget(self.value, 1)
        self.looks = self._make_looks()
        line.addWidget(self.looks)
        self._waiting = label("", "muted")
        self._waiting.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._middle = QStackedLayout()
        self._middle.addWidget(self._waiting)
        self.ways = self._make_ways()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(head)
        box.addWidget(seam())
        box.addLayout(self._middle, 1)
        box.addWidget(self.ways)
        self.show_seen(False)

    # -------------------------------------------------------------------------------- parts
    def _make_ways(self) -> QWidget:
        words = {
            "map": self.tr("Map"),
            "side_by_side": self.tr("Side by side"),
            "curtain": self.tr("Curtain"),
            "flicker": self.tr("Flicker"),
            "blend": self.tr("Blend"),
            "morph": self.tr("Morph"),
        }
        group = QButtonGroup(self)
        self.modes: dict[str, QPushButton] = {}
        for mode, text in words.items():
            made = button(text, "choice", partial(self.choose_mode, mode))
            made.setCheckable(True)
            made.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the picture
            made.setStyleSheet("padding: 7px 8px;")
            group.addButton(made)
            self.modes[mode] = made
            if mode in _MODE_KEYS:
                self._bind(made, text, _MODE_KEYS[mode], partial(self.choose_mode, mode))
        self.modes["map"].setChecked(True)
        self.modes["flicker"].setToolTip(self.tr("One surface in place of the other (space bar)"))
        views = {
            "occlusal": self.tr("Occlusal (7)"),
            "frontal": self.tr("Frontal (1)"),
            "left": self.tr("Left"),
            "right": self.tr("Right"),
            "lingual": self.tr("Lingual"),
            "underside": self.tr("Underside"),
        }
        tools = QHBoxLayout()
        tools.setSpacing(0)
        self.views: dict[str, QToolButton] = {}
        for view, text in views.items():
            tool = _tool(f"view-{view}", text, partial(self.view_wanted.emit, view))
            self.views[view] = tool
            tools.addWidget(tool)
            if view in _VIEW_KEYS:
                self._bind(tool, text, _VIEW_KEYS[view], partial(self.view_wanted.emit, view))
        tools.addWidget(_tool("fit", self.tr("Fit (F)"), partial(self.view_wanted.emit, "fit")))
        line = row(*self.modes.values(), 1, spacing=4)
        line.addLayout(tools)
        legend = row(self.legend)
        legend.setContentsMargins(6, 4, 6, 0)
        line.setContentsMargins(12, 0, 10, 8)
        ways = _bar()
        ways.setLayout(column(legend, line, spacing=4))
        return ways

    def _make_looks(self) -> QWidget:
        self.amount = _slider(self.tr("From before to after"), self.amount_wanted.emit)
        self.section = button(self.tr("Section"), "choice", lambda: self.section_wanted.emit(self.section.isChecked()))
        self.section.setCheckable(True)
        self.section.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.section.setToolTip(self.tr("Cut both: through the chosen area from cheek to tongue, or through the middle"))
        self.cut = _slider(self.tr("Place of the section"), self.section_moved.emit)
        self.cut.hide()
        looks = QWidget()
        line = row(self.amount, self.section, self.cut, spacing=8)
        line.setContentsMargins(0, 0, 0, 0)
        looks.setLayout(line)
        return looks

    def _bind(self, part: QWidget, text: str, key: str, call: Callable[[], None]) -> None:
        """A key while the page is shown; it stands in the part's tool tip."""
        shortcut = QShortcut(QKeySequence(key), self)
        shortcut.setWhatsThis(text)
        shortcut.activated.connect(lambda: call())
        part.setToolTip(f"{text} ({QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)})")

    # -------------------------------------------------------------------------------- showing
    def put(self, part: QWidget) -> None:
        """Add what may stand in the middle."""
        self._middle.addWidget(part)

    def show_seen(self, on: bool) -> None:
        """Whether there is an answer to look at."""
        for part in (self.ways, self.looks):
            part.setVisible(on)
        self._show_amount()
        if not on:
            self.value.setText("")

    def show_part(self, part: QWidget | None) -> None:
        """This in the middle, or the words that the 3D view is being prepared."""
        self._middle.setCurrentWidget(part or self._waiting)

    def show_waiting(self, words: str) -> None:
        """What stands in the place of the 3D view while there is none."""
        self._waiting.setText(words)

    def show_value(self, signed_um: float | None, *, there: bool) -> None:
        """Of the point under the pointer; nothing when it is not over a surface."""
        self.value.setText(value_words(signed_um) if there else "")
        self.legend.show_value(signed_um)

    def show_amount(self, share: float) -> None:
        """As the curtain was dragged."""
        self.amount.blockSignals(True)
        self.amount.setValue(round(1000 * share))
        self.amount.blockSignals(False)

    def choose_mode(self, mode: str) -> None:
        if self.ways.isHidden():
            return
        self.mode = mode
        self.modes[mode].setChecked(True)
        self._show_amount()
        self.mode_wanted.emit(mode)

    def show_section(self, on: bool) -> None:
        self.section.setChecked(on)
        self.cut.setVisible(on)

    def _show_amount(self) -> None:
        self.amount.setVisible(self.mode in _WITH_AMOUNT)
        if self.mode in _WITH_AMOUNT:
            self.show_amount(0.5)
            self.amount_wanted.emit(0.5)


def _bar() -> QWidget:
    made = QWidget()
    made.setProperty("role", "panel")
    made.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
    return made


def _tool(drawing: str, text: str, clicked: Callable[[], None]) -> QToolButton:
    made = QToolButton()
    made.setIcon(icon(drawing, "muted", "text"))
    made.setIconSize(QSize(20, 20))
    made.setToolTip(text)
    made.setAccessibleName(text)
    made.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    made.clicked.connect(lambda: clicked())
    return made


def _slider(name: str, moved: Callable[[float], None]) -> QSlider:
    made = QSlider(Qt.Orientation.Horizontal)
    made.setRange(0, 1000)
    made.setValue(500)
    made.setAccessibleName(name)
    made.setToolTip(name)
    made.setFixedWidth(130)
    made.valueChanged.connect(lambda value: moved(value / 1000))
    return made
