"""The Rig page and its controller without the rest of the window."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import cast

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QPushButton

from app.background import Background
from app.controllers.readiness import ReadinessController
from app.controllers.rig import RigController
from app.services import Services
from app.settings import Settings
from app.views.device_row import DeviceRow
from app.views.rig_page import RigPage
from tests.gui.waiting import until


class RigWindow:
    """`told` holds what would stand in the banner."""

    def __init__(self, folder: Path) -> None:
        self.told: list[BaseException] = []
        self.background = Background()
        self.rig = RigController(self.background, folder / "rigs", self.told.append)
        settings = Settings()
        self.readiness = ReadinessController(self.background, self.rig, settings)
        self.page = RigPage(cast(Services, SimpleNamespace(rig=self.rig, settings=settings, readiness=self.readiness)))
        self.page.resize(1190, 746)
        self.page.show()
        self._timer = QTimer()
        self._timer.timeout.connect(self._tick)
        self._timer.start(30)

    def _tick(self) -> None:
        self.background.drain()
        self.page.tick()

    def open(self, path: Path) -> None:
        """And wait for what comes of it."""
        self.rig.choose(preset=str(path))
        until(lambda: not self.rig.snapshot.opening, 30, "an answer")

    def row(self, name: str) -> DeviceRow:
        return self.page.devices.rows[name]

    def button(self, text: str) -> QPushButton:
        """The one that can be seen."""
        return next(made for made in self.page.findChildren(QPushButton) if made.text() == text and made.isVisible())

    def close(self) -> None:
        self._timer.stop()
        assert self.rig.shutdown(10)
        assert self.background.join(20) == []
        self.page.close()
        self.page.deleteLater()
