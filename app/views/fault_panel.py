"""Let something go wrong on the virtual rig: which fault, when, and what was let happen so far.  Folded until it is wanted."""

from __future__ import annotations

import time

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QComboBox, QVBoxLayout, QWidget

from app.controllers.rig import RigController
from app.views.parts import button, label, number_field, row

_LONGEST_S = 600
_SHOWN = 3


class FaultPanel(QWidget):
    """A line to unfold, and what is behind it."""

    def __init__(self, rig: RigController) -> None:
        super().__init__()
        self._rig = rig
        self.toggle = button(self.tr("Let something go wrong…"), "link", self._unfold)
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Fault"))
        self.choice.setMinimumHeight(32)
        self.choice.setMinimumContentsLength(14)
        self.choice.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.choice.currentIndexChanged.connect(self._describe)
        self.when = number_field(0, _LONGEST_S, 1, lambda _: None, suffix=self.tr(" s from now"), special=self.tr("now"))
        self.when.setFixedWidth(130)
        self.do = button(self.tr("Let it happen"), "", self._happen)
        self.right = button(self.tr("Put everything right"), "link", self._put_right)
        self.right.setToolTip(self.tr("Opens the virtual rig anew"))
        self._about = label("", "muted", wrap=True)
        self._in_force = label("", "bad", wrap=True)
        self._inside = QWidget()
        inside = QVBoxLayout(self._inside)
        inside.setContentsMargins(0, 4, 0, 0)
        inside.setSpacing(8)
        line = row(self.choice, self.when, self.do)
        line.setStretch(0, 1)
        inside.addLayout(line)
        inside.addWidget(self._about)
        told = row(self._in_force, self.right, spacing=14)
        told.setStretch(0, 1)
        told.setAlignment(self.right, Qt.AlignmentFlag.AlignTop)
        inside.addLayout(told)
        self._inside.hide()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(self.toggle, 0, Qt.AlignmentFlag.AlignLeft)
        box.addWidget(self._inside)
        self.show_rig()

    @property
    def in_force(self) -> str:
        """What is said of the faults so far."""
        return self._in_force.text()

    def show_rig(self) -> None:
        """Whether there is a virtual rig, and what was let happen on it."""
        snapshot = self._rig.snapshot
        self.setVisible(not snapshot.own if snapshot.config is None else snapshot.config.virtual is not None)
        self.do.setEnabled(snapshot.connected)
        newest = [self._words(*entry) for entry in self._rig.faults[: -_SHOWN - 1 : -1]]
        more = len(self._rig.faults) - len(newest)
        if more > 0:
            newest.append(self.tr("{n} before").format(n=more))
        self._in_force.setText(self.tr("So far: {faults}").format(faults=", ".join(newest)) if newest else "")
        self.right.setVisible(bool(newest))

    # -------------------------------------------------------------------------------- inside
    def _words(self, title: str, at_s: float) -> str:
        left_s = at_s - time.monotonic()
        word = QCoreApplication.translate("rig-faults", title)
        return self.tr("{fault} in {n} s").format(fault=word, n=f"{left_s:.0f}") if left_s > 0.5 else word

    def _unfold(self) -> None:
        if not self.choice.count():
            from scanner_core.virtual.faults import FAULTS

            for name, fault in FAULTS.items():
                self.choice.addItem(QCoreApplication.translate("rig-faults", fault.title), name)
        self._inside.setVisible(self._inside.isHidden())

    def _describe(self) -> None:
        from scanner_core.virtual.faults import FAULTS

        fault = FAULTS[self.choice.currentData()]
        parts = [QCoreApplication.translate("rig-faults", part) for part in (fault.happens, fault.expected)]
        self._about.setText(self.tr("{happens}. The program {expected}.").format(happens=parts[0][:1].upper() + parts[0][1:], expected=parts[1]))

    def _happen(self) -> None:
        self._rig.let_happen(self.choice.currentData(), self.when.value())

    def _put_right(self) -> None:
        self._rig.choose()
