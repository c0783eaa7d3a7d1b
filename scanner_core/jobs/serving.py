"""The child's loop: receive a job, run it, tell how it went."""

from __future__ import annotations

import ctypes
import gc
import importlib
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from scanner_core.errors import ImprontaError, WorkerError
from scanner_core.jobs.messages import Begun, JobCancelled, JobDone, JobFailed, JobOutcome, JobProgress, Ready, Run, Told
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.jobs.registry import resolve

PREVIEW_INTERVAL_S = 0.2
TEXT_INTERVAL_S = 0.05


class _ParentGone(BaseException):
    """The pipe is closed at the other end; ends the loop, also from within a job."""


class Throttle:
    """Lets at most 5 previews and 20 messages a second through; a new phase is always told, and so is the end."""

    def __init__(self, tell: Callable[[Progress], None], now_s: Callable[[], float] = time.monotonic) -> None:
        self._tell, self._now_s = tell, now_s
        self._phase: str | None = None
        self._preview_at = self._text_at = -1e9

    def __call__(self, progress: Progress) -> None:
        now = self._now_s()
        preview = progress.preview if now - self._preview_at >= PREVIEW_INTERVAL_S else None
        if preview is None and progress.phase == self._phase and progress.fraction < 1 and now - self._text_at < TEXT_INTERVAL_S:
            return
        self._phase, self._text_at = progress.phase, now
        if preview is not None:
            self._preview_at = now
        distances = progress.distances if preview is not None else None
        self._tell(Progress(progress.phase, progress.fraction, progress.seconds_left, preview, distances))


def serve(connection: Connection, cancelled_number: ctypes.c_int64, enough_number: ctypes.c_int64, preload: tuple[str, ...]) -> None:
    """Run jobs until the pipe closes; parameters as for :func:`scanner_core.jobs.child.work`."""
    for module in preload:
        with suppress(Exception):  # the job itself will say what is wrong with its module
            importlib.import_module(module)
    with suppress(_ParentGone):
        _send(connection, Ready())
        while True:
            run: Run = _receive(connection)
            _tell(connection, run.number, _outcome(connection, run, cancelled_number, enough_number))
            gc.collect()  # an idle worker holds no clouds


def _outcome(connection: Connection, run: Run, cancelled_number: ctypes.c_int64, enough_number: ctypes.c_int64) -> JobOutcome:
    try:
        request = _receive(connection)
        _send(connection, Begun(run.number))
        job = resolve(run.target)
        more = {"enough": lambda: enough_number.value == run.number} if run.ends_early else {}
        result = job(
            request,
            progress=Throttle(lambda progress: _send(connection, Told(run.number, JobProgress(progress)))),
            cancelled=lambda: cancelled_number.value == run.number,
            **more,
        )
    except Cancelled:
        return JobCancelled()
    except ImprontaError as error:
        return JobFailed(error)
    except _ParentGone:
        raise
    except BaseException as fault:  # whatever a job does, the program gets an answer
        return JobFailed(_unexpected(fault))
    return JobDone(result)


def _tell(connection: Connection, number: int, outcome: JobOutcome) -> None:
    try:
        _send(connection, Told(number, outcome))
    except Exception as fault:  # a result that cannot be pickled; nothing of it has been sent
        _send(connection, Told(number, JobFailed(_unexpected(fault))))


def _send(connection: Connection, message: object) -> None:
    try:
        connection.send(message)
    except OSError as fault:
        raise _ParentGone from fault


def _receive(connection: Connection) -> Any:
    try:
        return connection.recv()
    except (EOFError, OSError) as fault:
        raise _ParentGone from fault


def _unexpected(fault: BaseException) -> ImprontaError:
    reason = "this computer has too little memory" if isinstance(fault, MemoryError) else f"{type(fault).__name__}: {fault}"
    return WorkerError("E-JOB-02", details="".join(traceback.format_exception(fault)), reason=reason)
