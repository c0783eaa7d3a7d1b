"""The worker process: results, errors, cancels and deaths arrive, and nothing is left behind."""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import psutil
import pytest

from scanner_core.errors import ReconstructionError, UsageError, WorkerError, WorkerLostError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs import registry
from scanner_core.jobs.child import BLAS_THREADS
from scanner_core.jobs.messages import JobCancelled, JobDone, JobEvent, JobFailed, JobOutcome, JobProgress
from scanner_core.jobs.worker import JobHandle, Worker
from tests.core.jobs import tiny_jobs

LONG_S = 60.0


@pytest.fixture
def worker(monkeypatch: pytest.MonkeyPatch) -> Iterator[Worker]:
    monkeypatch.setattr(registry, "JOBS", tiny_jobs.targets())
    monkeypatch.setattr(registry, "END_EARLY", frozenset({"content"}))
    for name in BLAS_THREADS:  # the tests side by side set them for themselves
        monkeypatch.delenv(name, raising=False)
    with Worker("test") as worker:
        yield worker
    assert not [child for child in psutil.Process().children() if child.status() == psutil.STATUS_ZOMBIE]


def _raise(reason: str) -> None:
    raise ValueError(reason)


class Unloadable:
    """Fails when the child unpickles it."""

    def __reduce__(self) -> tuple[object, ...]:
        return _raise, ("not in this child",)


def outcome(worker: Worker, job: str, request: object) -> JobOutcome:
    ended = worker.submit(job, request, lambda event: None).wait(LONG_S)
    assert ended is not None
    return ended


def started(worker: Worker, job: str, request: object) -> tuple[Callable[[], JobEvent], object]:
    """Submit, and wait for the first progress."""
    events: queue.SimpleQueue[JobEvent] = queue.SimpleQueue()
    handle = worker.submit(job, request, events.put)
    assert isinstance(events.get(timeout=LONG_S), JobProgress)
    return (lambda: events.get(timeout=LONG_S)), handle


def test_result_and_progress_arrive_in_order(worker: Worker) -> None:
    events: list[JobEvent] = []
    ended = worker.submit("add", (2.0, 3.0), events.append).wait(LONG_S)
    assert isinstance(ended, JobDone)
    assert ended.result == 5.0
    assert isinstance(events[0], JobProgress)
    assert events[0].progress.phase == "add"


def test_a_large_mesh_travels_both_ways(worker: Worker) -> None:
    mesh = TriangleMesh(np.random.default_rng(5).normal(size=(46_000, 3)), np.arange(92_000 * 3).reshape(-1, 3) % 46_000)
    ended = outcome(worker, "echo", mesh)
    assert isinstance(ended, JobDone)
    assert isinstance(ended.result, TriangleMesh)
    assert (ended.result.vertices == mesh.vertices).all()


def test_the_child_has_one_blas_thread_and_ignores_ctrl_c(worker: Worker, capfd: pytest.CaptureFixture[str]) -> None:
    ended = outcome(worker, "environment", None)
    assert isinstance(ended, JobDone)
    assert isinstance(ended.result, dict)
    assert set(ended.result["blas"].values()) == {"1"}
    assert ended.result["interrupt"] is True
    if ended.result["threads"] is not None:
        assert ended.result["threads"] == 2  # the job and the watch of the parent; no thread of a BLAS
    assert "noise" not in capfd.readouterr().out


def test_a_caller_who_is_content_gets_what_there_is_and_the_next_one_all(worker: Worker) -> None:
    following, handle = started(worker, "content", 60.0)
    assert isinstance(handle, JobHandle)
    handle.end_early()
    ended = following()
    assert isinstance(ended, JobDone)
    assert ended.result == "half"
    handle.end_early()  # over: it says nothing to the next job
    again = outcome(worker, "content", 0.05)
    assert isinstance(again, JobDone)
    assert again.result == "whole"


def test_a_job_that_cannot_end_early_goes_on_and_can_be_cancelled(worker: Worker) -> None:
    following, handle = started(worker, "patient", 60.0)
    assert isinstance(handle, JobHandle)
    handle.end_early()
    handle.cancel()
    assert isinstance(following(), JobCancelled)


def test_errors_keep_their_code_fields_and_details(worker: Worker) -> None:
    ended = outcome(worker, "refuse", 7)
    assert isinstance(ended, JobFailed)
    assert isinstance(ended.error, ReconstructionError)
    assert (ended.error.code, ended.error.fields, ended.error.details) == ("E-REC-01", {"points": 7, "least": 100}, "few")


