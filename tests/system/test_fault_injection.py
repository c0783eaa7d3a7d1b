"""Every fault that can be provoked, at one moment: a safe state or an undisturbed scan, one sentence, nothing lost or left."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from scanner_core.case.store import CaseStore
from scanner_core.clock import SteppedClock
from scanner_core.errors import CaseLockedError, ImprontaError
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.reconstruction.job import ReconstructionRequest
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.virtual.faults import FAULTS, parse_fault
from scanner_core.virtual.host import Host
from scanner_core.virtual.host_faults import CaseLocked, WorkerFault
from tests.system.faulted_scan import ENDS, GOES_ON, ball, scan_with, unexpected
from tests.system.impronta import command, environment

ENDING = [name for name in ENDS if ENDS[name] != GOES_ON and name != "lamp_on"]
TOGETHER = (
    ("frames_dropped@3", "frames_late@8", "partial_lines@5", "clock_jump@9", "case_locked@4", "lost_steps@10"),
    ("frames_torn@3", "camera_bumped@9", "camera_skew@9", "shiny_patch@4", "trigger_lost@14", "lenses_warm@5", "mark_knocked_off@5"),
)
"""What a scan survives; several at once, for the time that they take."""


def test_every_fault_is_tried_here() -> None:
    together = {text.partition("@")[0] for texts in TOGETHER for text in texts}
    assert {*ENDING, *together, "lamp_on", "worker_killed", "worker_out_of_memory", "program_killed"} == FAULTS.keys()


@pytest.mark.parametrize("name", ENDING)
def test_a_scan_ends_in_a_safe_state_with_one_sentence(name: str, tmp_path: Path) -> None:
    ended = scan_with([parse_fault(f"{name}@4")], tmp_path / "case")
    assert unexpected(ended, name) == []


@pytest.mark.parametrize("texts", TOGETHER)
def test_a_scan_goes_on(texts: tuple[str, ...], tmp_path: Path) -> None:
    ended = scan_with([parse_fault(text) for text in texts], tmp_path / "case")
    assert ended.problems == []
    assert ended.code is None


def test_a_lamp_from_the_beginning_finds_no_surface(tmp_path: Path) -> None:
    ended = scan_with([parse_fault("lamp_on")], tmp_path / "case")
    assert ended.problems == []
    assert ended.code == "E-SCAN-06"


def test_a_case_that_another_program_holds_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    CaseStore.create(path).close()
    with CaseLocked.held(path), pytest.raises(CaseLockedError) as refused:
        CaseStore.open(path)
    assert refused.value.code == "E-CASE-02"
    CaseStore.open(path).close()


ON_LINUX = pytest.mark.skipif(sys.platform != "linux", reason="RLIMIT_AS")


@pytest.mark.parametrize("name", ["worker_killed", pytest.param("worker_out_of_memory", marks=ON_LINUX)])
def test_a_worker_that_dies_is_said(name: str) -> None:
    fault = parse_fault(f"{name}@0.3")
    assert isinstance(fault, WorkerFault)
    request = ReconstructionRequest(ball(100_000), ReconstructionParameters())  # more than fits into what the worker has at its start
    host = Host(SteppedClock())
    host.let_happen_to_worker(fault)
    try:
        with pytest.raises(ImprontaError) as said:
            run_in_worker("reconstruct", request, progress=lambda _: None, cancelled=lambda: False)
    finally:
        host.close()
    assert said.value.code in ("E-JOB-01", "E-JOB-02")


def test_a_killed_program_leaves_a_case_that_opens(tmp_path: Path) -> None:
    case = tmp_path / "a.impronta"
    words = command("scan", "--rig", "bench", "--specimen", "sphere", "--out", case, "--json", "--fault", "program_killed@12")
    done = subprocess.run(words, capture_output=True, text=True, timeout=60, check=False, env=environment())
    assert done.returncode == (-9 if sys.platform != "win32" else 15), done
    assert done.stdout == ""
    with CaseStore.open(case) as store:
        assert sum(sum(store.verdict_counts(scan.id).values()) for scan in store.scans()) > 0
