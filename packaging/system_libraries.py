"""The system libraries that Qt and VTK load at run time: which are missing, and how they come in.

A bare Debian has none of them, and without them Qt says no more than "could not load the platform plugin".
On Windows and macOS they are part of the system or of the packages.
"""

from __future__ import annotations

import ctypes
import importlib
import importlib.util
import os
import shutil
import sys
from collections.abc import Sequence

from progress import SetupError, last_lines, run_and_follow, say

# What is loaded -> the Debian and Ubuntu package that holds it.
WINDOW_LIBRARIES = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libfontconfig.so.1": "libfontconfig1",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libdbus-1.so.3": "libdbus-1-3",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-shape.so.0": "libxcb-shape0",
}
TEST_PROGRAMS = {"xvfb-run": "xvfb", "xauth": "xauth"}

_DISK_FULL = ("No space left on device", "enough free space")
_UNREACHABLE = ("Temporary failure resolving", "Could not resolve", "Could not connect", "Failed to fetch")


def missing_libraries() -> list[str]:
    """Debian packages whose library cannot be loaded here; empty where Qt and VTK bring their own."""
    if not sys.platform.startswith("linux"):
        return []
    return [package for library, package in WINDOW_LIBRARIES.items() if not _loads(library)]


def missing_test_programs() -> list[str]:
    """Debian packages of the virtual display that the tests run under; none needed on Windows and macOS."""
    if not sys.platform.startswith("linux"):
        return []
    return [package for program, package in TEST_PROGRAMS.items() if shutil.which(program) is None]


def missing_venv() -> list[str]:
    """The Debian package that completes a Python which cannot create an environment."""
    importlib.invalidate_caches()
    if importlib.util.find_spec("ensurepip") is not None and importlib.util.find_spec("venv") is not None:
        return []
    return [f"python{sys.version_info.major}.{sys.version_info.minor}-venv"]


def display_answers() -> bool:
    """Whether a window can be opened here."""
    if not sys.platform.startswith("linux"):
        return True
    if not os.environ.get("DISPLAY"):
        return bool(os.environ.get("WAYLAND_DISPLAY"))
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return True
    x11.XOpenDisplay.restype = ctypes.c_void_p
    connection = x11.XOpenDisplay(None)
    if not connection:
        say(f"The display {os.environ['DISPLAY']} does not answer; going on without a window.")
        return False
    x11.XCloseDisplay(ctypes.c_void_p(connection))
    return True


def install_command(packages: Sequence[str]) -> str:
    """The one command that an administrator of this machine has to run."""
    names = " ".join(packages)
    if shutil.which("apt-get"):
        return f"sudo apt-get update && sudo apt-get install -y --no-install-recommends {names}"
    return f"(with your system's package manager) install what Debian calls: {names}"


def can_install() -> bool:
    """Whether packages can be installed without asking anyone: Debian or a relative of it, and root."""
    return sys.platform != "win32" and shutil.which("apt-get") is not None and os.geteuid() == 0


def install(packages: Sequence[str]) -> None:
    """Install Debian packages; fetches the package lists when the first attempt needs newer ones.

    Raises
    ------
    SetupError
        When apt-get could not do it; what is already installed stays.
    """
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C.UTF-8"}
    wait_for_others = ["-o", "DPkg::Lock::Timeout=300"]
    apt_install = ["apt-get", "install", "-y", "--no-install-recommends", *wait_for_others, *packages]
    code, _ = run_and_follow(apt_install, show=_show_progress, environment=environment)
    if code == 0:
        return
    # A package list that is absent or old shows as a package that cannot be found or fetched.
    say("      fetching the package lists first")
    update_code, update_lines = run_and_follow(["apt-get", "update", *wait_for_others], show=_show_progress, environment=environment)
    code, lines = run_and_follow(apt_install, show=_show_progress, environment=environment)
    if code == 0:
        return
    text = "\n".join([*update_lines, *lines])
    if any(sign in text for sign in _DISK_FULL):
        raise SetupError("The disk is full; the system packages were not installed completely. Make room, then run this command again.")
    if update_code != 0 or any(sign in text for sign in _UNREACHABLE):
        raise SetupError(
            "The system's package server could not be reached; nothing was changed. Check the network, then run this command again. "
            f"It is about these packages: {' '.join(packages)}"
        )
    raise SetupError(f"apt-get could not install {' '.join(packages)}. Solve what it says, then run this command again:\n{last_lines(lines)}")


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def _show_progress(line: str) -> str | None:
    return line if line.startswith(("Need to get", "After this operation", "Fetched")) else None
