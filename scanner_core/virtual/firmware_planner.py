"""The firmware model's planner: fifteen blocks, trapezoids with look-ahead over the corners, hold and abort.

Junction speeds follow GRBL's junction deviation.  Other than GRBL, a block that has begun keeps the speed that it was
given for its end; only blocks that wait are planned anew when another one arrives.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

from scanner_core.virtual.firmware_trajectory import Piece, Position, Timeline

CAPACITY = 15
"""Blocks that the planner takes before it withholds ``ok``."""


@dataclass(slots=True)
class Block:
    """A straight move still to be done.  Speeds in deg/s along the path; `target` in physical degrees."""

    target: Position
    direction: Position
    length_deg: float
    speed_deg_s: float
    rated_speed_deg_s: float
    acceleration_deg_s2: float
    power: float
    scaled_power: bool
    corner_speed_deg_s: float = 0.0
    """Highest speed at which the corner before this block may be passed."""


class Planner:
    """Turns blocks into pieces of the timeline.  Passive: the firmware calls :meth:`finish` when ``end_s`` has come."""

    def __init__(self, timeline: Timeline) -> None:
        self._timeline = timeline
        self._blocks: deque[Block] = deque()
        self._started = False
        self._holding = False
        self._stops_inside = False
        self._end_speed_deg_s = 0.0
        self.end_s = math.inf

    @property
    def full(self) -> bool:
        return len(self._blocks) >= CAPACITY

    @property
    def empty(self) -> bool:
        return not self._blocks

    @property
    def moving(self) -> bool:
        return self._started

    @property
    def room(self) -> int:
        return CAPACITY - len(self._blocks)

    def add(self, block: Block, time_s: float, junction_deviation_deg: float) -> None:
        if self._blocks:
            block.corner_speed_deg_s = _corner_speed(self._blocks[-1], block, junction_deviation_deg)
        self._blocks.append(block)
        if not self._started and not self._holding:
            self._start(time_s, 0.0)

    def finish(self, time_s: float) -> None:
        """The running piece of work is done: go on with the next block, or rest."""
        block = self._blocks[0]
        speed, self._end_speed_deg_s = self._end_speed_deg_s, 0.0
        self._started, self.end_s = False, math.inf
        if self._stops_inside:
            self._stops_inside = False
            self._timeline.rest(time_s, self._timeline.at(time_s).position, 0.0)
            return
        self._blocks.popleft()
        if self._blocks and (speed > 0.0 or not self._holding):
            self._start(time_s, speed)
        else:
            power = 0.0 if self._holding or block.scaled_power else block.power
            self._timeline.rest(time_s, block.target, power)

    def hold(self, time_s: float) -> None:
        """Slow down to a stop; blocks are kept."""
        self._holding = True
        if self._started:
            speed = self._timeline.at(time_s).speed_deg_s
            self._timeline.truncate(time_s)
            self._cut(self._blocks[0], time_s)
            self._start(time_s, speed)
        else:
            self._timeline.rest(time_s, self._timeline.at(time_s).position, 0.0)

    def resume(self, time_s: float) -> None:
        self._holding = False
        if self._blocks and not self._started:
            self._start(time_s, 0.0)

    def drop_rest(self) -> None:
        """Forget all blocks after a stop (jog cancel)."""
        self._blocks.clear()
        self._holding = False

    def abort(self, time_s: float) -> None:
        """Stop dead and dark."""
        position = self._timeline.at(time_s).position
        self._timeline.truncate(time_s)
        self._timeline.rest(time_s, position, 0.0)
        self._blocks.clear()
        self._started = self._holding = self._stops_inside = False
        self._end_speed_deg_s, self.end_s = 0.0, math.inf

    def planned_position(self, time_s: float) -> Position:
        """Physical position when all blocks are done."""
        return self._blocks[-1].target if self._blocks else self._timeline.at(time_s).position

    def _cut(self, block: Block, time_s: float) -> None:
        position = self._timeline.at(time_s).position
        block.length_deg = math.sqrt(sum((a - b) ** 2 for a, b in zip(block.target, position, strict=True)))

    def _start(self, time_s: float, speed: float) -> None:
        block = self._blocks[0]
        self._started = True
        a, length = block.acceleration_deg_s2, block.length_deg
        if self._holding:
            self._brake(block, time_s, speed)
            return
        end_speed = min(self._entry_of_next(), block.speed_deg_s, math.sqrt(speed * speed + 2.0 * a * length))
        peak = min(block.speed_deg_s, math.sqrt(a * length + 0.5 * (speed * speed + end_speed * end_speed)))
        peak = max(peak, speed, end_speed)
        up = (peak * peak - speed * speed) / (2.0 * a)
        down = (peak * peak - end_speed * end_speed) / (2.0 * a)
        cruise = max(0.0, length - up - down)
        start = tuple([p - length * d for p, d in zip(block.target, block.direction, strict=True)])
        clock_s, along = time_s, 0.0
        for distance, v0, acceleration, duration in (
            (up, speed, a, (peak - speed) / a),
            (cruise, peak, 0.0, cruise / peak),
            (down, peak, -a, (peak - end_speed) / a),
        ):
            if duration > 0.0:
                self._append(block, clock_s, start, along, v0, acceleration)
                clock_s, along = clock_s + duration, along + distance
        self.end_s, self._end_speed_deg_s = clock_s, end_speed

    def _brake(self, block: Block, time_s: float, speed: float) -> None:
        a, length = block.acceleration_deg_s2, block.length_deg
        start = tuple([p - length * d for p, d in zip(block.target, block.direction, strict=True)])
        self._append(block, time_s, start, 0.0, speed, -a)
        distance = speed * speed / (2.0 * a)
        if distance < length - 1e-9:
            self._stops_inside, self._end_speed_deg_s = True, 0.0
            block.length_deg = length - distance
        else:
            self._end_speed_deg_s = math.sqrt(max(0.0, speed * speed - 2.0 * a * length))
        self.end_s = time_s + (speed - self._end_speed_deg_s) / a

    def _append(self, block: Block, time_s: float, start: Position, along: float, speed: float, acceleration: float) -> None:
        position = tuple([p + along * d for p, d in zip(start, block.direction, strict=True)])
        rated = block.rated_speed_deg_s if block.scaled_power else 0.0
        self._timeline.append(Piece(time_s, position, block.direction, speed, acceleration, block.power, rated))

    def _entry_of_next(self) -> float:
        """Speed at which the second block may be entered so that the last one can still end at rest."""
        entry = 0.0
        for index in range(len(self._blocks) - 1, 0, -1):
            block = self._blocks[index]
            entry = min(block.corner_speed_deg_s, math.sqrt(entry * entry + 2.0 * block.acceleration_deg_s2 * block.length_deg))
        return entry


def _corner_speed(before: Block, after: Block, deviation_deg: float) -> float:
    cosine = -sum(a * b for a, b in zip(before.direction, after.direction, strict=True))
    limit = min(before.speed_deg_s, after.speed_deg_s)
    if cosine > 0.999999:
        return 0.0
    if cosine < -0.999999:
        return limit
    sine_half = math.sqrt(0.5 * (1.0 - cosine))
    acceleration = min(before.acceleration_deg_s2, after.acceleration_deg_s2)
    return min(limit, math.sqrt(acceleration * deviation_deg * sine_half / (1.0 - sine_half)))
