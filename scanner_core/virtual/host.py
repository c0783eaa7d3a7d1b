"""Lets the computer's faults happen at their times."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from contextlib import suppress

from scanner_core.case.store import CaseStore
from scanner_core.clock import Clock
from scanner_core.errors import CaseError
from scanner_core.jobs.worker import begun_watchers
from scanner_core.virtual.host_faults import HostFault, WorkerFault

_LOOK_S = 0.005
"""How often the rig's clock is looked at.  Waiting on a stepped clock would drive it."""


class Host:
    """The computer under a virtual rig.  Its threads begin with the first fault and end with :meth:`close`."""

    def __init__(self, clock: Clock) -> None:
        self.case: CaseStore | None = None
        """The case that is open."""
        self._clock = clock
        self._lock = threading.Lock()
        self._coming: list[HostFault] = []
        self._struck: list[HostFault] = []
        self._for_worker: list[WorkerFault] = []
        self._threads: list[threading.Thread] = []
        self._closing = threading.Event()

    def let_happen(self, fault: HostFault) -> None:
        """Let `fault` strike at its time on the rig's clock."""
        with self._lock:
            self._coming.append(fault)
            first = len(self._coming) + len(self._struck) == 1
        if first:
            self._start("host-faults", self._wait_for_times)

    def let_happen_to_worker(self, fault: WorkerFault) -> None:
        """Let `fault` strike the worker, its time after it has begun the next job."""
        with self._lock:
            self._for_worker.append(fault)
        if self._worker_begins not in begun_watchers:
            begun_watchers.append(self._worker_begins)

    def close(self) -> None:
        """Forget what has not happened yet and put right what can be."""
        self._closing.set()
        if self._worker_begins in begun_watchers:
            begun_watchers.remove(self._worker_begins)
        for thread in self._threads:
            thread.join()
        for fault in self._struck:
            with suppress(CaseError):
                fault.put_right(self.case)

    def _start(self, name: str, target: Callable[[], None]) -> None:
        thread = threading.Thread(target=target, name=name)
        self._threads.append(thread)
        thread.start()

    def _wait_for_times(self) -> None:
        while not self._closing.wait(_LOOK_S):
            now_s = self._clock.now_s()
            with self._lock:
                due = [fault for fault in self._coming if fault.at_s <= now_s]
                self._coming = [fault for fault in self._coming if fault.at_s > now_s]
                self._struck += due
            for fault in due:
                with suppress(CaseError):  # the case has been closed
                    fault.strike(self.case)

    def _worker_begins(self, pid: int) -> None:
        """In the thread that listens to the worker."""
        with self._lock:
            faults, self._for_worker = self._for_worker, []
        if faults:
            self._start("worker-faults", lambda: self._strike_worker(faults, pid))

    def _strike_worker(self, faults: list[WorkerFault], pid: int) -> None:
        begun_s = time.monotonic()
        for fault in sorted(faults, key=lambda fault: fault.at_s):
            if self._closing.wait(max(0.0, begun_s + fault.at_s - time.monotonic())):
                return
            with suppress(OSError):  # its job is done, it may be gone
                fault.strike(pid)
                self._closing.wait(fault.lasts_s)
                fault.put_right(pid)
