"""The program killed with SIGKILL at random moments: every case opens, holds what was acknowledged, and the laser is off.

The moments are drawn with fixed seeds.  The witness is the firmware model, which lives in a process of its own.
"""

from __future__ import annotations

import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import psutil
import pytest

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.case.processing import case_cloud
from scanner_core.case.recovery import find_interrupted
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.virtual.specimens import load_specimen
from tests.core.devices.boards import RemoteBoard, remote_board
from tests.core.devices.test_guardian import OFF_WITHIN_S, off_after_s
from tests.system.impronta import balanced, environment, impronta

SCANNING_S = 30.0
"""A scan of the program takes about so long; it is killed somewhere in between, its start included."""
WORKING_S = 4.0
PATIENCE_S = 60.0


@dataclass
class Killed:
    """A program and what it has said."""

    process: subprocess.Popen[str]
    acknowledged: int = 0
    family: tuple[psutil.Process, ...] = ()

    def kill(self) -> float | None:
        """Moment (monotonic, s) of the kill; None when the program had come to its end."""
        if self.process.poll() is not None:
            return None
        self.family = tuple(psutil.Process(self.process.pid).children(recursive=True))
        since_s = time.monotonic()
        self.process.send_signal(signal.SIGKILL)
        return since_s


@contextmanager
def program(*words: object) -> Iterator[Killed]:
    """It has begun to work; in the end all that it acknowledged is known."""
    command = [sys.executable, "-m", "tests.long.acknowledging", *map(str, words)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment(), start_new_session=True)
    told = Killed(process)
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"

    def listen() -> None:
        assert process.stdout is not None
        for line in process.stdout:
            if line.startswith("ack "):
                told.acknowledged = int(line[4:])

    listener = threading.Thread(target=listen)
    listener.start()
    try:
        yield told
    finally:
        process.kill()
        process.wait()
        listener.join(PATIENCE_S)
        process.stdout.close()


def nobody_is_left(family: tuple[psutil.Process, ...]) -> None:
    """Guardian and worker end with the program."""
    _, alive = psutil.wait_procs(list(family), timeout=10.0)
    assert not alive, alive


def integrity(case: Path) -> None:
    connection = sqlite3.connect(case)
    assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    connection.close()


def killed_scan(remote: RemoteBoard, mode: str, case: Path, after_s: float) -> tuple[float | None, int]:
    """Seconds until the laser was dark, None when the scan had ended by itself, and acknowledged observations."""
    with program(mode, case, remote.url, remote.side_channel) as told:
        end_s = time.monotonic() + after_s
        while time.monotonic() < end_s and told.process.poll() is None:
            time.sleep(0.01)
        since_s = told.kill()
        off_s = None if since_s is None else max(0.0, off_after_s(remote, since_s))
    nobody_is_left(told.family)
    listed = find_interrupted([case])
    with CaseStore.open(case) as store:
        kept = sum(len(store.exposed_ids(scan.id)) for scan in store.scans())
        assert kept >= told.acknowledged, f"{told.acknowledged - kept} acknowledged observations are gone"
        finished = any(scan.kind == "scan" and scan.finish_reason == "completed" for scan in store.scans())
    assert finished or len(listed) == (1 if told.acknowledged or listed else 0)
    integrity(case)
    return off_s, told.acknowledged


def killed_work(mode: str, case: Path, after_s: float) -> int:
    """Acknowledged meshes and edits."""
    with program(mode, case) as told:
        time.sleep(after_s)
        told.kill()
    nobody_is_left(told.family)
    with CaseStore.open(case) as store:
        points = len(case_cloud(store))
        done = told.acknowledged
        meshes = done if mode == "reconstruct" else (done + 1) // 2
        assert meshes <= store.mesh_count() <= meshes + 1
        if mode == "save" and done >= 2:
            assert int(store.order().number) >= done - done % 2
        if store.mesh_count():
            assert len(store.mesh()[0].triangles) > 0
    assert points > 800
    integrity(case)
    return told.acknowledged


@pytest.fixture(scope="module")
def scanned(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("scanned") / "a.impronta"
    specimen = load_specimen("sphere")
    with CaseStore.create(path) as store, open_rig(load_preset("bench"), specimen, seed=1) as rig:
        runner = ScanRunner(rig, PlanRequest(6, 1000, specimen.radius_mm, specimen.height_mm), store)
        runner.start()
        assert runner.join(PATIENCE_S)
    return path


@pytest.mark.long
@pytest.mark.parametrize(("mode", "runs", "seed"), [("scan", 80, 51), ("pause", 40, 52)])
def test_scans_killed_at_random_moments(tmp_path: Path, mode: str, runs: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    times_s: list[float] = []
    acknowledged: list[int] = []
    while len(times_s) < runs:
        with remote_board() as remote:
            off_s, count = killed_scan(remote, mode, tmp_path / f"{len(acknowledged)}.impronta", float(rng.uniform(0, SCANNING_S)))
        times_s += [] if off_s is None else [off_s]
        acknowledged.append(count)
    lit = [time_s for time_s in times_s if time_s > 0]
    print(f"{mode}: {runs} kills of {len(acknowledged)} runs, {len(lit)} of them lit, dark after {np.median(lit):.3f} s, longest {max(lit):.3f} s")
    print(f"{sum(acknowledged)} observations acknowledged")
    assert max(times_s) < OFF_WITHIN_S


@pytest.mark.long
@pytest.mark.parametrize(("mode", "runs", "seed"), [("reconstruct", 40, 53), ("save", 40, 54)])
def test_work_killed_at_random_moments(tmp_path: Path, scanned: Path, mode: str, runs: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    acknowledged = []
    for number in range(runs):
        case = tmp_path / f"{number}.impronta"
        shutil.copyfile(scanned, case)
        acknowledged.append(killed_work(mode, case, float(rng.uniform(0, WORKING_S))))
    print(f"{mode}: {runs} kills, {sum(acknowledged)} acknowledged")


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_a_save_that_is_killed(tmp_path: Path, scanned: Path) -> None:
    case = tmp_path / "a.impronta"
    shutil.copyfile(scanned, case)
    assert killed_work("save", case, 0.4) > 2


@pytest.mark.long
def test_a_killed_scan_is_resumed_on_a_board_that_forgets_where_it_stands(tmp_path: Path) -> None:
    case, rig = tmp_path / "a.impronta", tmp_path / "rig.toml"
    with remote_board(position_survives_reset=False) as remote:
        with program("scan", case, remote.url, remote.side_channel) as told:
            while remote.witness.instant(remote.witness.clock.now_s()).table_deg < 100.0 or told.acknowledged < 350:
                time.sleep(0.05)
            told.kill()
            off_after_s(remote, time.monotonic())
        with CaseStore.open(case) as store:
            before = store.scans()[-1]
            assert before.kind == "scan"
            known = len(store.observations(before.id))
        time.sleep(1.0)  # until the guardian has released the port
        rig.write_text(dump_rig(replace(load_preset("bench"), controller=remote.config)))
        done = impronta("scan", "--rig", rig, "--specimen", "sphere", "--resume", "--out", case, "--seed", 1, "--json")
    assert done.code == 0, done
    told_again = done.json()
    balanced(told_again)
    assert told_again["resumed"] == {"points_before": known}
    assert told_again["measured"] == 200
