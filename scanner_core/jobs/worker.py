"""The worker process as the program sees it: one spawned child, replaced when it dies or ignores a cancel."""

from __future__ import annotations

import ctypes
import multiprocessing
import signal
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from types import TracebackType

from scanner_core.errors import UsageError, WorkerError, WorkerLostError
from scanner_core.jobs.child import work
from scanner_core.jobs.messages import Begun, JobCancelled, JobEvent, JobFailed, JobOutcome, JobProgress, Ready, Run, Told
from scanner_core.jobs.registry import ends_early, modules, target_of

CANCEL_GRACE_S = 0.7
"""A job that has not stopped this long after its cancel is killed with its process."""

_TRIES = 2
"""Children that a job is given to until one of them begins it."""

begun_watchers: list[Callable[[int], None]] = []
"""Each is told the process id of every child that begins a job, in a listener thread; it must return quickly."""

OnEvent = Callable[[JobEvent], None]


class JobHandle:
    """One submitted job."""

    def __init__(self, cancel: Callable[[JobHandle], None], end_early: Callable[[JobHandle], None]) -> None:
        self._cancel, self._end_early = cancel, end_early
        self._ended = threading.Event()
        self._outcome: JobOutcome | None = None

    def cancel(self) -> None:
        """Ask the job to stop; returns at once.  JobCancelled follows within a second.  Harmless after the end."""
        self._cancel(self)

    def end_early(self) -> None:
        """Ask the job to end with what it has; returns at once.  Without effect on a job that cannot, and after the end."""
        self._end_early(self)

    @property
    def outcome(self) -> JobOutcome | None:
        """How the job ended, or None while it runs."""
        return self._outcome

    def wait(self, timeout_s: float | None = None) -> JobOutcome | None:
        """Wait for the end, after `on_event` was told; None when the time is over before.  Not from within `on_event`."""
        return self._outcome if self._ended.wait(timeout_s) else None


@dataclass(slots=True, eq=False)
class _Current:
    number: int
    target: str
    ends_early: bool
    request: object
    on_event: OnEvent
    handle: JobHandle
    phase: str = "start"
    sent: bool = False
    begun: bool = False
    tries: int = 1
    cancelled_at_s: float | None = None


