"""Over the worklist: the order that was just removed, and the way back."""

from __future__ import annotations

from PySide6.QtWidgets import QFrame

from app.controllers.worklist import WorklistController
from app.views import format as fmt
from app.views.parts import button, label, row


class RemovedStrip(QFrame):
    """Hidden while nothing was removed."""

    def __init__(self, worklist: WorklistController) -> None:
        super().__init__()
        self._worklist = worklist
        self.setProperty("role", "banner")
        self.setProperty("mood", "note")
        self._what = label("", wrap=True)
        self.undo = button(self.tr("Undo"), "", worklist.undo_remove)
        line = row(self._what, self.undo, spacing=10)
        line.setStretch(0, 1)
        line.setContentsMargins(22, 6, 22, 6)
        self.setLayout(line)
        worklist.removed_changed.connect(self.show_removed)
        self.show_removed()

    def show_removed(self) -> None:
        removed = self._worklist.removed
        self.setVisible(removed is not None)
        if removed is not None:
            told, place = removed
            self._what.setText(self.tr("{order} was removed; its file is kept.").format(order=told.order.number or told.path.stem))
            self._what.setToolTip(fmt.short_path(str(place)))
