"""What was rejected: how much of it, for which reasons, and what to do about the largest."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from app.views import format as fmt
from app.views.parts import label, row
from app.views.reasons import reason_text
from app.views.reject_advice import reject_advice

SHOWN_REASONS = 4


class RejectList(QWidget):
    """The most frequent reasons, the rest in one line; all of them on the pointer."""

    def __init__(self) -> None:
        super().__init__()
        self._total = label("", "muted")
        self._lines = [(label("", "muted", wrap=True), label("", "muted")) for _ in range(SHOWN_REASONS)]
        self.advice = label("", "faint", wrap=True)
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setVerticalSpacing(2)
        grid.setColumnStretch(0, 1)
        for line, parts in enumerate(self._lines):
            grid.addWidget(parts[0], line, 0)
            grid.addWidget(parts[1], line, 1, Qt.AlignmentFlag.AlignRight)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(4)
        box.addLayout(row(label(self.tr("Rejected"), "section"), 1, self._total))
        box.addLayout(grid)
        box.addWidget(self.advice)

    @property
    def texts(self) -> list[str]:
        """The lines as they are read."""
        return [f"{name.text()} {many.text()}" for name, many in self._lines if name.text()]

    def show_counts(self, measured: int, rejected: Mapping[str, int]) -> None:
        """Numbers by reason, beside those that were measured."""
        total = sum(rejected.values())
        share = fmt.percent(total / (measured + total)) if total else ""
        self._total.setText(self.tr("{count}  ·  {share} %").format(count=fmt.count(total), share=share) if total else self.tr("none"))
        ranked = sorted(rejected.items(), key=lambda entry: -entry[1])
        if len(ranked) > SHOWN_REASONS:
            rest = sum(many for _, many in ranked[SHOWN_REASONS - 1 :])
            ranked = [*ranked[: SHOWN_REASONS - 1], ("", rest)]
        for line, parts in enumerate(self._lines):
            name, many = ranked[line] if line < len(ranked) else ("", 0)
            parts[0].setText(reason_text(name) if name else self.tr("other") if many else "")
            parts[1].setText(fmt.count(many) if many else "")
            for part in parts:
                part.setVisible(many > 0)
        advice = reject_advice(measured, rejected)
        self.advice.setText(advice)
        self.advice.setVisible(bool(advice))
        self.setToolTip("\n".join(f"{reason_text(name)}: {fmt.count(many)}" for name, many in rejected.items()))
