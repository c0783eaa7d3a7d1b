"""What was noticed: what is serious in full, the rest folded away behind its number."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from app.views.comparison_words import doubt_words
from app.views.parts import button, column, label
from scanner_core.comparison.doubt import Doubt


class Remarks(QWidget):
    """Hidden while there is nothing."""

    def __init__(self) -> None:
        super().__init__()
        self._doubts: tuple[Doubt, ...] = ()
        self._serious = label("", "bad", wrap=True, selectable=True)
        self.unfold = button("", "link", self._turn)
        self._others = label("", "muted", wrap=True, selectable=True)
        box = column(self._serious, self.unfold, self._others, spacing=6)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_doubts(())

    def show_doubts(self, doubts: Sequence[Doubt]) -> None:
        """These instead of those that stand there; other ones are folded away again."""
        if tuple(doubts) == self._doubts and self._doubts:
            return
        self._doubts = tuple(doubts)
        serious, others = ([doubt_words(doubt) for doubt in doubts if doubt.serious is kind] for kind in (True, False))
        self._serious.setText("\n\n".join(serious))
        self._serious.setVisible(bool(serious))
        self.unfold.setText(self.tr("1 remark") if len(others) == 1 else self.tr("{n} remarks").format(n=len(others)))
        self.unfold.setVisible(bool(others))
        self._others.setText("\n\n".join(others))
        self._others.hide()
        self.setVisible(bool(doubts))

    @property
    def text(self) -> str:
        return "\n\n".join(part for part in (self._serious.text(), self._others.text()) if part)

    def _turn(self) -> None:
        self._others.setVisible(self._others.isHidden())
