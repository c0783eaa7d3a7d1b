"""A program that brings the laser into a state and then ends in some way: ``python -m tests.core.devices.victim URL [STATE [END]]``.

It prints ``lit`` when it is in the state, and just before an end of its own the time (``time.monotonic()``).
"""

from __future__ import annotations

import os
import signal
import sys
import time

from scanner_core.clock import ScaledClock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import GrblController, open_controller
from scanner_core.errors import DeviceError

STATES = ("idle", "sweep", "turning", "standing")
ENDS = ("return", "exception", "sys.exit", "os._exit")


def enter(controller: GrblController, state: str) -> None:
    """Into the state, for some ten seconds."""
    if state == "sweep":
        controller.sweep(60.0, 0.0, 5.0)
    elif state == "standing":
        controller.laser(True)


def stay(controller: GrblController, state: str, duration_s: float) -> None:
    """In the state, the laser looked after."""
    end_s = time.monotonic() + duration_s
    if state == "turning":
        controller.rotate_to(360.0)
    while time.monotonic() < end_s:
        controller.status()
        time.sleep(0.1)


def main(url: str, state: str = "standing", end: str = "") -> None:
    with open_controller(ControllerConfig("grbl", url), ScaledClock()) as controller:
        enter(controller, state)
        print("lit", flush=True)
        if end == "hang":
            time.sleep(60.0)
        try:
            stay(controller, state, 0.3 if end else 60.0)
        except DeviceError as error:
            print(error.code, flush=True)
            raise
        print(time.monotonic(), flush=True)
        if end == "exception":
            raise RuntimeError("something in the program")
        if end == "sys.exit":
            sys.exit(3)
        if end == "os._exit":
            os._exit(4)


if __name__ == "__main__":
    if hasattr(signal, "SIGHUP"):
        signal.signal(signal.SIGHUP, signal.SIG_DFL)  # whoever runs the tests may have been told to outlive its terminal
    main(*sys.argv[1:])
