"""What goes through the pipe between the program and its worker process, and what the program makes of it."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.errors import ImprontaError
from scanner_core.jobs.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class JobProgress:
    """The job goes on."""

    progress: Progress


@dataclass(frozen=True, slots=True, eq=False)
class JobDone:
    """The job returned."""

    result: object


@dataclass(frozen=True, slots=True, eq=False)
class JobCancelled:
    """The job was cancelled; this is no error."""


@dataclass(frozen=True, slots=True, eq=False)
class JobFailed:
    """The job, or the worker process, failed."""

    error: ImprontaError


JobOutcome = JobDone | JobCancelled | JobFailed
JobEvent = JobProgress | JobOutcome


@dataclass(frozen=True, slots=True)
class Ready:
    """Child to parent: imports are done, a job can start at once."""


@dataclass(frozen=True, slots=True)
class Run:
    """Parent to child: run `target` (``module:function``); the request follows as a message of its own.

    With `ends_early` the job is told when its caller wants no better result than there is.
    """

    number: int
    target: str
    ends_early: bool = False


@dataclass(frozen=True, slots=True)
class Begun:
    """Child to parent: the request has arrived and the job with this number begins."""

    number: int


@dataclass(frozen=True, slots=True, eq=False)
class Told:
    """Child to parent: an event of the job with this number."""

    number: int
    event: JobEvent
