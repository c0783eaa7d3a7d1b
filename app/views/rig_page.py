"""Rig: which one, what stands on the virtual table, how fast it runs, what its devices say, and its calibration."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QButtonGroup, QComboBox, QGridLayout, QHBoxLayout, QPushButton, QStackedWidget, QVBoxLayout, QWidget

from app.controllers.emission import Emission
from app.controllers.rig import SPECIMENS, SPEEDS
from app.services import Services
from app.translation import QT_TRANSLATE_NOOP
from app.views.board_watch_view import BoardWatchView
from app.views.calibrating_panel import CalibratingPanel
from app.views.calibration_panel import CalibrationPanel
from app.views.camera_preview import CameraPreview
from app.views.fault_panel import FaultPanel
from app.views.file_dialogs import choose_file
from app.views.page import Page
from app.views.parts import Lamp, button, label, row, seam
from scanner_core.devices.motion import MotionState

PRESET_WORDS = {
    "bench": QT_TRANSLATE_NOOP("rig", "Bench: 604 × 294 px at 435 mm"),
    "paper-2003": QT_TRANSLATE_NOOP("rig", "Paper 2003: the published rig at 770 mm"),
    "workshop": QT_TRANSLATE_NOOP("rig", "Workshop: 1440 × 1080 px at 600 mm"),
}
SPECIMEN_WORDS = {
    "ear": QT_TRANSLATE_NOOP("rig", "Ear impression"),
    "arch": QT_TRANSLATE_NOOP("rig", "Dental arch"),
    "heart": QT_TRANSLATE_NOOP("rig", "Heart"),
    "sphere": QT_TRANSLATE_NOOP("rig", "Reference sphere"),
}
SPEED_WORDS = {
    "1": QT_TRANSLATE_NOOP("rig", "Real time"),
    "5": QT_TRANSLATE_NOOP("rig", "5 times"),
    "max": QT_TRANSLATE_NOOP("rig", "As fast as it can"),
}


def specimen_words(name: str) -> str:
    """A built-in specimen in words, a file by its name."""
    word = SPECIMEN_WORDS.get(name)
    return QCoreApplication.translate("rig", word) if word else Path(name).name


class RigPage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        box = QHBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        self.calibration = CalibrationPanel(services.rig)
        self.board = BoardWatchView()
        self.progress = CalibratingPanel(services.rig)
        self._emission: Emission | None = None
        self.faults = FaultPanel(services.rig)
        self._lefts, self._rights = QStackedWidget(), QStackedWidget()
        for stack, parts in ((self._lefts, (self._left(), self.board)), (self._rights, (self.calibration, self.progress))):
            for part in parts:
                stack.addWidget(part)
        box.addWidget(self._lefts, 6)
        box.addWidget(seam(upright=True))
        box.addWidget(self._rights, 5)
        services.rig.changed.connect(self._show_if_seen)
        self._show()

    def entered(self) -> None:
        self._show()

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        self.services.rig.watching.set()
        super().showEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        self.services.rig.watching.clear()
        super().hideEvent(event)

    def tick(self) -> None:
        """For the pump: the newest frames of the idle rig, or the newest look at the board."""
        look = self.services.rig.calibration.looks.take()
        if look is not None and self.services.rig.snapshot.calibrating is not None:
            self.board.show_look(look)
            self.progress.show_look(look)
        if self.isVisible():
            self._show_laser()
        for name, preview in self._previews.items():
            frame = self.services.rig.frames[name].take()
            if frame is not None and self.isVisible():
                preview.show_frame(frame)

    # -------------------------------------------------------------------------------- parts
    def _left(self) -> QWidget:
        self._preset = QComboBox()
        for key, word in PRESET_WORDS.items():
            self._preset.addItem(QCoreApplication.translate("rig", word), key)
        self._preset.activated.connect(lambda index: self.services.rig.choose(preset=self._preset.itemData(index)))
        self._specimen = QComboBox()
        for key in SPECIMENS:
            self._specimen.addItem(QCoreApplication.translate("rig", SPECIMEN_WORDS[key]), key)
        self._specimen.activated.connect(lambda index: self.services.rig.choose(specimen=self._specimen.itemData(index)))
        self._file = button(self.tr("Mesh file…"), "", self._choose_file, "folder")
        speeds = QHBoxLayout()
        speeds.setSpacing(8)
        group = QButtonGroup(self)
        self._speeds: dict[str, QPushButton] = {}
        for key in SPEEDS:
            made = button(QCoreApplication.translate("rig", SPEED_WORDS[key]), "choice", partial(self.services.rig.choose, speed=key))
            made.setCheckable(True)
            group.addButton(made)
            speeds.addWidget(made, 1)
            self._speeds[key] = made
        for field in (self._preset, self._specimen):
            field.setMinimumHeight(34)
        form = QGridLayout()
        form.setHorizontalSpacing(18)
        form.setVerticalSpacing(14)
        form.setColumnMinimumWidth(0, 110)
        form.setColumnStretch(1, 1)
        form.addWidget(label(self.tr("Rig"), "muted"), 0, 0)
        form.addWidget(self._preset, 0, 1)
        form.addWidget(label(self.tr("On the table"), "muted"), 1, 0)
        form.addLayout(row(self._specimen, self._file), 1, 1)
        form.addWidget(label(self.tr("Speed"), "muted"), 2, 0)
        form.addLayout(speeds, 2, 1)
        self._devices = {name: (Lamp(), label("", "muted")) for name in ("left", "right", "controller", "laser", "turntable")}
        words = {
            "left": self.tr("Camera left"),
            "right": self.tr("Camera right"),
            "controller": self.tr("Controller"),
            "laser": self.tr("Laser"),
            "turntable": self.tr("Turntable"),
        }
        devices = QGridLayout()
        devices.setHorizontalSpacing(18)
        devices.setVerticalSpacing(12)
        devices.setColumnMinimumWidth(0, 110)
        devices.setColumnStretch(2, 1)
        for line, (name, (lamp, detail)) in enumerate(self._devices.items()):
            devices.addWidget(label(words[name], "muted"), line, 0)
            devices.addWidget(lamp, line, 1)
            devices.addWidget(detail, line, 2, Qt.AlignmentFlag.AlignRight)
        side = QWidget()
        side_box = QVBoxLayout(side)
        side_box.setContentsMargins(40, 38, 40, 30)
        side_box.setSpacing(0)
        side_box.addWidget(label(self.tr("Virtual rig"), "headline"))
        side_box.addSpacing(6)
        about = self.tr("Two cameras, a laser and a turntable, computed frame by frame; the rest is the real program.")
        side_box.addWidget(label(about, "muted", wrap=True))
        side_box.addSpacing(28)
        side_box.addLayout(form)
        side_box.addSpacing(30)
        side_box.addWidget(seam())
        side_box.addSpacing(22)
        side_box.addWidget(label(self.tr("Devices"), "section"))
        side_box.addSpacing(12)
        side_box.addLayout(devices)
        side_box.addSpacing(22)
        self._previews = {"left": CameraPreview(self.tr("Camera left")), "right": CameraPreview(self.tr("Camera right"))}
        side_box.addLayout(row(*self._previews.values(), spacing=10), 3)
        side_box.addSpacing(12)
        side_box.addWidget(self.faults)
        side_box.addStretch(1)
        return side

    # -------------------------------------------------------------------------------- showing
    def _show_if_seen(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        rig = self.services.rig.snapshot
        self._preset.setCurrentIndex(self._preset.findData(rig.preset))
        at = self._specimen.findData(rig.specimen)
        if at < 0:
            self._specimen.addItem(Path(rig.specimen).name, rig.specimen)
            at = self._specimen.count() - 1
        self._specimen.setCurrentIndex(at)
        self._speeds[rig.speed].setChecked(True)
        self._show_devices()
        self.faults.show_rig()
        for part in (self._preset, self._specimen, self._file, *self._speeds.values()):
            part.setEnabled(not rig.busy and rig.calibrating is None)
        self._show_calibration()

    def _show_devices(self) -> None:
        rig = self.services.rig.snapshot
        config, motion = rig.config, rig.motion
        ready = ("good", self.tr("ready")) if rig.connected else ("idle", self.tr("opening…"))
        for name in ("left", "right"):
            lamp, detail = self._devices[name]
            lamp.show_state(*ready)
            camera = None if config is None else getattr(config, name)
            detail.setText("" if camera is None else f"{camera.id}  ·  {camera.exposure_ms:g} ms  ·  {camera.gain_db:g} dB")
        lamp, detail = self._devices["controller"]
        halted = motion is not None and motion.state in (MotionState.ALARM, MotionState.DOOR, MotionState.UNKNOWN)
        lamp.show_state(*(ready if motion is None else ("warn" if halted else "good", self._state_word(motion.state.value))))
        detail.setText("" if config is None else config.controller.port)
        self._devices["laser"][1].setText(self.tr("as the controller reports it"))
        lamp, detail = self._devices["turntable"]
        lamp.show_state("good" if motion is not None else "idle", "–" if motion is None else f"{motion.table_deg:.1f}°")
        detail.setText("")

    def _show_laser(self) -> None:
        emission = self.services.rig.emission
        if emission is self._emission:
            return
        self._emission = emission
        words = {
            Emission.NO_RIG: ("idle", "–"),
            Emission.UNKNOWN: ("warn", self.tr("unknown")),
            Emission.DARK: ("idle", self.tr("off")),
            Emission.LIT: ("laser", self.tr("emitting")),
        }
        self._devices["laser"][0].show_state(*words[emission])

    def _state_word(self, state: str) -> str:
        return {
            "idle": self.tr("idle"),
            "moving": self.tr("moving"),
            "hold": self.tr("held"),
            "homing": self.tr("homing"),
            "alarm": self.tr("alarm"),
            "door": self.tr("door open"),
        }.get(state, self.tr("unknown"))

    def _show_calibration(self) -> None:
        calibrating = self.services.rig.snapshot.calibrating is not None
        if calibrating and not self._lefts.currentIndex():
            self.board.clear()
            self.progress.clear()
        for stack in (self._lefts, self._rights):
            stack.setCurrentIndex(int(calibrating))
        if calibrating:
            self.progress.show_progress()
        else:
            self.calibration.show_calibration()

    def _choose_file(self) -> None:
        kinds = self.tr("Meshes (*.stl *.ply *.obj *.vtp *.3mf)")
        choose_file(self, self.tr("A mesh as specimen"), "", kinds, lambda path: self.services.rig.choose(specimen=str(path)))
