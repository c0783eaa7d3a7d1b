"""The left rail: which order this is, the pages in the order of the work, and the laser's switch."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QButtonGroup, QPushButton, QVBoxLayout, QWidget

from app.controllers.emission import Emission
from app.draft import KINDS, DraftValues
from app.theme import Sign, icon
from app.views.pages import PageInfo
from app.views.parts import SideBadge, button, label, row, seam

WIDTH = 196
_SIDES = 30
"""Left and right of the order together."""


class Rail(QWidget):
    """Calls `chosen(page id)` and `laser_off()`."""

    def __init__(self, pages: Sequence[PageInfo], foot: Sequence[PageInfo], chosen: Callable[[str], None], laser_off: Callable[[], None]) -> None:
        super().__init__()
        self.setProperty("role", "panel")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        mark = Sign(26, "mark", "accent")
        head = row(mark, label("Impronta", "title"), 1, spacing=9)
        head.setContentsMargins(16, 14, 12, 12)
        self._order = label("", "")
        self._order.setStyleSheet("font-weight: 600; font-size: 14px;")
        self._badge = SideBadge()
        self._kind = label("", "muted", wrap=True)
        self._pair = label("", "", wrap=True)
        self._code = label("", "faint")
        order = QVBoxLayout()
        order.setContentsMargins(18, 12, 12, 14)
        order.setSpacing(5)
        order.addWidget(self._order)
        order.addWidget(self._code)
        kind = row(self._badge, self._kind, spacing=8)
        kind.setStretch(1, 1)
        order.addLayout(kind)
        order.addWidget(self._pair)
        self._values: DraftValues | None = None
        self._surfaces: tuple[str | None, str | None] | None = None
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 14)
        box.setSpacing(0)
        box.addLayout(head)
        box.addWidget(seam())
        box.addLayout(order)
        box.addWidget(seam())
        box.addSpacing(8)
        self._group = QButtonGroup(self)
        self._steps: dict[str, QPushButton] = {}
        for number, page in enumerate(pages, start=1):
            box.addWidget(self._make_step(page, f"Ctrl+{number}", chosen))
        box.addStretch(1)
        for page in foot:
            box.addWidget(self._make_step(page, "Ctrl+,", chosen))
        box.addSpacing(10)
        self.stop_button = button(self.tr("Stop · laser off"), "laser", laser_off, "laser", "laser_text")
        self.stop_button.setToolTip(self.tr("Stops every movement and switches the laser off, from every page (Esc)"))
        stop = QVBoxLayout()
        stop.setContentsMargins(14, 0, 14, 0)
        stop.setSpacing(6)
        stop.addWidget(self.stop_button)
        hint = label(self.tr("Esc, from every page"), "faint", wrap=True)
        hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        stop.addWidget(hint)
        box.addLayout(stop)
        self.setFixedWidth(max(WIDTH, self.sizeHint().width()))  # in another language its buttons may be wider

    def step_of(self, page_id: str) -> QPushButton:
        """The button of a page that has one."""
        return self._steps[page_id]

    def _make_step(self, page: PageInfo, shortcut: str, chosen: Callable[[str], None]) -> QPushButton:
        step = QPushButton(QCoreApplication.translate("pages", page.title))
        step.setProperty("role", "step")
        step.setCheckable(True)
        step.setIcon(icon(page.icon, "muted", "text"))
        step.setIconSize(QSize(19, 19))
        step.setShortcut(shortcut)
        step.setToolTip(QKeySequence(shortcut).toString(QKeySequence.SequenceFormat.NativeText))
        step.clicked.connect(lambda: chosen(page.id))
        self._group.addButton(step)
        self._steps[page.id] = step
        return step

    def show_page(self, page_id: str) -> None:
        self._steps[page_id].setChecked(True)

    def show_order(self, values: DraftValues | None) -> None:
        """None while no case is open."""
        self._values = values
        self._show_head()

    def show_surfaces(self, names: tuple[str | None, str | None] | None) -> None:
        """The names of the surfaces before and after in the place of the order, which need not be theirs; None for the order again."""
        self._surfaces = names
        self._show_head()

    def _show_head(self) -> None:
        values, names = self._values, self._surfaces
        for part in (self._order, self._code, self._badge, self._kind):
            part.setVisible(names is None)
        self._pair.setVisible(names is not None)
        if names is not None:
            told, words = [name or self.tr("none yet") for name in names], self.tr("Before: {before}\nAfter: {after}")
            before, after = map(self._shortened, told)
            self._pair.setText(words.format(before=before, after=after))
            self._pair.setToolTip(words.format(before=told[0], after=told[1]))
            self._pair.setFixedHeight(self._pair.heightForWidth(self.width() - _SIDES))
            return
        if values is None:
            self._order.setText(self.tr("No order open"))
            for part in (self._code, self._badge, self._kind):
                part.setVisible(False)
            return
        self._order.setText(values.order or self.tr("No order number"))
        self._code.setText(values.patient_code)
        self._code.setVisible(bool(values.patient_code))
        self._badge.show_side(values.side)
        self._kind.setText(QCoreApplication.translate("draft", KINDS[values.kind]))

    def _shortened(self, name: str) -> str:
        """A name that has no place to break and is wider than the rail loses its middle."""
        metrics, room = self._pair.fontMetrics(), self.width() - _SIDES
        if max(map(metrics.horizontalAdvance, name.split() or [""])) <= room:
            return name
        return metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, room - 4).replace("…", "\u2060…\u2060")  # no line may end there

    def show_laser(self, emission: Emission) -> None:
        """Filled red while the laser emits, outlined otherwise; it asks when nobody knows."""
        lit = emission is Emission.LIT
        words = {Emission.LIT: self.tr("Laser on · stop"), Emission.UNKNOWN: self.tr("Stop · laser?")}
        self.stop_button.setProperty("lit", lit)
        self.stop_button.setText(words.get(emission, self.tr("Stop · laser off")))
        self.stop_button.setIcon(icon("laser", "on_laser" if lit else "laser_text"))
        self.stop_button.style().unpolish(self.stop_button)
        self.stop_button.style().polish(self.stop_button)
