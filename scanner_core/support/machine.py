"""What of the machine matters to whoever mends the program: versions, processors, memory, graphics, displays."""

from __future__ import annotations

import ctypes
import os
import platform
import sys
from contextlib import suppress
from pathlib import Path

from scanner_core.log_file import versions

_ENVIRONMENT = ("XDG_SESSION_TYPE", "QT_QPA_PLATFORM", "QT_SCALE_FACTOR", "LIBGL_ALWAYS_SOFTWARE", "LANG", "OMP_NUM_THREADS", "PYLON_CAMEMU")
"""Variables that change how the program runs; none of them names anybody."""


def machine_facts() -> dict[str, object]:
    """By name; what the system does not tell is None."""
    return {
        "versions": versions(),
        "python": {"implementation": platform.python_implementation(), "bits": 64 if sys.maxsize > 2**32 else 32, "frozen": hasattr(sys, "frozen")},
        "system": {"name": platform.system(), "release": platform.release(), "version": platform.version(), "distribution": _distribution()},
        "processors": {"count": os.cpu_count(), "model": _processor(), "machine": platform.machine()},
        "memory_gib": _memory_gib(),
        "graphics_drivers": _graphics_drivers(),
        "environment": {name: os.environ[name] for name in _ENVIRONMENT if name in os.environ},
    }


def _distribution() -> str | None:
    with suppress(OSError, AttributeError):
        return platform.freedesktop_os_release().get("PRETTY_NAME")
    return None


def _processor() -> str | None:
    with suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines():
            if line.startswith(("model name", "Model")):
                return line.partition(":")[2].strip()
    return platform.processor() or None


def _memory_gib() -> float | None:
    """Of the whole machine."""
    if sys.platform == "win32":
        return _memory_of_windows()
    with suppress(OSError, ValueError):
        return round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30, 2)
    return None


def _memory_of_windows() -> float | None:
    """After GetPhysicallyInstalledSystemMemory, which answers in KiB."""
    if sys.platform != "win32":
        return None
    installed = ctypes.c_ulonglong()
    if not ctypes.WinDLL("kernel32").GetPhysicallyInstalledSystemMemory(ctypes.byref(installed)):
        return None
    return round(installed.value / 2**20, 2)


def _graphics_drivers() -> list[str]:
    """Of the cards that Linux lists; elsewhere the window knows more than this."""
    drivers: list[str] = []
    for card in sorted(Path("/sys/class/drm").glob("card[0-9]")):
        with suppress(OSError):
            drivers.append((card / "device" / "driver").resolve(strict=True).name)
    return drivers
