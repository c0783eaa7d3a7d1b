from __future__ import annotations

import ctypes
import subprocess
import sys
from pathlib import Path

import numpy as np

from scanner_core.reconstruction.memory import _Counters, peak_memory_mb

ROOT = Path(__file__).parents[3]


def test_peak_grows_with_what_is_used_and_stays() -> None:
    before = peak_memory_mb()
    wanted = int(before * 1e6) + 50_000_000  # beyond any earlier peak of this process
    block = np.ones(wanted, np.uint8)
    after = peak_memory_mb()
    assert after > before + 40
    del block
    assert peak_memory_mb() >= after - 1


def test_a_child_does_not_tell_the_size_of_its_parent() -> None:
    block = np.ones(400_000_000, np.uint8)
    code = "from scanner_core.reconstruction.memory import peak_memory_mb; print(peak_memory_mb())"
    told = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, cwd=ROOT, timeout=60).stdout
    assert 1 < float(told) < 300 < 1e-6 * block.nbytes


def test_layout_of_the_windows_structure() -> None:
    assert ctypes.sizeof(_Counters) == 8 + 8 * ctypes.sizeof(ctypes.c_size_t)
    assert _Counters.PeakWorkingSetSize.offset == 8
