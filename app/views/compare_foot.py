"""The foot of the Compare page: what is going on and how long it will take, and the one button that is next."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QProgressBar, QWidget

from app.faults import sentence_of
from app.services import Services
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.comparison_words import PHASES, translated
from app.views.parts import button, column, label
from scanner_core.comparison.parameters import Frame
from scanner_core.errors import ComparisonError

_POINTS_HELP = ("E-CMP-01", "E-CMP-02", "E-CMP-05")
"""Refusals that three picked points may get around."""
_TOOL_WORDS = {
    "tooth": QT_TRANSLATE_NOOP("comparison", "Click the tooth in the picture: the mark grows to its edge, and its motion is told."),
    "lasso_add": QT_TRANSLATE_NOOP("comparison", "Draw a line round what belongs to the tooth, too; only what is seen is added."),
    "lasso_remove": QT_TRANSLATE_NOOP("comparison", "Draw a line round what does not belong to the tooth; only what is seen is taken off."),
    "paint": QT_TRANSLATE_NOOP("comparison", "Paint with the left button what did not move, then align on it."),
    "erase": QT_TRANSLATE_NOOP("comparison", "Wipe with the left button over what may have moved, then align on the rest."),
}


class CompareFoot(QWidget):
    """Calls `save()` to have a report written."""

    def __init__(self, services: Services, save: Callable[[], None]) -> None:
        super().__init__()
        self._comparing = services.comparing
        self._tool = "look"
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._words = label("", "muted", wrap=True, selectable=True)
        self.start = button(self.tr("Compare"), "primary", self._comparing.answers.start)
        self.points = button(self.tr("Pick three points on each…"), "primary", self._comparing.points.begin)
        self.cancel = button(self.tr("Cancel"), "", self._cancel)
        self.save = button(self.tr("Save the report…"), "primary", save)
        self.keep = button(self.tr("Keep it in the open case"), "", self._comparing.keep)
        self._folder = button(self.tr("Show in its folder"), "link", self._show_folder)
        box = column(self._bar, self._words, self._folder, self.start, self.points, self.keep, self.save, self.cancel, spacing=8)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_state()

    def show_state(self) -> None:
        answers, report = self._comparing.answers, self._comparing.report
        progress = answers.progress if answers.running else report.progress if report.busy else None
        picking = self._comparing.points.active
        busy = (answers.running or report.busy) and not picking
        self._bar.setVisible(busy)
        self._bar.setValue(0 if progress is None else round(1000 * progress.fraction))
        self._words.setText(self._sentence())
        self._words.setVisible(bool(self._words.text()))
        choice = self._comparing.draft.choice
        open_question = not busy and not picking and choice.before is not None and choice.after is not None and not answers.current
        refused = isinstance(answers.fault, ComparisonError)  # the same question would be refused again
        self.start.setVisible(open_question and not refused)
        self.start.setEnabled(choice.ready)
        painted = self.tr("Align on the painted region") if choice.frame is Frame.MASK else self.tr("Compare")
        self.start.setText(painted if answers.fault is None else self.tr("Try again"))
        self.points.setVisible(open_question and refused and _code(answers.fault) in _POINTS_HELP)
        self.save.setVisible(not busy and not picking and answers.settled)
        self.keep.setVisible(not busy and not picking and self._comparing.keepable)
        self.cancel.setVisible(busy or picking)
        self.cancel.setEnabled(picking or not answers.cancelling)
        self._folder.setVisible(report.folder is not None and not busy)

    def show_tool(self, tool: str) -> None:
        """The tool that is in hand."""
        self._tool = tool
        self.show_state()

    @property
    def text(self) -> str:
        return self._words.text()

    def _sentence(self) -> str:
        answers, report = self._comparing.answers, self._comparing.report
        if self._comparing.points.active:
            before, after = map(len, self._comparing.draft.choice.picks)
            return self.tr(
                "Click three points on each surface, in the same order and far from each other. Before: {b} of 3, after: {a} of 3."
            ).format(b=before, a=after)
        if answers.cancelling:
            return self.tr("Cancelling…")
        if answers.running:
            if answers.progress is None:
                return self.tr("Starting…")
            phase = PHASES.get(answers.progress.phase)
            words = translated(phase) if phase else answers.progress.phase
            left = answers.progress.seconds_left
            return f"{words}…" if left is None else self.tr("{phase}: {left} left").format(phase=words, left=fmt.left_time(left))
        if report.busy:
            left = None if report.progress is None else report.progress.seconds_left
            return self.tr("Writing the report…") if left is None else self.tr("Writing the report: {left} left").format(left=fmt.left_time(left))
        if self._tool != "look":
            return translated(_TOOL_WORDS[self._tool])
        if report.folder is not None:
            return self.tr("Written: {folder}").format(folder=fmt.short_path(str(report.folder)))
        choice = self._comparing.draft.choice
        if choice.before is None or choice.after is None:
            return self.tr("Two surfaces are needed: one before, one after.")
        if answers.fault is not None:
            return " ".join(sentence_of(answers.fault))
        if choice.frame is Frame.MASK and not answers.current:
            return self.tr("Paint what did not move, then align on it.")
        return ""

    def _cancel(self) -> None:
        """What the words above the button speak of, and nothing else."""
        if self._comparing.points.active:
            self._comparing.points.end()
        elif self._comparing.answers.running:
            self._comparing.answers.cancel()
        else:
            self._comparing.report.cancel()

    def _show_folder(self) -> None:
        folder = self._comparing.report.folder
        if folder is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder)))


def _code(fault: Exception | None) -> str:
    return fault.code if isinstance(fault, ComparisonError) else ""
