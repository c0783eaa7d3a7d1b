"""Faults of the computer that the program runs on: disk, other programs, clock, worker, the program itself."""

from __future__ import annotations

import os
import signal
import sqlite3
import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.process import BaseProcess
from multiprocessing.synchronize import Event
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar, Self

from scanner_core import wall_clock
from scanner_core.errors import UsageError
from scanner_core.virtual.fault import Fault, Place

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore

_TRIES_S = 1.0
"""How long the other program tries to get a case."""


@dataclass(frozen=True, slots=True, kw_only=True)
class HostFault(Fault, ABC):
    """Something that befalls the computer."""

    place: ClassVar[Place] = Place.HOST

    @abstractmethod
    def strike(self, case: CaseStore | None) -> None:
        """Let it happen; `case` is the one that is open, where there is one."""

    def put_right(self, case: CaseStore | None) -> None:
        """After the rig has been closed."""


@dataclass(frozen=True, slots=True)
class DiskFull(HostFault):
    """The disk under the open case is full: the file grows no more."""

    title: ClassVar[str] = "Disk full"
    happens: ClassVar[str] = "there is no space left on the disk of the case"
    expected: ClassVar[str] = "ends with E-DISK-01; laser off, everything acknowledged is kept"

    def strike(self, case: CaseStore | None) -> None:
        if case is not None:
            case.limit_growth(0)

    def put_right(self, case: CaseStore | None) -> None:
        if case is not None:
            case.limit_growth(None)


@dataclass(frozen=True, slots=True)
class CaseLocked(HostFault):
    """Another program tries to get the open case."""

    title: ClassVar[str] = "Case locked"
    happens: ClassVar[str] = "another program tries to open the case; at the opening it holds it"
    expected: ClassVar[str] = "goes on, the other program is refused; a case that the other holds is refused with E-CASE-02"

    def strike(self, case: CaseStore | None) -> None:
        if case is not None:
            other = get_context("spawn").Process(target=_take_case, args=(str(case.path),), name="other-program", daemon=True)
            other.start()
            other.join(10 * _TRIES_S)
            _end(other)

    @staticmethod
    @contextmanager
    def held(path: Path) -> Iterator[None]:
        """Another program has the case at `path` open meanwhile."""
        context = get_context("spawn")
        ready, leave = context.Event(), context.Event()
        other = context.Process(target=_hold_case, args=(str(path), ready, leave), name="other-program", daemon=True)
        other.start()
        try:
            ready.wait(10 * _TRIES_S)
            yield
        finally:
            leave.set()
            other.join(_TRIES_S)
            _end(other)


@dataclass(frozen=True, slots=True)
class ClockJump(HostFault):
    """The time of day jumps, as when the computer asks a time server."""

    title: ClassVar[str] = "Clock jump"
    happens: ClassVar[str] = "the computer's clock jumps back by an hour"
    expected: ClassVar[str] = "goes on; no duration, rate or deadline is touched"
    jump_s: float = -3600.0

    def strike(self, case: CaseStore | None) -> None:
        wall_clock.jump(self.jump_s)

    def put_right(self, case: CaseStore | None) -> None:
        wall_clock.jump(0.0)


@dataclass(frozen=True, slots=True)
class ProgramKilled(HostFault):
    """The program is killed without a chance to say anything."""

    title: ClassVar[str] = "Program killed"
    happens: ClassVar[str] = "the program is killed (SIGKILL)"
    expected: ClassVar[str] = "is gone; the guardian darkens a real laser within 0.6 s, everything acknowledged is kept"

    def strike(self, case: CaseStore | None) -> None:
        # Windows knows no SIGKILL: there os.kill ends the process at once whatever the signal
        os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))


@dataclass(frozen=True, slots=True, kw_only=True)
class WorkerFault(Fault, ABC):
    """Something that befalls the worker process, `at_s` real seconds after it began the next job, for `lasts_s`."""

    place: ClassVar[Place] = Place.WORKER
    lasts_s: float = 0.0

    def from_now(self, now_s: float) -> Self:
        """It waits for a job, whatever the rig's clock says."""
        return self

    @abstractmethod
    def strike(self, pid: int) -> None:
        """Let it happen to the process."""

    def put_right(self, pid: int) -> None:
        """Its end, where it has one and the process is still there."""


@dataclass(frozen=True, slots=True)
class WorkerKilled(WorkerFault):
    """The worker is killed in the middle of its job."""

    title: ClassVar[str] = "Worker killed"
    happens: ClassVar[str] = "the worker process is killed; the time counts from the start of the reconstruction"
    expected: ClassVar[str] = "E-JOB-01; the points are safe, a new worker is started"

    def strike(self, pid: int) -> None:
        os.kill(pid, getattr(signal, "SIGKILL", signal.SIGTERM))


@dataclass(frozen=True, slots=True, kw_only=True)
class WorkerOutOfMemory(WorkerFault):
    """For a while the worker gets no more memory than it has (Linux: RLIMIT_AS)."""

    lasts_s: float = 10.0
    title: ClassVar[str] = "Worker out of memory"
    happens: ClassVar[str] = "for 10 s the worker process gets no more memory; the time counts from the start of the reconstruction"
    expected: ClassVar[str] = "E-JOB-02 or E-JOB-01; the points are safe"

    def check(self) -> None:
        """Raises E-USE-01 where the system cannot do it."""
        if sys.platform != "linux":
            raise UsageError("E-USE-01", what="A worker can be kept from getting memory on Linux only", do="leave this fault away")

    def strike(self, pid: int) -> None:
        if sys.platform == "linux":
            import resource

            lines = Path(f"/proc/{pid}/status").read_text(encoding="ascii", errors="replace").splitlines()
            sizes = [int(line.split()[1]) for line in lines if line.startswith("VmSize:")]
            if not sizes:
                raise ProcessLookupError(f"the worker {pid} has ended")  # it is still listed, but has no memory any more
            resource.prlimit(pid, resource.RLIMIT_AS, (1024 * sizes[0], resource.prlimit(pid, resource.RLIMIT_AS)[1]))

    def put_right(self, pid: int) -> None:
        if sys.platform == "linux":
            import resource

            hard = resource.prlimit(pid, resource.RLIMIT_AS)[1]
            resource.prlimit(pid, resource.RLIMIT_AS, (hard, hard))


HOST_FAULTS: dict[str, Fault] = {
    fault.name: fault for fault in (DiskFull(), CaseLocked(), ClockJump(), WorkerKilled(), WorkerOutOfMemory(), ProgramKilled())
}
"""By the name that the command line knows."""


def _end(process: BaseProcess) -> None:
    process.kill()
    process.join()
    process.close()


def _hold_case(path: str, ready: Event, leave: Event) -> None:
    """What a program does that has the case open."""
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        connection.execute("BEGIN EXCLUSIVE")
        ready.set()
        leave.wait(60.0)


def _take_case(path: str) -> None:
    """What another program does: try for a while to write into the case."""
    with closing(sqlite3.connect(path, timeout=_TRIES_S, isolation_level=None)) as connection:
        try:
            connection.execute("BEGIN EXCLUSIVE")
            connection.execute("INSERT INTO audit (time, event, detail) VALUES ('', 'intruder', '')")
            connection.execute("COMMIT")
        except sqlite3.Error:
            return
