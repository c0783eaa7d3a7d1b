"""A measured reference sphere: verdict, size deviation, all figures that belong together, and its certificate."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.controllers.verification import VerificationSnapshot
from app.theme import Sign
from app.views import format as fmt
from app.views.facts import Facts
from app.views.parts import BigNumber, button, label, make_primary, row, seam
from app.views.sphere_words import kept_sentence, size_um, sphere_facts, verdict_sentence, verdict_words
from scanner_core.metrology.decision import Verdict

_SIGNS = {Verdict.PASS: ("check", "good"), Verdict.FAIL: ("cross", "warning"), Verdict.UNDECIDED: ("warning", "warning")}


class SphereResultPanel(QWidget):
    """Calls `save()` and, where the rig has failed, `calibrate()`."""

    def __init__(self, save: Callable[[], None], calibrate: Callable[[], None]) -> None:
        super().__init__()
        self._sign, self._verdict = Sign(26), label("", "headline")
        self._why = label("", "", wrap=True, selectable=True)
        self.deviation = BigNumber("", "hero")
        self.facts = Facts()
        self._kept, self._saved = label("", "muted", wrap=True), label("", "good", wrap=True, selectable=True)
        self.save = button(self.tr("Save certificate…"), "", save, "export")
        self.calibrate = button(self.tr("To the calibration"), "", calibrate, "calibrate")
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        verdict = row(self._sign, self._verdict, spacing=10)
        verdict.setStretch(1, 1)
        box.addLayout(verdict)
        box.addSpacing(6)
        box.addWidget(self._why)
        box.addSpacing(16)
        box.addWidget(self.deviation)
        box.addSpacing(14)
        box.addWidget(seam())
        box.addSpacing(14)
        box.addWidget(self.facts)
        box.addSpacing(14)
        box.addWidget(self._kept)
        box.addSpacing(12)
        box.addLayout(row(self.calibrate, self.save, 1))
        box.addSpacing(8)
        box.addWidget(self._saved)
        box.addStretch(1)

    @property
    def texts(self) -> tuple[str, str]:
        """The verdict and what it means."""
        return self._verdict.text(), self._why.text()

    def show_result(self, snapshot: VerificationSnapshot) -> None:
        """There is one."""
        check = snapshot.check
        if check is None:
            return
        result, verdict = check.result, check.result.verdict
        self._sign.show_sign(*_SIGNS[verdict])
        self._verdict.setText(verdict_words(verdict))
        self._why.setText(verdict_sentence(result))
        value, uncertainty, _ = size_um(result)
        self.deviation.show_unit(self.tr("µm size deviation, U = {uncertainty} µm (k = 2)").format(uncertainty=fmt.decimal(uncertainty, 1)))
        self.deviation.show_number(fmt.decimal(value, 1, signed=True))
        self.facts.show_facts(sphere_facts(result))
        self._kept.setText(kept_sentence(snapshot))
        self.save.setEnabled(not snapshot.saving)
        self.save.setText(self.tr("Writing the certificate…") if snapshot.saving else self.tr("Save certificate…"))
        failed = verdict is Verdict.FAIL
        self.calibrate.setVisible(failed)
        make_primary(self.calibrate, failed)
        make_primary(self.save, verdict is Verdict.PASS)
        self._saved.setText("" if snapshot.saved is None else self.tr("Saved: {path}").format(path=fmt.short_path(str(snapshot.saved))))
        self._saved.setVisible(snapshot.saved is not None)


def certificate_name(folder: str, rig: str, date: str) -> str:
    """Where the certificate of a rig goes by itself: its name and the day."""
    return str(Path(folder) / f"{rig}_sphere_{date[:10]}.pdf")
