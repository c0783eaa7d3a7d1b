"""A job in a worker process, waited for: for the command line."""

from __future__ import annotations

import queue

from scanner_core.jobs.messages import JobCancelled, JobDone, JobEvent, JobFailed, JobProgress
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress
from scanner_core.jobs.worker import Worker

_POLL_S = 0.05


def run_in_worker(job: str, request: object, *, progress: OnProgress, cancelled: IsCancelled) -> object:
    """Run a registered job in a worker process of its own and return its result.

    `progress` and `cancelled` are called in the calling thread.  The worker and its thread are gone when this returns
    or raises, also on a KeyboardInterrupt.

    Raises
    ------
    Cancelled
        Within a second after `cancelled` said so, even when the job does not listen.
    ImprontaError
        What the job raised; E-JOB-01 when the process died, E-JOB-02 for any other exception.
    """
    events: queue.SimpleQueue[JobEvent] = queue.SimpleQueue()
    with Worker(job) as worker:
        running = worker.submit(job, request, events.put)
        while True:
            if cancelled():
                running.cancel()
            try:
                event = events.get(timeout=_POLL_S)
            except queue.Empty:
                continue
            match event:
                case JobProgress(told):
                    progress(told)
                case JobDone(result):
                    return result
                case JobCancelled():
                    raise Cancelled
                case JobFailed(error):
                    raise error
