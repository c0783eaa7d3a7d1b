"""The firmware model's lines: ``$`` commands, jogging, homing and G-code, carried out against the planner."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from dataclasses import replace

from scanner_core.virtual.firmware_parser import GrblRefusal, Instruction, Modal, clean, interpret
from scanner_core.virtual.firmware_planner import Block
from scanner_core.virtual.firmware_report import HELP, modal_line, settings_lines
from scanner_core.virtual.firmware_state import Abort, MachineState, Wait
from scanner_core.virtual.firmware_trajectory import Position, unit

Steps = Generator["Wait | float"]

_SWITCH_SEARCH_S = 1.0
_DEBOUNCE_S = 0.25
_LEAST_LENGTH_DEG = 1e-7


class Interpreter:
    """Carries lines out.  ``now_s`` is the time of the event in which it is called."""

    def __init__(self, machine: MachineState, say: Callable[..., None]) -> None:
        self._machine = machine
        self._say = say
        self.now_s = 0.0

    def execute(self, text: str) -> Steps:
        """A generator that yields what it waits for and ends when ``ok`` is due.

        Raises
        ------
        GrblRefusal
        """
        line = clean(text)
        if line.startswith("$J="):
            yield from self._jog(line[3:])
        elif line.startswith("$"):
            yield from self._system(line)
        elif line:
            if self._machine.locked or self._machine.jogging:
                raise GrblRefusal(9)
            yield from self._gcode(line)

    # ------------------------------------------------------------------------------------------ $ commands
    def _system(self, line: str) -> Steps:
        machine, now_s = self._machine, self.now_s
        if line == "$":
            self._say(now_s, HELP)
        elif line == "$G":
            self._say(now_s, modal_line(machine.modal))
        elif line == "$X":
            if machine.locked:
                if machine.door_ajar:
                    raise GrblRefusal(13)
                machine.locked = False
                self._say(now_s, "[MSG:Caution: Unlocked]")
        elif not (machine.planner.empty or machine.locked):
            raise GrblRefusal(8)
        elif line == "$$":
            self._say(now_s, *settings_lines(machine.values))
        elif line == "$I":
            axes = machine.settings.axes
            extra = [f"[AXS:{len(axes)}:{axes}]"] if len(axes) > 3 else []
            self._say(now_s, f"[VER:{machine.settings.version}:]", "[OPT:V,15,128]", *extra)
        elif line == "$#":
            zeros = ",".join("0.000" for _ in machine.settings.axes)
            offset = ",".join(f"{value:.3f}" for value in machine.settings.offset)
            self._say(now_s, f"[G54:{offset}]", f"[G92:{zeros}]", "[TLO:0.000]")
        elif line == "$N":
            self._say(now_s, "$N0=", "$N1=")
        elif line == "$H":
            yield from self._home()
        else:
            self._set(line)

    def _set(self, line: str) -> None:
        number, equals, value = line[1:].partition("=")
        if not equals or not number.isdigit() or int(number) not in self._machine.values:
            raise GrblRefusal(3)
        try:
            setting = float(value)
        except ValueError:
            raise GrblRefusal(2) from None
        if not math.isfinite(setting):
            raise GrblRefusal(2)
        if setting < 0.0:
            raise GrblRefusal(4)
        if int(number) == 20 and setting == 1.0 and self._machine.values[22] == 0.0:
            raise GrblRefusal(10)
        self._machine.values[int(number)] = setting

    def _home(self) -> Steps:
        machine = self._machine
        if machine.values[22] == 0.0:
            raise GrblRefusal(5)
        if machine.door_ajar:
            raise GrblRefusal(13)
        machine.locked, machine.homing = False, True
        if not machine.settings.homing_switches:
            yield self.now_s + _SWITCH_SEARCH_S
            machine.alarm()
            machine.abort = Abort.RESET
            self._say(self.now_s, "ALARM:8")
            return
        seek = machine.values[25] / 60.0
        target = (0.0,) * len(machine.settings.axes)
        self._plan(target, seek, seek, 0.0, scaled=False)
        yield Wait.IDLE
        yield self.now_s + _DEBOUNCE_S
        machine.adopt_reference()
        machine.homing = False

    def _jog(self, line: str) -> Steps:
        machine = self._machine
        if machine.locked:
            raise GrblRefusal(9)
        if not (machine.planner.empty or machine.jogging):
            raise GrblRefusal(8)
        instruction = interpret(line, machine.modal, machine.settings.axes, jog=True)
        target = self._target(instruction)
        if machine.values[20] == 1.0 and self._beyond_travel(target):
            raise GrblRefusal(15)
        yield from self._room()
        machine.jogging = True
        speed = (instruction.modal.feed or 0.0) / 60.0
        self._plan(machine.physical_position(target), speed, speed, 0.0, scaled=False)
        if machine.planner.empty:
            machine.jogging = False

    # ------------------------------------------------------------------------------------------ G-code
    def _gcode(self, line: str) -> Steps:
        machine = self._machine
        before = machine.modal
        instruction = interpret(line, before, machine.settings.axes)
        if self._needs_synchronization(instruction, before):
            yield from self._idle()
            machine.modal = replace(instruction.modal, motion=before.motion if instruction.axes else instruction.modal.motion)
            machine.stand(self.now_s)
        machine.modal = instruction.modal
        if instruction.dwell_s is not None:
            yield from self._idle()
            if instruction.dwell_s > 0.0:
                yield self.now_s + instruction.dwell_s
        elif instruction.axes:
            yield from self._move(instruction)
        elif instruction.ends_program:
            yield from self._idle()
            machine.stand(self.now_s)

    def _needs_synchronization(self, instruction: Instruction, before: Modal) -> bool:
        after = instruction.modal
        if after.spindle != before.spindle:
            return True
        if after.spindle == 5:
            return False
        if self._machine.laser_mode and instruction.axes is not None:
            return False  # the block carries the power, none in G0
        return after.power != before.power or (after.spindle == 3 and after.motion != before.motion)

    def _move(self, instruction: Instruction) -> Steps:
        machine = self._machine
        target = self._target(instruction)
        if machine.values[20] == 1.0 and self._beyond_travel(target):
            yield from self._idle()
            machine.alarm()
            machine.abort = Abort.DEAD
            self._say(self.now_s, "ALARM:2", "[MSG:Reset to continue]")
            return
        yield from self._room()
        modal = machine.modal
        lit = modal.spindle in (3, 4) and (modal.motion == 1 or not machine.laser_mode)
        power = machine.share(modal.power) if lit else 0.0
        scaled = machine.laser_mode and modal.spindle == 4
        feed = math.inf if modal.motion == 0 else (modal.feed or 0.0) / 60.0
        self._plan(machine.physical_position(target), feed, feed, power, scaled=scaled)

    def _target(self, instruction: Instruction) -> Position:
        machine, modal = self._machine, instruction.modal
        here = machine.machine_position(machine.planner.planned_position(self.now_s))
        words = instruction.axes or {}
        base = machine.settings.offset if modal.absolute else here
        return tuple([base[i] + words[letter] if letter in words else here[i] for i, letter in enumerate(machine.settings.axes)])

    def _beyond_travel(self, target: Position) -> bool:
        """GRBL's machine zero is the upper end of every axis' travel."""
        return any(not -self._machine.values[130 + i] <= value <= 0.0 for i, value in enumerate(target))

    def _plan(self, target: Position, speed: float, rated: float, power: float, *, scaled: bool) -> None:
        """Queue a block; per axis limits shorten speed and acceleration along the path."""
        machine = self._machine
        here = machine.planner.planned_position(self.now_s)
        length, direction = unit([t - h for t, h in zip(target, here, strict=True)])
        if length < _LEAST_LENGTH_DEG:
            if machine.planner.empty:
                machine.stand(self.now_s)
            return
        parts = [(i, abs(d)) for i, d in enumerate(direction) if d != 0.0]
        limit = min(machine.values[110 + i] / 60.0 / d for i, d in parts)
        acceleration = min(machine.values[120 + i] / d for i, d in parts)
        block = Block(target, direction, length, max(1e-3, min(speed, limit)), rated if math.isfinite(rated) else limit, acceleration, power, scaled)
        machine.planner.add(block, self.now_s, machine.values[11])

    def _idle(self) -> Steps:
        if not self._machine.planner.empty:
            yield Wait.IDLE

    def _room(self) -> Steps:
        if self._machine.planner.full:
            yield Wait.ROOM
