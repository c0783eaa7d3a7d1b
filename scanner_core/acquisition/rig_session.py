"""An open rig: two cameras, the controller and the clock that they share; real or virtual behind the same seams."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

from scanner_core.clock import Clock, Speed
from scanner_core.devices.camera import Camera
from scanner_core.devices.motion import MotionController
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import ImprontaError, UsageError
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens import Specimen

_numbers = itertools.count(1)


@dataclass(slots=True, eq=False)
class OpenRig:
    """Everything that a scan needs.  A context manager: leaving it switches the laser off and releases the devices.

    `bench` is the virtual rig, or None for hardware; only the person's operations on it (change the specimen, show the
    calibration board) go through it, never a measurement.
    """

    config: RigConfig
    left: Camera
    right: Camera
    motion: MotionController
    clock: Clock
    calibration: StereoCalibration | None
    bench: VirtualBench | None = None

    def close(self) -> None:
        """Laser and controller first, then the cameras."""
        for device in (self.motion, self.left, self.right):
            try:
                device.close()
            except ImprontaError:
                continue  # one device that fails to close must not keep the others open

    def __enter__(self) -> OpenRig:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def open_rig(config: RigConfig, specimen: Specimen | None = None, speed: Speed = "max", seed: int = 0) -> OpenRig:
    """Open the devices of a rig.

    Parameters
    ----------
    specimen : what stands on the virtual rig's table
    speed : of the virtual rig: 1, 5, or ``"max"``; ignored by hardware
    seed : of the virtual rig's noise

    Raises
    ------
    DeviceError, UsageError
    """
    if config.virtual is None:
        raise UsageError("E-RIG-01", path=config.name, reason=f"there is no driver for cameras of the kind '{config.left.driver}'")
    if config.virtual not in PRESETS:
        raise UsageError("E-RIG-01", path=config.name, reason=f"'virtual' must be one of {', '.join(PRESETS)}")
    return _open_virtual(config, specimen, speed, seed)
