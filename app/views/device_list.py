"""The devices of the rig, each with its state, what it says of itself, what is wrong with it, and what can be done about it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QPushButton, QVBoxLayout, QWidget

from app.controllers.device_failure import CONTROLLER, LEFT, RIG_FILE, RIGHT
from app.controllers.emission import Emission
from app.controllers.rig import RigController
from app.controllers.rig_snapshot import RigSnapshot
from app.faults import sentence_of
from app.views import format as fmt
from app.views.device_row import DeviceRow
from app.views.parts import button, label, row
from scanner_core.devices.camera import CameraReport
from scanner_core.devices.motion import MotionState

_HALTED = (MotionState.ALARM, MotionState.DOOR, MotionState.UNKNOWN)


class DeviceList(QWidget):
    """Asks the rig's controller for what a person wants done."""

    def __init__(self, rig: RigController, show_transcript: Callable[[], None]) -> None:
        super().__init__()
        self._rig = rig
        self._emission: Emission | None = None
        self._again = {name: self._try_again() for name in (LEFT, RIGHT, CONTROLLER, RIG_FILE)}
        self._reference = button(self.tr("Find reference"), "", rig.find_reference)
        self._reference.setToolTip(self.tr("The axes move until they find their switches; nobody may reach into the rig"))
        self._unlock = button(self.tr("Unlock"), "", rig.unlock)
        self._unlock.setToolTip(self.tr("Ends the alarm; nothing moves, and the position may be lost"))
        self._forget = button(self.tr("Take it off the list"), "link", self._forget_rig)
        self.transcript = button(self.tr("Transcript…"), "link", show_transcript)
        self.transcript.setToolTip(self.tr("The last 200 lines to and from the controller"))
        self._file_fault = label("", "notice", wrap=True, selectable=True)
        self.rows = {
            LEFT: DeviceRow(self.tr("Camera left"), self._again[LEFT]),
            RIGHT: DeviceRow(self.tr("Camera right"), self._again[RIGHT]),
            CONTROLLER: DeviceRow(self.tr("Controller"), self._again[CONTROLLER], self._unlock, self._reference),
            "laser": DeviceRow(self.tr("Laser")),
            "turntable": DeviceRow(self.tr("Turntable")),
        }
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(10)
        box.addLayout(row(label(self.tr("Devices"), "section"), 1, self.transcript))
        box.addWidget(self._file_fault)
        box.addLayout(row(self._again[RIG_FILE], self._forget, 1, spacing=14))
        for device in self.rows.values():
            box.addWidget(device)

    def show_rig(self) -> None:
        """All but the laser, which has a pace of its own."""
        rig = self._rig.snapshot
        failure = rig.failure
        for name, again in self._again.items():
            again.setVisible(failure is not None and failure.device == name and not rig.connected)
            again.setEnabled(not rig.opening)
        broken_file = failure is not None and failure.device == RIG_FILE
        self._file_fault.setText("\n".join(sentence_of(failure.fault)) if failure is not None and broken_file else "")
        self._file_fault.setVisible(broken_file)
        self._forget.setVisible(broken_file and rig.own)
        for name in (LEFT, RIGHT):
            self._show_camera(name, rig)
        self._show_controller(rig)
        self._show_turntable(rig)

    def show_laser(self) -> None:
        """As the controller last reported it."""
        emission = self._rig.emission
        if emission is self._emission:
            return
        self._emission = emission
        words = {
            Emission.NO_RIG: ("idle", "–"),
            Emission.UNKNOWN: ("warn", self.tr("unknown")),
            Emission.DARK: ("idle", self.tr("off")),
            Emission.LIT: ("laser", self.tr("emitting")),
        }
        self.rows["laser"].show_state(*words[emission])
        told = {Emission.NO_RIG: "", Emission.UNKNOWN: self.tr("take it for lit: the controller reports nothing")}
        self.rows["laser"].show_device(told.get(emission, self.tr("as the controller reports it")))

    # -------------------------------------------------------------------------------- inside
    def _try_again(self) -> QPushButton:
        return button(self.tr("Try again"), "", lambda: self._rig.choose())

    def _forget_rig(self) -> None:
        self._rig.files.forget(self._rig.snapshot.preset)
        self._rig.choose(preset="bench")

    def _show_fault(self, name: str, rig: RigSnapshot) -> bool:
        """What is wrong with this device; False when it is another one, or none."""
        failure = rig.failure
        if failure is None or failure.device != name:
            self.rows[name].show_fault(None)
            return False
        after = self.tr("It is opened again by itself when it is back.") if failure.returns else ""
        self.rows[name].show_fault(failure.fault, after)
        return True

    def _waiting(self, rig: RigSnapshot) -> tuple[str, str]:
        """The lamp of a device with which nothing is wrong."""
        if rig.connected:
            return "good", self.tr("ready")
        return "idle", self.tr("not open") if rig.failure is not None and not rig.opening else self.tr("opening…")

    def _show_camera(self, name: str, rig: RigSnapshot) -> None:
        shown, report = self.rows[name], rig.cameras.get(name)
        if self._show_fault(name, rig):
            shown.show_state("warn", self.tr("not available"))
        else:
            refused = report is not None and bool(report.refused)
            shown.show_state(*(("warn", self.tr("ready, not as asked")) if refused else self._waiting(rig)))
        config = None if rig.config is None else (rig.config.left if name == LEFT else rig.config.right)
        if report is None:
            shown.show_device("" if config is None else config.id)
        elif rig.own:
            shown.show_device(report.model, self._settings(report), report.refused, f"{report.driver}: {report.id}")
        else:
            shown.show_device(f"{report.id}  ·  {report.exposure_ms:g} ms  ·  {report.gain_db:g} dB")

    def _settings(self, report: CameraReport) -> str:
        triggers = {"free": self.tr("free running"), "software": self.tr("software trigger"), "hardware": self.tr("hardware trigger")}
        width, height = report.size_px
        known = (
            f"{width} × {height} px",
            f"{report.rate_hz:.4g} Hz",
            f"{report.exposure_ms:.4g} ms" if report.exposure_ms > 0 else "",  # some cameras do not tell
            f"{report.gain_db:.3g} dB",
            report.pixel_format,
            triggers.get(report.trigger, report.trigger),
        )
        return "  ·  ".join(part for part in known if part)

    def _show_controller(self, rig: RigSnapshot) -> None:
        shown, motion = self.rows[CONTROLLER], rig.motion
        failed = self._show_fault(CONTROLLER, rig)
        alarmed = rig.connected and (failed or (motion is not None and motion.state in _HALTED))
        if failed and not rig.connected:
            shown.show_state("warn", self.tr("not available"))
        elif rig.acting == "home":
            shown.show_state("warn", self.tr("finding its reference…"))
        elif motion is None or not rig.connected:
            shown.show_state(*self._waiting(rig))
        else:
            halted = failed and motion.state not in _HALTED
            shown.show_state("warn" if alarmed else "good", self.tr("stopped") if halted else self._state_word(motion.state))
        self._unlock.setVisible(alarmed)
        self._reference.setVisible(rig.connected and rig.needs_homing)
        for made in (self._unlock, self._reference):
            made.setEnabled(not rig.acting and not rig.busy and rig.calibrating is None)
        port = "" if rig.config is None else rig.config.controller.port
        told = rig.controller
        about = ""
        if told and rig.own:
            mode = self.tr("laser mode on") if told.get("laser_mode") else self.tr("laser mode off")
            firmware = str(told.get("firmware", "")).partition(" [")[0]
            about = "  ·  ".join((firmware, self.tr("axes {letters}").format(letters=told.get("axes", "")), mode))
        shown.show_device(port, about)

    def _show_turntable(self, rig: RigSnapshot) -> None:
        shown, motion = self.rows["turntable"], rig.motion
        angle = "–" if motion is None else f"{fmt.decimal(motion.table_deg, 1)}°"
        unknown = rig.needs_homing and not rig.simulated  # a computed table begins where it is thought to be
        shown.show_state("idle" if motion is None else "warn" if unknown else "good", angle)
        shown.show_device(self.tr("position unknown: find the reference") if unknown else "")

    def _state_word(self, state: MotionState) -> str:
        return {
            MotionState.IDLE: self.tr("idle"),
            MotionState.MOVING: self.tr("moving"),
            MotionState.HOLD: self.tr("held"),
            MotionState.HOMING: self.tr("homing"),
            MotionState.ALARM: self.tr("alarm"),
            MotionState.DOOR: self.tr("door open"),
        }.get(state, self.tr("unknown"))
