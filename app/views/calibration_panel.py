"""The calibration in use: accepted or not, how good, how old, what it rests on, what it found, and what has moved."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from app.controllers.rig import RigController
from app.faults import sentence_of
from app.theme import icon
from app.views import format as fmt
from app.views.calibration_words import (
    age_of,
    age_text,
    calibration_facts,
    change_facts,
    change_text,
    drift_text,
    expired_text,
    finding_text,
    sphere_fact,
)
from app.views.facts import Facts
from app.views.file_dialogs import choose_new_file
from app.views.parts import BigNumber, Lamp, button, label, make_primary, row, seam


class CalibrationPanel(QWidget):
    """The right half of the Rig page while nothing is calibrated."""

    def __init__(self, rig: RigController, calibrate: Callable[[], None] | None = None) -> None:
        """`calibrate` is called when a person wants to; the rig's own way when None."""
        super().__init__()
        self._rig = rig
        self._shown: object = None
        self._state = Lamp()
        self._notice = label("", "notice", wrap=True)
        self._accuracy = BigNumber(self.tr("µm rms at board corners that were not used"), "hero")
        self._calibrated = label("", "muted", wrap=True)
        self._sentences = QVBoxLayout()
        self._sentences.setSpacing(8)
        self._told: list[QLabel] = []
        self.numbers, self.moved = Facts(), Facts()
        self._written = label("", "muted", wrap=True)
        self._written.hide()
        self._calibrate = button(self.tr("Calibrate"), "primary", calibrate or rig.calibrate, "calibrate")
        self._target = button(self.tr("Print the target…"), "", self._choose_target, "export")
        inside = QWidget()
        box = QVBoxLayout(inside)
        box.setContentsMargins(36, 34, 36, 12)
        box.setSpacing(0)
        box.addLayout(row(label(self.tr("Calibration"), "section"), 1, self._state))
        box.addWidget(self._accuracy)
        box.addSpacing(4)
        box.addWidget(self._calibrated)
        box.addSpacing(12)
        box.addWidget(self._notice)
        box.addSpacing(14)
        box.addWidget(seam())
        box.addSpacing(14)
        box.addWidget(self.numbers)
        box.addSpacing(14)
        self._line = seam()
        box.addWidget(self._line)
        box.addSpacing(14)
        box.addLayout(self._sentences)
        box.addSpacing(8)
        box.addWidget(self.moved)
        box.addStretch(1)
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(inside)
        scroll.viewport().setAutoFillBackground(False)
        inside.setAutoFillBackground(False)
        more = seam()  # where there is more to scroll to
        more.hide()
        scroll.verticalScrollBar().rangeChanged.connect(lambda _, last: more.setVisible(last > 0))
        below = QVBoxLayout()
        below.setContentsMargins(36, 8, 36, 24)
        below.setSpacing(10)
        below.addWidget(self._written)
        below.addLayout(row(self._calibrate, self._target, 1))
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(scroll, 1)
        whole.addWidget(more)
        whole.addLayout(below)
        rig.target.changed.connect(self._show_target)
        rig.target.written.connect(self._tell_written)

    # -------------------------------------------------------------------------------- showing
    @property
    def sentences(self) -> list[str]:
        """All that is said in whole sentences, from above."""
        return [shown.text() for shown in (self._notice, *self._told) if shown.text()]

    @property
    def state(self) -> str:
        """The word of the lamp."""
        return self._state.text

    def lead(self, leads: bool) -> None:
        """Whether calibrating is the page's next thing to do, or something else is."""
        make_primary(self._calibrate, leads)
        self._calibrate.setIcon(icon("calibrate", "on_accent" if leads else "text"))

    def show_calibration(self) -> None:
        """The rig's calibration, and what came of the last one."""
        snapshot = self._rig.snapshot
        self._calibrate.setEnabled(snapshot.connected and snapshot.failure is None and not snapshot.busy and snapshot.calibrating is None)
        self._show_target()
        days = "" if snapshot.calibration is None else age_text(age_of(snapshot.calibration))
        shown = (snapshot.calibration, snapshot.found, snapshot.refused, snapshot.sphere, days, snapshot.unreadable)
        if shown == self._shown:
            return
        self._shown = shown
        self._show_notice()
        self._show_numbers()
        self._show_sentences()

    def _show_notice(self) -> None:
        snapshot = self._rig.snapshot
        calibration, refused = snapshot.calibration, snapshot.refused
        age = None if calibration is None else age_of(calibration)
        text = "" if calibration is None else expired_text(age)
        if refused is not None:
            self._state.show_state("warn", self.tr("New calibration not accepted"))
            stays = self.tr("Without a calibration the rig cannot scan.")
            if calibration is not None:
                stays = self.tr("The calibration of {date} stays in use.").format(date=fmt.day(calibration.date))
            text = "\n".join(part for part in (sentence_of(refused)[0], f"{stays} {text}".strip()) if part)
        elif calibration is None:
            self._state.show_state(*(("idle", self.tr("not known")) if snapshot.unreadable else ("warn", self.tr("Not calibrated"))))
        elif snapshot.found is not None:
            mood, words = age_text(age)
            self._state.show_state(mood, self.tr("Accepted  ·  {age}").format(age=words))
        else:
            self._state.show_state(*age_text(age))
        self._notice.setText(text)
        self._notice.setVisible(bool(text))

    def _show_numbers(self) -> None:
        calibration = self._rig.snapshot.calibration
        if calibration is None:
            self._accuracy.show_number(fmt.NO_VALUE)
            first = self.tr("Not calibrated yet: show the board to both cameras before the first scan.")
            self._calibrated.setText(self.tr("Its calibration stands in the rig file.") if self._rig.snapshot.unreadable else first)
            self.numbers.show_facts(())
            return
        self._accuracy.show_number(fmt.micrometres(calibration.held_out_rms_um))
        self._calibrated.setText(self.tr("Calibrated on {date}, {age}.").format(date=fmt.day(calibration.date), age=fmt.age(calibration.date)))
        sphere = self._rig.snapshot.sphere
        self.numbers.show_facts(calibration_facts(calibration) + ([] if sphere is None else [sphere_fact(sphere)]))

    def _show_sentences(self) -> None:
        for shown in self._told:
            self._sentences.removeWidget(shown)
            shown.deleteLater()
        snapshot = self._rig.snapshot
        told: list[tuple[str, str]] = []
        if snapshot.calibration is not None:
            from scanner_core.optics.calibration_result import scale_findings

            found = scale_findings(snapshot.calibration) if snapshot.found is None else snapshot.found.found()
            drift = drift_text(snapshot.sphere, snapshot.calibration)
            told += [("bad", drift)] if drift else []
            told += [("bad" if finding.kind.limits else "", finding_text(finding)) for finding in sorted(found, key=lambda f: not f.kind.limits)]
        change = None if snapshot.found is None else snapshot.found.change
        if change is not None:
            told.append(("section", self.tr("Since the previous calibration")))
            told.append(("bad" if change.significant else "", change_text(change)))
        self._told = [label(text, role, wrap=True) for role, text in told]
        for shown in self._told:
            if shown.property("role") == "section" and self._sentences.count():
                shown.setContentsMargins(0, 8, 0, 0)
            self._sentences.addWidget(shown)
        self.moved.show_facts([] if change is None else change_facts(change))
        self._line.setVisible(bool(told))

    # -------------------------------------------------------------------------------- the target
    def _choose_target(self) -> None:
        start = str(Path.home() / "impronta-target.pdf")
        title = self.tr("The calibration target as a page to print")
        choose_new_file(self, title, start, self.tr("PDF (*.pdf)"), "pdf", lambda path: self._rig.target.write(path, replace=True))

    def _show_target(self) -> None:
        self._target.setEnabled(not self._rig.target.busy)
        if self._rig.target.busy:
            self._written.hide()

    def _tell_written(self, path: str) -> None:
        from scanner_core.optics.printable_target import RULER_MM

        text = self.tr("Written to {path}. Print it at 100 % and check that its ruler measures {ruler} mm.")
        self._written.setText(text.format(path=fmt.short_path(path), ruler=f"{RULER_MM:g}"))
        self._written.show()
