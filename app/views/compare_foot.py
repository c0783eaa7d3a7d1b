"""The foot of the Compare page: what is going on and how long it will take, and the one button that is next."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QProgressBar, QWidget

from app.services import Services
from app.views import format as fmt
from app.views.comparison_words import PHASES, translated
from app.views.parts import button, column, label
from scanner_core.comparison.parameters import Frame


class CompareFoot(QWidget):
    """Calls `save()` to have a report written."""

    def __init__(self, services: Services, save: Callable[[], None]) -> None:
        super().__init__()
        self._comparing = services.comparing
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._words = label("", "muted", wrap=True, selectable=True)
        self.start = button(self.tr("Compare"), "primary", self._comparing.answers.start)
        self.cancel = button(self.tr("Cancel"), "", self._cancel)
        self.save = button(self.tr("Save the report…"), "primary", save)
        self.keep = button(self.tr("Keep it in the open case"), "", self._comparing.keep)
        self._folder = button(self.tr("Show in its folder"), "link", self._show_folder)
        box = column(self._bar, self._words, self._folder, self.start, self.keep, self.save, self.cancel, spacing=8)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_state()

    def show_state(self) -> None:
        answers, report = self._comparing.answers, self._comparing.report
        progress = answers.progress if answers.running else report.progress if report.busy else None
        busy = answers.running or report.busy
        picking = self._comparing.points.active
        self._bar.setVisible(busy)
        self._bar.setValue(0 if progress is None else round(1000 * progress.fraction))
        self._words.setText(self._sentence())
        self._words.setVisible(bool(self._words.text()))
        choice = self._comparing.draft.choice
        self.start.setVisible(not busy and not picking and choice.before is not None and choice.after is not None and not answers.current)
        self.start.setEnabled(choice.ready)
        self.start.setText(self.tr("Align on the painted region") if choice.frame is Frame.MASK else self.tr("Compare"))
        self.save.setVisible(not busy and not picking and answers.current)
        self.keep.setVisible(not busy and not picking and self._comparing.keepable)
        self.cancel.setVisible(busy or picking)
        self.cancel.setEnabled(not answers.cancelling)
        self._folder.setVisible(report.folder is not None and not busy)

    @property
    def text(self) -> str:
        return self._words.text()

    def _sentence(self) -> str:
        answers, report = self._comparing.answers, self._comparing.report
        if answers.cancelling:
            return self.tr("Cancelling…")
        if answers.running:
            if answers.progress is None:
                return self.tr("Starting…")
            phase = PHASES.get(answers.progress.phase)
            words = translated(phase) if phase else answers.progress.phase
            return self.tr("{phase}: {left} left").format(phase=words, left=fmt.left_time(answers.progress.seconds_left))
        if report.busy:
            left = None if report.progress is None else report.progress.seconds_left
            return self.tr("Writing the report…") if left is None else self.tr("Writing the report: {left} left").format(left=fmt.left_time(left))
        if self._comparing.points.active:
            before, after = map(len, self._comparing.draft.choice.picks)
            return self.tr(
                "Click three points on each surface, in the same order and far from each other. Before: {b} of 3, after: {a} of 3."
            ).format(b=before, a=after)
        if report.folder is not None:
            return self.tr("Written: {folder}").format(folder=fmt.short_path(str(report.folder)))
        choice = self._comparing.draft.choice
        if choice.before is None or choice.after is None:
            return self.tr("Two surfaces are needed: one before, one after.")
        if answers.fault is not None:
            return self.tr("They could not be compared; the message above says why. Under Alignment, three points on each can be picked.")
        if choice.frame is Frame.MASK and not answers.current:
            return self.tr("Paint what did not move, then align on it.")
        return ""

    def _cancel(self) -> None:
        self._comparing.points.end()
        self._comparing.answers.cancel()
        self._comparing.report.cancel()

    def _show_folder(self) -> None:
        folder = self._comparing.report.folder
        if folder is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder)))
