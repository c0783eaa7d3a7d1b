"""The conversation with a GRBL board: a line out, its one answer in, and a deadline on every wait.

One thread talks; :meth:`GrblLink.stop`, :meth:`GrblLink.hold` and :meth:`GrblLink.cancel_jog` may come from any.  After a
stop or a fault the board has been reset (laser off) and the link is *halted*: nothing is sent any more until
:meth:`GrblLink.revive`, so that a thread that has not noticed yet cannot start the next move.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import asdict, dataclass
from enum import Enum

from scanner_core.clock import Clock
from scanner_core.devices.grbl.line_buffer import LineBuffer
from scanner_core.devices.grbl.lines import Alarm, Banner, Line, Ok, Other, Refusal, Report, parse_line
from scanner_core.devices.grbl.meanings import LOCKED, alarm_meaning, refusal_meaning
from scanner_core.devices.laser_safety import UNWATCHED_S, Darkened
from scanner_core.devices.motion import MotionState
from scanner_core.devices.serial_port import BytePort
from scanner_core.errors import (
    ControllerAlarmError,
    DeviceClosedError,
    DeviceError,
    DeviceLostError,
    DeviceTimeoutError,
    MotionStoppedError,
)

RESET = b"\x18"
_HOLD, _JOG_CANCEL = b"!", b"\x85"
ANSWER_S = 2.0
"""Deadline of an answer that waits for no motion."""

_SLICE_S = 0.2
_ALIVE_PERIOD_S = 0.5
_AGAIN_S = 0.4
"""After so much silence a question that costs nothing is asked again."""
_QUIET_S = 0.1
_HOLD_LOOK_S = 0.03
_TRANSCRIPT_LINES = 200
_LOCKED_NUMBER, _DOOR_NUMBER = 9, 13


class Halt(Enum):
    """Why nothing is sent."""

    STOPPED = "stop() was called"
    FAULT = "a fault was raised"


@dataclass(frozen=True, slots=True)
class TranscriptLine:
    """A line as it went over the wire; `direction` is ``out`` or ``in``, `t_s` is on the rig's clock."""

    t_s: float
    direction: str
    line: str


