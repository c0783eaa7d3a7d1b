"""Where the mechanics of the firmware model were: a short history of pieces with constant acceleration."""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass

Position = tuple[float, ...]

HISTORY_S = 20.0
"""How far back the timeline is exact."""


@dataclass(frozen=True, slots=True)
class Piece:
    """Motion along a straight line with constant acceleration, or rest, from `start_s` until the next piece starts.

    `power` is the share of full power; with a `rated_speed_deg_s` it is scaled by speed / rated speed (M4).
    """

    start_s: float
    position: Position
    direction: Position
    speed_deg_s: float = 0.0
    acceleration_deg_s2: float = 0.0
    power: float = 0.0
    rated_speed_deg_s: float = 0.0

    def at(self, time_s: float) -> Sample:
        elapsed_s = time_s - self.start_s
        speed = max(0.0, self.speed_deg_s + self.acceleration_deg_s2 * elapsed_s)
        distance = 0.5 * (self.speed_deg_s + speed) * elapsed_s
        power = self.power
        if self.rated_speed_deg_s > 0.0:
            power *= min(1.0, speed / self.rated_speed_deg_s)
        return Sample(tuple([p + distance * d for p, d in zip(self.position, self.direction, strict=True)]), speed, power)


@dataclass(frozen=True, slots=True)
class Sample:
    """Mechanics at an instant: physical position in degrees, speed along the path, emitted share of full power."""

    position: Position
    speed_deg_s: float
    power: float


class Timeline:
    """The pieces in order of time; the last one goes on for ever.

    ``laser_log`` holds (time_s, power) for every change of the nominal power: under M4 a move counts as lit from its
    start to its end, although its power rises and falls with the speed.
    """

    def __init__(self, start_s: float, position: Position) -> None:
        self._pieces: list[Piece] = []
        self._starts: list[float] = []
        self.laser_log: list[tuple[float, float]] = [(start_s, 0.0)]
        self.rest(start_s, position, 0.0)

    def rest(self, time_s: float, position: Position, power: float) -> None:
        self.append(Piece(time_s, position, (0.0,) * len(position), power=power))

    def append(self, piece: Piece) -> None:
        """Go on with `piece`; it must not start before the last one."""
        self._pieces.append(piece)
        self._starts.append(piece.start_s)
        if piece.power != self.laser_log[-1][1]:
            self.laser_log.append((piece.start_s, piece.power))
        if len(self._pieces) > 4096:
            self._forget(piece.start_s - HISTORY_S)

    def truncate(self, time_s: float) -> None:
        """Take back what was to happen after `time_s`."""
        keep = max(1, bisect_right(self._starts, time_s))
        del self._pieces[keep:], self._starts[keep:]
        while self.laser_log[-1][0] > time_s and len(self.laser_log) > 1:
            self.laser_log.pop()

    def at(self, time_s: float) -> Sample:
        """The mechanics at `time_s`; before the history begins, its first state."""
        index = max(0, bisect_right(self._starts, time_s) - 1)
        return self._pieces[index].at(max(time_s, self._starts[0]))

    def _forget(self, time_s: float) -> None:
        drop = max(0, bisect_right(self._starts, time_s) - 1)
        del self._pieces[:drop], self._starts[:drop]


def unit(vector: list[float]) -> tuple[float, Position]:
    """Length and direction."""
    length = math.sqrt(sum(v * v for v in vector))
    return length, tuple(v / length for v in vector) if length > 0.0 else tuple(vector)
