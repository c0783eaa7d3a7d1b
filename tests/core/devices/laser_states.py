"""States of the laser and what can happen in them, seen by a witness outside of the program."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import psutil

from tests.core.devices.boards import RemoteBoard

SIGNALS = {name: getattr(signal, name) for name in ("SIGKILL", "SIGSTOP", "SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)}
BOARD_EVENTS = ("open_door", "trip_limit", "power_cycle")

DARK_WITHIN_S = {
    **dict.fromkeys(SIGNALS, 0.6),
    **dict.fromkeys(BOARD_EVENTS, 0.2),
    **dict.fromkeys(("return", "exception", "sys.exit", "os._exit"), 0.6),
    "hang": 2.5,
    "guardian": 2.0,
}
"""The promises of :mod:`scanner_core.devices.laser_safety`, by event."""


@dataclass
class Seen:
    """What the witness saw: how long after the event the laser was lit at last, 0 when it was dark; and what the program said."""

    dark_after_s: float
    lit_again: bool
    said: list[str]


@contextmanager
def program(remote: RemoteBoard, state: str, end: str = "") -> Iterator[subprocess.Popen[str]]:
    """A program of its own that is in a state of the laser."""
    words = [sys.executable, "-m", "tests.core.devices.victim", remote.url, state, end]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, start_new_session=True) as started:
        try:
            assert started.stdout is not None
            assert started.stdout.readline() == "lit\n"
            yield started
        finally:
            started.kill()


def happen(remote: RemoteBoard, state: str, event: str) -> Seen:
    """Let it happen in the state, and look until well after the promise."""
    with program(remote, state, event if event in ("return", "exception", "sys.exit", "os._exit", "hang") else "") as running:
        assert running.stdout is not None
        time.sleep(0.15)  # into the movement
        lit = remote.witness.laser_log()[-1][1] > 0.0
        assert lit == (state in ("sweep", "standing")), state
        at_s = time.monotonic()
        if event in SIGNALS:
            running.send_signal(SIGNALS[event])
        elif event in BOARD_EVENTS:
            remote.witness.happen(event)
        elif event == "guardian":
            next(child for child in psutil.Process(running.pid).children() if "guardian_process" in " ".join(child.cmdline())).kill()
        elif event == "hang":
            at_s = remote.witness.laser_log()[-1][0] if lit else at_s  # it hung when it had lit it
        else:
            at_s = float(running.stdout.readline())
        time.sleep(DARK_WITHIN_S[event] + 0.5)
        log = remote.witness.laser_log()
        said = []
        if lit and (event in BOARD_EVENTS or event == "guardian"):  # the program is there to say what it was
            running.wait(10.0)
            said = running.stdout.read().split()
    if event == "open_door":
        remote.witness.happen("close_door")
    end_s = at_s + DARK_WITHIN_S[event]
    last_s, power = log[-1] if log else (at_s, 0.0)
    return Seen(max(0.0, last_s - at_s) if power == 0.0 else float("inf"), any(time_s > end_s and power > 0.0 for time_s, power in log), said)
