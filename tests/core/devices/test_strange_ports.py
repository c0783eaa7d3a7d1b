"""What may sit on a port instead of the controller: each gets one sentence, within five seconds.  Terminals stand for the cable."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time

import pytest

from scanner_core.clock import ScaledClock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import open_controller
from scanner_core.errors import DeviceError
from tests.core.devices.boards import remote_board
from tests.core.devices.terminals import terminal
from tests.core.devices.test_guardian import repeat

pytestmark = pytest.mark.skipif(not hasattr(os, "openpty"), reason="terminals")

NMEA = b"$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n"
MARLIN = b"start\r\necho:Marlin 2.1.2\r\necho: Last Updated: 2023-01-01\r\n"


def refusal(url: str) -> tuple[DeviceError, float]:
    begin_s = time.monotonic()
    with pytest.raises(DeviceError) as caught:
        open_controller(ControllerConfig("grbl", url), ScaledClock())
    return caught.value, time.monotonic() - begin_s


def told(**ports: str) -> dict[str, tuple[DeviceError, float]]:
    """What is said of each port; all are asked at once, for each needs its four seconds."""
    found: dict[str, tuple[DeviceError, float]] = {}
    askers = [threading.Thread(target=lambda name=name, url=url: found.update({name: refusal(url)})) for name, url in ports.items()]
    for asker in askers:
        asker.start()
    for asker in askers:
        asker.join()
    assert all(len(str(error)) < 400 for error, _ in found.values())
    assert all(seconds < 15.0 for _, seconds in found.values()), "five on a machine with nothing else to do"
    return found


def test_each_strange_device_is_told_in_one_sentence() -> None:
    old_banner = b"\r\nGrbl 0.9j ['$' for help]\r\n"
    with terminal() as silent, terminal(MARLIN, again_s=0.7) as printer, terminal(echo=True) as echo, terminal(old_banner, again_s=0.7) as old:
        found = told(silent=silent, printer=printer, echo=echo, old=old, nothing="/dev/no-such-port")
    codes = {name: error.code for name, (error, _) in found.items()}
    assert codes.pop("old") in ("E-MOT-01", "E-MOT-09"), "it greets, and answers nothing"
    assert codes == {"silent": "E-MOT-24", "printer": "E-MOT-07", "echo": "E-MOT-07", "nothing": "E-MOT-08"}
    assert "Marlin 2.1.2" in found["printer"][0].message


def test_a_flood_is_told_from_a_controller() -> None:
    with terminal(20 * NMEA, again_s=0.02) as gps, terminal(b"\xfe\x00\x91" * 500, again_s=0.02) as garbage:
        found = told(gps=gps, garbage=garbage)
    assert {name: error.code for name, (error, _) in found.items()} == {"gps": "E-MOT-07", "garbage": "E-MOT-07"}
    assert "$GPGGA" in found["gps"][0].message


def test_a_second_program_is_refused_and_the_first_goes_on() -> None:
    program = (
        "import sys; from scanner_core.clock import ScaledClock; from scanner_core.devices.controller_config import ControllerConfig as C;"
        "from scanner_core.devices.grbl import open_controller; from scanner_core.errors import DeviceError\n"
        "try: open_controller(C('grbl', sys.argv[1]), ScaledClock())\n"
        "except DeviceError as error: print(error.code)"
    )
    with terminal() as name:
        first, slow = [], threading.Thread(target=lambda: first.append(refusal(name)[0].code))
        slow.start()
        time.sleep(1.5)  # it has the port by now, and waits for a greeting
        ended = subprocess.run([sys.executable, "-c", program, name], capture_output=True, text=True, check=True)
        slow.join()
    assert ended.stdout.strip() == "E-MOT-03"
    assert first == ["E-MOT-24"]


def test_after_an_unplug_opening_again_works_in_the_same_program() -> None:
    with remote_board() as remote:
        with remote.open() as controller:
            controller.laser(True)
            remote.witness.happen("unplug")
            with pytest.raises(DeviceError) as caught:
                repeat(controller.status)
            assert caught.value.code == "E-MOT-02"
        with pytest.raises(DeviceError) as caught:
            remote.open()
        remote.witness.happen("plug")
        with remote.open() as controller:
            controller.aim(1.0, 1.0)
            assert controller.status().laser_power == 0.0
