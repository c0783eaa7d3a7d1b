"""A cable that is plugged in again may get another name from the system."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from serial.tools import list_ports

from scanner_core.clock import SteppedClock
from scanner_core.devices import guardian
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import open_controller
from scanner_core.devices.serial_port import open_error
from scanner_core.errors import DeviceError
from tests.core.devices.test_grbl_controller import BANNER, GRBL_HAL, ScriptedPort


def test_a_port_that_was_open_is_found_by_the_serial_number_of_its_adapter(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = SteppedClock()
    adapters = {"/dev/ttyUSB7": "A5069RR4", "/dev/ttyUSB9": "B0"}

    def opened(url: str, baud: int) -> ScriptedPort:
        if url not in adapters:
            raise open_error(url, "missing", "")
        return ScriptedPort(clock, GRBL_HAL, BANNER)

    monkeypatch.setattr(guardian, "GuardedPort", opened)
    monkeypatch.setattr(list_ports, "comports", lambda: [SimpleNamespace(device=name, serial_number=number) for name, number in adapters.items()])
    config = ControllerConfig("grbl", "/dev/ttyUSB7")
    open_controller(config, clock).close()
    del adapters["/dev/ttyUSB7"]
    with pytest.raises(DeviceError) as caught:
        open_controller(config, clock)
    assert caught.value.code == "E-MOT-08"
    adapters["/dev/ttyUSB8"] = "A5069RR4"
    open_controller(config, clock).close()
