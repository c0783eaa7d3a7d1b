"""What is known of the rig, as one frozen value."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from scanner_core.devices.motion import MotionStatus
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.devices.rig import RigConfig
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.optics.calibration import StereoCalibration
    from scanner_core.optics.calibration_result import CalibrationResult


@dataclass(frozen=True, slots=True, eq=False)
class RigSnapshot:
    """What is known of the rig.

    Attributes
    ----------
    preset, specimen, speed : what was chosen; `specimen` is a name or a file's path
    config : the rig as it is used, with its calibration; None until it was read
    connected : cameras and controller are open
    busy : a scan owns it
    motion : the controller's newest report
    calibrating, calibration_left_s : progress of the running calibration, 0 to 1, or None; estimate of the rest
    cancelling : the running calibration was asked to end
    found, refused : what the last calibration of this rig has found, or why it was not accepted; None before there is one
    sphere : the last test with the reference sphere, as of when the rig was opened; None when there is none
    specimen_radius_mm, specimen_height_mm : of what stands on the virtual table
    """

    preset: str = "bench"
    specimen: str = "ear"
    speed: str = "max"
    config: RigConfig | None = None
    connected: bool = False
    busy: bool = False
    motion: MotionStatus | None = None
    calibrating: float | None = None
    calibration_left_s: float | None = None
    cancelling: bool = False
    found: CalibrationResult | None = None
    refused: ImprontaError | None = None
    sphere: SphereTrend | None = None
    specimen_radius_mm: float | None = None
    specimen_height_mm: float | None = None

    @property
    def calibration(self) -> StereoCalibration | None:
        return None if self.config is None else self.config.calibration
