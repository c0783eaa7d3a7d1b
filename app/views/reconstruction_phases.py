"""The three phases as steps with their times, and how long it takes yet."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QProgressBar, QVBoxLayout, QWidget

from app.controllers.reconstruction import PHASES, ReconstructionController
from app.theme import Sign
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.parts import label, row

PHASE_WORDS = {
    "inflate": (QT_TRANSLATE_NOOP("phases", "Inflate"), QT_TRANSLATE_NOOP("phases", "grows to the points")),
    "refine": (QT_TRANSLATE_NOOP("phases", "Refine"), QT_TRANSLATE_NOOP("phases", "where the error is")),
    "smooth": (QT_TRANSLATE_NOOP("phases", "Smooth"), QT_TRANSLATE_NOOP("phases", "without shrinking")),
}


class ReconstructionPhases(QWidget):
    """Of the job that runs."""

    def __init__(self, job: ReconstructionController) -> None:
        super().__init__()
        self._job = job
        self._lines = {name: _PhaseLine(name) for name in PHASES}
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress of the reconstruction"))
        self._left = label("", "muted", wrap=True)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(7)
        for line in self._lines.values():
            box.addWidget(line)
        box.addWidget(self._bar)
        box.addWidget(self._left)

    def show_job(self) -> None:
        """As it is now."""
        job = self._job
        progress = job.progress
        now = "" if progress is None else progress.phase
        for name, line in self._lines.items():
            active = name == now
            line.show_phase(active=active, seconds=job.phase_time_s if active else job.phase_seconds.get(name))
        self._bar.setValue(0 if progress is None else round(1000 * progress.fraction))
        self._left.setText(self._sentence(None if progress is None else progress.seconds_left))

    def _sentence(self, left_s: float | None) -> str:
        job = self._job
        if job.cancelling:
            return self.tr("Cancelling…")
        if job.ending_early:
            return self.tr("Finishing what there is…")
        if job.progress is None:
            return self.tr("Starting…")
        return self.tr("Looking at the points…") if left_s is None else self.tr("{left} left").format(left=fmt.left_time(left_s))


class _PhaseLine(QWidget):
    """A phase: a mark, its name, what it does, and its time."""

    def __init__(self, name: str) -> None:
        super().__init__()
        title, what = (QCoreApplication.translate("phases", word) for word in PHASE_WORDS[name])
        self._mark = Sign(15)
        self._title = label(title)
        self._time = label("", "muted")
        self._time.setMinimumWidth(56)  # of "888.8 s": it changes too often to lay the line out anew
        self._time.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        line = row(self._mark, self._title, label(what, "faint"), 1, self._time, spacing=6)
        line.setContentsMargins(0, 0, 0, 0)
        self.setLayout(line)
        self._shown: tuple[bool, str] | None = None
        self.show_phase(active=False, seconds=None)

    def show_phase(self, *, active: bool, seconds: float | None) -> None:
        time = "" if seconds is None else self.tr("{n} s").format(n=fmt.decimal(seconds, 1))
        if (active, time) == self._shown:
            return
        self._shown = (active, time)
        name, colour = ("play", "accent") if active else ("check", "accent") if time else ("pending", "faint")
        self._mark.show_sign(name, colour)
        self._title.setStyleSheet("font-weight: 600;" if active else "")
        self._time.setText(time)
