"""GRBL 1.1 and grblHAL boards as motion controllers: beam on X and Y, table on Z or A, laser on the spindle output."""

from scanner_core.devices.grbl.controller import GrblController
from scanner_core.devices.grbl.identity import ControllerIdentity, FirmwareFamily
from scanner_core.devices.grbl.opening import open_controller

__all__ = ["ControllerIdentity", "FirmwareFamily", "GrblController", "open_controller"]
