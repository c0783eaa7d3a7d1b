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
from tests.gui.standing import Standing, as_at_the_start, end, first_settings, stand
from tests.gui.waiting import until

HERE = Path(__file__).parent
_sharing: set[Path] = set()
"""Modules whose tests have one program."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if HERE in item.path.parents:
            item.add_marker(pytest.mark.gui)
        if "shared_program" in getattr(item, "fixturenames", ()):
            _sharing.add(item.path)
    items.sort(key=lambda item: item.path in _sharing)  # one after the other, so that it starts once


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


_standing = Standing()


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Two windows would take the keyboard from one another."""
    if item.path not in _sharing:
        _standing.close()


@pytest.fixture(scope="session")
def standing(application: QApplication) -> Iterator[Standing]:
    yield _standing
    _standing.close()


@pytest.fixture(scope="module")
def shared_program(application: QApplication, standing: Standing, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Program]:
    """One program for the tests of many modules, which leave it idle: its start costs more than most of them.

    A module finds it as it is after its start, but for what it has learned and where its windows stand.
    """
    running = standing.program or standing.start(application, tmp_path_factory.mktemp("shared"))
    running.window.activateWindow()
    QTest.qWaitForWindowActive(running.window, 3000)
    yield running
    as_at_the_start(application, running)


@pytest.fixture(scope="module")
def shared_settings(shared_program: Program) -> Path:
    """Settings of :func:`shared_program`."""
    return shared_program._settings_file


@pytest.fixture(scope="module")
def module_settings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Settings of :func:`module_program`."""
    return first_settings(tmp_path_factory.mktemp("module"))


@pytest.fixture(scope="module")
def module_program(application: QApplication, module_settings: Path) -> Iterator[Program]:
    """One program for the tests of one module, which may leave traces in it that others would stumble over."""
    running = stand(application, module_settings)
    yield running
    end(running)


@pytest.fixture(scope="module")
def scanning_program(module_program: Program) -> Program:
    """The same with the process that the first scan starts, and that stays until the program ends."""
    live_surface = module_program.services.live_surface
    live_surface.prepare()
    until(lambda: live_surface.worker_pid is not None, 120, "the process of the live surface")
    return module_program


@pytest.fixture
def program(application: QApplication, settings_file: Path) -> Iterator[Program]:
    """The running program; taken down like a closed window."""
    running = Program(application, started_s=time.perf_counter(), settings_file=settings_file)
    running.window.activateWindow()  # shortcuts belong to the active window, and Xvfb has no window manager
    QTest.qWaitForWindowActive(running.window, 3000)
    yield running
    end(running)
