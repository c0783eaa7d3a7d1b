"""The peak memory of this process."""

from __future__ import annotations

import ctypes
import re
import sys
from pathlib import Path


def peak_memory_mb() -> float:
    """Largest resident size of the process so far, MB (1e6 bytes); 0 where the system does not tell."""
    if sys.platform == "win32":
        return _of_windows()
    if sys.platform == "linux":
        # not getrusage: its figure survives the start of another program, so that a child tells the size of its parent
        try:
            status = Path("/proc/self/status").read_text(encoding="ascii", errors="replace")
        except OSError:
            return 0.0
        found = re.search(r"^VmHWM:\s*(\d+) kB$", status, re.MULTILINE)
        return int(found[1]) * 1024 / 1e6 if found else 0.0
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 1e6


class _Counters(ctypes.Structure):
    """PROCESS_MEMORY_COUNTERS of psapi.h."""

    _fields_ = (
        ("cb", ctypes.c_uint32),
        ("PageFaultCount", ctypes.c_uint32),
        ("PeakWorkingSetSize", ctypes.c_size_t),
        ("WorkingSetSize", ctypes.c_size_t),
        ("QuotaPeakPagedPoolUsage", ctypes.c_size_t),
        ("QuotaPagedPoolUsage", ctypes.c_size_t),
        ("QuotaPeakNonPagedPoolUsage", ctypes.c_size_t),
        ("QuotaNonPagedPoolUsage", ctypes.c_size_t),
        ("PagefileUsage", ctypes.c_size_t),
        ("PeakPagefileUsage", ctypes.c_size_t),
    )


def _of_windows() -> float:
    if sys.platform != "win32":
        return 0.0
    process = ctypes.WinDLL("kernel32").GetCurrentProcess
    process.restype = ctypes.c_void_p
    ask = ctypes.WinDLL("psapi").GetProcessMemoryInfo
    ask.argtypes = (ctypes.c_void_p, ctypes.POINTER(_Counters), ctypes.c_uint32)
    ask.restype = ctypes.c_int
    counters = _Counters(cb=ctypes.sizeof(_Counters))
    if not ask(process(), ctypes.byref(counters), ctypes.sizeof(_Counters)):
        return 0.0
    return int(counters.PeakWorkingSetSize) / 1e6
