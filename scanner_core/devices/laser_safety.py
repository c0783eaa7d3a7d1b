"""When the laser may be lit, and what makes it dark: the state machine of the laser, and the two rules that enforce it.

States
======
The *light* is what the driver has allowed the controller to emit; the states of scan and rig map onto three of them::

                      sweep()                             laser(True)
        +------------------------------+     +------------------------------+
        v                              |     |                              v
    Light.SWEEP --wait_idle(), aim()--> Light.DARK <--laser(False), aim()-- Light.STANDING
        |                               ^  ^  ^                             |
        +---- any event below ----------+  |  +---------- any event below --+
                                           |
    no rig, connecting, idle, turning, paused, finishing, stopped, fault, alarm, closed

============================  ==========  ====================================================================
state                         light       why it cannot be brighter
============================  ==========  ====================================================================
no rig, connecting            DARK        opening a port resets the board (DTR, or 0x18 when it does not greet)
idle, turning, paused         DARK        ``M5`` came before; a report that says otherwise is a breach
locating, sweeping            SWEEP       ``M4``: the board emits only while it moves, so the end of the row,
                                          a hold, or a queue that runs dry is dark without anybody's doing
standing spot                 STANDING    ``M3``; 60 s at most, and only while its owner looks after it
finishing                     DARK        ``M5``, or reset after a fault, before anything slow is done
stopped, fault, alarm         DARK        reset sent; the link is halted and sends no move before ``recover()``
closed                        DARK        reset sent, port released, guardian gone
============================  ==========  ====================================================================

Events
======
Every bound counts from the event, at speed 1, on a link that works; the tests let a witness outside of the program
measure it (``tests/core/devices/test_laser_states.py``, ``tests/long/test_laser_states.py``).

============================  ========  =============================================================================
event                         dark in   by whom
============================  ========  =============================================================================
stop, Esc, cancel             0.2 s     ``stop()`` sends reset from the thread that asks, past whatever the owner waits for
hold                          0.2 s     ``hold()`` lets the axes brake, ``M4`` dims with them; what no report shows dark after
                                        :data:`HELD_LIT_S` is reset, and its position lost; a standing spot is reset at once
leaving the rig: return,      0.6 s     ``close()`` sends reset before anything else is let go
exception, ``sys.exit``
SIGINT, SIGTERM, SIGHUP       0.6 s     headless: the scan is cancelled and its end recorded, exit 130; window: it closes
window closed                 0.6 s     the scan is cancelled, then the rig is closed
program killed, ``os._exit``  0.6 s     the guardian: its pipe ends
program hung or stopped       0.6 s     the guardian: 0.4 s without a heartbeat (2 s as long as nothing was sent that could light it)
owner's thread hung           2.5 s     :class:`LaserWatch`: the heartbeat goes on then, nobody looks at the laser; a
                                        sweep is dark at its end anyway, which comes sooner as a rule
guardian killed               2 s       a second guardian resets the board (E-MOT-10), or a sentence says that nobody could
                                        (E-MOT-11)
lid opened                    0.2 s     the board itself; the next report (0.2 s later in a sweep) ends the sweep with
                                        E-MOT-16 and a reset, so that closing the lid lights nothing
alarm                         0.2 s     the board itself; E-MOT-05 and a reset follow
controller reset              0.2 s     the board itself; E-MOT-09, and its position counts as lost
lit against the rules         0.7 s     :func:`breach` in the next report: E-MOT-18 and a reset (asked every 0.2 s in a scan,
                                        every 0.5 s while idle or in a move)
status lost                   2.2 s     the question's deadline (:data:`LIT_ANSWER_S` after at most 0.2 s; ``ANSWER_S`` while
                                        waiting in a move), then reset; a sweep is dark at its end anyway
camera lost                   0.2 s     its fault stops the rig before anything is tidied up; a camera that only falls silent
                                        counts as lost after 4 s, when the sweep has ended
port lost                     row end   nobody can send any more: a sweep ends dark by ``M4``; a standing spot may stay lit,
                                        and E-MOT-02 says so
============================  ========  =============================================================================

Two things are not the program's: a board whose processor hangs keeps what it emits whatever is sent (a sweep's last
step ends, ``M4`` then scales to zero only if the board still runs), and a laser whose power the board does not switch.
Against both stands the interlock of the rig, not software.

What the window shows is the board's own report (:attr:`MotionController.newest`), whoever asked for it; when none came
for a second it says that the laser is unknown.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable
from enum import Enum

from scanner_core.clock import Clock
from scanner_core.devices.motion import MotionState
from scanner_core.errors import ControllerAlarmError, DeviceError

STANDING_LASER_S = 60.0
"""Real seconds after which a standing laser is switched off by the host."""
UNWATCHED_S = 2.0
"""Real seconds that a lit laser may be on without its owner having talked to the board."""
LIT_ANSWER_S = 1.0
"""How long an answer about a lit laser is waited for, on the rig's clock."""
HELD_LIT_S = 0.1
"""How long a lit sweep may brake before it is reset, on the rig's clock."""

