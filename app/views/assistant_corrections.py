"""What the check measured that the rig file should say otherwise, each to be taken or left."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QCheckBox, QFrame, QVBoxLayout

from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.parts import button, label, row

if TYPE_CHECKING:
    from scanner_core.commissioning.rig_findings import AxisFinding, RigFindings
    from scanner_core.devices.rig import RigConfig

AXES = ("x", "y", "table")
_EXCHANGED, _EXPOSURE = "exchanged", "exposure"
_TURN = {
    "x": QT_TRANSLATE_NOOP("assistant", "Turn the direction of beam X round: it moves the spot the other way."),
    "y": QT_TRANSLATE_NOOP("assistant", "Turn the direction of beam Y round: it moves the spot the other way."),
    "table": QT_TRANSLATE_NOOP("assistant", "Turn the direction of the table round: it turns the other way."),
}
_STEPS = {
    "x": QT_TRANSLATE_NOOP("assistant", "Correct the steps of beam X: it moves {percent} % of what it is told."),
    "y": QT_TRANSLATE_NOOP("assistant", "Correct the steps of beam Y: it moves {percent} % of what it is told."),
    "table": QT_TRANSLATE_NOOP("assistant", "Correct the steps of the table: it turns {percent} % of what it is told."),
}


def _tr(text: str) -> str:
    return QCoreApplication.translate("assistant", text)


def corrections_of(config: RigConfig, findings: RigFindings) -> dict[str, str]:
    """A sentence for everything that would be changed, by what :func:`only` takes."""
    from scanner_core.commissioning.proposed_rig import corrected_rig

    told = {}
    if findings.exchanged:
        told[_EXCHANGED] = _tr(QT_TRANSLATE_NOOP("assistant", "Exchange the cameras: the one that is called left stands to the right of the other."))
    for place, axis in enumerate(AXES):
        seen = findings.axes.get(axis)
        before, after = (rig.controller.units_per_deg[place] for rig in (config, corrected_rig(config, only(findings, {axis}))))
        if seen is None or before == after:
            continue
        told[axis] = _axis_text(seen, abs(after) != abs(before))
    exposed = corrected_rig(config, only(findings, {_EXPOSURE}))
    if (exposed.left, exposed.right) != (config.left, config.right):
        told[_EXPOSURE] = _tr(
            QT_TRANSLATE_NOOP(
                "assistant",
                "Expose both cameras for {ms} ms (left {left} dB, right {right} dB): it suits what stands there.",
            )
        ).format(ms=f"{exposed.left.exposure_ms:.3g}", left=f"{exposed.left.gain_db:.2g}", right=f"{exposed.right.gain_db:.2g}")
    return told


def only(findings: RigFindings, taken: set[str]) -> RigFindings:
    """The findings as far as they are to correct the rig."""
    return replace(
        findings,
        exchanged=findings.exchanged if _EXCHANGED in taken else None,
        axes={axis: seen for axis, seen in findings.axes.items() if axis in taken},
        cameras=findings.cameras if _EXPOSURE in taken else {},
    )


def _axis_text(seen: AxisFinding, steps: bool) -> str:
    texts = []
    if seen.direction is not None and seen.direction < 0:
        texts.append(_tr(_TURN[seen.axis]))
    if steps and seen.ratio is not None:
        texts.append(_tr(_STEPS[seen.axis]).format(percent=fmt.percent(seen.ratio)))
    return " ".join(texts)


class Corrections(QFrame):
    """Calls `correct(findings)` with what was taken; hidden while there is nothing to correct."""

    def __init__(self, correct: Callable[[RigFindings], None]) -> None:
        super().__init__()
        self._correct = correct
        self._findings: RigFindings | None = None
        self.boxes: dict[str, QCheckBox] = {}
        self.do = button(self.tr("Correct and check again"), "primary", self._take)
        self._lines = QVBoxLayout()
        self._lines.setSpacing(8)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(10)
        box.addWidget(label(self.tr("To be corrected"), "section"))
        box.addLayout(self._lines)
        box.addLayout(row(self.do, 1))
        self.hide()

    def show_findings(self, config: RigConfig | None, findings: RigFindings | None) -> None:
        """Of the rig under which they were measured."""
        if findings is self._findings:
            return
        self._findings = findings
        for line in self.boxes.values():
            self._lines.removeWidget(line)
            line.deleteLater()
        self.boxes = {}
        told = {} if config is None or findings is None else corrections_of(config, findings)
        for key, text in told.items():
            made = QCheckBox(text)
            made.setChecked(True)
            made.toggled.connect(self._show_taken)
            self._lines.addWidget(made)
            self.boxes[key] = made
        self._show_taken()
        self.setVisible(bool(told))

    def _show_taken(self) -> None:
        self.do.setEnabled(any(line.isChecked() for line in self.boxes.values()))

    def _take(self) -> None:
        if self._findings is not None:
            self._correct(only(self._findings, {key for key, line in self.boxes.items() if line.isChecked()}))
