"""Checks of the machine itself: Python, libraries, disk, permissions, processors, clock."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
import time
from importlib import metadata
from pathlib import Path

from scanner_core import wall_clock
from scanner_core.devices.check import Check

_LIBRARIES = ("numpy", "scipy", "opencv-contrib-python-headless", "vtk", "pyserial", "pyvista", "pyvistaqt", "PySide6_Essentials")
_DISK_GIB = 1.0
_GROUPS = ("dialout", "video")
"""Who may open serial ports and cameras on Linux where no udev rule gives them to the user at the screen."""
_RULE_FOLDERS = ("/etc/udev/rules.d", "/lib/udev/rules.d", "/usr/lib/udev/rules.d")
_RULE = "impronta"
_RELEASED = 2026
"""A calibration's age and a case's dates rest on the time of day."""


def check_machine(folder: Path | None = None) -> list[Check]:
    """One line each; `folder` is where results are to be written, the current one if None."""
    folder = Path.cwd() if folder is None else folder
    checks = [_python(), _libraries(), _disk(folder), _writable(folder)]
    if sys.platform == "linux":
        checks.append(_groups())
    return [*checks, _processors(), _clock()]


def _python() -> Check:
    version = ".".join(map(str, sys.version_info[:3]))
    return Check("Python", "pass" if sys.version_info >= (3, 11) else "fail", f"version {version}.", "Install Python 3.11 or newer.")


def _libraries() -> Check:
    missing, found = [], []
    for name in _LIBRARIES:
        try:
            found.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            missing.append(name)
    if missing:
        return Check("libraries", "fail", f"{', '.join(missing)} not installed.", "Run packaging/start.py again.")
    return Check("libraries", "pass", ", ".join(found) + ".")


def _disk(folder: Path) -> Check:
    free_gib = shutil.disk_usage(folder).free / 2**30
    return Check("disk", "pass" if free_gib > _DISK_GIB else "warn", f"{free_gib:.1f} GiB free in this folder.", "Free some space before you scan.")


def _writable(folder: Path) -> Check:
    try:
        with tempfile.NamedTemporaryFile(dir=folder):
            return Check("permission", "pass", "files can be written in the current folder.")
    except OSError as fault:
        return Check("permission", "warn", f"the current folder cannot be written ({fault.strerror}).", "Give --out a folder of your own.")


def _groups() -> Check:
    import grp

    if os.geteuid() == 0:
        return Check("permission of devices", "pass", "this is the administrator, who may open every port and camera.")
    rules = [path for folder in map(Path, _RULE_FOLDERS) if folder.is_dir() for path in folder.glob(f"*{_RULE}*.rules")]
    if rules:
        return Check("permission of devices", "pass", f"the rule {rules[0]} gives ports and cameras to the user at the screen.")
    mine = {grp.getgrgid(number).gr_name for number in os.getgroups() if _named(number)}
    missing = [name for name in _GROUPS if name not in mine]
    if not missing:
        return Check("permission of devices", "pass", f"this user belongs to the groups {' and '.join(_GROUPS)}.")
    remedy = "Install the rule of packaging/udev, or join: sudo usermod -aG " + ",".join(missing) + " $USER; then log in again."
    return Check("permission of devices", "warn", f"this user does not belong to {' and '.join(missing)}: devices may be refused.", remedy)


def _named(number: int) -> bool:
    import grp

    try:
        grp.getgrgid(number)
    except KeyError:
        return False
    return True


def _processors() -> Check:
    cores = os.cpu_count() or 1
    return Check("processors", "pass" if cores >= 2 else "warn", f"{cores}.", "Scanning and the window share one processor: expect delays.")


def _clock() -> Check:
    now = wall_clock.now()
    resolution_s = time.get_clock_info("monotonic").resolution
    detail = f"{now:%Y-%m-%d %H:%M}, steps of {1e6 * resolution_s:.3g} us."
    if now.year < _RELEASED:
        return Check("clock", "warn", detail, "Set the time of day: the age of the calibration and the dates of cases come from it.")
    return Check("clock", "pass", detail)
