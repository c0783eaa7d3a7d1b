"""Hands every fault to whom it concerns."""

from __future__ import annotations

from typing import Protocol

from scanner_core.case.store import CaseStore
from scanner_core.clock import Clock
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.bench_faults import BenchFault
from scanner_core.virtual.controller_faults import ControllerFault
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.host import Host
from scanner_core.virtual.host_faults import HostFault, WorkerFault


class FaultyBoard(Protocol):
    """The firmware model, near or in another process."""

    def let_happen(self, fault: ControllerFault) -> None: ...


class FaultInjection:
    """The faults of one open virtual rig."""

    def __init__(self, clock: Clock, bench: VirtualBench, board: FaultyBoard) -> None:
        self._clock, self._bench = clock, bench
        self.board = board
        """The witness of beam and laser; for tests alone."""
        self._host = Host(clock)

    def inject(self, fault: Fault) -> None:
        """Let `fault` happen, its time from now, beside those that were given before.

        Raises
        ------
        UsageError
            E-USE-01: this system cannot do it.
        """
        fault.check()
        coming = fault.from_now(self._clock.now_s())
        match coming:
            case BenchFault():
                self._bench.let_happen(coming)
            case ControllerFault():
                self.board.let_happen(coming)
            case HostFault():
                self._host.let_happen(coming)
            case WorkerFault():
                self._host.let_happen_to_worker(coming)

    def concern(self, case: CaseStore) -> None:
        """The case whose disk may fill up and which another program may try for."""
        self._host.case = case

    def close(self) -> None:
        """What has not happened yet never will."""
        self._host.close()
