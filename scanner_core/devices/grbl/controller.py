"""A GRBL board as the instrument's motion controller."""

from __future__ import annotations

from typing import TYPE_CHECKING

from scanner_core.clock import Clock
from scanner_core.devices.check import Check
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl.axes import TABLE, Axes, Target, X, Y
from scanner_core.devices.grbl.doctor import controller_checks
from scanner_core.devices.grbl.handshake import shake_hands
from scanner_core.devices.grbl.lines import Report
from scanner_core.devices.grbl.link import ANSWER_S, GrblLink, Halt
from scanner_core.devices.grbl.transcript import as_text
from scanner_core.devices.grbl.whereabouts import Whereabouts
from scanner_core.devices.laser_safety import HELD_LIT_S, LIT_ANSWER_S, STANDING_LASER_S, Darkened, LaserWatch, Light, breach
from scanner_core.devices.motion import MotionState, MotionStatus
from scanner_core.devices.serial_port import BytePort
from scanner_core.errors import ControllerAlarmError, DeviceError

if TYPE_CHECKING:
    from scanner_core.devices.rig import LimitsConfig

_HOME_DEADLINE_S = 120.0
_LOOKS = 5
_OFFSET_LOOKS, _FIRST_LOOKS = 35, 3
_JOG_LOOK_S = 0.1
_MODES = "G54G21G90G94M5"


