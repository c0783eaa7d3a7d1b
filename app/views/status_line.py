"""The line at the bottom: cameras, laser, turntable, calibration, rig; visible from every page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFrame, QHBoxLayout

from app.controllers.device_failure import CONTROLLER, LEFT, RIGHT
from app.controllers.rig_snapshot import RigSnapshot
from app.views import format as fmt
from app.views.calibration_words import age_of, age_text, expired_text
from app.views.parts import Lamp, button, label, seam


class StatusLine(QFrame):
    """Lamps with words, a seam between them."""

    def __init__(self, open_reconstructed: Callable[[], object] = lambda: None) -> None:
        """`open_reconstructed` leads to the order that is being reconstructed."""
        super().__init__()
        self.setProperty("role", "status")
        self.cameras = Lamp()
        self.laser = Lamp()
        self.turntable = Lamp()
        self.calibration = Lamp()
        self._activity = label("", "muted")
        self.reconstruction = button("", "link", open_reconstructed)
        self.reconstruction.setToolTip(self.tr("Open the order that is being reconstructed"))
        self.reconstruction.hide()
        self._rig = label("", "muted")
        box = QHBoxLayout(self)
        box.setContentsMargins(16, 0, 16, 0)
        box.setSpacing(14)
        for lamp in (self.cameras, self.laser, self.turntable, self.calibration):
            box.addWidget(lamp)
            box.addWidget(seam(upright=True))
        box.addWidget(self._activity)
        box.addWidget(self.reconstruction)
        box.addStretch(1)
        box.addWidget(self._rig)
        self.setFixedHeight(30)

    def show_rig(self, rig: RigSnapshot) -> None:
        """All but the laser, which has a pace of its own."""
        self.cameras.show_state(*self._cameras_state(rig))
        if rig.motion is None:
            self.turntable.show_state("idle", self.tr("Turntable"))
        else:
            mood = "warn" if rig.needs_homing and not rig.simulated else "good"
            self.turntable.show_state(mood, self.tr("Turntable {angle}°").format(angle=fmt.decimal(rig.motion.table_deg, 1)))
        calibration = rig.calibration
        if rig.unreadable:
            self.calibration.show_state("idle", self.tr("Calibration"))
        elif calibration is None:
            self.calibration.show_state("warn", self.tr("Not calibrated"))
        else:
            age = age_of(calibration)
            text = self.tr("Calibration expired") if expired_text(age) else self.tr("Calibration {age}").format(age=fmt.age(calibration.date))
            self.calibration.show_state(age_text(age)[0], text)
        name = Path(rig.preset).stem if rig.own else rig.preset
        speed = self.tr("full speed") if rig.speed == "max" else f"{rig.speed}×"
        words = self.tr("Virtual rig  ·  {rig}  ·  {speed}") if rig.simulated else self.tr("Virtual rig  ·  {rig}") if rig.virtual else "{rig}"
        self._rig.setText(words.format(rig=name, speed=speed))

    def _cameras_state(self, rig: RigSnapshot) -> tuple[str, str]:
        """Of both; what keeps the rig from being open when it is another device, or its file."""
        if rig.connected:
            return "good", self.tr("Cameras ready")
        if rig.opening:
            return "idle", self.tr("Cameras opening")
        if rig.failure is None:
            return "idle", self.tr("Cameras not open")
        words = {
            LEFT: self.tr("Camera left not available"),
            RIGHT: self.tr("Camera right not available"),
            CONTROLLER: self.tr("Controller not available"),
        }
        return "warn", words.get(rig.failure.device, self.tr("The rig file cannot be used"))

    def show_activity(self, text: str) -> None:
        self._activity.setText(text)
        self._activity.setVisible(bool(text))

    def show_reconstruction(self, text: str) -> None:
        """Whose points are being reconstructed, and how long yet; empty for none."""
        self.reconstruction.setText(text)
        self.reconstruction.setVisible(bool(text))
