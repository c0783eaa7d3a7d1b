"""One line for any page: is the rig ready, in one sentence, and the one thing to do when it is not."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.controllers.readiness import Readiness, ReadinessController, Remedy
from app.views.parts import Lamp, button, label, make_primary, row
from app.views.ready_words import ready_sentence, remedy_words

_MOODS = {Readiness.UNKNOWN: "idle", Readiness.READY: "good", Readiness.OBSTACLE: "warn"}


class ReadyLine(QWidget):
    """Follows the controller by itself.  `go` opens another page; `calibrate` begins a calibration where the page can."""

    def __init__(self, ready: ReadinessController, go: Callable[[str], object], calibrate: Callable[[], object] | None = None) -> None:
        """With `calibrate` the line belongs to the rig's own page, where its button is what is to be done next."""
        super().__init__()
        self._ready, self._go, self._calibrate = ready, go, calibrate
        self._leads = calibrate is not None
        self._lamp = Lamp()
        self._sentence = label("", wrap=True)
        self._sentence.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.remedy = button("", "", self._act)
        self.later = button(self.tr("Not now"), "link", ready.put_off)
        box = row(self._lamp, self._sentence, self.later, self.remedy, spacing=14)
        box.setContentsMargins(0, 0, 0, 0)
        box.setAlignment(self._lamp, Qt.AlignmentFlag.AlignVCenter)
        box.setStretch(1, 1)
        self.setLayout(box)
        ready.changed.connect(self.show_ready)
        self.show_ready()

    @property
    def sentence(self) -> str:
        return self._sentence.text()

    @property
    def state(self) -> str:
        """The word of the lamp."""
        return self._lamp.text

    def show_ready(self) -> None:
        """The newest answer; while it is looked at again the one before stays."""
        snapshot = self._ready.snapshot
        words = {
            Readiness.UNKNOWN: self.tr("Checking"),
            Readiness.READY: self.tr("Ready"),
            Readiness.OBSTACLE: self.tr("Attention"),
        }
        self._lamp.show_state(_MOODS[snapshot.readiness], words[snapshot.readiness])
        self._sentence.setText(ready_sentence(snapshot))
        self.setAccessibleName(f"{self._lamp.text}: {self._sentence.text()}")
        self.remedy.setText(remedy_words(snapshot.remedy))
        self.remedy.setVisible(snapshot.remedy is not Remedy.NONE)
        self.remedy.setEnabled(not snapshot.checking)
        self.later.setVisible(snapshot.remedy is Remedy.VERIFY)
        if self._leads:
            make_primary(self.remedy, snapshot.remedy is not Remedy.NONE)

    def _act(self) -> None:
        remedy = self._ready.snapshot.remedy
        if remedy is Remedy.SET_UP:
            self._go("assistant")
        elif remedy is Remedy.VERIFY:
            self._go("verify")
        elif remedy is not Remedy.CALIBRATE:
            self._ready.remedy()
        elif self._calibrate is not None:
            self._calibrate()
        else:
            self._go("rig")
