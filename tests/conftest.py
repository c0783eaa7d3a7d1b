"""What holds for every test: repeatable, away from the user's own files, and nothing left running."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Iterator
from multiprocessing import resource_tracker
from pathlib import Path

if "PYTEST_XDIST_WORKER" in os.environ:
    # A process a core already: threads of BLAS would wait for each other and cost up to eight times the CPU. Read when
    # numpy is loaded, so set before any import of it; programs that a test starts inherit it.
    for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS", "NUMEXPR_NUM_THREADS"):
        os.environ[_name] = "1"

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

_LONGEST = (
    "system/test_whole_job.py",
    "gui/test_compare_page.py",
    "gui/test_window.py",
    "core/reconstruction/test_pipeline.py",
    "gui/test_assistant.py",
    "system/test_reconstruct_inputs.py",
    "core/optics/test_calibration_session.py",
    "core/reconstruction/test_acceptance.py",
    "gui/test_journey.py",
    "core/devices/test_video4linux.py",
    "gui/test_own_rig.py",
    "core/acquisition/test_error_driven.py",
)
"""Files that take longest, in the order in which they begin when processes share the files."""
_HERE = Path(__file__).parent
_THIS_PROCESS = psutil.Process()
_GRACE_S = 2.0  # a thread that was told to stop may take this long to be gone


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--rig", metavar="RIG.toml", help="with -m hardware: the rig file whose devices are tested")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the longest files: one that begins last keeps one process busy while the others have nothing left to do."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        rank = {_HERE / name: number for number, name in enumerate(_LONGEST)}
        items.sort(key=lambda item: rank.get(item.path, len(rank)))


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