@pytest.mark.parametrize(
    ("request_", "said"),
    [("value", "ValueError: no such value"), ("end", "EOFError: mine"), ("pipe", "BrokenPipeError: mine"), ("memory", "too little memory")],
)
def test_other_exceptions_become_one_sentence_with_the_traceback_for_the_log(worker: Worker, request_: str, said: str) -> None:
    assert isinstance(outcome(worker, "echo", 1), JobDone)
    pid = worker.pid
    ended = outcome(worker, "stumble", request_)
    assert isinstance(ended, JobFailed)
    assert isinstance(ended.error, WorkerError)
    assert ended.error.code == "E-JOB-02"
    assert said in str(ended.error)
    assert "tiny_jobs.py" in ended.error.details
    assert worker.pid == pid


def test_a_job_that_exits_fails_and_the_worker_stays(worker: Worker) -> None:
    assert isinstance(outcome(worker, "echo", 1), JobDone)
    pid = worker.pid
    ended = outcome(worker, "leave", 3)
    assert isinstance(ended, JobFailed)
    assert "SystemExit" in str(ended.error)
    assert worker.pid == pid


def test_results_and_requests_that_cannot_be_pickled(worker: Worker) -> None:
    for ended in (outcome(worker, "unpicklable", None), outcome(worker, "echo", lambda: None)):
        assert isinstance(ended, JobFailed)
        assert ended.error.code == "E-JOB-02"
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)


def test_a_cancel_stops_a_job_that_listens_and_keeps_the_child(worker: Worker) -> None:
    next_event, handle = started(worker, "patient", LONG_S)
    pid = worker.pid
    handle.cancel()
    handle.cancel()
    assert isinstance(next_event(), JobCancelled)
    assert worker.pid == pid
    assert isinstance(outcome(worker, "patient", 0.0), JobDone)  # the old cancel does not reach the next job


def test_a_cancel_kills_a_job_that_does_not_listen(worker: Worker) -> None:
    next_event, handle = started(worker, "deaf", LONG_S)
    pid = worker.pid
    assert pid is not None
    begin = time.monotonic()
    handle.cancel()
    assert isinstance(next_event(), JobCancelled)
    assert time.monotonic() - begin < LONG_S / 2  # it did not wait for the job
    assert not psutil.pid_exists(pid)
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)


def test_a_cancel_before_the_child_is_ready_is_at_once(worker: Worker) -> None:
    with Worker("fresh") as fresh:
        assert isinstance(cancelled_at_once(fresh), JobCancelled)


def cancelled_at_once(worker: Worker) -> JobOutcome | None:
    handle = worker.submit("add", (1, 1), lambda event: None)
    handle.cancel()
    return handle.wait(LONG_S)


@pytest.mark.parametrize(
    ("request_", "reason"), [(signal.SIGKILL, "killed by signal 9"), (signal.SIGSEGV, "killed by signal 11"), (-5, "exit code 5")]
)
def test_a_dead_child_is_told_with_phase_and_reason_and_replaced(worker: Worker, request_: int, reason: str) -> None:
    ended = outcome(worker, "die", int(request_))
    assert isinstance(ended, JobFailed)
    assert isinstance(ended.error, WorkerLostError)
    assert ended.error.code == "E-JOB-01"
    assert ended.error.fields["phase"] == "dying"
    assert reason in str(ended.error)
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)


def test_an_idle_child_that_dies_is_replaced(worker: Worker) -> None:
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)
    assert worker.pid is not None
    os.kill(worker.pid, signal.SIGKILL)
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)  # whether the job or the death came first


def test_children_that_die_before_they_begin_are_tried_twice(worker: Worker, monkeypatch: pytest.MonkeyPatch) -> None:
    assert isinstance(outcome(worker, "echo", Unloadable()), JobFailed)
    monkeypatch.setitem(registry.JOBS, "dead", "tests.core.jobs.deadly:job")  # preloaded by the children from now on
    assert isinstance(outcome(worker, "die", -1), JobFailed)
    ended = outcome(worker, "add", (1, 1))
    assert isinstance(ended, JobFailed)
    assert (ended.error.code, ended.error.fields["phase"]) == ("E-JOB-01", "start")
    monkeypatch.delitem(registry.JOBS, "dead")
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)


