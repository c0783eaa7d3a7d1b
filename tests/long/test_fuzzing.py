"""100,000 inputs for every reader, with either engine: no crash, none that takes 5 s, none that needs 1 GiB."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.fuzz.readers import READERS
from tests.system.impronta import ROOT, environment

pytestmark = pytest.mark.long
INPUTS = 100_000
NO_ATHERIS = pytest.mark.skipif(importlib.util.find_spec("atheris") is None, reason="the extra `fuzz` is not installed")


@pytest.mark.skipif(sys.platform == "win32", reason="the watch needs POSIX signals and limits")
@pytest.mark.parametrize("engine", ["hypothesis", pytest.param("atheris", marks=NO_ATHERIS)])
@pytest.mark.parametrize("reader", READERS)
def test_no_input_crashes_hangs_or_eats_the_memory(tmp_path: Path, reader: str, engine: str) -> None:
    command = [sys.executable, "-m", "tests.fuzz", "--reader", reader, "--engine", engine, "--inputs", str(INPUTS), "--seed", "1"]
    done = subprocess.run([*command, "--out", str(tmp_path)], cwd=ROOT, env=environment(), check=False, capture_output=True, text=True)
    print(done.stdout)
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads(done.stdout)
    assert summary["inputs"] == INPUTS
    assert summary["findings"] == {}
    assert summary["slowest_s"] < 5
    assert summary.get("noise_bytes", 0) == 0
