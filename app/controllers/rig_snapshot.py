"""What is known of the rig, as one frozen value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from app.controllers.device_failure import DeviceFailure, is_simulated
from scanner_core.devices.camera import CameraReport
from scanner_core.devices.motion import MotionStatus
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.devices.rig import RigConfig
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.optics.calibration import StereoCalibration
    from scanner_core.optics.calibration_result import CalibrationResult

PRESETS: tuple[str, ...] = ("bench", "paper-2003", "workshop")
"""The rigs that are shipped with the program; any other name is the path of a rig file."""


@dataclass(frozen=True, slots=True, eq=False)
class RigSnapshot:
    """What is known of the rig.

    Attributes
    ----------
    preset : what was chosen: a preset's name, or the path of a rig file
    specimen, speed : what was chosen for the virtual rig; `specimen` is a name or a file's path
    pose : how the virtual specimen was put down; None as it came
    config : the rig as it is used, with its calibration; None until it was read
    connected : cameras and controller are open
    failure : what keeps it from being open, and at which device
    opening : somebody is opening it just now
    busy : a scan owns it, or the measurement of the reference sphere
    aiming : a person aims by the live pictures, and has lit the laser
    motion : the controller's newest report
    needs_homing : the controller does not know its position, and can find it
    acting : what the controller does because a person asked: ``home``, ``unlock``, or nothing
    cameras : what each camera says of itself, by its name, as of when it was opened
    controller : what the controller said of itself then: ``port``, ``firmware``, ``axes``, ``laser_mode``
    calibrating, calibration_left_s : progress of the running calibration, 0 to 1, or None; estimate of the rest
    by_hand : a person shows the board
    cancelling : the running calibration was asked to end
    found, refused : what the last calibration of this rig has found, or why it was not accepted; None before there is one
    sphere : the last test with the reference sphere, as of when the rig was opened or it was measured here; None when there is none
    specimen_radius_mm, specimen_height_mm : of what stands on the virtual table
    """

    preset: str = "bench"
    specimen: str = "ear"
    speed: str = "max"
    pose: str | None = None
    config: RigConfig | None = None
    connected: bool = False
    failure: DeviceFailure | None = None
    opening: bool = False
    busy: bool = False
    aiming: bool = False
    motion: MotionStatus | None = None
    needs_homing: bool = False
    acting: str = ""
    cameras: Mapping[str, CameraReport] = field(default_factory=dict)
    controller: Mapping[str, object] = field(default_factory=dict)
    calibrating: float | None = None
    calibration_left_s: float | None = None
    by_hand: bool = False
    cancelling: bool = False
    found: CalibrationResult | None = None
    refused: ImprontaError | None = None
    sphere: SphereTrend | None = None
    specimen_radius_mm: float | None = None
    specimen_height_mm: float | None = None

    @property
    def calibration(self) -> StereoCalibration | None:
        return None if self.config is None else self.config.calibration

    @property
    def at_rest(self) -> bool:
        """Open, and nobody does anything with it."""
        return self.connected and not self.busy and not self.aiming and not self.acting and self.calibrating is None

    @property
    def unreadable(self) -> bool:
        """There is no rig, only a file that cannot be used: nothing is known of devices and calibration."""
        return self.config is None and self.failure is not None

    @property
    def own(self) -> bool:
        """A rig file of somebody, no preset."""
        return self.preset not in PRESETS

    @property
    def virtual(self) -> bool:
        """Its scene is computed, so that a specimen can be chosen; of a rig file that was not read yet it is not known, and not said."""
        return not self.own if self.config is None else "virtual" in (self.config.left.driver, self.config.right.driver)

    @property
    def simulated(self) -> bool:
        """Its controller is computed, too: it has a speed of its own, and faults can be rehearsed."""
        return self.virtual and (self.config is None or is_simulated(self.config))


def shown_of(status: MotionStatus | None) -> tuple[object, ...]:
    """What the window shows of a controller's report."""
    return () if status is None else (status.state, status.table_deg, status.laser_power > 0.0)
