"""The view of the plan that a person has chosen: its words, and a button to measure it once more."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.views.parts import button, column, label, row
from app.views.plan_words import view_counts, view_words
from scanner_core.acquisition.view_state import ViewProgress, ViewState


class ChosenView(QWidget):
    """Hidden while none is chosen."""

    again = Signal(int)
    """Measure this view (from 0) once more."""

    def __init__(self) -> None:
        super().__init__()
        self._number = -1
        self.words = label("", wrap=True)
        self.counts = label("", "muted", wrap=True)
        self.redo = button(self.tr("Redo this view"), "", lambda: self.again.emit(self._number))
        self.redo.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.redo.setToolTip(self.tr("Measure this view once more: after the last one while the scan runs, else at once"))
        box = column(self.words, self.counts, row(self.redo, 1), spacing=4)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_view(None, able=False)

    def show_view(self, view: ViewProgress | None, *, able: bool) -> None:
        """This one, or none; `able` says whether it can be measured once more."""
        self.setVisible(view is not None)
        self._number = -1 if view is None else view.number
        if view is not None:
            self.words.setText(view_words(view))
            counts = view_counts(view)
            self.counts.setText(counts)
            self.counts.setVisible(bool(counts))
            self.redo.setEnabled(able and view.state in (ViewState.DONE, ViewState.WEAK))
