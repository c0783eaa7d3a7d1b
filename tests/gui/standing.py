"""Programs that more than one test is given, and how one is left for the next."""

from __future__ import annotations

import json
import time
from pathlib import Path

from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.controllers.preferences import STEPS
from app.draft import first_order
from app.program import Program
from app.settings import Settings
from app.theme import set_theme
from app.views.main_window import SIZE
from tests.gui.waiting import until, wait_ms


def first_settings(folder: Path) -> Path:
    """Settings whose folders are below that one."""
    path = folder / "settings.json"
    path.write_text(json.dumps({"case_folder": str(folder / "cases"), "export_folder": str(folder / "exports"), "language": "en"}))
    return path


class Standing:
    """The program that the fixture `shared_program` hands from one module to the next."""

    def __init__(self) -> None:
        self.program: Program | None = None

    def start(self, application: QApplication, folder: Path) -> Program:
        self.close()
        self.program = stand(application, first_settings(folder))
        return self.program

    def close(self) -> None:
        if self.program is not None:
            end(self.program)
        self.program = None


def stand(application: QApplication, settings_file: Path) -> Program:
    """A program with everything that stays."""
    running = Program(application, started_s=time.perf_counter(), settings_file=settings_file)
    until(lambda: running.window.scene is not None and running.services.reconstruction.worker_pid is not None, 120, "all that stays")
    running.window.activateWindow()
    QTest.qWaitForWindowActive(running.window, 3000)
    return running


def end(running: Program) -> None:
    """Taken down like a closed window."""
    running.window.close()
    running.window.deleteLater()
    wait_ms(10)


def as_at_the_start(application: QApplication, running: Program) -> None:
    """No case, first settings, nothing to undo, Home."""
    services, window = running.services, running.window
    services.case.close()
    first, settings = Settings(), services.settings
    folder = running._settings_file.parent
    kept = {"case_folder": str(folder / "cases"), "export_folder": str(folder / "exports"), "language": "en"}
    for name in first.__dataclass_fields__:
        setattr(settings, name, kept.get(name, getattr(first, name)))
    for name in STEPS:
        if name != "language":
            services.preferences.changed.emit(name)
    services.preferences.keep()
    services.draft.load(first_order(""))
    for stack in running._stacks:
        stack.clear()
    set_theme(application, "dark")
    window.banner.dismiss()
    window.resize(*SIZE)
    window.show_page("home")
    wait_ms(10)
