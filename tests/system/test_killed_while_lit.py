"""The whole program dies in the middle of a sweep: a witness outside of it sees the laser go off, and the case holds."""

from __future__ import annotations

import signal
import sqlite3
import subprocess
import time
from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig, load_preset
from tests.core.devices.boards import RemoteBoard, remote_board
from tests.core.devices.test_guardian import OFF_WITHIN_S, off_after_s
from tests.system.impronta import command, environment

PATIENCE_S = 90.0


ROWS = 8


def lit_in_mid_scan(remote: RemoteBoard) -> bool:
    """The laser is on, after some rows that have been written to the case by now."""
    log = remote.witness.laser_log()
    return len(log) > 2 * ROWS and log[-1][1] > 0


def scan_and(remote: RemoteBoard, folder: Path, how: signal.Signals) -> tuple[float, int]:
    """Seconds until the witness saw the laser off, and the observations that the case holds."""
    rig, case = folder / "rig.toml", folder / "case.impronta"
    rig.write_text(dump_rig(replace(load_preset("bench"), controller=remote.config)))
    words = command("scan", "--rig", rig, "--specimen", "sphere", "--out", case)
    with subprocess.Popen(words, env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as program:
        end_s = time.monotonic() + PATIENCE_S
        while not lit_in_mid_scan(remote):
            assert program.poll() is None, program.stderr.read() if program.stderr else ""
            assert time.monotonic() < end_s, "the scan never came to a sweep"
            time.sleep(0.01)
        since_s = time.monotonic()
        program.send_signal(how)
        off_s = off_after_s(remote, since_s)
        program.kill()
    with CaseStore.open(case) as store:
        kept = sum(sum(store.verdict_counts(scan.id).values()) for scan in store.scans())
        assert store.scans()[-1].finish_reason is None
    connection = sqlite3.connect(case)
    assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    connection.close()
    return off_s, kept


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSTOP])
def test_the_laser_is_off_in_time_and_the_case_holds(tmp_path: Path, how: signal.Signals) -> None:
    with remote_board() as remote:
        off_s, kept = scan_and(remote, tmp_path, how)
    assert off_s < OFF_WITHIN_S
    assert kept > 20