def test_previews_come_at_most_five_times_a_second(worker: Worker) -> None:
    events: list[JobEvent] = []
    ended = worker.submit("previews", 0.5, events.append).wait(LONG_S)
    assert isinstance(ended, JobDone)
    assert isinstance(ended.result, int)
    with_preview = [event for event in events if isinstance(event, JobProgress) and event.progress.preview is not None]
    assert 1 <= len(with_preview) <= 3
    assert len(events) <= 12


def test_one_job_at_a_time_and_only_known_ones(worker: Worker) -> None:
    next_event, handle = started(worker, "patient", LONG_S)
    assert worker.busy
    with pytest.raises(UsageError, match="running already"):
        worker.submit("add", (1, 1), lambda event: None)
    with pytest.raises(UsageError, match="no job 'bake'"):
        worker.submit("bake", None, lambda event: None)
    handle.cancel()
    assert isinstance(next_event(), JobCancelled)
    assert not worker.busy


def test_the_next_job_may_be_submitted_from_the_last_event(worker: Worker) -> None:
    second: queue.SimpleQueue[JobEvent] = queue.SimpleQueue()

    def go_on(event: JobEvent) -> None:
        if isinstance(event, JobDone):
            worker.submit("echo", "second", second.put)

    worker.submit("echo", "first", go_on)
    event = second.get(timeout=LONG_S)
    assert isinstance(event, JobDone)
    assert event.result == "second"


def test_a_listener_that_raises_is_told_and_survived(worker: Worker, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[type[BaseException]] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: told.append(args.exc_type))

    def stumble(event: JobEvent) -> None:
        raise KeyError("mine")

    assert isinstance(worker.submit("echo", 1, stumble).wait(LONG_S), JobDone)
    assert isinstance(outcome(worker, "add", (1, 1)), JobDone)
    assert told == [KeyError]


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs /proc")
def test_an_idle_child_holds_no_memory_of_its_last_job(worker: Worker) -> None:
    before = outcome(worker, "resident_mb", None)
    assert isinstance(outcome(worker, "hoard", 300), JobDone)
    after = outcome(worker, "resident_mb", None)
    assert isinstance(before, JobDone)
    assert isinstance(after, JobDone)
    assert isinstance(before.result, float)
    assert isinstance(after.result, float)
    assert after.result - before.result < 60


def test_close_ends_a_running_job_and_leaves_nothing(worker: Worker) -> None:
    other = Worker("other")
    next_event, _ = started(other, "deaf", LONG_S)
    pid = other.pid
    assert pid is not None
    other.close()
    other.close()
    assert isinstance(next_event(), JobCancelled)
    assert not psutil.pid_exists(pid)
    assert not [thread for thread in threading.enumerate() if thread.name == "job-listener-other"]
    with pytest.raises(UsageError, match="closed"):
        other.submit("add", (1, 1), lambda event: None)


PARENT = """
import os, signal, sys
from scanner_core.jobs import registry
from scanner_core.jobs.child import BLAS_THREADS
from scanner_core.jobs.messages import JobProgress
from scanner_core.jobs.worker import JobHandle, Worker

def main():
    registry.JOBS["deaf"] = "tests.core.jobs.tiny_jobs:deaf"
    worker = Worker("orphan")
    def on_event(event):
        if isinstance(event, JobProgress):
            print(worker.pid, flush=True)
            os.kill(os.getpid(), signal.SIGKILL)
    worker.submit("deaf", 600.0, on_event)

if __name__ == "__main__":
    main()
"""


def test_the_child_dies_with_its_parent(tmp_path: Path) -> None:
    script = tmp_path / "parent.py"
    script.write_text(PARENT, encoding="utf-8")
    root = Path(__file__).parents[3]
    parent = subprocess.run(
        [sys.executable, str(script)], cwd=root, env={**os.environ, "PYTHONPATH": str(root)}, stdout=subprocess.PIPE, timeout=LONG_S, check=False
    )
    child = int(parent.stdout)
    assert parent.returncode == -signal.SIGKILL
    deadline = time.monotonic() + 10
    while psutil.pid_exists(child) and psutil.Process(child).status() != psutil.STATUS_ZOMBIE and time.monotonic() < deadline:
        time.sleep(0.02)
    assert not psutil.pid_exists(child) or psutil.Process(child).status() == psutil.STATUS_ZOMBIE