class Worker:
    """One child process for long jobs, started at once so that the first job need not wait for its imports.

    Its environment allows one BLAS thread; it ignores Ctrl-C, ends when this process ends, and previews reach it at
    most five times a second.  All methods may be called from any thread.  Use it as a context manager or call
    :meth:`close`; its listener thread keeps the program alive until then.

    Parameters
    ----------
    name
        Of its process and of its thread.
    job
        The only one that it is for, so that it starts with the imports of that one; None when it is for all.
    gentle
        It gives way to everything else that wants a core.
    """

    def __init__(self, name: str = "worker", *, job: str | None = None, gentle: bool = False) -> None:
        self._name, self._job, self._gentle = name, job, gentle
        self._context = multiprocessing.get_context("spawn")
        self._cancelled_number: ctypes.c_int64 = self._context.RawValue(ctypes.c_int64, 0)
        self._enough_number: ctypes.c_int64 = self._context.RawValue(ctypes.c_int64, 0)
        self._lock, self._wake_lock = threading.Lock(), threading.Lock()
        self._current: _Current | None = None
        self._count = 0
        self._closing = False
        self._process: SpawnProcess | None = None
        self._connection: Connection | None = None
        self._ready = False
        self._wake_receiver, self._wake_sender = self._context.Pipe(duplex=False)
        if sys.platform != "win32":
            resource_tracker.ensure_running()  # now: starting it unblocks the signals of the thread that does
        self._listener = threading.Thread(target=self._listen, name=f"job-listener-{name}", daemon=False)
        self._listener.start()

    # ------------------------------------------------------------------------------------------ for the program

    def submit(self, job: str, request: object, on_event: OnEvent) -> JobHandle:
        """Run a registered job; returns at once.

        Parameters
        ----------
        job
            A name of :data:`scanner_core.jobs.registry.JOBS`.
        request
            The job's argument; it is pickled.
        on_event
            Called in the listener thread with any number of :class:`JobProgress` and then exactly one of
            :class:`JobDone`, :class:`JobCancelled`, :class:`JobFailed`; it must return quickly.  From within the last
            one the next job may be submitted.

        Raises
        ------
        UsageError
            E-USE-01 for an unknown job, when a job is running, or after ``close()``.
        """
        target = target_of(job)
        with self._lock:
            if self._closing:
                raise UsageError("E-USE-01", what="The worker has been closed", do="start the program again")
            if self._current is not None:
                raise UsageError("E-USE-01", what="A job is running already", do="wait for it or cancel it first")
            self._count += 1
            handle = JobHandle(self._cancel, self._end_early)
            self._current = _Current(self._count, target, ends_early(job), request, on_event, handle)
        self._wake()
        return handle

    @property
    def busy(self) -> bool:
        """Whether a job runs."""
        return self._current is not None

    @property
    def pid(self) -> int | None:
        """The child's process id, or None while there is none."""
        process = self._process
        return None if process is None else process.pid

    def close(self, deadline_s: float = 3.0) -> None:
        """Cancel the running job, end the child and join the listener; a second call does nothing.

        Not from within `on_event`.  A child that does not go by itself is killed.
        """
        with self._lock:
            self._closing = True
            current = self._current
        if current is not None:
            self._cancel(current.handle)
        self._wake()
        self._listener.join(deadline_s)
        if self._listener.is_alive():
            process = self._process
            if process is not None:
                process.kill()
            self._listener.join(deadline_s)
        if not self._listener.is_alive():
            self._wake_sender.close()
            self._wake_receiver.close()

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def _cancel(self, handle: JobHandle) -> None:
        with self._lock:
            current = self._current
            if current is None or current.handle is not handle or current.cancelled_at_s is not None:
                return
            current.cancelled_at_s = time.monotonic()
            self._cancelled_number.value = current.number
        self._wake()

    def _end_early(self, handle: JobHandle) -> None:
        with self._lock:
            if self._current is not None and self._current.handle is handle:
                self._enough_number.value = self._current.number

    def _wake(self) -> None:
        with self._wake_lock, suppress(OSError):
            self._wake_sender.send_bytes(b"\0")

    # ------------------------------------------------------------------------------------------ the listener thread

    def _listen(self) -> None:
        if hasattr(signal, "pthread_sigmask"):
            # Children inherit this: Ctrl-C cannot hit one before it has begun to ignore it.
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            self._start_child()
            while self._step():
                pass
        finally:
            self._stop_child()

    def _step(self) -> bool:
        """Do what is due, then wait for the next thing; False when the worker shall end."""
        with self._lock:
            current, closing = self._current, self._closing
        if current is None and closing:
            return False
        timeout_s = None
        if current is not None:
            if current.cancelled_at_s is not None:
                timeout_s = current.cancelled_at_s + CANCEL_GRACE_S - time.monotonic()
                if not current.sent or timeout_s <= 0:
                    if current.sent:
                        self._kill_child()
                    self._end(JobCancelled())
                    self._start_child()
                    return True
            elif self._process is None:
                self._start_child()
            elif self._ready and not current.sent:
                self._send(current)
        self._await(timeout_s)
        return True

    def _await(self, timeout_s: float | None) -> None:
        sources: list[Connection | int] = [self._wake_receiver]
        if self._process is not None and self._connection is not None:
            sources += [self._connection, self._process.sentinel]
        found = wait(sources, timeout_s)
        if self._wake_receiver in found:
            self._wake_receiver.recv_bytes()
        if self._connection in found:
            self._receive()
        elif self._process is not None and self._process.sentinel in found:
            self._lost()

    def _send(self, current: _Current) -> None:
        assert self._connection is not None
        current.sent = True
        try:
            self._connection.send(Run(current.number, current.target, current.ends_early))
            self._connection.send(current.request)
        except OSError:
            return  # the child is gone; its sentinel tells the rest
        except Exception as fault:
            # The child waits for the request now: an empty one would run, so it is replaced.
            self._kill_child()
            self._end(JobFailed(WorkerError("E-JOB-02", details=repr(fault), reason=f"the request cannot be sent ({fault})")))
            self._start_child()

    def _receive(self) -> None:
        assert self._connection is not None
        try:
            message = self._connection.recv()
        except (EOFError, OSError):
            self._lost()
            return
        except Exception as fault:
            self._end(JobFailed(WorkerError("E-JOB-02", details=repr(fault), reason=f"its result cannot be read ({fault})")))
            return
        current = self._current
        if isinstance(message, Ready):
            self._ready = True
        elif isinstance(message, Begun) and current is not None and message.number == current.number:
            current.begun, current.request = True, None
            for watcher in tuple(begun_watchers):
                if self.pid is not None:
                    watcher(self.pid)
        elif isinstance(message, Told) and current is not None and message.number == current.number:
            if isinstance(message.event, JobProgress):
                current.phase = message.event.progress.phase
                if current.cancelled_at_s is None:
                    self._tell(current, message.event)
            else:
                self._end(message.event)

    def _lost(self) -> None:
        """The child died by itself."""
        assert self._process is not None
        self._process.join(1.0)
        code, was_ready, current = self._process.exitcode, self._ready, self._current
        self._kill_child()
        if current is not None and not current.begun and current.tries < _TRIES:
            # An idle child was killed just when the job came: the job has done nothing yet and can go to the next one.
            current.tries, current.sent = current.tries + 1, False
        elif current is not None:
            self._end(JobFailed(WorkerLostError("E-JOB-01", details=f"exit code {code}", phase=current.phase, reason=_reason(code))))
        if was_ready:  # one that dies while it starts would do so for ever; the next job tries again
            self._start_child()

    def _end(self, outcome: JobOutcome) -> None:
        """Announce the end of the current job, once; after a cancel every end is JobCancelled."""
        with self._lock:
            current, self._current = self._current, None
            if current is None:
                return
            if current.cancelled_at_s is not None:
                outcome = JobCancelled()
        current.handle._outcome = outcome
        self._tell(current, outcome)
        current.handle._ended.set()  # last: who waited for the end knows that `on_event` has heard of it

    def _tell(self, current: _Current, event: JobEvent) -> None:
        try:
            current.on_event(event)
        except Exception:
            kind, fault, trace = sys.exc_info()
            assert kind is not None
            threading.excepthook(threading.ExceptHookArgs((kind, fault, trace, threading.current_thread())))

    def _start_child(self) -> None:
        if self._process is not None or self._closing:
            return
        ours, theirs = self._context.Pipe()
        preload = modules() if self._job is None else (target_of(self._job).partition(":")[0],)
        arguments = (theirs, self._cancelled_number, self._enough_number, preload, self._gentle)
        process = self._context.Process(target=work, args=arguments, name=f"impronta-{self._name}", daemon=True)
        process.start()
        theirs.close()
        self._process, self._connection, self._ready = process, ours, False

    def _kill_child(self) -> None:
        process, connection = self._process, self._connection
        self._process = self._connection = None
        self._ready = False
        if connection is not None:
            connection.close()
        if process is not None:
            process.kill()
            process.join()
            process.close()

    def _stop_child(self) -> None:
        """An idle child goes when its pipe closes; one that is starting, or that does not go, is killed."""
        if self._process is not None and self._connection is not None and self._ready:
            self._connection.close()
            self._process.join(1.0)
        self._kill_child()


def _reason(code: int | None) -> str:
    if code is None:
        return "for an unknown reason"
    if code >= 0:
        return f"exit code {code}"
    return f"killed by signal {-code}" + (", often a lack of memory" if code == -9 else "")
