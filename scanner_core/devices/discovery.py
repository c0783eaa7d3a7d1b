"""Which port is the controller's: every serial port of the machine is asked, and what it answered is listed.

Asking opens a port and may reset what sits on it, as every serial program does; nothing is moved and no laser is lit.
So it is done when a person asks for it, never at start-up.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum

from serial.tools import list_ports

from scanner_core.clock import Clock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import ControllerIdentity, open_controller
from scanner_core.errors import DeviceError


class PortState(Enum):
    """What a port turned out to be."""

    CONTROLLER = "a controller that the rig can use"
    UNSUITABLE = "a GRBL board that is set up for something else"
    OTHER = "something else"
    SILENT = "nothing answers"
    BUSY = "used by another program"
    NOT_PERMITTED = "this user may not open it"
    GONE = "it cannot be opened"


_STATES = {
    "E-MOT-03": PortState.BUSY,
    "E-MOT-07": PortState.OTHER,
    "E-MOT-08": PortState.GONE,
    "E-MOT-12": PortState.NOT_PERMITTED,
    "E-MOT-13": PortState.UNSUITABLE,
    "E-MOT-14": PortState.UNSUITABLE,
    "E-MOT-22": PortState.UNSUITABLE,
    "E-MOT-23": PortState.UNSUITABLE,
    "E-MOT-24": PortState.SILENT,
}


@dataclass(frozen=True, slots=True)
class SerialPort:
    """A port as the system lists it: `url` to open it, and the name of what is plugged in."""

    url: str
    description: str


@dataclass(frozen=True, slots=True, eq=False)
class PortAnswer:
    """What came of asking a port.

    Attributes
    ----------
    identity : of a controller that can be used
    error : of anything else, with its sentence and the transcript in its details
    """

    port: SerialPort
    state: PortState
    identity: ControllerIdentity | None = None
    error: DeviceError | None = None


def serial_ports() -> list[SerialPort]:
    """The serial ports of this machine, by name; nothing is opened."""
    return sorted((SerialPort(port.device, port.description or "") for port in list_ports.comports()), key=lambda port: port.url)


def ask_ports(ports: Iterable[SerialPort], clock: Clock, *, table_axis: str = "Z", baud: int = 115200) -> list[PortAnswer]:
    """Shake hands on every port, one after the other; up to about five seconds each.

    An answer for every port: one that cannot be used is a value, not an error.
    """
    return [_ask(port, clock, table_axis, baud) for port in ports]


def _ask(port: SerialPort, clock: Clock, table_axis: str, baud: int) -> PortAnswer:
    try:
        with open_controller(ControllerConfig("grbl", port.url, baud, table_axis), clock) as controller:
            return PortAnswer(port, PortState.CONTROLLER, controller.identity)
    except DeviceError as error:
        return PortAnswer(port, _STATES.get(error.code, PortState.OTHER), error=error)
