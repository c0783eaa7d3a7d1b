"""A display for the tests of the window: the one that is there, or an Xvfb of our own.

Never the platform ``offscreen``: there a 3D view "works" and its picture is noise.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.main import make_application
from app.program import Program
from tests.gui.waiting import until, wait_ms

HERE = Path(__file__).parent


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if HERE in item.path.parents:
            item.add_marker(pytest.mark.gui)


@pytest.fixture(scope="session")
def display() -> Iterator[None]:
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    # windows of two processes would take the keyboard from one another: each has a display of its own
    alone = "PYTEST_XDIST_WORKER" not in os.environ or shutil.which("Xvfb") is None
    if not sys.platform.startswith("linux") or (alone and os.environ.get("DISPLAY")):
        yield
        return
    read, write = os.pipe()
    try:
        server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1600x1200x24", "-nolisten", "tcp"], pass_fds=[write], stderr=subprocess.DEVNULL
        )
    except FileNotFoundError:
        pytest.fail("the tests of the window need a display: install xvfb, or run them where there is one")
    os.close(write)
    with os.fdopen(read) as told:
        os.environ["DISPLAY"] = ":" + told.readline().strip()
    yield
    server.terminate()
    server.wait(5)


@pytest.fixture(scope="session")
def application(display: None) -> QApplication:
    return make_application()


@pytest.fixture
def settings_file(tmp_path: Path) -> Path:
    """Settings whose folders are the test's own."""
    path = tmp_path / "config" / "settings.json"
    path.parent.mkdir()
    path.write_text(json.dumps({"case_folder": str(tmp_path / "cases"), "export_folder": str(tmp_path / "exports"), "language": "en"}))
    return path


@pytest.fixture(scope="module")
def shared_settings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Settings of :func:`shared_program`."""
    folder = tmp_path_factory.mktemp("shared")
    path = folder / "settings.json"
    path.write_text(json.dumps({"case_folder": str(folder / "cases"), "export_folder": str(folder / "exports"), "language": "en"}))
    return path


@pytest.fixture(scope="module")
def shared_program(application: QApplication, shared_settings: Path) -> Iterator[Program]:
    """One program for the tests of a module, which leave it idle: its start costs more than most of them."""
    running = Program(application, started_s=time.perf_counter(), settings_file=shared_settings)
    until(lambda: running.window.scene is not None and running.services.reconstruction.worker_pid is not None, 120, "all that stays")
    running.window.activateWindow()
    QTest.qWaitForWindowActive(running.window, 3000)
    yield running
    running.window.close()
    running.window.deleteLater()
    wait_ms(10)


@pytest.fixture(scope="module")
def scanning_program(shared_program: Program) -> Program:
    """The same with the process that the first scan starts, and that stays until the program ends."""
    live_surface = shared_program.services.live_surface
    live_surface.prepare()
    until(lambda: live_surface.worker_pid is not None, 120, "the process of the live surface")
    return shared_program


@pytest.fixture
def program(application: QApplication, settings_file: Path) -> Iterator[Program]:
    """The running program; taken down like a closed window."""
    running = Program(application, started_s=time.perf_counter(), settings_file=settings_file)
    running.window.activateWindow()  # shortcuts belong to the active window, and Xvfb has no window manager
    QTest.qWaitForWindowActive(running.window, 3000)
    yield running
    running.window.close()
    running.window.deleteLater()
    wait_ms(10)
