"""First step: which controller, and which camera stands on which side."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QStackedWidget, QWidget

from app.controllers.assistant import AssistantController
from app.controllers.assistant_choice import VIRTUAL, VIRTUAL_PORT, is_virtual, key_of
from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.views.assistant_camera_card import CameraCard
from app.views.assistant_ports import PortList
from app.views.assistant_settings import CameraSettings
from app.views.parts import button, column, label, row, scrolled, seam
from scanner_core.devices.discovery import PortState
from scanner_core.devices.found_camera import CameraState, FoundCamera

_COLUMNS = 3


class FindStep(QStackedWidget):
    """At first what to plug in; then ports on the left, cameras on the right, how they are wanted below."""

    def __init__(self, assistant: AssistantController) -> None:
        super().__init__()
        self._assistant = assistant
        self.ports = PortList(lambda url: assistant.choose(assistant.snapshot.choice.with_port(url)))
        self.cards: list[CameraCard] = []
        self._to_plug = self._intro()
        self._no_port = label("", "muted", wrap=True)
        self._no_camera = label("", "muted", wrap=True)
        self.exchange = button(self.tr("Exchange left and right"), "", lambda: assistant.choose(assistant.snapshot.choice.exchanged()))
        self.settings = CameraSettings(assistant.choose)
        self.use_virtual = button(self.tr("Try it on the virtual rig"), "", self._use_virtual)
        ports = QWidget()
        ports_box = column(label(self.tr("Controller"), "section"), self._no_port, self.ports, self.use_virtual, 1, spacing=12)
        ports_box.setContentsMargins(36, 20, 24, 16)
        ports.setLayout(ports_box)
        self._grid = QGridLayout()
        self._grid.setHorizontalSpacing(14)
        self._grid.setVerticalSpacing(18)
        self._grid.setColumnStretch(_COLUMNS, 1)
        cameras = QWidget()
        hint = label(self.tr("Left and right as seen from behind the cameras. Wave a hand before one: its picture moves."), "muted", wrap=True)
        self._hint = hint
        cameras_box = column(label(self.tr("Cameras"), "section"), hint, self._no_camera, self._grid, 1, spacing=12)
        cameras_box.setContentsMargins(24, 20, 28, 16)
        cameras.setLayout(cameras_box)
        self._below = QWidget()
        below = column(row(label(self.tr("How both cameras are wanted"), "section"), 1, self.exchange), self.settings, spacing=10)
        below.setContentsMargins(24, 12, 28, 14)
        self._below.setLayout(below)
        right = column(scrolled(cameras), seam(), self._below, spacing=0)
        right.setStretch(0, 1)
        found = QWidget()
        box = QHBoxLayout(found)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(scrolled(ports), 4)
        box.addWidget(seam(upright=True))
        box.addLayout(right, 7)
        self.addWidget(self._to_plug)
        self.addWidget(found)

    def _intro(self) -> QWidget:
        made = QWidget()
        lines = (
            self.tr("Plug the controller of laser and turntable in by USB, and switch it on."),
            self.tr("Plug both cameras in, each into a USB port of its own and not into a common hub."),
            self.tr("Take the lens caps off, and close other programs that use the cameras or the port."),
        )
        texts = [row(label(str(number), "number"), label(text, wrap=True), spacing=16) for number, text in enumerate(lines, start=1)]
        for line in texts:
            line.setStretch(1, 1)
        after = self.tr("Then look for devices, below. Without any, everything here can be tried on the virtual rig, which is always found.")
        box = column(label(self.tr("What is plugged in?"), "headline"), *texts, label(after, "muted", wrap=True), spacing=18)
        box.setContentsMargins(40, 38, 40, 30)
        inside = QWidget()
        inside.setMaximumWidth(680)
        inside.setLayout(box)
        outer = column(inside, 1)
        outer.setContentsMargins(0, 0, 0, 0)
        made.setLayout(outer)
        return made

    # -------------------------------------------------------------------------------- showing
    def show_snapshot(self, snapshot: AssistantSnapshot) -> None:
        """What was found, what is chosen, and what is missing."""
        self.setCurrentIndex(int(snapshot.looked))
        self.ports.show_ports(snapshot.ports, snapshot.choice.port)
        self._show_cameras(snapshot)
        done = snapshot.looked and snapshot.running is not Job.FIND
        real_ports = [answer for answer in snapshot.ports if not is_virtual(answer.port.url)]
        usable = [answer for answer in real_ports if answer.state is PortState.CONTROLLER]
        self._no_port.setText(self._about_ports(len(real_ports), len(usable)) if done else self._waiting(snapshot, bool(snapshot.ports)))
        real = [found for found in snapshot.cameras if found.driver != VIRTUAL]
        self._no_camera.setText(self._about_cameras(real) if done else self._waiting(snapshot, bool(snapshot.cameras)))
        for shown in (self._no_port, self._no_camera):
            shown.setVisible(bool(shown.text()))
        ready = [found for found in real if found.state is CameraState.READY]
        self.use_virtual.setVisible(done and not (usable and len(ready) > 1) and not snapshot.choice.virtual)
        self._hint.setVisible(bool(real))
        self._below.setVisible(bool(snapshot.cameras) and done)
        self.settings.show_choice(snapshot.choice)
        self.exchange.setEnabled(snapshot.choice.exchanged() != snapshot.choice)
        self.exchange.setVisible(not snapshot.choice.virtual)

    def tick(self) -> None:
        """For the pump: newer pictures."""
        for card in self.cards:
            frame = self._assistant.frame_of(card.key)
            if frame is not None:
                card.thumbnail.show_image(frame.image)

    def _show_cameras(self, snapshot: AssistantSnapshot) -> None:
        if [card.found for card in self.cards] != list(snapshot.cameras[: len(self.cards)]):
            for card in self.cards:
                self._grid.removeWidget(card)
                card.deleteLater()
            self.cards = []
        for found in snapshot.cameras[len(self.cards) :]:
            card = CameraCard(found, self._press, self._side)
            self._grid.addWidget(card, *self._next_place(found))
            self.cards.append(card)
        for card in self.cards:
            card.show_side(snapshot.choice.side_of(card.key))

    def _next_place(self, found: FoundCamera) -> tuple[int, int]:
        """Row and column of a card; those of the virtual rig begin a row of their own."""
        alike = [card for card in self.cards if (card.found.driver == VIRTUAL) == (found.driver == VIRTUAL)]
        before = -(-(len(self.cards) - len(alike)) // _COLUMNS) if found.driver == VIRTUAL else 0
        return before + len(alike) // _COLUMNS, len(alike) % _COLUMNS

    def _waiting(self, snapshot: AssistantSnapshot, some: bool) -> str:
        return self.tr("Looking…") if snapshot.running is Job.FIND and not some else ""

    def _about_ports(self, count: int, usable: int) -> str:
        if not count:
            return self.tr("No serial port was found on this machine. Plug the controller in by USB, switch it on, and look again.")
        if not usable:
            return self.tr("None of these ports can move the rig: see what each of them says.")
        return ""

    def _about_cameras(self, real: list[FoundCamera]) -> str:
        if not real:
            return self.tr("No camera was found on this machine. Plug both cameras in, each into a USB port of its own, and look again.")
        if sum(found.state is CameraState.READY for found in real) < 2:
            return self.tr("The rig needs two cameras that give pictures: see what each of them says.")
        return ""

    # -------------------------------------------------------------------------------- choosing
    def _press(self, found: FoundCamera) -> None:
        self._assistant.choose(self._assistant.snapshot.choice.next_click(key_of(found)))

    def _side(self, found: FoundCamera, side: str) -> None:
        choice, key = self._assistant.snapshot.choice, key_of(found)
        if choice.side_of(key) == side and not choice.virtual:
            self._assistant.choose(replace(choice, left=None) if side == "left" else replace(choice, right=None))
        else:
            self._assistant.choose(choice.with_camera(side, key))
        self.show_snapshot(self._assistant.snapshot)  # the button turns back where nothing was changed

    def _use_virtual(self) -> None:
        self._assistant.choose(self._assistant.snapshot.choice.with_port(VIRTUAL_PORT))
