"""The jobs that the worker process knows by name.

A job is a plain function, the same in this process (tests) and in the worker::

    def job(request, *, progress: OnProgress, cancelled: IsCancelled) -> result

One of :data:`END_EARLY` also takes ``enough: IsEnough`` and asks it where it could end with a whole result.
It calls ``progress`` now and then, asks ``cancelled`` at least every 0.3 s, and raises
:class:`scanner_core.jobs.progress.Cancelled` when that says so.  Request and result travel through a pipe: plain
dataclasses and arrays.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

from scanner_core.errors import UsageError

JOBS: dict[str, str] = {
    "reconstruct": "scanner_core.reconstruction.job:run",
    "assess": "scanner_core.acquisition.assessing:run",
    "live-surface": "scanner_core.reconstruction.live_surface:live_surface",
    "compare": "scanner_core.comparison.compare:run",
    "compare-series": "scanner_core.comparison.series:run",
    "coverage": "scanner_core.coverage.job:run",
    "register-mounts": "scanner_core.case.mount_job:run",
    "comparison-report": "scanner_core.comparison.report.job:run",
}
"""Name -> ``module:function``; the module is imported in the worker only, when it starts."""

END_EARLY = frozenset({"reconstruct"})
"""Jobs that can end before they are done, with what they have so far."""

Job = Callable[..., Any]


def target_of(job: str) -> str:
    """The ``module:function`` of a job's name; UsageError E-USE-01 when there is none."""
    if job not in JOBS:
        raise UsageError("E-USE-01", what=f"There is no job '{job}'", do=f"choose one of {', '.join(JOBS)}")
    return JOBS[job]


def ends_early(job: str) -> bool:
    """Whether a job can end with what it has."""
    return job in END_EARLY


def modules() -> tuple[str, ...]:
    """The modules of all jobs, for a worker to import before it is needed."""
    return tuple(dict.fromkeys(target.partition(":")[0] for target in JOBS.values()))


def resolve(target: str) -> Job:
    """Import the function of a ``module:function``."""
    module, _, function = target.partition(":")
    job: Job = getattr(importlib.import_module(module), function)
    return job
