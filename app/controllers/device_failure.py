"""Which device keeps the rig from being open, and whether it is back."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.devices.rig import RigConfig

LEFT, RIGHT, CONTROLLER, RIG_FILE = "left", "right", "controller", "rig"

_GONE = {
    *("E-CAM-01", "E-CAM-02", "E-CAM-05", "E-CAM-07", "E-CAM-10"),
    *("E-MOT-01", "E-MOT-02", "E-MOT-03", "E-MOT-08", "E-MOT-09", "E-MOT-10"),
}
"""Unplugged, switched off, or held by another program: that may change without anybody's doing at this program.

Of all others a person has to do something first; and a port on which something else answers is better left alone: opening it resets what is there.
"""


@dataclass(frozen=True, slots=True, eq=False)
class DeviceFailure:
    """`device` is ``left``, ``right``, ``controller``, or ``rig`` when it is the rig file itself; `returns`: it is tried again by itself."""

    device: str
    fault: ImprontaError
    returns: bool = False

    def same_as(self, other: DeviceFailure | None) -> bool:
        """Nothing new to tell."""
        return other is not None and (self.device, str(self.fault), self.returns) == (other.device, str(other.fault), other.returns)


def is_simulated(config: RigConfig) -> bool:
    """Whether the controller is the firmware model in this process."""
    return config.controller.port.lower().startswith("virtual://")


def failure_of(fault: ImprontaError, config: RigConfig) -> DeviceFailure:
    """At which device it stands, by its code and fields."""
    device = CONTROLLER if fault.code.startswith("E-MOT") else RIG_FILE
    if fault.code.startswith("E-CAM"):
        named = str(fault.fields.get("camera", ""))
        by_driver = next((camera.name for camera in (config.left, config.right) if camera.driver == fault.fields.get("driver")), LEFT)
        device = named if named in (LEFT, RIGHT) else by_driver
    # The cable of a simulated controller stays pulled until a person puts it right.
    return DeviceFailure(device, fault, fault.code in _GONE and not is_simulated(config))


def is_back(failure: DeviceFailure, config: RigConfig) -> bool:
    """A gentle look in the device thread: the rig's other devices are not touched, and nothing of this one but that it is there."""
    if failure.device == CONTROLLER:
        return _is_plugged(config.controller.port)
    camera = config.left if failure.device == LEFT else config.right
    if camera.driver == "virtual":
        return True
    from scanner_core.clock import make_clock
    from scanner_core.devices.camera_drivers import open_camera

    try:
        open_camera(camera, make_clock(1.0)).close()
    except ImprontaError:
        return False
    return True


def _is_plugged(port: str) -> bool:
    """A URL can only be tried."""
    from scanner_core.devices.discovery import serial_ports

    return "://" in port or Path(port).exists() or any(known.url == port for known in serial_ports())
