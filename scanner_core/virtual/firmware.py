"""A model of GRBL 1.1h in laser mode: bytes in, bytes out, and mirrors and a table that move.

The model is passive.  It holds no thread; whatever is asked of it first brings it up to the present of the injected
clock, event by event, so that answers, positions and the laser are a function of time and of the bytes that came.
:meth:`Firmware.next_event_s` tells a port how long it may sleep.  Bytes take their time on the wire both ways.

What it does follows GRBL's published behaviour (interface v1.1 and the source's order of events): one ``ok`` or
``error:N`` a line, real-time bytes answered out of turn, fifteen blocks in the planner after which ``ok`` is withheld,
power that follows speed under M4, no power at rest or in G0 in laser mode, a reset in motion that ends in ALARM:3.
It has no watchdog, as GRBL has none: an M3 beam stays on when the host dies.
"""

from __future__ import annotations

import math
import threading
from collections import deque
from collections.abc import Generator

from scanner_core.clock import Clock
from scanner_core.virtual.controller_faults import ControllerFault
from scanner_core.virtual.fault_schedule import FaultSchedule
from scanner_core.virtual.firmware_interpreter import Interpreter
from scanner_core.virtual.firmware_parser import GrblRefusal, Modal
from scanner_core.virtual.firmware_planner import Planner
from scanner_core.virtual.firmware_report import status_line
from scanner_core.virtual.firmware_settings import FirmwareSettings
from scanner_core.virtual.firmware_state import Abort, MachineState, Wait
from scanner_core.virtual.firmware_trajectory import Position, Timeline
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.wire import Wire

_RECEIVE_BUFFER = 128
_LINE_LIMIT = 79
_RESET, _STATUS, _HOLD, _RESUME, _DOOR, _JOG_CANCEL = 0x18, 0x3F, 0x21, 0x7E, 0x84, 0x85
_LOCKED = "[MSG:'$H'|'$X' to unlock]"


