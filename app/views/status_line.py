"""The line at the bottom: cameras, laser, turntable, calibration, rig; visible from every page."""

from __future__ import annotations

from PySide6.QtWidgets import QFrame, QHBoxLayout

from app.views.parts import Lamp, label, seam


class StatusLine(QFrame):
    """Lamps with words, a seam between them."""

    def __init__(self) -> None:
        super().__init__()
        self.setProperty("role", "status")
        self.cameras = Lamp()
        self.laser = Lamp()
        self.turntable = Lamp()
        self.calibration = Lamp()
        self._activity = label("", "muted")
        self._rig = label("", "muted")
        box = QHBoxLayout(self)
        box.setContentsMargins(16, 0, 16, 0)
        box.setSpacing(14)
        for lamp in (self.cameras, self.laser, self.turntable, self.calibration):
            box.addWidget(lamp)
            box.addWidget(seam(upright=True))
        box.addWidget(self._activity)
        box.addStretch(1)
        box.addWidget(self._rig)
        self.setFixedHeight(30)

    def show_rig(self, text: str) -> None:
        self._rig.setText(text)

    def show_activity(self, text: str) -> None:
        self._activity.setText(text)
