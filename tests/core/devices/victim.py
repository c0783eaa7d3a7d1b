"""A program that lights the laser and waits for its end: ``python -m tests.core.devices.victim URL``."""

from __future__ import annotations

import sys
import time

from scanner_core.clock import ScaledClock
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.rig import ControllerConfig

if __name__ == "__main__":
    with open_controller(ControllerConfig("grbl", sys.argv[1]), ScaledClock()) as controller:
        controller.laser(True)
        print("lit", flush=True)
        time.sleep(60.0)
