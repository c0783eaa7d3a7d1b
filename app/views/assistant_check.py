"""Second step: does the rig do what it is told?  By what its cameras see."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox, QFrame, QHBoxLayout, QProgressBar, QVBoxLayout, QWidget

from app.controllers.assistant import AssistantController
from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.faults import unmeasured_words
from app.views import format as fmt
from app.views.assistant_check_line import CheckLine
from app.views.assistant_corrections import Corrections
from app.views.assistant_jog import JogPanel
from app.views.assistant_pictures import AssistantPictures
from app.views.check_names import check_name
from app.views.parts import button, column, give_role, label, make_primary, row, scrolled, seam
from app.views.spot_advice import show_look
from scanner_core.acquisition.handover import Preview


class CheckStep(QWidget):
    """Warning, checks and corrections on the left; what the cameras see, and moving by hand, on the right."""

    def __init__(self, assistant: AssistantController) -> None:
        super().__init__()
        self._assistant = assistant
        self.lines: list[CheckLine] = []
        self._followed = True
        self.warning = label(
            self.tr(
                "The check moves beam and table and lights the laser. A laser of class 3R can injure the eye: do not look into the beam or its "
                "reflections, wear goggles for its wavelength, take rings and watches off, and keep hands and hair out of the rig. "
                "Esc and the red button at the lower left stop everything at once."
            ),
            "notice",
            wrap=True,
        )
        self.agreed = QCheckBox(self.tr("Everybody near the rig is protected, and nothing is in the way of beam and table"))
        self.agreed.toggled.connect(lambda _: self.show_snapshot(assistant.snapshot))
        self.start = button(self.tr("Start the check"), "primary", assistant.check)
        self.open = button(self.tr("Only look and move by hand"), "", assistant.open)
        self.cancel = button(self.tr("Cancel"), "", assistant.cancel)
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress of the check"))
        self._doing = label("", "muted")
        self._failed = label("", "bad", wrap=True, selectable=True)
        self.summary = label("", wrap=True)
        self._running = QFrame()
        running = column(row(self._doing, 1, self.cancel), self._bar, spacing=8)
        running.setContentsMargins(0, 0, 0, 0)
        self._running.setLayout(running)
        self._list = QVBoxLayout()
        self._list.setSpacing(16)
        self.corrections = Corrections(assistant.check)
        self.pictures = AssistantPictures()
        self.jog = JogPanel(assistant)
        inside = QWidget()
        above = (self.warning, self.agreed, row(self.start, self.open, 1), self._running, self._failed)
        left = column(*above, self.summary, self.corrections, self._list, 1, spacing=14)
        left.setContentsMargins(36, 20, 24, 16)
        inside.setLayout(left)
        self.left = scrolled(inside)
        pictures = QWidget()
        pictures_box = column(self.pictures, 1)
        pictures_box.setContentsMargins(24, 20, 24, 12)
        pictures.setLayout(pictures_box)
        hand = QWidget()
        hand_box = column(self.jog)
        hand_box.setContentsMargins(24, 12, 24, 14)
        hand.setLayout(hand_box)
        right = column(scrolled(pictures), seam(), hand, spacing=0)
        right.setStretch(0, 1)
        box = QHBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(self.left, 6)
        box.addWidget(seam(upright=True))
        box.addLayout(right, 5)

    def show_snapshot(self, snapshot: AssistantSnapshot) -> None:
        """How far it is, and what came of it."""
        running = snapshot.running in (Job.CHECK, Job.OPEN)
        self._running.setVisible(running)
        self.agreed.setEnabled(not running)
        self.warning.setVisible(not self.agreed.isChecked() or not (running or snapshot.checks or snapshot.opened))
        self.start.setVisible(not running)
        self.start.setEnabled(self.agreed.isChecked() and snapshot.choice.complete and snapshot.running is Job.NONE)
        self.open.setVisible(not running and not snapshot.opened)
        self.open.setEnabled(self.start.isEnabled())
        self.start.setText(self.tr("Check again") if snapshot.checks else self.tr("Start the check"))
        make_primary(self.start, snapshot.findings is None)
        self._bar.setValue(round(1000 * snapshot.fraction))
        self.cancel.setEnabled(not snapshot.cancelling)
        self.cancel.setText(self.tr("Cancelling…") if snapshot.cancelling else self.tr("Cancel"))
        doing = check_name(snapshot.doing) if snapshot.doing else self.tr("Opening the devices")
        self._doing.setText(self.tr("{doing}  ·  {left} left").format(doing=doing, left=fmt.left_time(snapshot.left_s)))
        self._failed.setText("" if snapshot.failed is None else unmeasured_words(snapshot.failed))
        self._failed.setVisible(snapshot.failed is not None)
        self._show_checks(snapshot)
        self._show_summary(snapshot)
        self.corrections.show_findings(snapshot.config, snapshot.findings)
        self.corrections.do.setVisible(not running)
        self.jog.show_snapshot(snapshot)

    def left_alone(self) -> None:
        """Who comes back to it says anew that everybody is protected."""
        self.agreed.setChecked(False)
        self.pictures.clear_live()

    def tick(self) -> None:
        """For the pump: what the cameras see now."""
        for side, preview in self.pictures.live.items():
            look = self._assistant.looks[side].take()
            if isinstance(look, Preview):
                show_look(preview, look, self._assistant.snapshot.config)
            elif look is not None:
                preview.show_frame(look)

    def _show_checks(self, snapshot: AssistantSnapshot) -> None:
        if [line.made for line in self.lines] != list(snapshot.checks[: len(self.lines)]):
            for line in self.lines:
                self._list.removeWidget(line)
                line.deleteLater()
            self.lines = []
            self._followed = True
            self.pictures.show_live()
        for made in snapshot.checks[len(self.lines) :]:
            line = CheckLine(made, self._choose)
            self._list.addWidget(line)
            self.lines.append(line)
            if made.pictures and self._followed:
                self.pictures.show_check(made)
        shown = self.pictures.check
        for line in self.lines:
            line.show_chosen(line.made is shown)

    def _show_summary(self, snapshot: AssistantSnapshot) -> None:
        """One verdict of all checks, and which of them to look at."""
        self.summary.setVisible(snapshot.findings is not None)
        to_see = [check_name(made.check.name) for made in snapshot.checks if made.check.verdict != "pass"]
        if to_see:
            self.summary.setText(self.tr("Not everything is as it should be: {checks}.").format(checks=", ".join(to_see)))
        else:
            self.summary.setText(self.tr("All {n} checks are good.").format(n=len(snapshot.checks)))
        give_role(self.summary, "bad" if to_see else "good")

    def _choose(self, made: object) -> None:
        """The pictures of one check, whatever else comes; pressed once more, what the cameras see now."""
        self._followed = False
        line = next(line for line in self.lines if line.made is made)
        if self.pictures.check is made:
            self.pictures.show_live()
        else:
            self.pictures.show_check(line.made)
        for other in self.lines:
            other.show_chosen(other.made is self.pictures.check)