class GrblLink:
    """Send-and-wait over an open port."""

    def __init__(self, port: BytePort, port_name: str, clock: Clock) -> None:
        self.port_name, self.clock = port_name, clock
        self.restarted = False
        self.judge: Callable[[Report], DeviceError | None] = lambda _: None
        """Sees every report; what it returns is raised, the laser off, unless the board has been reset already."""
        self.talked_s = time.monotonic()
        """When the owner last waited or sent, ``time.monotonic()``."""
        self._port = port
        self._buffer = LineBuffer()
        self._lines: deque[Line] = deque()
        self._transcript: deque[TranscriptLine] = deque(maxlen=_TRANSCRIPT_LINES)
        self._write_lock = threading.RLock()
        self._read_lock = threading.RLock()
        self._hold_lock = threading.RLock()
        """Whoever revives the board waits for the end of a hold; :meth:`stop` does not."""
        self._halt: Halt | Darkened | None = None
        self._closed = False
        self._greeted = False
        """It is a GRBL board, which greets after a reset."""
        self._axes = 0
        """Numbers of a position, from the first report that had one."""

    @property
    def halt(self) -> Halt | Darkened | None:
        return self._halt

    @property
    def closed(self) -> bool:
        return self._closed

    def transcript(self) -> list[dict[str, object]]:
        """The last lines, oldest first."""
        return [asdict(line) for line in tuple(self._transcript)]

    # ------------------------------------------------------------------------------------------ the one conversation
    def command(self, text: str, deadline_s: float = ANSWER_S, *, mute: bool = False) -> list[Line]:
        """Send a line and wait for its answer; the lines that came before ``ok``.

        Meanwhile the board is asked twice a second whether it is still there, whether its door is open and its laser dark,
        unless it answers no questions (`mute`: it homes).  A board that has been idle for :data:`ANSWER_S` has nothing left to
        answer: its ``ok`` is lost, and no longer waited for.

        Raises
        ------
        DeviceTimeoutError, DeviceLostError, ControllerAlarmError, MotionStoppedError, DeviceError
            After each of them the laser is off and the link is halted.
        """
        self._send(f"{text}\n".encode("ascii"), text)
        now_s = self.clock.now_s()
        end_s, asked_s, heard_s = now_s + deadline_s, now_s, now_s
        idle_s: float | None = None
        before: list[Line] = []
        while True:
            wake_s = end_s if mute else min(end_s, asked_s + _ALIVE_PERIOD_S)
            line = self._next_line(wake_s, text)
            now_s = self.clock.now_s()
            if isinstance(line, Ok):
                return before
            if isinstance(line, Refusal):
                raise self._refused(text, line.number)
            if isinstance(line, Report):
                heard_s = now_s
                self._check_report(line)
                if line.state is MotionState.DOOR:
                    raise self.fault(ControllerAlarmError("E-MOT-16"))
                idle_s = None if line.state is not MotionState.IDLE else now_s if idle_s is None else idle_s
                if idle_s is not None and now_s - idle_s > ANSWER_S:
                    raise self.fault(self._timeout(text, now_s - end_s + deadline_s))
            elif line is not None:
                self._expect_no_reset(line, text)
                before.append(line)
            if now_s >= end_s:
                raise self.fault(self._timeout(text, deadline_s))
            if not mute and now_s >= asked_s + _ALIVE_PERIOD_S:
                if asked_s - heard_s > ANSWER_S:
                    raise self.fault(self._timeout("?", ANSWER_S))
                asked_s = now_s
                self._send(b"?", "?", even_when_halted=True)

    def report(self, deadline_s: float = ANSWER_S) -> Report:
        """Ask for the status; also while halted.  What comes garbled, or not at all, is asked for again until the deadline.

        Raises
        ------
        DeviceTimeoutError, DeviceLostError, ControllerAlarmError
        """
        self._lines = deque(line for line in self._lines if not isinstance(line, Report))  # of a question before this one
        end_s = self.clock.now_s() + deadline_s
        while True:
            self._send(b"?", "?", even_when_halted=True)
            line = self._next_line(min(end_s, self.clock.now_s() + _AGAIN_S), "?", even_when_halted=True)
            while not (line is None or isinstance(line, Report | Other | Banner)):
                if self._halt is None:
                    self._expect_no_reset(line, "?")
                line = self._next_line(min(end_s, self.clock.now_s() + _AGAIN_S), "?", even_when_halted=True)
            if isinstance(line, Report) and self._whole(line):
                self._check_report(line)
                return line
            if isinstance(line, Banner) and self._halt is None:
                self._expect_no_reset(line, "?")
            if self.clock.now_s() >= end_s:
                raise self.fault(self._timeout("?", deadline_s))

    def listen(self, deadline_s: float) -> Line | None:
        """The next line whatever it is, or None; for handshake and recovery."""
        return self._next_line(self.clock.now_s() + deadline_s, "", even_when_halted=True)

    @property
    def unfinished(self) -> str:
        """What has come of a line that is not complete."""
        return self._buffer.unfinished

    # ------------------------------------------------------------------------------------------ reset and after
    def stop(self, reason: Halt | Darkened = Halt.STOPPED) -> None:
        """Reset the board now: laser off, motion stopped.  From any thread; after close() there is nothing to stop."""
        with self._write_lock:
            if self._closed:
                return
            self._halt = reason
            self._note("out", "<ctrl-x>")
            self._port.write(RESET)

    def hold(self, deadline_s: float, lit_s: float | None) -> None:
        """Let the axes brake, see them rest, then reset: as :meth:`stop`, but the position stays known.  From any thread.

        Nothing else is sent from now on; the owner, who may be waiting for an answer, is told that the motion was stopped.

        Parameters
        ----------
        deadline_s : then the reset comes whatever moves
        lit_s : the laser may be lit; when no report has shown it dark after so long the reset comes at once.  None = it is dark
        """
        with self._hold_lock:
            with self._write_lock:
                if self._closed or self._halt is not None:
                    return
                self._halt = Halt.STOPPED
                self._note("out", "!")
                self._port.write(_HOLD)
            try:
                self._see_it_rest(deadline_s, lit_s)
            except DeviceClosedError:
                return  # whoever closed it meanwhile has reset the board
            finally:
                self.stop()

    def _see_it_rest(self, deadline_s: float, lit_s: float | None) -> None:
        ask_s = self.clock.now_s()
        end_s = ask_s + deadline_s
        dark_by_s = end_s if lit_s is None else ask_s + lit_s
        while (now_s := self.clock.now_s()) < min(end_s, dark_by_s):
            if now_s >= ask_s:
                self._send(b"?", "?", even_when_halted=True)
                ask_s = now_s + _HOLD_LOOK_S
            line = self._next_line(ask_s, "!", even_when_halted=True)
            if isinstance(line, Alarm | Banner) or (isinstance(line, Report) and at_rest(line)):
                return
            if isinstance(line, Report) and line.laser_power == 0.0:
                dark_by_s = end_s

    def cancel_jog(self) -> None:
        """End a jog; from any thread."""
        with self._write_lock:
            if not self._closed and self._halt is None:
                self._note("out", "<jog-cancel>")
                self._port.write(_JOG_CANCEL)

    def ask_for_banner(self) -> None:
        """Reset a board that may not have been reset by the opening of the port."""
        self._send(RESET, "<ctrl-x>")

    def revive(self, deadline_s: float = ANSWER_S) -> bool:
        """Reset, wait for the banner, and talk again; True when an alarm or a loss of position was reported on the way.

        Raises
        ------
        DeviceTimeoutError, DeviceLostError
        """
        with self._hold_lock, self._write_lock:
            self.stop(Halt.FAULT)
            self._halt = None
        alarmed, greeted, again = False, False, False
        end_s = self.clock.now_s() + deadline_s
        while not greeted:
            line = self._next_line(end_s if again else end_s - 0.5 * deadline_s, "reset")
            if line is None and not again:  # its greeting was garbled, or it has just been reset by itself
                self._port.write(RESET)
                again = True
                continue
            if line is None:
                raise self.fault(self._timeout("reset", deadline_s))
            greeted = isinstance(line, Banner)
            alarmed = alarmed or isinstance(line, Alarm)
        while (line := self._next_line(self.clock.now_s() + _QUIET_S, "reset")) is not None:
            alarmed = alarmed or isinstance(line, Alarm)  # the banner of an earlier reset may still have been on its way
        return alarmed

    def fault(self, error: DeviceError) -> DeviceError:
        """Laser off, halted; returns `error` for raising."""
        try:
            self.stop(Halt.FAULT if self._halt is None else self._halt)
        except DeviceError as second:
            error.add_note(f"the reset could not be sent: {second}")
        return error

    def close(self) -> None:
        """Reset the board, see that it happened where it has answered before, release the port."""
        with self._write_lock:
            if self._closed:
                return
            try:
                self.stop(Halt.STOPPED)
                end_s = self.clock.now_s() + (0.5 if self._greeted else 0.0)
                while (line := self._next_line(end_s, "reset", even_when_halted=True)) is not None and not isinstance(line, Banner):
                    continue
            except DeviceError as fault:
                self._note("in", f"(lost: {fault.code})")
            finally:
                self._closed = True
                self._port.close()

    # ------------------------------------------------------------------------------------------ bytes
    def _send(self, chunk: bytes, text: str, *, even_when_halted: bool = False) -> None:
        with self._write_lock:
            self._check_open()
            if self._halt is not None and not even_when_halted:
                raise self._stopped(text)
            self._note("out", text)
            self.talked_s = time.monotonic()
            self._port.write(chunk)

    def _next_line(self, end_s: float, text: str, *, even_when_halted: bool = False) -> Line | None:
        """The next line, None when `end_s` comes first."""
        while True:
            self.talked_s = time.monotonic()
            if self._halt is not None and not even_when_halted:
                raise self._stopped(text)
            with self._read_lock:
                if self._lines:
                    return self._lines.popleft()
                self._check_open()
                left_s = end_s - self.clock.now_s()
                # One look also when the time is up: a process that did not run for a while must not take that for a silent board.
                for said in self._buffer.feed(self._port.read(min(max(left_s, 0.0), _SLICE_S))):
                    self._note("in", said)
                    self._lines.append(line := parse_line(said))
                    self._greeted = self._greeted or isinstance(line, Banner)
            if left_s <= 0.0 and not self._lines:
                return None

    def _check_open(self) -> None:
        if self._closed:
            raise DeviceClosedError("E-MOT-04", port=self.port_name)

    def _note(self, direction: str, line: str) -> None:
        self._transcript.append(TranscriptLine(round(self.clock.now_s(), 4), direction, line))

    # ------------------------------------------------------------------------------------------ faults
    def _whole(self, report: Report) -> bool:
        """Whether noise has spared it, as far as one can see; boards that leave the position out are believed as they are."""
        axes = 0 if report.position is None else len(report.position)
        if self._axes == 0:
            self._axes = axes
        return report.state is not MotionState.UNKNOWN and axes == self._axes

    def _check_report(self, report: Report) -> None:
        error = self.judge(report)
        if error is not None and self._halt is None:
            raise self.fault(error)

    def _stopped(self, text: str) -> MotionStoppedError:
        if self._halt is Darkened.UNWATCHED:
            return MotionStoppedError("E-MOT-19", seconds=UNWATCHED_S)
        return MotionStoppedError("E-MOT-15", command=text)

    def _expect_no_reset(self, line: Line, text: str) -> None:
        if isinstance(line, Alarm | Banner) and self._halt is not None:
            raise self._stopped(text)
        if isinstance(line, Alarm):
            meaning = alarm_meaning(line.number)
            self.restarted = True
            raise self.fault(ControllerAlarmError("E-MOT-05", alarm=line.number, meaning=meaning.text, remedy=meaning.remedy))
        if isinstance(line, Banner):
            self.restarted = True
            raise self.fault(DeviceLostError("E-MOT-09", port=self.port_name, details=line.firmware))

    def _refused(self, text: str, number: int) -> DeviceError:
        if number == _LOCKED_NUMBER:
            return self.fault(ControllerAlarmError("E-MOT-05", alarm="lock", meaning=LOCKED.text, remedy=LOCKED.remedy))
        if number == _DOOR_NUMBER:
            return self.fault(ControllerAlarmError("E-MOT-16"))
        return self.fault(DeviceError("E-MOT-06", command=text, number=number, meaning=refusal_meaning(number)))

    def late(self, text: str, deadline_s: float) -> DeviceError:
        """What is to be raised when something took too long; laser off, halted."""
        return self.fault(self._timeout(text, deadline_s))

    def _timeout(self, text: str, deadline_s: float) -> DeviceTimeoutError:
        return DeviceTimeoutError("E-MOT-01", port=self.port_name, command=text, seconds=round(deadline_s, 1))


def at_rest(report: Report) -> bool:
    """Nothing moves any more: idle, locked, or a hold or an open door with the axes braked (``Hold:0``, ``Door:0``, ``Door:1``)."""
    braked = {MotionState.HOLD: (0,), MotionState.DOOR: (0, 1)}.get(report.state)
    return report.state in (MotionState.IDLE, MotionState.ALARM) or (braked is not None and report.substate in braked)
