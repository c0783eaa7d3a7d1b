"""The scan is told to end by its system: the laser goes off, what was measured is kept, and the case says how it ended."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from contextlib import ExitStack
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from scanner_core.acquisition.status import FinishReason
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig, load_preset
from tests.core.devices.boards import remote_board
from tests.core.devices.test_guardian import OFF_WITHIN_S, off_after_s
from tests.system.impronta import balanced, command, environment

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals")
PATIENCE_S = 60.0
_SIGNALS = ("SIGHUP", pytest.param("SIGTERM", marks=pytest.mark.long), pytest.param("SIGINT", marks=pytest.mark.long))


@pytest.mark.parametrize("name", _SIGNALS)
def test_a_signal_ends_the_scan_like_ctrl_c(tmp_path: Path, name: str) -> None:
    rig, case = tmp_path / "rig.toml", tmp_path / "case.impronta"
    with remote_board() as remote:
        rig.write_text(dump_rig(replace(load_preset("bench"), controller=remote.config)))
        words = command("scan", "--rig", rig, "--specimen", "sphere", "--out", case, "--json")
        # Whoever runs the tests may have been told to outlive its terminal; the scan must not inherit that.
        hears = partial(signal.signal, getattr(signal, name), signal.SIG_DFL)
        with (
            subprocess.Popen(words, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=hears) as program,
            ExitStack() as ending,
        ):
            ending.callback(program.kill)
            end_s = time.monotonic() + PATIENCE_S
            while not (log := remote.witness.laser_log()) or len(log) < 8 or log[-1][1] == 0.0:
                assert program.poll() is None, program.stderr.read() if program.stderr else ""
                assert time.monotonic() < end_s, "the scan never came to a sweep"
                time.sleep(0.01)
            if name == "SIGHUP" and program.stderr is not None:
                program.stderr.close()  # the terminal is gone, and takes no sentence any more
            since_s = time.monotonic()
            program.send_signal(getattr(signal, name))
            assert off_after_s(remote, since_s) < OFF_WITHIN_S
            assert program.wait(PATIENCE_S) == 130  # its JSON fits into the pipe
            assert program.stdout is not None
            values = json.loads(program.stdout.read())
        assert remote.witness.laser_log()[-1][1] == 0.0
    assert values["finish_reason"] == "cancelled"
    balanced(values)
    with CaseStore.open(case) as store:
        assert store.scans()[-1].finish_reason == FinishReason.CANCELLED.value


def test_nohup_is_respected(tmp_path: Path) -> None:
    code = (
        "import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN); from scanner_core.__main__ import main; "
        f"main(['info', {str(tmp_path / 'none.impronta')!r}]); print(signal.getsignal(signal.SIGHUP) is signal.SIG_IGN)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment())
    assert done.stdout.strip() == "True"
