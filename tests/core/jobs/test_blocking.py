"""A job for the command line: waited for, cancelled within a second, nothing left behind."""

from __future__ import annotations

import threading

import pytest

from scanner_core.errors import ReconstructionError, WorkerLostError
from scanner_core.jobs import registry
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.jobs.progress import Cancelled, Progress
from tests.core.jobs import tiny_jobs


@pytest.fixture(autouse=True)
def _tiny_jobs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "JOBS", tiny_jobs.targets())


def test_result_and_progress_come_in_the_calling_thread() -> None:
    told: list[tuple[Progress, threading.Thread]] = []
    result = run_in_worker("add", (1, 2), progress=lambda p: told.append((p, threading.current_thread())), cancelled=lambda: False)
    assert result == 3
    assert [(p.phase, thread) for p, thread in told] == [("add", threading.current_thread())]


@pytest.mark.parametrize("job", ["patient", "deaf"])
def test_a_cancel_is_raised_whether_the_job_listens_or_not(job: str) -> None:
    begun = threading.Event()
    with pytest.raises(Cancelled):
        run_in_worker(job, 60.0, progress=lambda p: begun.set(), cancelled=begun.is_set)


def test_errors_and_deaths_are_raised() -> None:
    with pytest.raises(ReconstructionError, match="E-REC-01"):
        run_in_worker("refuse", 3, progress=lambda p: None, cancelled=lambda: False)
    with pytest.raises(WorkerLostError, match="killed by signal 9"):
        run_in_worker("die", 9, progress=lambda p: None, cancelled=lambda: False)


def test_an_interrupt_leaves_no_process_behind() -> None:
    def interrupt(progress: Progress) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_in_worker("deaf", 60.0, progress=interrupt, cancelled=lambda: False)
