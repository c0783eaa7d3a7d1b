"""Every fault at twenty moments drawn at random over a whole run: a safe state or an undisturbed scan, every time.

The summary stands in the test's output (``pytest -s``, or a failure's): one line a fault.
"""

from __future__ import annotations

import random
import subprocess
import sys
import time
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.case.store import CaseStore
from scanner_core.clock import SteppedClock
from scanner_core.errors import ImprontaError
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.reconstruction.job import ReconstructionRequest
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.virtual.bench_faults import CameraFault
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.faults import FAULTS
from scanner_core.virtual.host import Host
from scanner_core.virtual.host_faults import ClockJump, WorkerFault
from tests.system.faulted_scan import ENDS, LONGEST_S, WHOLE_RUN_S, ball, scan_with, unexpected
from tests.system.impronta import command, environment

MOMENTS = 20
LONGEST_JOB_S = 6.0
"""The job's duration, so that some moments come after it."""


def _told(name: str, ends: Counter[str], worst_s: float) -> None:
    words = ", ".join(f"{count} {end}" for end, count in sorted(ends.items()))
    print(f"{name:20s} {words}; worst {worst_s:.1f} s", flush=True)


def _varied(name: str, at_s: float, draw: random.Random) -> Fault:
    """The fault at a moment, of a camera or in a direction drawn at random."""
    fault = replace(FAULTS[name], at_s=at_s)
    if isinstance(fault, CameraFault):
        return replace(fault, camera=draw.choice(("left", "right")))
    if isinstance(fault, ClockJump):
        return replace(fault, jump_s=draw.choice((-3600.0, 3600.0)))
    return fault


def _where_it_can_be_had(name: str) -> object:
    """Only Linux limits the memory of another process."""
    elsewhere = name == "worker_out_of_memory" and sys.platform != "linux"
    return pytest.param(name, marks=pytest.mark.skipif(elsewhere, reason="needs RLIMIT_AS of another process"))


@pytest.mark.long
@pytest.mark.parametrize("name", ENDS)
def test_a_scan_survives_a_fault_at_any_moment(name: str, tmp_path: Path) -> None:
    draw, ends, worst_s, wrong = random.Random(name), Counter[str](), 0.0, []
    for number in range(MOMENTS):
        fault = _varied(name, draw.uniform(0.0, 1.05 * WHOLE_RUN_S), draw)
        ended = scan_with([fault], tmp_path / str(number), seed=number)
        ends[ended.code or ended.result.finish_reason.value] += 1
        worst_s = max(worst_s, ended.seconds)
        wrong += [f"at {fault.at_s:.2f} s, seed {number}: {problem}" for problem in unexpected(ended, name)]
    _told(name, ends, worst_s)
    assert wrong == []


@pytest.mark.long
@pytest.mark.parametrize("name", [_where_it_can_be_had(name) for name, fault in FAULTS.items() if isinstance(fault, WorkerFault)])
def test_a_reconstruction_survives_a_fault_at_any_moment(name: str) -> None:
    draw, ends, worst_s = random.Random(name), Counter[str](), 0.0
    request = ReconstructionRequest(ball(), ReconstructionParameters())
    for _ in range(MOMENTS):
        begin_s = time.monotonic()
        host = Host(SteppedClock())
        fault = replace(FAULTS[name], at_s=draw.uniform(0.0, LONGEST_JOB_S))
        assert isinstance(fault, WorkerFault)
        host.let_happen_to_worker(fault)
        try:
            run_in_worker("reconstruct", request, progress=lambda _: None, cancelled=lambda: False)
            ends["completed"] += 1
        except ImprontaError as error:
            ends[error.code] += 1
        finally:
            host.close()
        worst_s = max(worst_s, time.monotonic() - begin_s)
        assert worst_s < LONGEST_S
    _told(name, ends, worst_s)
    assert ends.keys() <= {"completed", "E-JOB-01", "E-JOB-02"}


@pytest.mark.long
@pytest.mark.skipif(sys.platform == "win32", reason="an exit code for a kill is POSIX's")
def test_a_program_is_killed_at_any_moment(tmp_path: Path) -> None:
    draw, ends, worst_s = random.Random("program_killed"), Counter[str](), 0.0
    plan = tmp_path / "plan.toml"
    plan.write_text("views = 2\npoints = 120\n", encoding="utf-8")
    for number in range(MOMENTS):
        case, at_s = tmp_path / f"{number}.impronta", draw.uniform(0.0, WHOLE_RUN_S)
        words = command("scan", "--rig", "bench", "--specimen", "sphere", "--plan", plan, "--out", case, "--fault", f"program_killed@{at_s:.3f}")
        begin_s = time.monotonic()
        done = subprocess.run(words, capture_output=True, text=True, timeout=LONGEST_S, check=False, env=environment())
        worst_s = max(worst_s, time.monotonic() - begin_s)
        ends[{-9: "killed", 0: "completed"}.get(done.returncode, f"exit {done.returncode}: {done.stderr}")] += 1
        with CaseStore.open(case) as store:
            assert store._rows("PRAGMA integrity_check") == [("ok",)]
    _told("program_killed", ends, worst_s)
    assert ends.keys() <= {"killed", "completed"}