class GrblController:
    """Implements :class:`scanner_core.devices.motion.MotionController` on a port that is open.

    One thread owns it; :meth:`stop`, :meth:`hold` and :meth:`jog_cancel` may come from any.  Sweeps use M4 (dark at rest); M3
    only lights the standing spot of :meth:`laser`.  When it may be lit, and what makes it dark, stands in
    :mod:`scanner_core.devices.laser_safety`.  Degrees are the board's work coordinates (G54), by the rig file's `units_per_deg`.
    """

    def __init__(
        self,
        port: BytePort,
        config: ControllerConfig,
        clock: Clock,
        limits: LimitsConfig | None = None,
        *,
        standing_laser_s: float = STANDING_LASER_S,
        watched: bool = False,
    ) -> None:
        """`watched`: a lit laser that the owner does not talk about for two seconds is switched off."""
        self._link = GrblLink(port, config.port, clock)
        self._clock = clock
        self._watch = LaserWatch(self._darken, lambda: self._link.talked_s, clock, standing_laser_s, strict=watched)
        self._modes_set = False
        self._jog_cancelled = False
        try:
            self.identity, report = shake_hands(self._link, config.table_axis.upper())
            self._axes = Axes(self.identity, config, limits)
            self._place = Whereabouts(self._axes, clock)
            self._place.reported(report)
            self._link.judge = self._judge
            for look in range(_OFFSET_LOOKS):  # it stands in one of the first reports, and then in every tenth or so
                if self._place.doubts_offset or (look < _FIRST_LOOKS and not self._place.heard_offset):
                    self._link.report()
            if report.state is not MotionState.ALARM:
                self._set_modes()
            self.status()
        except BaseException as fault:
            self.close()
            if isinstance(fault, DeviceError):
                fault.details = f"{fault.details}\n{self.transcript_text()}".strip()
            raise

    # ------------------------------------------------------------------------------------------ motion
    def aim(self, x_deg: float, y_deg: float) -> None:
        """Move the beam's direction, laser dark; returns when it is there."""
        self._go({X: x_deg, Y: y_deg})

    def rotate_to(self, table_deg: float) -> None:
        """Turn the table, laser dark; returns when it is there."""
        self._go({TABLE: table_deg})

    def check_table(self, table_deg: float) -> None:
        """Raises :class:`UsageError`, E-MOT-21, where :meth:`rotate_to` would not go."""
        self._axes.check({TABLE: table_deg})

    def _go(self, target: Target) -> None:
        """Arrive from below where an axis has play: downwards it goes `approach_deg` too far first."""
        self._axes.check(target)
        self._ready()
        detour = self._place.detour(target)
        for place in (target,) if detour is None else (detour, target):
            self._link.command(f"M5G0{self._axes.words(place)}")
            self._watch.allow(Light.DARK)
            self._link.command("G4P0", self._axes.travel_s(self._place.delta(place)))
            self._place.arrived(place)

    def sweep(self, x_deg: float, y_deg: float, speed_deg_s: float) -> None:
        """Begin a straight move with the laser lit; returns when the board has accepted it.

        Raises
        ------
        UsageError
            E-MOT-21 outside of the limits; E-USE-01 the speed is beyond the board's maximum rate: it would move slower than planned.
        """
        target = {X: x_deg, Y: y_deg}
        self._axes.check(target)
        delta = self._place.delta(target)
        self._axes.check_rate(delta, speed_deg_s)
        self._ready()
        self._watch.allow(Light.SWEEP, self._clock.now_s() + self._axes.sweep_s(delta, speed_deg_s))
        self._link.command(f"M4S{self.full_power:.0f}G1{self._axes.words(target)}F{self._axes.feed(delta, speed_deg_s):.2f}")
        self._place.arrived(target)

    def wait_idle(self, deadline_s: float) -> None:
        """Wait for the end of the motion."""
        self._ready()
        swept = self._watch.light is Light.SWEEP
        self._link.command("M5G4P0" if swept else "G4P0", deadline_s)  # M5 waits for the end of the motion, too
        if swept:
            self._watch.allow(Light.DARK)

    def jog(self, *, x_deg: float = 0.0, y_deg: float = 0.0, table_deg: float = 0.0, speed_deg_s: float) -> bool:
        """Move by so many degrees, laser dark, without taking out play; False when :meth:`jog_cancel` ended it before.

        Raises
        ------
        UsageError
            E-MOT-21, E-USE-01.
        """
        delta = {axis: value for axis, value in ((X, x_deg), (Y, y_deg), (TABLE, table_deg)) if value != 0.0}
        here = self._place.here()
        self._axes.check({axis: here[axis] + value for axis, value in delta.items()})
        self._axes.check_rate(delta, speed_deg_s)
        if not delta:
            return True
        self._jog_cancelled = False
        self._ready()
        if self._watch.light is not Light.DARK:
            self.laser(False)
        patience_s = 2.0 * self._axes.sweep_s(delta, speed_deg_s) + ANSWER_S
        end_s = self._clock.now_s() + patience_s
        self._place.disturb()
        self._link.command(f"$J=G91{self._axes.words(delta)}F{self._axes.feed(delta, speed_deg_s):.2f}")
        while self.status().state in (MotionState.MOVING, MotionState.HOLD):
            if self._clock.now_s() > end_s:
                raise self._link.late("$J", patience_s)
            self._clock.sleep(_JOG_LOOK_S)
        return not self._jog_cancelled

    def jog_cancel(self) -> None:
        """End a :meth:`jog`: the axes brake and the position stays known.  From any thread; nothing else is touched."""
        self._jog_cancelled = True
        self._link.cancel_jog()

    @property
    def needs_homing(self) -> bool:
        """``$22`` says that there are switches.  Many boards forget their position when the port is opened, and do not tell."""
        return self.identity.homing is True and not self._place.homed

    def home(self) -> None:
        """Find the reference position; also unlocks.  After a :meth:`stop` it moves nothing before :meth:`recover`."""
        if self._link.halt not in (None, Halt.STOPPED):
            self.recover()
        if self._watch.light is not Light.DARK:
            self.laser(False)
        self._link.command("$H", _HOME_DEADLINE_S, mute=True)
        self._set_modes()
        self._place.known = self._place.homed = True
        self._place.disturb()
        self._link.restarted = False
        self.status()

    # ------------------------------------------------------------------------------------------ laser
    @property
    def full_power(self) -> float:
        """S value of full power (``$30``); the handshake has seen to it that it is known."""
        return self.identity.settings[30]

    def laser(self, on: bool) -> None:
        """A standing spot for aiming, or dark.

        Raises
        ------
        DeviceError
            E-MOT-17 when the board's own status does not show it lit.
        """
        self._ready()
        if not on:
            self._link.command("M5", self._axes.travel_s({}))
            self._watch.allow(Light.DARK)
            return
        self._watch.allow(Light.STANDING)
        self._link.command(f"G1F60M3S{self.full_power:.0f}", self._axes.travel_s({}))
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
        expected = before = self._place.last
        said, looks = self._asked(), 0
        # A digit that noise has changed makes a report like any other: where the board rests elsewhere than expected, two must agree.
        while not self._place.resting(said, expected, before):
            if looks == _LOOKS:
                raise self._link.fault(DeviceError("E-MOT-20", port=self._link.port_name))
            expected, said, looks = said, self._asked(), looks + 1
        return said

    def _asked(self) -> MotionStatus:
        report = self._link.report(ANSWER_S if self._watch.light is Light.DARK else LIT_ANSWER_S)
        return self.newest or self._place.understood(report)

    @property
    def newest(self) -> MotionStatus | None:
        """The last report that came."""
        return self._place.newest

    def _judge(self, report: Report) -> DeviceError | None:
        """Every report passes here, whoever asked for it."""
        power = self._place.reported(report).laser_power
        return breach(self._watch.light, report.state, power, emitted=self.identity.tells_emitted_power)

    def stop(self) -> None:
        """Laser off and motion stopped, now, from any thread; then :meth:`recover` comes first."""
        self._link.stop()
        self._watch.allow(Light.DARK)

    def hold(self) -> None:
        """As :meth:`stop`, but the axes brake before the reset, so that the position stays known; from any thread.

        What is lit and not dark within :data:`~scanner_core.devices.laser_safety.HELD_LIT_S` is stopped at once after all;
        :meth:`recover` tells whether the position is still known.
        """
        if self._watch.light is Light.STANDING:  # nothing moves
            self.stop()
            return
        lit_s = HELD_LIT_S if self._watch.light is Light.SWEEP else None
        self._link.hold(2.0 * self._axes.braking_s() + ANSWER_S, lit_s)
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
        self._place.disturb()
        state = self._link.report().state
        if state is MotionState.DOOR:
            raise self._link.fault(ControllerAlarmError("E-MOT-16"))
        if alarmed or self._link.restarted or state is MotionState.ALARM:
            self._place.lose()
        if state is MotionState.ALARM:
            self.unlock()
        else:
            self._set_modes()
            self.status()
        return self._place.known

    def unlock(self) -> None:
        """Take an alarm's lock off (``$X``) without homing: it moves again, and the position counts as lost."""
        self._place.lose()
        self._link.command("$X")
        self._set_modes()
        self.status()

    # ------------------------------------------------------------------------------------------ what was said
    def transcript(self) -> list[dict[str, object]]:
        """The last 200 lines: ``t_s`` on the rig's clock, ``direction`` (``out``, ``in``), ``line``."""
        return self._link.transcript()

    def transcript_text(self) -> str:
        """The same as text to copy, a line each."""
        return as_text(self.transcript())

    def description(self) -> dict[str, object]:
        """For ``impronta doctor``; None is what the board did not tell."""
        identity = self.identity
        return {
            "port": self._link.port_name,
            "firmware": identity.firmware,
            "version": identity.version,
            "family": identity.family.value,
            "axes": identity.axes,
            "laser_mode": identity.laser_mode,
            "full_power": identity.full_power,
            "homing": identity.homing,
            "soft_limits": identity.soft_limits,
            "planner_blocks": identity.planner_blocks,
            "receive_bytes": identity.receive_bytes,
            "max_rate_deg_s": [self._axes.rate_deg_s(axis) for axis in (X, Y, TABLE)],
            "transcript": self.transcript(),
        }

    @property
    def axes(self) -> Axes:
        """Units, limits and rates of the three axes."""
        return self._axes

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
