"""A GRBL board as the instrument's motion controller."""

from __future__ import annotations

import math
import time

from scanner_core.clock import Clock
from scanner_core.devices.check import Check
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl.doctor import controller_checks
from scanner_core.devices.grbl.handshake import shake_hands
from scanner_core.devices.grbl.lines import Report
from scanner_core.devices.grbl.link import ANSWER_S, GrblLink, Halt
from scanner_core.devices.laser_safety import LIT_ANSWER_S, STANDING_LASER_S, Darkened, LaserWatch, Light, breach
from scanner_core.devices.motion import MotionState, MotionStatus
from scanner_core.devices.serial_port import BytePort, DirectPort
from scanner_core.errors import ControllerAlarmError, DeviceError, UsageError

_HOME_DEADLINE_S = 120.0
_SPARE_S = 5.0
_LOOKS = 5
_SAME_PLACE_DEG = 0.0015
"""A unit of the last digit of a report; where a motor's step is coarser, a rested position is asked for twice."""
_MODES = "G21G90G94M5"


def open_controller(config: ControllerConfig, clock: Clock, *, standing_laser_s: float = STANDING_LASER_S) -> GrblController:
    """Open the port, through a guardian unless it is virtual, and shake hands.

    Raises
    ------
    DeviceError
        E-MOT-03 busy, E-MOT-08 missing, E-MOT-12 not permitted, E-MOT-07 no GRBL, E-MOT-13 no laser mode, E-MOT-14 axis.
    """
    port: BytePort
    can_burn = not config.port.lower().startswith("virtual://")
    if can_burn:
        from scanner_core.devices.guardian import GuardedPort

        port = GuardedPort(config.port, config.baud)
    else:
        port = DirectPort(config.port, config.baud)
    return GrblController(port, config, clock, standing_laser_s=standing_laser_s, watched=can_burn)


APPROACH_DEG = 1.0
"""More than any sound drive's play."""


