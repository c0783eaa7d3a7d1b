"""The faults that wait for their time inside the firmware model."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from scanner_core.virtual.controller_faults import Board, ControllerFault


class FaultSchedule:
    """What will strike one board, and when."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._due: list[tuple[float, Callable[[float, bool], None]]] = []
        self._waiting: list[ControllerFault] = []

    def add(self, fault: ControllerFault, now_s: float) -> None:
        """`fault` strikes at its time, not before now."""
        self._due.append((max(fault.at_s, now_s), partial(self._strike, fault)))

    def next_s(self) -> float:
        """When the next thing happens; inf = nothing will."""
        return min((at_s for at_s, _ in self._due), default=math.inf)

    def happen(self, time_s: float, moving: bool) -> None:
        """Let the next thing happen; `moving` when the board carries a move out."""
        number = min(range(len(self._due)), key=lambda i: self._due[i][0])
        self._due.pop(number)[1](time_s, moving)

    def aim(self, time_s: float, end_s: float) -> None:
        """A move runs until `end_s`: what waits for one strikes in its middle."""
        self._due += [(0.5 * (time_s + end_s), partial(self._strike, fault)) for fault in self._waiting]
        self._waiting.clear()

    def _strike(self, fault: ControllerFault, time_s: float, moving: bool) -> None:
        if fault.moving and not moving:
            self._waiting.append(fault)
            return
        fault.strike(self._board, time_s)
        if fault.lasts_s > 0.0:
            self._due.append((time_s + fault.lasts_s, lambda time_s, moving: fault.pass_by(self._board)))
