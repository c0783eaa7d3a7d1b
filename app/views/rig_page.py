"""Rig: which one, what its devices say, its calibration, and how a person calibrates it."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtGui import QDragEnterEvent, QDropEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QVBoxLayout, QWidget

from app.controllers.calibration import ByHand
from app.controllers.readiness import Remedy
from app.services import Services
from app.views import format as fmt
from app.views.board_watch_view import BoardWatchView
from app.views.by_hand_panel import ByHandPanel
from app.views.calibrating_panel import CalibratingPanel
from app.views.calibration_panel import CalibrationPanel
from app.views.camera_preview import CameraPreview
from app.views.device_list import DeviceList
from app.views.fault_panel import FaultPanel
from app.views.page import Page
from app.views.parts import button, label, row, scrolled, seam
from app.views.ready_line import ReadyLine
from app.views.rig_choice import RigChoice
from app.views.transcript_window import TranscriptWindow

_RIG_FILE = ".toml"


class RigPage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.setAcceptDrops(True)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        self.ready = ReadyLine(services.readiness, self.wanted.emit, self._calibrate)
        self.ready.setContentsMargins(40, 12, 36, 12)
        box = QHBoxLayout()
        box.setSpacing(0)
        whole.addWidget(self.ready)
        whole.addWidget(seam())
        whole.addLayout(box, 1)
        self._transcript: TranscriptWindow | None = None
        self._preparing = False
        self.choice = RigChoice(services.rig)
        self.set_up = button(self.tr("Set up a rig…"), "link", lambda: self.wanted.emit("assistant"))
        self.set_up.setToolTip(self.tr("Finds ports and cameras, checks them by what the cameras see, and writes a rig file"))
        self.choice.more.addWidget(self.set_up)
        self.choice.more.addSpacing(18)
        self.choice.more.addWidget(button(self.tr("Measure the sphere…"), "link", lambda: self.wanted.emit("verify")))
        self.choice.more.addStretch(1)
        self.devices = DeviceList(services.rig, self.show_transcript)
        self.calibration = CalibrationPanel(services.rig, self._calibrate)
        self.board = BoardWatchView()
        self.progress = CalibratingPanel(services.rig, self.show_transcript)
        self.by_hand = ByHandPanel(services.settings, self._begin_by_hand, lambda: self._prepare(False))
        self.faults = FaultPanel(services.rig)
        self._lefts, self._rights = QStackedWidget(), QStackedWidget()
        for stack, parts in ((self._lefts, (scrolled(self._left()), self.board)), (self._rights, (self.calibration, self.progress, self.by_hand))):
            for part in parts:
                stack.addWidget(part)
        box.addWidget(self._lefts, 6)
        box.addWidget(seam(upright=True))
        box.addWidget(self._rights, 5)
        services.rig.changed.connect(self._show_if_seen)
        services.readiness.changed.connect(self._show_next)
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
            self.devices.show_laser()
        for name, preview in self._previews.items():
            frame = self.services.rig.frames[name].take()
            if frame is not None and self.isVisible() and self.services.rig.snapshot.connected:
                preview.show_frame(frame)

    def show_transcript(self) -> None:
        """From any state of the rig."""
        if self._transcript is None:
            self._transcript = TranscriptWindow(self.services.rig, self.window())
        self._transcript.show()
        self._transcript.raise_()
        self._transcript.activateWindow()

    # -------------------------------------------------------------------------------- a rig file that is dropped
    def dragEnterEvent(self, event: QDragEnterEvent) -> None:  # noqa: N802 - Qt's name
        if _dropped_rig(event) is not None and self._may_choose():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:  # noqa: N802 - Qt's name
        path = _dropped_rig(event)
        if path is not None and self._may_choose():
            event.acceptProposedAction()
            self.services.rig.choose(preset=path)

    def _may_choose(self) -> bool:
        rig = self.services.rig.snapshot
        return not rig.busy and rig.calibrating is None

    # -------------------------------------------------------------------------------- parts
    def _left(self) -> QWidget:
        self._title, self._about = label("", "headline", wrap=True), label("", "muted", wrap=True)
        self._previews = {"left": CameraPreview(self.tr("Camera left")), "right": CameraPreview(self.tr("Camera right"))}
        side = QWidget()
        box = QVBoxLayout(side)
        box.setContentsMargins(40, 34, 40, 26)
        box.setSpacing(0)
        box.addWidget(self._title)
        box.addSpacing(6)
        box.addWidget(self._about)
        box.addSpacing(22)
        box.addWidget(self.choice)
        box.addSpacing(22)
        box.addWidget(seam())
        box.addSpacing(18)
        box.addWidget(self.devices)
        box.addSpacing(18)
        box.addLayout(row(*self._previews.values(), spacing=10), 3)
        box.addSpacing(12)
        box.addWidget(self.faults)
        box.addStretch(1)
        return side

    # -------------------------------------------------------------------------------- showing
    def _show_if_seen(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        self._show_title()
        self.choice.show_rig()
        self.devices.show_rig()
        self.faults.show_rig()
        rig = self.services.rig.snapshot
        for name, preview in self._previews.items():
            preview.wait_for_measurement(name in rig.cameras and rig.cameras[name].driver == "replay")
            if not rig.connected:
                preview.clear()
        self._show_calibration()

    def _show_next(self) -> None:
        """One thing is to be done next."""
        self.calibration.lead(self.services.readiness.snapshot.remedy is Remedy.NONE)

    def _show_title(self) -> None:
        rig = self.services.rig.snapshot
        computed = self.tr("Two cameras, a laser and a turntable, computed frame by frame; the rest is the real program.")
        if not rig.own:
            self._title.setText(self.tr("Virtual rig"))
            self._about.setText(computed)
            return
        stem = Path(rig.preset).stem
        name = stem if rig.config is None else rig.config.name
        self._title.setText(self.tr("{rig} (virtual rig)").format(rig=name) if rig.virtual else name)
        self._about.setText(fmt.short_path(rig.preset))

    def _show_calibration(self) -> None:
        rig = self.services.rig.snapshot
        calibrating = rig.calibrating is not None
        if calibrating and not self._lefts.currentIndex():
            self.board.clear(by_hand=rig.by_hand)
            self.progress.clear()
        if calibrating or not rig.connected or rig.virtual:
            self._preparing = False
        self._lefts.setCurrentIndex(int(calibrating))
        self._rights.setCurrentIndex(1 if calibrating else 2 if self._preparing else 0)
        if calibrating:
            self.progress.show_progress()
        else:
            self.calibration.show_calibration()

    # -------------------------------------------------------------------------------- calibrating
    def _calibrate(self) -> None:
        """The virtual bench shows the board by itself; at a real rig somebody has to, and is asked what is known first."""
        if self.services.rig.snapshot.virtual:
            self.services.rig.calibrate()
        else:
            self._prepare(True)

    def _prepare(self, on: bool) -> None:
        self._preparing = on
        self._show_calibration()

    def _begin_by_hand(self, by_hand: ByHand) -> None:
        self._preparing = False
        self.services.rig.calibrate(by_hand)


def _dropped_rig(event: QDropEvent) -> str | None:
    """The path of the one rig file that is dropped."""
    paths = [url.toLocalFile() for url in event.mimeData().urls()]
    return paths[0] if len(paths) == 1 and paths[0].lower().endswith(_RIG_FILE) else None
