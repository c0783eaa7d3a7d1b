"""The firmware model's machine: alarm lock, hold, door, homing, modal state, and the offset of a lost position."""

from __future__ import annotations

from enum import Enum

from scanner_core.virtual.firmware_parser import Modal
from scanner_core.virtual.firmware_planner import Planner
from scanner_core.virtual.firmware_settings import FirmwareSettings
from scanner_core.virtual.firmware_trajectory import Position, Timeline


class Wait(Enum):
    """What a line waits for before it goes on."""

    IDLE = "all blocks are done"
    ROOM = "the planner takes another block"


class Abort(Enum):
    """What ends a line without an answer."""

    NONE = "none"
    DEAD = "nothing but a reset gets through"
    RESET = "the board resets itself"


class MachineState:
    """State beside the planner.  Physical positions are those of the mechanics; machine positions are what GRBL believes."""

    def __init__(self, settings: FirmwareSettings, planner: Planner, timeline: Timeline, now_s: float) -> None:
        self.settings, self.planner, self._timeline = settings, planner, timeline
        self.values = settings.numbered()
        self.modal = Modal()
        self.locked = settings.locked_at_start
        self.homing = False
        self.jogging = False
        self.abort = Abort.NONE
        self.door_ajar = False
        self._held = False
        self._door = False
        self._standing_power = 0.0
        self._origin: Position = (0.0,) * len(settings.axes)

    # ------------------------------------------------------------------------------------------ names and places
    @property
    def suspended(self) -> bool:
        """The main program takes no line meanwhile."""
        return self._held or self._door

    def state_name(self) -> str:
        moving = self.planner.moving
        if self.locked:
            return "Alarm"
        if self._door:
            return "Door:2" if moving else "Door:1" if self.door_ajar else "Door:0"
        if self._held and not self.jogging:  # a jog that is cancelled brakes as a jog
            return "Hold:1" if moving else "Hold:0"
        if self.homing:
            return "Home"
        if self.jogging and not self.planner.empty:
            return "Jog"
        return "Idle" if self.planner.empty else "Run"

    def machine_position(self, physical: Position) -> Position:
        return tuple([p - o for p, o in zip(physical, self._origin, strict=True)])

    def physical_position(self, machine: Position) -> Position:
        return tuple([p + o for p, o in zip(machine, self._origin, strict=True)])

    def adopt_reference(self) -> None:
        """Homing is done: the machine's zero is the mechanics' zero."""
        self._origin = (0.0,) * len(self._origin)

    # ------------------------------------------------------------------------------------------ laser
    @property
    def laser_mode(self) -> bool:
        return self.values[32] == 1.0

    def share(self, power: float) -> float:
        """An S value as a share of full power."""
        top = self.values[30]
        return min(power, top) / top if top > 0.0 else 0.0

    @property
    def programmed_power(self) -> float:
        """The S value of a spindle that is switched on, whatever it emits."""
        return self.modal.power if self.modal.spindle in (3, 4) else 0.0

    def stand(self, time_s: float) -> None:
        """The planner is empty and spindle words were given: set the power of the resting beam."""
        modal = self.modal
        lit = modal.spindle in (3, 4) and (not self.laser_mode or (modal.spindle == 3 and modal.motion == 1))
        self._standing_power = self.share(modal.power) if lit else 0.0
        self._timeline.rest(time_s, self._timeline.at(time_s).position, self._standing_power)

    # ------------------------------------------------------------------------------------------ events
    def finish_motion(self, time_s: float) -> None:
        self.planner.finish(time_s)
        if self.planner.moving:
            return
        if self._held and self.jogging:
            self.planner.drop_rest()
            self._held = self.jogging = False
        elif self.planner.empty:
            self.jogging = False

    def hold(self, time_s: float) -> None:
        if self.locked or self.homing or self.suspended:
            return
        self._standing_power = self._power(time_s) if not self.planner.moving else 0.0
        self._held = True
        self.planner.hold(time_s)
        if self.jogging and not self.planner.moving:
            self.finish_motion(time_s)

    def open_door(self, time_s: float) -> None:
        if self.locked or self._door:
            return
        if not self._held:
            self._standing_power = self._power(time_s) if not self.planner.moving else 0.0
            self.planner.hold(time_s)
        self._held, self._door = False, True

    def resume(self, time_s: float) -> None:
        """``~``: ignored while slowing down and while the door is ajar."""
        if not self.suspended or self.planner.moving or self.door_ajar:
            return
        self._held = self._door = False
        self.planner.resume(time_s)
        if not self.planner.moving and self._standing_power > 0.0:
            self._timeline.rest(time_s, self._timeline.at(time_s).position, self._standing_power)

    def cancel_jog(self, time_s: float) -> None:
        if self.jogging:
            self.hold(time_s)

    def alarm(self) -> None:
        self.locked = True
        self.homing = self.jogging = self._held = self._door = False

    def reset(self, time_s: float) -> int:
        """0x18: stop dead and dark; the number of the alarm it ends in, 0 when none."""
        alarm = 6 if self.homing else 3 if self.planner.moving else 0
        self.planner.abort(time_s)
        self.modal = Modal()
        self.abort = Abort.NONE
        self._standing_power = 0.0
        if alarm:
            self.alarm()
        self.homing = self.jogging = self._held = self._door = False
        if self.door_ajar:
            self._door = not self.locked
        return alarm

    def restart(self, time_s: float, *, lose_position: bool) -> None:
        """Power-up."""
        self.reset(time_s)
        self.locked = self.settings.locked_at_start
        if lose_position:
            self._origin = self._timeline.at(time_s).position

    def _power(self, time_s: float) -> float:
        return self._timeline.at(time_s).power
