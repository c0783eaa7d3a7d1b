"""A worker whose process is killed at random moments, hundreds of times: every job gets one answer, nothing piles up."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
import time

import numpy as np
import psutil
import pytest

from scanner_core.jobs import registry
from scanner_core.jobs.messages import JobCancelled, JobDone, JobEvent, JobFailed, JobProgress
from scanner_core.jobs.worker import Worker
from tests.core.jobs import tiny_jobs

ROUNDS = 400


@pytest.mark.long
@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_kills_and_cancels_at_random_moments(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "JOBS", tiny_jobs.targets())
    rng = np.random.default_rng(20)
    request = np.arange(300_000.0)  # more than a pipe holds, so that kills hit transfers too
    answers: list[type[JobEvent]] = []
    this = psutil.Process()
    with Worker("soak") as worker:
        open_before = 0
        for number in range(ROUNDS):
            events: list[JobEvent] = []
            handle = worker.submit("echo" if number % 2 else "patient", request if number % 2 else 0.3, events.append)
            time.sleep(float(rng.uniform(0, 0.5)))
            pid = worker.pid
            if number % 3 == 0:
                handle.cancel()
            elif pid is not None:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            assert handle.wait(30.0) is not None
            ends = [event for event in events if not isinstance(event, JobProgress)]
            assert len(ends) == 1
            assert not isinstance(ends[0], JobFailed) or ends[0].error.code == "E-JOB-01"
            answers.append(type(ends[0]))
            if number == 20:
                open_before = this.num_fds()
        assert this.num_fds() <= open_before + 6
        assert isinstance(worker.submit("add", (1, 2), lambda event: None).wait(30.0), JobDone)
    assert {JobDone, JobFailed, JobCancelled} == set(answers)
    assert not [child for child in this.children() if child.status() == psutil.STATUS_ZOMBIE]
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("job-listener")]