class Firmware:
    """The board.  Safe to use from several threads; every method returns at once."""

    def __init__(self, clock: Clock, settings: FirmwareSettings | None = None) -> None:
        self.clock = clock
        self.settings = settings or FirmwareSettings()
        self._lock = threading.RLock()
        now_s = clock.now_s()
        self._timeline = Timeline(now_s, (0.0,) * len(self.settings.axes))
        self._table_index = self.settings.axes.index(self.settings.table_axis)
        self._machine = MachineState(self.settings, Planner(self._timeline), self._timeline, now_s)
        self._interpreter = Interpreter(self._machine, self._say)
        self._byte_s = 10.0 / self.settings.baud
        self._arriving: deque[tuple[float, bytes]] = deque()
        self._received = bytearray()
        self.wire = Wire(self._byte_s, now_s)
        self._wire_free_s = now_s
        self._event_s = now_s
        self._advancing = False
        self._faults = FaultSchedule(self)
        self._boot_end_s = math.inf
        self._program: Generator[Wait | float] | None = None
        self._waits_for: Wait | float = Wait.IDLE
        self._dead = False  # critical alarm: nothing but a reset gets through
        self._reports = 0
        self._silent = False  # booting, or frozen
        self._plugged = True
        self._boot()

    # ------------------------------------------------------------------------------------------ the port's side
    def connect(self) -> None:
        """A host opened the port: DTR resets the board."""
        with self._lock:
            self._advance()
            self.wire.clear()
            if self.settings.resets_on_connect:
                self._power_cycle(lose_position=not self.settings.position_survives_reset)

    def write(self, chunk: bytes) -> None:
        """Bytes from the host; they arrive one after the other at the baud rate."""
        if not chunk:
            return
        with self._lock:
            self._advance()
            self._wire_free_s = max(self._wire_free_s, self.clock.now_s())
            for piece in chunk.splitlines(keepends=True):
                self._wire_free_s += len(piece) * self._byte_s
                self._arriving.append((self._wire_free_s, piece))

    def read(self, size: int | None = None) -> bytes:
        """Up to `size` bytes that have reached the host by now (None = all)."""
        with self._lock:
            self._advance()
            return self.wire.receive(self.clock.now_s(), size)

    @property
    def in_waiting(self) -> int:
        """Bytes that :meth:`read` would give now."""
        with self._lock:
            self._advance()
            return self.wire.waiting(self.clock.now_s())

    def next_event_s(self) -> float:
        """When something will be emitted or change by itself; inf = never."""
        with self._lock:
            self._advance()
            return min(self._next_internal_s(), self.wire.next_s())

    # ------------------------------------------------------------------------------------------ the scene's side
    def instant(self, time_s: float) -> MotionInstant:
        """Mechanics and laser at `time_s`, not later than now and not older than the history of the timeline."""
        with self._lock:
            self._advance()
            sample = self._timeline.at(time_s)
        return MotionInstant(sample.position[0], sample.position[1], sample.position[self._table_index], sample.power)

    @property
    def laser_log(self) -> list[tuple[float, float]]:
        """(time_s, share of full power) of every change of the nominal power until now."""
        with self._lock:
            self._advance()
            now_s = self.clock.now_s()
            return [entry for entry in self._timeline.laser_log if entry[0] <= now_s]

    # ------------------------------------------------------------------------------------------ what happens to a board
    def let_happen(self, fault: ControllerFault) -> None:
        """Let `fault` strike at its time on the rig's clock."""
        with self._lock:
            self._advance()
            self._faults.add(fault, self._event_s)

    def power_cycle(self) -> None:
        """It restarts by itself (a brown-out): the position is forgotten, the mechanics stay where they are."""
        with self._lock:
            self._advance()
            self._power_cycle(lose_position=True)

    @property
    def plugged(self) -> bool:
        """Whether the cable is on."""
        with self._lock:
            self._advance()
            return self._plugged

    def unplug(self) -> None:
        """The cable comes off; the board goes on."""
        self._plugged = False

    def plug(self) -> None:
        self._plugged = True

    def freeze(self) -> None:
        """The board's processor hangs: nothing is answered any more, motion and laser stay as they are until a power cycle."""
        with self._lock:
            self._advance()
            self._silent, self._boot_end_s = True, math.inf

    def press_reset(self) -> None:
        """The reset button: as a reset by the host, ALARM:3 in motion."""
        with self._lock:
            self._advance()
            if not self._silent:
                self._reset(self._event_s)

    def trip_limit(self) -> None:
        """An axis runs into its limit switch: ALARM:1, and nothing but a reset gets through."""
        with self._lock:
            self._advance()
            self._critical_alarm(1)

    def leave_travel(self) -> None:
        """A target seems to lie beyond the travel of its axis (soft limits): ALARM:2, and nothing but a reset gets through."""
        with self._lock:
            self._advance()
            self._critical_alarm(2)

    def open_door(self) -> None:
        """The safety door opens: motion stops, then the laser goes dark; held open until :meth:`close_door`."""
        with self._lock:
            self._advance()
            self._machine.door_ajar = True
            self._machine.open_door(self._event_s)

    def close_door(self) -> None:
        """Ready for ``~``."""
        with self._lock:
            self._advance()
            self._machine.door_ajar = False

    # ------------------------------------------------------------------------------------------ events in order of time
    def _advance(self) -> None:
        if self._advancing:  # a fault that strikes now
            return
        self._advancing = True
        try:
            now_s = self.clock.now_s()
            while (due_s := self._next_internal_s()) <= now_s:
                self._event_s = time_s = max(due_s, self._event_s)
                if due_s == self._boot_end_s:
                    self._wake(time_s)
                elif self._arriving and due_s == self._arriving[0][0]:
                    self._receive(time_s, self._arriving.popleft()[1])
                elif due_s == self._machine.planner.end_s:
                    self._machine.finish_motion(time_s)
                elif due_s == self._faults.next_s():
                    self._faults.happen(time_s, self._machine.planner.moving)
                self._run_program(time_s)
                if self._machine.planner.moving:
                    self._faults.aim(time_s, self._machine.planner.end_s)
            self._event_s = now_s
        finally:
            self._advancing = False

    def _next_internal_s(self) -> float:
        arriving = self._arriving[0][0] if self._arriving else math.inf
        waiting = math.inf
        if isinstance(self._waits_for, float) and self._program is not None and not self._halted:
            waiting = self._waits_for
        return min(arriving, self._machine.planner.end_s, self._boot_end_s, waiting, self._faults.next_s())

    @property
    def _halted(self) -> bool:
        """The main program does not run."""
        return self._dead or self._silent or self._machine.suspended

    def _boot(self) -> None:
        self._silent = True
        self._boot_end_s = self._event_s + self.settings.boot_s

    def _wake(self, time_s: float) -> None:
        self._boot_end_s = math.inf
        self._silent = False
        self._greet(time_s)

    def _power_cycle(self, *, lose_position: bool) -> None:
        now_s = self._event_s
        self._machine.planner.abort(now_s)
        self._machine.restart(now_s, lose_position=lose_position)
        self._forget_input()
        self._arriving.clear()
        self._wire_free_s = now_s
        self._boot()

    def _greet(self, time_s: float) -> None:
        self._say(time_s, "", self.settings.banner)
        self._reports = 0
        if self._machine.locked:
            self._say(time_s, _LOCKED)

    def _forget_input(self) -> None:
        self._received.clear()
        if self._program is not None:
            self._program.close()
            self._program = None
        self._dead = False

    def _receive(self, time_s: float, chunk: bytes) -> None:
        if self._silent:
            return
        for byte in chunk:
            if byte in (_RESET, _STATUS, _HOLD, _RESUME) or byte >= 0x80:
                self._real_time(time_s, byte)
            elif len(self._received) < _RECEIVE_BUFFER:
                self._received.append(byte)

    def _real_time(self, time_s: float, byte: int) -> None:
        if byte == _RESET:
            self._reset(time_s)
        elif self._dead:
            return
        elif byte == _STATUS:
            if not self._machine.homing:
                self._report(time_s)
        elif byte == _HOLD:
            self._machine.hold(time_s)
        elif byte == _RESUME:
            self._machine.resume(time_s)
        elif byte == _DOOR:
            self._machine.open_door(time_s)
        elif byte == _JOG_CANCEL:
            self._machine.cancel_jog(time_s)

    def _reset(self, time_s: float) -> None:
        alarm = self._machine.reset(time_s)
        self._forget_input()
        if alarm:
            self._say(time_s, f"ALARM:{alarm}")
        self._greet(time_s)

    def _critical_alarm(self, number: int) -> None:
        if self._silent:
            return
        time_s = self._event_s
        self._machine.planner.abort(time_s)
        self._machine.alarm()
        self._forget_input()
        self._dead = True
        self._say(time_s, f"ALARM:{number}", "[MSG:Reset to continue]")

    # ------------------------------------------------------------------------------------------ the main program
    def _run_program(self, time_s: float) -> None:
        while not self._halted:
            if self._program is None:
                line = self._take_line()
                if line is None:
                    return
                self._program = self._answer(line)
            elif not self._ready(time_s):
                return
            self._interpreter.now_s = time_s
            try:
                self._waits_for = next(self._program)
            except StopIteration:
                self._program = None
            abort = self._machine.abort
            if abort is not Abort.NONE:
                self._machine.reset(time_s)
                self._forget_input()
                self._dead = abort is Abort.DEAD
                if abort is Abort.RESET:
                    self._greet(time_s)

    def _ready(self, time_s: float) -> bool:
        if isinstance(self._waits_for, float):
            return time_s >= self._waits_for
        planner = self._machine.planner
        return planner.empty if self._waits_for is Wait.IDLE else not planner.full

    def _take_line(self) -> str | None:
        ends = [at for at in (self._received.find(b"\n"), self._received.find(b"\r")) if at >= 0]
        if not ends:
            return None
        end = min(ends)
        line = self._received[:end].decode("ascii", errors="replace")
        del self._received[: end + 1]
        return line

    def _answer(self, line: str) -> Generator[Wait | float]:
        """Carry a line out; each yield says what it waits for.  Its last act is the one answer."""
        try:
            if len(line) > _LINE_LIMIT:
                raise GrblRefusal(14 if line.lstrip().startswith("$") else 11)
            yield from self._interpreter.execute(line)
        except GrblRefusal as refusal:
            self._say(self._interpreter.now_s, f"error:{refusal.number}")
        else:
            if self._machine.abort is Abort.NONE:
                self._say(self._interpreter.now_s, "ok")

    # ------------------------------------------------------------------------------------------ answers
    def _say(self, time_s: float, *lines: str) -> None:
        chunk = "".join(f"{line}\r\n" for line in lines).encode("ascii")
        self.wire.send(time_s, chunk)

    def _report(self, time_s: float) -> None:
        sample = self._timeline.at(time_s)
        machine = self._machine
        text = status_line(
            machine.state_name(),
            machine.machine_position(sample.position),
            machine.settings.offset,
            feed_deg_min=sample.speed_deg_s * 60.0,
            power=machine.programmed_power if self.settings.programmed_power else sample.power * machine.values[30],
            mask=int(machine.values[10]),
            room=machine.planner.room,
            free_bytes=_RECEIVE_BUFFER - len(self._received),
            count=self._reports,
            pins="D" if machine.door_ajar else "",
        )
        self._reports += 1
        self._say(time_s, text)

    @property
    def modal(self) -> Modal:
        """The modal state of the parser, for tests and the doctor."""
        with self._lock:
            self._advance()
            return self._machine.modal

    @property
    def machine_position(self) -> Position:
        """What the status report would say now."""
        with self._lock:
            self._advance()
            return self._machine.machine_position(self._timeline.at(self.clock.now_s()).position)
