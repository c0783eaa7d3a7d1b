"""Small parts that the pages are made of: seams, numbers, fields, buttons."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, TypeVar

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPaintEvent, QValidator
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QLayout, QPushButton, QScrollArea, QSizePolicy, QSpinBox, QVBoxLayout, QWidget

from app.draft import SIDES
from app.theme import icon, look_of
from app.views import format as fmt

BoxT = TypeVar("BoxT", QHBoxLayout, QVBoxLayout)


def label(text: str = "", role: str = "", *, wrap: bool = False, selectable: bool = False) -> QLabel:
    """A label in one of the theme's roles; its text is plain, never markup."""
    made = QLabel(text)
    made.setTextFormat(Qt.TextFormat.PlainText)
    if role:
        made.setProperty("role", role)
    made.setWordWrap(wrap)
    if selectable:
        made.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    return made


def give_role(made: QWidget, role: str) -> None:
    """Another role of the theme for what is already shown."""
    if made.property("role") != role:
        made.setProperty("role", role)
        made.style().unpolish(made)
        made.style().polish(made)
        drawing = made.property("drawing")
        if isinstance(made, QPushButton) and drawing:
            made.setIcon(icon(drawing, _on_button(role, "text")))


def make_primary(made: QWidget, primary: bool) -> None:
    """Whether a button that is already shown is what is to be done next."""
    give_role(made, "primary" if primary else "")


def seam(*, upright: bool = False) -> QFrame:
    """A line of one pixel instead of a frame."""
    made = QFrame()
    made.setProperty("role", "seam")
    if upright:
        made.setFixedWidth(1)
    else:
        made.setFixedHeight(1)
    return made


def button(text: str, role: str, clicked: Callable[[], object], drawing: str = "", colour: str = "text") -> QPushButton:
    made = QPushButton(text)
    if role:
        made.setProperty("role", role)
    if drawing:
        made.setProperty("drawing", drawing)
        made.setIcon(icon(drawing, _on_button(role, colour)))
    made.clicked.connect(lambda: clicked())
    made.setCursor(Qt.CursorShape.PointingHandCursor)
    return made


def _on_button(role: str, colour: str) -> str:
    """The colour of the drawing on a button of that role."""
    return "on_accent" if role == "primary" else colour


def number_field(low: int, high: int, step: int, edited: Callable[[int], None], *, suffix: str = "", special: str = "") -> QSpinBox:
    """A spin box that tells `edited` what a person entered, and nothing when the program sets it."""
    made = CountField()
    made.setRange(low, high)
    made.setSingleStep(step)
    made.setAlignment(Qt.AlignmentFlag.AlignRight)
    made.setKeyboardTracking(False)
    made.setMinimumHeight(30)
    if suffix:
        made.setSuffix(suffix)
        if len(suffix.strip()) > 3:  # a word, no unit
            made.setAccessibleName(suffix.strip())
    if special:
        made.setSpecialValueText(special)
    made.valueChanged.connect(edited)
    return made


class CountField(QSpinBox):
    """A spin box whose thousands stand apart as everywhere else in the window."""

    def textFromValue(self, value: int) -> str:  # noqa: N802 - Qt's name
        return fmt.count(value)

    def valueFromText(self, text: str) -> int:  # noqa: N802 - Qt's name
        digits = "".join(character for character in text.removesuffix(self.suffix()) if character.isdigit())
        return int(digits) if digits else self.value()

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        kept = text.removesuffix(self.suffix())
        known = kept == self.specialValueText() or all(character.isdigit() or character in " ,.'\u202f" for character in kept)
        return (QValidator.State.Acceptable if known else QValidator.State.Invalid), text, position


def row(*parts: QWidget | QLayout | int, spacing: int = 8) -> QHBoxLayout:
    """Side by side; an integer is a stretch."""
    return _fill(QHBoxLayout(), parts, spacing)


def column(*parts: QWidget | QLayout | int, spacing: int = 8) -> QVBoxLayout:
    """One below the other; an integer is a stretch."""
    return _fill(QVBoxLayout(), parts, spacing)


def scrolled(part: QWidget) -> QScrollArea:
    """As high as there is room; what does not fit is scrolled to, downwards only."""
    area = _Scrolled()
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setWidget(part)
    area.viewport().setAutoFillBackground(False)
    part.setAutoFillBackground(False)
    return area


class _Scrolled(QScrollArea):
    """Gives what it holds the height that its wrapped texts need; left to itself it goes by what they need without a wrap."""

    def viewportEvent(self, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        done = super().viewportEvent(event)
        if event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest):
            part = self.widget()
            layout = None if part is None else part.layout()
            if part is not None and layout is not None and layout.hasHeightForWidth():
                width = min(self.viewport().width(), part.maximumWidth())
                part.setMinimumHeight(layout.totalHeightForWidth(width))
        return done


def _fill(box: BoxT, parts: tuple[QWidget | QLayout | int, ...], spacing: int) -> BoxT:
    box.setSpacing(spacing)
    for part in parts:
        if isinstance(part, int):
            box.addStretch(part)
        elif isinstance(part, QWidget):
            box.addWidget(part)
        else:
            box.addLayout(part)
    return box


class BigNumber(QWidget):
    """A large number over its small unit."""

    def __init__(self, unit: str, role: str = "number") -> None:
        super().__init__()
        self._number = label("–", role)
        if role == "hero":  # a tabular one leaves a gap before a large number; nothing moves here
            font = self._number.font()
            font.setFeature(QFont.Tag("tnum"), 0)
            self._number.setFont(font)
        self._unit = label(unit, "unit")
        box = column(self._number, self._unit, spacing=0)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_number(self, text: str) -> None:
        self._number.setText(text)
        self.setAccessibleName(f"{text} {self._unit.text()}")

    def show_unit(self, text: str) -> None:
        self._unit.setText(text)

    @property
    def text(self) -> str:
        return self._number.text()


class SideBadge(QLabel):
    """Left or right as a word in an outlined badge of its colour: blue left, red right."""

    def show_side(self, side: str) -> None:
        """A key of ``SIDES``; nothing is shown for none."""
        self.setVisible(bool(side))
        if not side:
            return
        self.setProperty("role", "badge")
        self.setProperty("side", side)
        self.style().unpolish(self)
        self.style().polish(self)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setText(QCoreApplication.translate("draft", SIDES[side]))
        QCoreApplication.sendEvent(self, QEvent(QEvent.Type.StyleChange))  # else the frame keeps the width that it had without one


class Lamp(QWidget):
    """A dot with a word; the word says it all, the dot only sooner."""

    COLOURS: ClassVar[dict[str, str]] = {"good": "good", "warn": "warning", "idle": "muted", "laser": "laser"}

    def __init__(self, text: str = "") -> None:
        super().__init__()
        self._dot = _Dot()
        self._word = label(text)
        box = row(self._dot, self._word, spacing=7)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)

    def show_state(self, mood: str, text: str) -> None:
        self._dot.paint_in(self.COLOURS[mood])
        self._word.setText(text)

    @property
    def text(self) -> str:
        return self._word.text()


class _Dot(QWidget):
    def __init__(self) -> None:
        super().__init__()
        self.setFixedSize(9, 9)
        self._colour = "muted"

    def paint_in(self, colour: str) -> None:
        """A colour of the palette, by its name."""
        if self._colour != colour:
            self._colour = colour
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(look_of(self._colour)))
        painter.drawEllipse(self.rect())