_TICK_S = 0.2
_LOCKED = "it is locked until it is homed or unlocked"


class Light(Enum):
    """What the controller is allowed to emit."""

    DARK = "dark"
    SWEEP = "sweep"
    STANDING = "standing"


class Darkened(Enum):
    """Why the watch has switched the laser off."""

    STOOD_LONG = "the standing laser had been on for long enough"
    UNWATCHED = "nobody looked after the lit laser"


def breach(light: Light, state: MotionState, laser_power: float, *, emitted: bool = True) -> DeviceError | None:
    """What a status report says against the rules; the caller resets the board and raises it.

    `emitted` False: the power is what was programmed (grblHAL), which at the rest after a sweep says nothing; the ``M5`` that
    follows makes it 0.

    A closed-off rig that is dark is no breach: a report of an idle rig with an open lid is a value.  A state that is not
    known is none either: a line that noise has damaged must not end a scan that the next one would clear.
    """
    if light is not Light.DARK and state is MotionState.DOOR:
        return ControllerAlarmError("E-MOT-16")
    if light is not Light.DARK and state is MotionState.ALARM:
        return ControllerAlarmError("E-MOT-05", alarm="lock", meaning=_LOCKED, remedy="home the rig and resume")
    at_rest = emitted and light is Light.SWEEP and state is MotionState.IDLE
    if laser_power > 0.0 and (light is Light.DARK or at_rest):
        return DeviceError("E-MOT-18", power=f"{laser_power:.0f}")
    return None


class LaserWatch:
    """A thread beside the owner that switches a lit laser off when it stands for too long, or nobody looks after it.

    The guardian's heartbeat proves that the program runs; this proves that the thread which lit the laser does.  Its
    thread is a daemon: a program that forgets ``close()`` must end, and its end switches the laser off.
    """

    def __init__(self, darken: Callable[[Darkened], None], talked_s: Callable[[], float], clock: Clock, standing_s: float, *, strict: bool) -> None:
        """
        Parameters
        ----------
        darken : resets the board; called from the watch's thread
        talked_s : when the owner last talked to the board, ``time.monotonic()``
        clock : the rig's
        standing_s : longest time of a standing laser, real seconds
        strict : also look after the owner; a firmware model inside this process, which can burn nobody and may be halted in a
            debugger, is not worth it
        """
        self._darken, self._talked_s, self._clock = darken, talked_s, clock
        self._standing_s, self._strict = standing_s, strict
        self._changed = threading.Condition()
        self._light = Light.DARK
        self._lit_s = 0.0
        self._until_s = 0.0
        self._closing = False
        self._thread: threading.Thread | None = None

    @property
    def light(self) -> Light:
        return self._light

    def allow(self, light: Light, until_s: float = float("inf")) -> None:
        """What may be emitted from now on; `until_s` (rig's clock) is when a sweep is over by itself."""
        with self._changed:
            if light is Light.DARK is self._light:
                return
            self._light, self._until_s, self._lit_s = light, until_s, time.monotonic()
            if self._thread is None and (light is Light.STANDING or self._strict):
                self._thread = threading.Thread(target=self._run, name="laser-watch", daemon=True)
                self._thread.start()
            self._changed.notify_all()

    def close(self) -> None:
        """End the thread; may be called again, and from the thread itself."""
        with self._changed:
            self._light, self._closing = Light.DARK, True
            self._changed.notify_all()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join()

    def _run(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._closing or self._light is not Light.DARK)
                if self._closing:
                    return
                reason = self._due()
                if reason is None:
                    self._changed.wait(_TICK_S if self._strict else min(self._standing_s, _TICK_S))
                    continue
                self._light = Light.DARK
            with contextlib.suppress(DeviceError):  # a port that is lost says so to the owner
                self._darken(reason)

    def _due(self) -> Darkened | None:
        now_s = time.monotonic()
        if self._light is Light.STANDING and now_s - self._lit_s >= self._standing_s:
            return Darkened.STOOD_LONG
        unwatched = now_s - max(self._talked_s(), self._lit_s) >= UNWATCHED_S
        over = self._light is Light.SWEEP and self._clock.now_s() > self._until_s
        return Darkened.UNWATCHED if self._strict and unwatched and not over else None
