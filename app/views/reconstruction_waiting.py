"""What is being reconstructed for another order, and which orders wait: they can be hurried or taken out."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton, QVBoxLayout, QWidget

from app.controllers.reconstruction import ReconstructionController
from app.controllers.reconstruction_queue import WantedSurface
from app.theme import icon
from app.views.parts import label, row
from app.views.reconstruction_words import order_words, reconstruction_words


class ReconstructionWaiting(QWidget):
    """Hidden while nothing waits and nothing else runs."""

    def __init__(self, job: ReconstructionController) -> None:
        super().__init__()
        self._job = job
        self._now = label("", "muted", wrap=True)
        self._title = label(self.tr("Waiting"), "section")
        self._rows = QVBoxLayout()
        self._rows.setSpacing(2)
        self.lines: list[_Line] = []
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(4)
        box.addWidget(self._now)
        box.addWidget(self._title)
        box.addLayout(self._rows)

    def show_queue(self) -> None:
        """As it is now."""
        job = self._job
        waiting = job.queue.waiting
        self._now.setText("" if job.mine else reconstruction_words(job, with_count=False))
        self._now.setVisible(job.running and not job.mine)
        self._title.setVisible(bool(waiting))
        if tuple(line.wanted for line in self.lines) != waiting:
            self._fill(waiting)
        self.setVisible(bool(waiting) or (job.running and not job.mine))

    def _fill(self, waiting: tuple[WantedSurface, ...]) -> None:
        for line in self.lines:
            line.hide()
            line.deleteLater()
        self.lines = [_Line(wanted, self._job, first=number == 0) for number, wanted in enumerate(waiting)]
        for line in self.lines:
            self._rows.addWidget(line)


class _Line(QWidget):
    def __init__(self, wanted: WantedSurface, job: ReconstructionController, *, first: bool) -> None:
        super().__init__()
        self.wanted = wanted
        name = order_words(wanted.values)
        self.hurry = self._tool("up", self.tr("{order}: one place forward").format(order=name))
        self.hurry.setEnabled(not first)
        self.hurry.clicked.connect(lambda: job.hurry(wanted))
        self.drop = self._tool("cross", self.tr("{order}: do not reconstruct").format(order=name))
        self.drop.clicked.connect(lambda: job.drop(wanted))
        words = label(name)
        words.setTextInteractionFlags(Qt.TextInteractionFlag.NoTextInteraction)
        line = row(words, 1, self.hurry, self.drop, spacing=2)
        line.setContentsMargins(0, 0, 0, 0)
        self.setLayout(line)

    @staticmethod
    def _tool(drawing: str, words: str) -> QToolButton:
        made = QToolButton()
        made.setIcon(icon(drawing, "muted"))
        made.setToolTip(words)
        made.setAccessibleName(words)
        return made
