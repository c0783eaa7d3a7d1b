"""Reference sphere: is the rig still right?  What to do, one button, how far it is, and what came of it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QDoubleSpinBox, QGridLayout, QHBoxLayout, QProgressBar, QStackedWidget, QVBoxLayout, QWidget

from app.controllers.verification import VIRTUAL_SPHERE, CertifiedSphere
from app.faults import sentence_of
from app.services import Services
from app.views import format as fmt
from app.views.accuracy_card import AccuracyCard
from app.views.file_dialogs import choose_new_file
from app.views.page import Page
from app.views.parts import BigNumber, button, column, label, make_primary, row, scrolled, seam
from app.views.sphere_result import SphereResultPanel, certificate_name
from scanner_core.metrology.decision import Verdict

_PDF = "PDF (*.pdf)"


class VerifyPage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._verification = services.verification
        self.result = SphereResultPanel(self._choose_file, lambda: self.wanted.emit("rig"))
        self.last = AccuracyCard()
        self._rights = QStackedWidget()
        before = QWidget()
        before.setLayout(column(self.last, 1))
        for part in (before, self._running(), self.result):
            if (inside := part.layout()) is not None:
                inside.setContentsMargins(0, 0, 0, 0)
            part.setContentsMargins(36, 34, 36, 24)
            self._rights.addWidget(scrolled(part))
        box = QHBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(scrolled(self._left()), 6)
        box.addWidget(seam(upright=True))
        box.addWidget(self._rights, 7)
        services.rig.changed.connect(self._show_if_seen)
        services.verification.changed.connect(self._show_if_seen)
        self._show()

    def entered(self) -> None:
        self._show()

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        self._verification.watched = True
        super().showEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        self._verification.watched = False
        super().hideEvent(event)

    # -------------------------------------------------------------------------------- parts
    def _left(self) -> QWidget:
        settings = self.services.settings
        self._steps = label("", wrap=True)
        self.diameter = _field(0.0, 200.0, 4, 0.01, " mm", settings.sphere_diameter_mm, self.tr("Certified diameter"))
        self.diameter.setSpecialValueText(self.tr("not entered"))
        self.uncertainty = _field(0.0, 100.0, 1, 0.1, " µm", settings.sphere_uncertainty_um, self.tr("Its uncertainty U (k = 2)"))
        self.diameter.valueChanged.connect(self._enter)
        self.uncertainty.valueChanged.connect(self._enter)
        self._certified = label("", "muted", wrap=True)
        self.start = button(self.tr("Measure the sphere"), "primary", self._start, "play")
        self.notice = label("", "notice", wrap=True, selectable=True)
        self._fields = QWidget()
        fields = QGridLayout(self._fields)
        fields.setContentsMargins(0, 0, 0, 0)
        fields.setVerticalSpacing(8)
        fields.setColumnStretch(0, 1)
        for line, field in enumerate((self.diameter, self.uncertainty)):
            name = label(field.accessibleName())
            name.setBuddy(field)
            fields.addWidget(name, line, 0)
            fields.addWidget(field, line, 1)
        made = QWidget()
        box = QVBoxLayout(made)
        box.setContentsMargins(40, 34, 40, 24)
        box.setSpacing(0)
        about = label(
            self.tr("A sphere of certified size tells whether the rig still measures right. It takes about a minute; nothing is scanned meanwhile."),
            "muted",
            wrap=True,
        )
        for part, space in (
            (label(self.tr("Reference sphere"), "headline"), 6),
            (about, 20),
            (self._steps, 20),
            (seam(), 16),
            (label(self.tr("From its certificate"), "section"), 10),
            (self._fields, 0),
            (self._certified, 22),
            (self.notice, 14),
        ):
            box.addWidget(part)
            box.addSpacing(space)
        box.addLayout(row(self.start, button(self.tr("Back to the rig"), "link", lambda: self.wanted.emit("rig")), 1, spacing=16))
        box.addStretch(1)
        more = self.tr("The whole test measures the sphere ten times and belongs to an acceptance: impronta verify sphere")
        box.addWidget(label(more, "faint", wrap=True, selectable=True))
        return made

    def _running(self) -> QWidget:
        self.share = BigNumber(self.tr("% done"), "hero")
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName(self.tr("Progress of the measurement"))
        self.time_left = label("", "muted")
        self.cancel = button(self.tr("Cancel"), "", self._verification.cancel)
        made = QWidget()
        box = QVBoxLayout(made)
        box.setSpacing(0)
        box.addWidget(label(self.tr("Measuring the reference sphere"), "section"))
        box.addWidget(self.share)
        box.addSpacing(10)
        box.addWidget(self.bar)
        box.addSpacing(8)
        box.addWidget(self.time_left)
        box.addSpacing(18)
        box.addLayout(row(self.cancel, 1))
        box.addSpacing(14)
        box.addWidget(label(self.tr("Keep your hands off and the lid closed. Esc switches the laser off at once."), "muted", wrap=True))
        box.addStretch(1)
        return made

    # -------------------------------------------------------------------------------- what a person does
    def _enter(self) -> None:
        self.services.settings.sphere_diameter_mm = self.diameter.value()
        self.services.settings.sphere_uncertainty_um = self.uncertainty.value()
        self._show()

    def _start(self) -> None:
        own = CertifiedSphere(self.diameter.value(), 1e-3 * self.uncertainty.value())
        self._verification.start(VIRTUAL_SPHERE if self.services.rig.snapshot.virtual else own)

    def _choose_file(self) -> None:
        snapshot = self._verification.snapshot
        if snapshot.check is None:
            return
        name = certificate_name(self.services.settings.export_folder, Path(snapshot.preset).stem, snapshot.check.entry.date)
        choose_new_file(
            self, self.tr("Save the certificate"), name, _PDF, "pdf", lambda path: self._verification.save(path, replace_it=path.exists())
        )

    # -------------------------------------------------------------------------------- showing
    def _show_if_seen(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        rig, snapshot = self.services.rig.snapshot, self._verification.snapshot
        if rig.virtual:
            self._steps.setText(
                self.tr("The virtual rig puts its sphere on the table by itself, and afterwards puts back what stood there. Nothing has to be done.")
            )
            diameter, uncertainty = fmt.decimal(VIRTUAL_SPHERE.diameter_mm, 3), fmt.decimal(1e3 * VIRTUAL_SPHERE.uncertainty_mm, 1)
            told = self.tr("Diameter {diameter} mm, U = {uncertainty} µm: the sphere of the virtual rig.")
            self._certified.setText(told.format(diameter=diameter, uncertainty=uncertainty))
        else:
            steps = (
                self.tr("1.  Take away what stands on the table."),
                self.tr("2.  Put the reference sphere into the middle of the table, clean and alone."),
                self.tr("3.  Close the lid."),
            )
            self._steps.setText("\n".join(steps))
        self._fields.setVisible(not rig.virtual)
        self._certified.setVisible(rig.virtual)
        self._fields.setEnabled(not snapshot.running)
        obstacle = self._obstacle()
        self.start.setEnabled(rig.at_rest and not snapshot.running and not obstacle)
        self.start.setText(self.tr("Measure again") if snapshot.check is not None else self.tr("Measure the sphere"))
        make_primary(self.start, snapshot.check is None or snapshot.check.result.verdict is Verdict.UNDECIDED)
        self.notice.setText(obstacle or self._refusal())
        self.notice.setVisible(bool(self.notice.text()))
        self._rights.setCurrentIndex(1 if snapshot.running else 0 if snapshot.check is None else 2)
        if snapshot.running:
            self._show_progress()
        elif snapshot.check is None:
            self.last.show_rig(rig)
        else:
            self.result.show_result(snapshot)

    def _show_progress(self) -> None:
        snapshot = self._verification.snapshot
        self.share.show_number(fmt.percent(snapshot.fraction))
        self.bar.setValue(round(1000 * snapshot.fraction))
        self.time_left.setText(self.tr("{left} left").format(left=fmt.left_time(snapshot.left_s)))
        self.cancel.setEnabled(not snapshot.cancelling)
        self.cancel.setText(self.tr("Cancelling…") if snapshot.cancelling else self.tr("Cancel"))

    def _obstacle(self) -> str:
        """What keeps it from being started, as far as a person can change that."""
        rig = self.services.rig.snapshot
        if self._verification.running:
            return ""
        if rig.unreadable or rig.failure is not None:
            return self.tr("The rig is not open: the Rig page says why.")
        if self.services.acquisition.running or rig.busy:
            return self.tr("A scan is running: wait for its end or stop it first (Esc).")
        if rig.connected and rig.calibrating is None and rig.calibration is None:
            return self.tr("This rig is not calibrated: calibrate it first.")
        if not rig.virtual and rig.connected and not self.diameter.value():
            return self.tr("Enter the diameter from the sphere's certificate.")
        return ""

    def _refusal(self) -> str:
        """What became of the last attempt, when that is nothing."""
        snapshot = self._verification.snapshot
        if snapshot.cancelled:
            return self.tr("Cancelled: nothing was kept, and the laser is off.")
        return "" if snapshot.refused is None else " ".join(sentence_of(snapshot.refused))


def _field(low: float, high: float, decimals: int, step: float, suffix: str, value: float, name: str) -> QDoubleSpinBox:
    made = QDoubleSpinBox()
    made.setRange(low, high)
    made.setDecimals(decimals)
    made.setSingleStep(step)
    made.setSuffix(suffix)
    made.setValue(value)
    made.setAlignment(Qt.AlignmentFlag.AlignRight)
    made.setMinimumHeight(30)
    made.setMinimumWidth(140)
    made.setKeyboardTracking(False)
    made.setAccessibleName(name)
    return made
