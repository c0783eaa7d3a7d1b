"""Opening a port as a motion controller, also when the system has given it another name since."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from serial.tools import list_ports

from scanner_core.clock import Clock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl.controller import GrblController
from scanner_core.devices.laser_safety import STANDING_LASER_S
from scanner_core.devices.serial_port import BytePort, DirectPort
from scanner_core.errors import DeviceError

if TYPE_CHECKING:
    from scanner_core.devices.rig import LimitsConfig

_serial_numbers: dict[str, str] = {}
"""Of the USB adapters behind the ports that this program has opened: a cable that is plugged in again may get another name."""


def open_controller(
    config: ControllerConfig, clock: Clock, limits: LimitsConfig | None = None, *, standing_laser_s: float = STANDING_LASER_S
) -> GrblController:
    """Open the port, through a guardian unless it is virtual, and shake hands.

    A port that was open before and is gone is looked for by the serial number of its USB adapter.

    Parameters
    ----------
    limits : of the rig; a target outside of them is refused (E-MOT-21) before anything is sent.  None = the board's own alone

    Raises
    ------
    DeviceError
        E-MOT-03 busy, E-MOT-08 missing, E-MOT-12 not permitted, E-MOT-24 silent, E-MOT-07 no GRBL, E-MOT-23 too old, E-MOT-13 no
        laser mode, E-MOT-22 full power unknown, E-MOT-14 axis.
    """
    can_burn = not config.port.lower().startswith("virtual://")
    port = _open(config) if can_burn else DirectPort(config.port, config.baud)
    return GrblController(port, config, clock, limits, standing_laser_s=standing_laser_s, watched=can_burn)


def _open(config: ControllerConfig) -> BytePort:
    from scanner_core.devices.guardian import GuardedPort

    try:
        port = GuardedPort(config.port, config.baud)
    except DeviceError as fault:
        elsewhere = _elsewhere(config.port) if fault.code == "E-MOT-08" else ""
        if not elsewhere:
            raise
        return GuardedPort(elsewhere, config.baud)
    if number := _adapters().get(os.path.realpath(config.port)):
        _serial_numbers[config.port] = number
    return port


def _elsewhere(name: str) -> str:
    """The port that the adapter which was behind `name` has now."""
    number = _serial_numbers.get(name)
    found = [device for device, other in _adapters().items() if other == number]
    return found[0] if len(found) == 1 else ""


def _adapters() -> dict[str, str]:
    """Serial numbers of the USB adapters that are plugged in, by the real names of their ports."""
    return {os.path.realpath(port.device): port.serial_number for port in list_ports.comports() if port.serial_number}
