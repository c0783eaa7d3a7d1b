"""What holds for every test: repeatable, away from the user's own files, and nothing left running."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Iterator
from multiprocessing import resource_tracker

import cv2
import psutil
import pytest
from hypothesis import settings

# Set before anything reads them: settings and cases of the person who runs the tests stay out of reach.
_HOME = tempfile.TemporaryDirectory(prefix="impronta-tests-")
for _name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"):
    os.environ[_name] = os.path.join(_HOME.name, _name.lower())

cv2.setNumThreads(1)
settings.register_profile("repeatable", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("repeatable")

_THIS_PROCESS = psutil.Process()
_GRACE_S = 2.0  # a thread that was told to stop may take this long to be gone


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--rig", metavar="RIG.toml", help="with -m hardware: the rig file whose devices are tested")


@pytest.fixture(autouse=True)
def nothing_left_running() -> Iterator[None]:
    """Fail the test after which a thread or a child process is alive that was not there before it."""
    threads_before = set(threading.enumerate())
    children_before = set(_children())
    yield
    deadline_s = time.monotonic() + _GRACE_S
    threads = [thread for thread in threading.enumerate() if thread not in threads_before]
    for thread in threads:
        thread.join(max(0.0, deadline_s - time.monotonic()))
    left_threads = [thread.name for thread in threads if thread.is_alive()]
    children = [child for child in _children() if child not in children_before]
    _, alive = psutil.wait_procs(children, timeout=max(0.0, deadline_s - time.monotonic()))
    left_children = [f"{child.pid} {_command(child)}" for child in alive]
    assert not left_threads, f"threads left running: {left_threads}"
    assert not left_children, f"processes left running: {left_children}"


def _children() -> list[psutil.Process]:
    # multiprocessing keeps one tracker of shared memory until the interpreter ends; it is no one's leak
    tracker = getattr(resource_tracker._resource_tracker, "_pid", None)
    return [child for child in _THIS_PROCESS.children() if child.pid != tracker and _running(child)]


def _running(child: psutil.Process) -> bool:
    try:
        return child.status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def _command(child: psutil.Process) -> str:
    try:
        return " ".join(child.cmdline())
    except psutil.Error:
        return "(gone)"
