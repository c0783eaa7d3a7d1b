"""What a calibration has found: the accepted calibration and everything that it rests on."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_change import CalibrationChange
from scanner_core.optics.stereo_calibration import StereoCalibrationFit
from scanner_core.optics.turntable_calibration import TurntableFit

_NOTED_BEND_MM = 0.1
_NOTED_PRINT = 2e-4
_NOTED_ANGLE_DEG = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationResult:
    """An accepted calibration; one that is not accepted is an exception, and never gets here.

    Attributes
    ----------
    calibration : to be used
    stereo, turntable : the fits behind it, in true millimetres
    change : against the previous calibration, or None when there was none
    """

    calibration: StereoCalibration
    stereo: StereoCalibrationFit
    turntable: TurntableFit
    change: CalibrationChange | None

    def findings(self) -> tuple[str, ...]:
        """What the board and the table are found to be; a sentence each."""
        found = []
        scale = self.calibration.scale
        if scale is not None and scale.source != "none" and abs(scale.print_scale - 1) >= _NOTED_PRINT:
            percent = 100 * (scale.print_scale - 1)
            found.append(f"The print is {abs(percent):.2f} % {'larger' if percent > 0 else 'smaller'} than its nominal size; this is corrected.")
        if self.stereo.board_bend_mm >= _NOTED_BEND_MM:
            found.append(f"The board is bent: its corners lie within {self.stereo.board_bend_mm:.2f} mm of height; this is taken into account.")
        worst = max(self.turntable.angle_errors_deg, key=abs)
        if abs(worst) >= _NOTED_ANGLE_DEG:
            at = self.turntable.table_deg[list(self.turntable.angle_errors_deg).index(worst)]
            found.append(f"The table stood {worst:+.3f} degrees off its reported angle at {at:.0f} degrees: backlash or lost steps.")
        return tuple(found)

    def warnings(self) -> tuple[str, ...]:
        """What limits the use of the calibration; a sentence each."""
        scale = self.calibration.scale
        if scale is None or scale.verified:
            return ()
        if scale.source == "print":
            return (f"Scale by a length measured on the print alone, to {scale.uncertainty_ppm:.0f} ppm: no second length has verified it.",)
        return (
            f"Scale not verified: no known length was shown, and the board's nominal size was believed ({scale.uncertainty_ppm:.0f} ppm, k = 1).",
        )
