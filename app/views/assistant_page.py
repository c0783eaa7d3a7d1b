"""Set up a rig: find its devices, check it by what its cameras see, write its file."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import QButtonGroup, QProgressBar, QPushButton, QStackedWidget, QWidget

from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.services import Services
from app.views import format as fmt
from app.views.assistant_check import CheckStep
from app.views.assistant_find import FindStep
from app.views.assistant_write import WriteStep
from app.views.page import Page
from app.views.parts import button, column, label, make_primary, row, seam

FIND, CHECK, WRITE = range(3)


class AssistantPage(Page):
    """Fills the window.  The devices are the assistant's while the page is shown, and the program's own rig is open again afterwards."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        assistant = services.assistant
        self._assistant = assistant
        self.finding = FindStep(assistant)
        self.checking = CheckStep(assistant)
        self.writing = WriteStep(assistant, Path(services.settings.case_folder) / "rigs", self._use)
        self._stack = QStackedWidget()
        for step in (self.finding, self.checking, self.writing):
            self._stack.addWidget(step)
        words = (self.tr("1  Find the devices"), self.tr("2  Check the rig"), self.tr("3  Write its file"))
        self.steps: list[QPushButton] = []
        group = QButtonGroup(self)
        for place, word in enumerate(words):
            made = button(word, "choice", partial(self.go_to, place))
            made.setCheckable(True)
            group.addButton(made)
            self.steps.append(made)
        leave = button(self.tr("Leave"), "", lambda: self.wanted.emit("rig"))
        leave.setToolTip(self.tr("Back to the Rig page; the devices are released"))
        head = row(label(self.tr("Set up a rig"), "title"), 24, *self.steps, 1, leave, spacing=8)
        head.setContentsMargins(36, 14, 28, 12)
        self._missing = label("", "muted", wrap=True)
        self.search = button(self.tr("Look for devices"), "primary", self._look)
        self.cancel = button(self.tr("Cancel"), "", assistant.cancel)
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setFixedWidth(200)
        self._bar.setAccessibleName(self.tr("Progress of the search"))
        self.next = button(self.tr("Next: check the rig"), "primary", self._next)
        self._foot = QWidget()
        foot = row(self.search, self.cancel, self._bar, self._missing, self.next, spacing=14)
        foot.setStretch(3, 1)
        foot.setContentsMargins(36, 12, 28, 14)
        self._foot.setLayout(foot)
        self._foot_seam = seam()
        box = column(head, seam(), self._stack, self._foot_seam, self._foot, spacing=0)
        box.setStretch(2, 1)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        assistant.changed.connect(self._show_if_seen)
        services.rig.changed.connect(self._show_if_seen)
        self.go_to(FIND)

    # -------------------------------------------------------------------------------- what the window asks
    def entered(self) -> None:
        self._show()

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        if not event.spontaneous():  # a window that is only minimized goes on
            self._assistant.give_back()
            self.checking.left_alone()
        super().hideEvent(event)

    def tick(self) -> None:
        """For the pump: newer pictures."""
        if not self.isVisible():
            return
        if self.step == FIND:
            self.finding.tick()
        elif self.step == CHECK:
            self.checking.tick()

    # -------------------------------------------------------------------------------- steps
    @property
    def step(self) -> int:
        return self._stack.currentIndex()

    def go_to(self, step: int) -> None:
        """One of the three steps."""
        self._stack.setCurrentIndex(step)
        self.steps[step].setChecked(True)
        if step == WRITE:
            self.writing.entered()
        self._show()

    def _next(self) -> None:
        self.go_to(min(self.step + 1, WRITE))

    def _look(self) -> None:
        self._assistant.look_for_devices()
        self.cancel.setFocus()

    def _use(self, path: Path) -> None:
        self._assistant.leave_with(str(path))
        self.wanted.emit("rig")

    # -------------------------------------------------------------------------------- showing
    def _show_if_seen(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        snapshot, rig = self._assistant.snapshot, self.services.rig.snapshot
        busy = rig.busy or rig.calibrating is not None
        idle = snapshot.running is Job.NONE
        self.finding.show_snapshot(snapshot)
        self.checking.show_snapshot(snapshot)
        self.writing.show_snapshot(snapshot)
        for step in (CHECK, WRITE):
            self.steps[step].setEnabled(snapshot.choice.complete and idle)
        self.steps[FIND].setEnabled(idle)
        searching = snapshot.running is Job.FIND
        self.search.setVisible(self.step == FIND and not searching)
        self.search.setEnabled(idle and not busy)
        self.search.setText(self.tr("Look again") if snapshot.looked else self.tr("Look for devices"))
        for part in (self.cancel, self._bar):
            part.setVisible(searching)
        self.cancel.setEnabled(not snapshot.cancelling)
        self._bar.setValue(round(1000 * snapshot.fraction))
        self._missing.setText(self._words(snapshot, busy))
        self._foot.setVisible(self.step != WRITE)
        self._foot_seam.setVisible(self.step != WRITE)
        self.next.setEnabled(snapshot.choice.complete and idle and not busy)
        self.next.setText(self._next_words(snapshot))
        # one thing is to be done next, and looks like it
        checked = snapshot.findings is not None and self.checking.corrections.isHidden()
        make_primary(self.next, self.step == FIND or checked)
        make_primary(self.search, not snapshot.choice.complete)

    def _next_words(self, snapshot: AssistantSnapshot) -> str:
        if self.step == FIND:
            return self.tr("Next: check the rig")
        return self.tr("Next: write its file") if snapshot.checks else self.tr("Go on without a check")

    def _words(self, snapshot: AssistantSnapshot, busy: bool) -> str:
        if busy:
            return self.tr("The rig of the program is measuring: its devices are free afterwards.")
        if snapshot.running is Job.FIND:
            return self.tr("Asking every port and every camera  ·  {left} left").format(left=fmt.left_time(snapshot.left_s))
        if self.step != FIND:
            return ""
        if not snapshot.looked:
            return self.tr("Every serial port and every camera is asked who it is. A board may restart; nothing moves, and no laser is lit.")
        choice = snapshot.choice
        named = ((self.tr("a controller"), not choice.port), (self.tr("the left camera"), choice.left is None))
        parts = [name for name, missing in (*named, (self.tr("the right camera"), choice.right is None)) if missing]
        return self.tr("Still to be chosen: {what}.").format(what=", ".join(parts)) if parts else ""
