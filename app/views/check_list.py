"""The list of checks before a delivery, the worst first; the current one is explained below it."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from app.theme import Sign
from app.views.delivery_words import SIGNS, check_name, check_sentence, check_value, verdict_word
from app.views.parts import label, row
from scanner_core.delivery.check import Check, CheckVerdict

_ORDER = (CheckVerdict.FAIL, CheckVerdict.WARN, CheckVerdict.PASS, CheckVerdict.OPEN)
_LINE = 27


class CheckList(QListWidget):
    """A line a check: a sign, its name, its number."""

    explained = Signal(object)
    """The check that is current, or None."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Checks"))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QListWidget.ScrollMode.ScrollPerPixel)
        self.setMinimumHeight(4 * _LINE)
        self._checks: list[Check] = []
        self.currentRowChanged.connect(lambda line: self.explained.emit(self._checks[line] if 0 <= line < len(self._checks) else None))

    def show_checks(self, checks: Sequence[Check]) -> None:
        """These instead of what stands there; the worst one is current."""
        self._checks = sorted(checks, key=lambda check: _ORDER.index(check.verdict))
        self.blockSignals(True)
        self.clear()
        for check in self._checks:
            item = QListWidgetItem()
            item.setSizeHint(QSize(0, _LINE))
            told = ", ".join(part for part in (verdict_word(check), check_value(check)) if part)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{check_name(check)}: {told}. {check_sentence(check)}")
            item.setToolTip(check_sentence(check))
            self.addItem(item)
            self.setItemWidget(item, _Line(check))
        self.setCurrentRow(0 if self._checks else -1)
        self.blockSignals(False)
        self.explained.emit(self._checks[0] if self._checks else None)

    @property
    def texts(self) -> list[str]:
        """As a screen reader tells them."""
        return [str(self.item(line).data(Qt.ItemDataRole.AccessibleTextRole)) for line in range(self.count())]


class _Line(QWidget):
    def __init__(self, check: Check) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        quiet = check.verdict is CheckVerdict.OPEN
        value = check_value(check) or ("" if check.verdict is CheckVerdict.PASS else verdict_word(check))
        box = row(Sign(16, *SIGNS[check.verdict]), label(check_name(check), "muted" if quiet else ""), 1, label(value, "muted"), spacing=9)
        box.setContentsMargins(4, 0, 8, 0)
        self.setLayout(box)
