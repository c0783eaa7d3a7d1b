"""Whether the result may be relied on, in one look; never more than what holds."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from app.views import format as fmt
from app.views.comparison_words import frame_words, serious_doubts
from app.views.parts import column, give_role, label
from scanner_core.comparison.comparison import Comparison


class Verdict(QWidget):
    """A word and, where it is "Not reliable", why."""

    def __init__(self) -> None:
        super().__init__()
        self._word = label("")
        self._word.setStyleSheet("font-size: 16px; font-weight: 600;")
        self._why = label("", "muted", wrap=True, selectable=True)
        box = column(self._word, self._why, spacing=2)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_comparison(None, current=False)

    def show_comparison(self, comparison: Comparison | None, *, current: bool) -> None:
        """Of the answer that is there, whether it is the one to what is chosen now."""
        self.setVisible(comparison is not None)
        if comparison is None:
            return
        reasons = serious_doubts(comparison)
        if not current:
            word, why, role = self.tr("Out of date"), self.tr("What is shown was computed before the last change."), "muted"
        elif reasons:
            more = self.tr("And {n} more, under Surfaces and Alignment.").format(n=len(reasons) - 1) if len(reasons) > 1 else ""
            word, why, role = self.tr("Not reliable"), f"{reasons[0]} {more}".strip(), "bad"
        else:
            held, share = frame_words(comparison.alignment.frame), fmt.percent(comparison.alignment.stable_area_fraction)
            why = self.tr("Held fixed: {frame} ({share} %).").format(frame=held, share=share)
            if comparison.doubts:
                why += " " + self.tr("Remarks: {n}.").format(n=len(comparison.doubts))
            word, role = self.tr("Reliable"), "good"
        self._word.setText(word)
        give_role(self._word, role)
        self._why.setText(why)
        self._why.setVisible(bool(why))

    @property
    def text(self) -> str:
        return "" if self.isHidden() else f"{self._word.text()} {self._why.text()}".strip()