class GrblController:
    """Implements :class:`scanner_core.devices.motion.MotionController` on a port that is open.

    One thread owns it; :meth:`stop` may come from any.  Sweeps use M4 (dark at rest); M3 only lights the standing spot
    of :meth:`laser`.  When it may be lit, and what makes it dark, stands in :mod:`scanner_core.devices.laser_safety`.
    """

    def __init__(
        self,
        port: BytePort,
        config: ControllerConfig,
        clock: Clock,
        *,
        standing_laser_s: float = STANDING_LASER_S,
        watched: bool = False,
    ) -> None:
        """`watched`: a lit laser that the owner does not talk about for two seconds is switched off."""
        self._link = GrblLink(port, config.port, clock)
        self._clock = clock
        self._watch = LaserWatch(self._darken, lambda: self._link.talked_s, clock, standing_laser_s, strict=watched)
        self._table_axis = config.table_axis.upper()
        self._position_known = True
        self._homed = False
        self._modes_set = False
        self._work_offset: tuple[float, ...] = ()
        self._last: MotionStatus | None = None
        self._newest: MotionStatus | None = None
        try:
            self.identity, state = shake_hands(self._link, self._table_axis)
            self._table_index = self.identity.axes.index(self._table_axis)
            self._link.judge = self._judge
            if state is not MotionState.ALARM:
                self._set_modes()
            self.status()
        except BaseException as fault:
            self.close()
            if isinstance(fault, DeviceError):
                fault.details = "\n".join([fault.details, *map(str, self.transcript())]).strip()
            raise

    # ------------------------------------------------------------------------------------------ motion
    def aim(self, x_deg: float, y_deg: float) -> None:
        """Move the beam's direction, laser dark; returns when it is there."""
        target = _words(X=x_deg, Y=y_deg)
        self._ready()
        self._link.command(f"M5G0{target}")
        self._watch.allow(Light.DARK)
        self._link.command("G4P0", self._travel_s({0: x_deg, 1: y_deg}))
        self._arrived(x_deg=x_deg, y_deg=y_deg)

    def sweep(self, x_deg: float, y_deg: float, speed_deg_s: float) -> None:
        """Begin a straight move with the laser lit; returns when the board has accepted it.

        Raises
        ------
        UsageError
            The speed is beyond the board's maximum rate: it would move slower than planned.
        """
        target = _words(X=x_deg, Y=y_deg)
        if not speed_deg_s > 0.0:
            raise UsageError("E-USE-01", what=f"A sweep of {speed_deg_s} deg/s goes nowhere", do="give a speed above 0")
        self._ready()
        self._check_rate(x_deg, y_deg, speed_deg_s)
        self._watch.allow(Light.SWEEP, self._clock.now_s() + self._sweep_s(x_deg, y_deg, speed_deg_s))
        self._link.command(f"M4S{self.full_power:.0f}G1{target}F{speed_deg_s * 60.0:.2f}")
        self._arrived(x_deg=x_deg, y_deg=y_deg)

    def wait_idle(self, deadline_s: float) -> None:
        """Wait for the end of the motion."""
        self._ready()
        self._link.command("G4P0", deadline_s)
        if self._watch.light is Light.SWEEP:
            self._watch.allow(Light.DARK)

    def rotate_to(self, table_deg: float) -> None:
        """Turn the table, laser dark; returns when it is there.

        It always arrives turning forwards, so that play in the drive does not show: backwards it goes :data:`APPROACH_DEG`
        too far first.
        """
        target = _words(**{self._table_axis: table_deg})
        self._ready()
        if table_deg < self._here(self._table_index):
            self._turn(_words(**{self._table_axis: table_deg - APPROACH_DEG}), table_deg - APPROACH_DEG)
        self._turn(target, table_deg)

    def _turn(self, target: str, table_deg: float) -> None:
        self._link.command(f"M5G0{target}")
        self._watch.allow(Light.DARK)
        self._link.command("G4P0", self._travel_s({self._table_index: table_deg}))
        self._arrived(table_deg=table_deg)

    @property
    def needs_homing(self) -> bool:
        """``$22`` says that there are switches.  Many boards forget their position when the port is opened, and do not tell."""
        return bool(int(self.identity.settings.get(22, 0.0)) & 1) and not self._homed

    def home(self) -> None:
        """Find the reference position; also unlocks.  After a :meth:`stop` it moves nothing before :meth:`recover`."""
        if self._link.halt not in (None, Halt.STOPPED):
            self.recover()
        if self._watch.light is not Light.DARK:
            self.laser(False)
        self._link.command("$H", _HOME_DEADLINE_S, mute=True)
        self._set_modes()
        self._position_known = self._homed = True
        self._link.restarted = False
        self.status()

    # ------------------------------------------------------------------------------------------ laser
    @property
    def full_power(self) -> float:
        """S value of full power (``$30``)."""
        return self.identity.settings.get(30, 1000.0)

    def laser(self, on: bool) -> None:
        """A standing spot for aiming, or dark.

        Raises
        ------
        DeviceError
            E-MOT-17 when the board's own status does not show it lit.
        """
        self._ready()
        if not on:
            self._link.command("M5", self._travel_s({}))
            self._watch.allow(Light.DARK)
            return
        self._watch.allow(Light.STANDING)
        self._link.command(f"G1F60M3S{self.full_power:.0f}", self._travel_s({}))
        if not self.status().laser_power > 0.0:
            raise self._link.fault(DeviceError("E-MOT-17"))

    # ------------------------------------------------------------------------------------------ state
    def status(self) -> MotionStatus:
        """Ask the board; also possible after a stop.

        Raises
        ------
        DeviceError
            E-MOT-05, E-MOT-16, E-MOT-18: the report breaks a rule of :mod:`scanner_core.devices.laser_safety`; a reset was sent.
            E-MOT-01, E-MOT-02, E-MOT-09: there is no report to be had.  E-MOT-20: noise on the line.
        """
        expected = before = self._last
        said, looks = self._asked(), 0
        # A digit that noise has changed makes a report like any other: where the board rests elsewhere than expected, two must agree.
        while said.state is MotionState.IDLE and not (_same_place(said, expected) or _same_place(said, before)):
            if looks == _LOOKS:
                raise self._link.fault(DeviceError("E-MOT-20", port=self._link.port_name))
            expected, said, looks = said, self._asked(), looks + 1
        return said

    def _asked(self) -> MotionStatus:
        report = self._link.report(ANSWER_S if self._watch.light is Light.DARK else LIT_ANSWER_S)
        return self._newest or self._understood(report)

    @property
    def newest(self) -> MotionStatus | None:
        """The last report that came."""
        return self._newest

    def _judge(self, report: Report) -> DeviceError | None:
        """Every report passes here, whoever asked for it."""
        self._newest = self._last = self._understood(report)
        return breach(self._watch.light, report.state, self._newest.laser_power)

    def _understood(self, report: Report) -> MotionStatus:
        position = report.position
        self._work_offset = report.work_offset or self._work_offset
        if position is not None and report.is_work_position and len(self._work_offset) == len(position):
            position = tuple(p + o for p, o in zip(position, self._work_offset, strict=True))
        if position is None or len(position) <= self._table_index:
            last = self._last
            x_deg, y_deg, table_deg = (last.x_deg, last.y_deg, last.table_deg) if last else (math.nan,) * 3
        else:
            x_deg, y_deg, table_deg = position[0], position[1], position[self._table_index]
        return MotionStatus(report.state, x_deg, y_deg, table_deg, report.laser_power or 0.0, self._clock.now_s(), time.monotonic())

    def stop(self) -> None:
        """Laser off and motion stopped, now, from any thread; then :meth:`recover` comes first."""
        self._link.stop()
        self._watch.allow(Light.DARK)

    def recover(self) -> bool:
        """Back to idle after a stop or an alarm; True when the position is still known.

        Raises
        ------
        DeviceTimeoutError, DeviceLostError
            The board does not come back.
        ControllerAlarmError
            E-MOT-16 the door is open.
        """
        alarmed = self._link.revive()
        self._watch.allow(Light.DARK)
        state = self._link.report().state
        if state is MotionState.DOOR:
            raise self._link.fault(ControllerAlarmError("E-MOT-16"))
        if state is MotionState.ALARM:
            alarmed = True
            self._link.command("$X")
        if alarmed or self._link.restarted:
            self._position_known = self._homed = False
        self._set_modes()
        self.status()
        return self._position_known

    def transcript(self) -> list[dict[str, object]]:
        """The last 200 lines: ``t_s`` on the rig's clock, ``direction`` (``out``, ``in``), ``line``."""
        return self._link.transcript()

    def description(self) -> dict[str, object]:
        """For ``impronta doctor``."""
        return {
            "port": self._link.port_name,
            "firmware": self.identity.firmware,
            "version": self.identity.version,
            "axes": self.identity.axes,
            "laser_mode": self.identity.laser_mode,
            "transcript": self.transcript(),
        }

    def self_checks(self) -> list[Check]:
        """Handshake, motion and laser, each with a verdict; the laser is off afterwards."""
        return controller_checks(self)

    # ------------------------------------------------------------------------------------------ end
    def close(self) -> None:
        """Laser off, release the port; may be called again."""
        try:
            self._link.close()
        finally:
            self._watch.close()

    def __enter__(self) -> GrblController:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    # ------------------------------------------------------------------------------------------ inside
    def _ready(self) -> None:
        """A standing laser that was switched off in time cost an idle board a reset: go on as if it had not."""
        if self._link.halt is Darkened.STOOD_LONG:
            self.recover()
        if not self._modes_set and self._link.halt is None:
            self._set_modes()

    def _set_modes(self) -> None:
        self._modes_set = False
        self._link.command(_MODES)
        self._modes_set = True

    def _darken(self, reason: Darkened) -> None:
        """For the watch; a link that is halted has been reset, and keeps its reason."""
        if self._link.halt is None:
            self._link.stop(reason)

    def _arrived(self, *, x_deg: float | None = None, y_deg: float | None = None, table_deg: float | None = None) -> None:
        last = self._last
        if last is not None:
            self._last = MotionStatus(
                last.state,
                last.x_deg if x_deg is None else x_deg,
                last.y_deg if y_deg is None else y_deg,
                last.table_deg if table_deg is None else table_deg,
                0.0,
                self._clock.now_s(),
            )

    def _here(self, axis: int) -> float:
        last = self._last
        if last is None:
            return 0.0
        value = last.x_deg if axis == 0 else last.y_deg if axis == 1 else last.table_deg
        return value if math.isfinite(value) else 0.0

    def _rate_deg_s(self, axis: int) -> float:
        return max(1e-3, self.identity.settings.get(110 + axis, 600.0) / 60.0)

    def _travel_s(self, target: dict[int, float]) -> float:
        """A deadline that a healthy board keeps: twice the time of the slowest axis, and some."""
        times = [0.0]
        for axis, value in target.items():
            acceleration = max(1e-3, self.identity.settings.get(120 + axis, 10.0))
            rate = self._rate_deg_s(axis)
            times.append(abs(value - self._here(axis)) / rate + rate / acceleration)
        return 2.0 * max(times) + _SPARE_S

    def _sweep_s(self, x_deg: float, y_deg: float, speed_deg_s: float) -> float:
        """After which a sweep is over and dark, with some to spare."""
        accelerating_s = speed_deg_s / max(1e-3, min(self.identity.settings.get(120 + axis, 10.0) for axis in (0, 1)))
        return math.hypot(x_deg - self._here(0), y_deg - self._here(1)) / speed_deg_s + accelerating_s + 0.5

    def _check_rate(self, x_deg: float, y_deg: float, speed_deg_s: float) -> None:
        delta = (x_deg - self._here(0), y_deg - self._here(1))
        length = math.hypot(*delta)
        for axis in (0, 1):
            if length > 0.0 and speed_deg_s * abs(delta[axis]) / length > self._rate_deg_s(axis) * 1.001:
                raise UsageError(
                    "E-USE-01",
                    what=f"A sweep of {speed_deg_s:g} deg/s is faster than axis {'XY'[axis]} of the controller ({self._rate_deg_s(axis):g} deg/s)",
                    do="lower the sweep speed in the rig file",
                )


def _same_place(a: MotionStatus, b: MotionStatus | None) -> bool:
    """Also where neither knows the place."""
    pairs = [] if b is None else [(a.x_deg, b.x_deg), (a.y_deg, b.y_deg), (a.table_deg, b.table_deg)]
    return bool(pairs) and not any(abs(p - q) > _SAME_PLACE_DEG or math.isnan(p) != math.isnan(q) for p, q in pairs)


def _words(**values: float) -> str:
    """Axis words with a point and fixed decimals, whatever the locale."""
    for axis, value in values.items():
        if not math.isfinite(value):
            raise UsageError("E-USE-01", what=f"{value} is no position for axis {axis}", do="give a finite number of degrees")
    return "".join(f"{axis}{value:.4f}" for axis, value in values.items())
