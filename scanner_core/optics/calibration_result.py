"""What a calibration has found: the accepted calibration and everything that it rests on."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_change import CalibrationChange
from scanner_core.optics.stereo_calibration import StereoCalibrationFit
from scanner_core.optics.turntable_calibration import TurntableFit

_NOTED_BEND_MM = 0.1
_NOTED_PRINT = 2e-4
_NOTED_ANGLE_DEG = 0.02


class FindingKind(Enum):
    """What can be found; the value is the sentence with its fields, by which a window translates it."""

    PRINT_LARGER = "The print is {percent} % larger than its nominal size; this is corrected."
    PRINT_SMALLER = "The print is {percent} % smaller than its nominal size; this is corrected."
    BOARD_BENT = "The board is bent: its corners lie within {bend_mm} mm of height; this is taken into account."
    TABLE_OFF = "The table stood {error_deg} degrees off its reported angle at {table_deg} degrees: backlash or lost steps."
    SCALE_BY_PRINT = "Scale by a length measured on the print alone, to {ppm} ppm: no second length has verified it."
    SCALE_UNVERIFIED = "Scale not verified: no known length was shown, and the board's nominal size was believed ({ppm} ppm, k = 1)."

    @property
    def limits(self) -> bool:
        """It limits the use of the calibration: a warning."""
        return self in (FindingKind.SCALE_BY_PRINT, FindingKind.SCALE_UNVERIFIED)


@dataclass(frozen=True, slots=True)
class Finding:
    """One of them, with the figures as they are written."""

    kind: FindingKind
    fields: dict[str, str]

    def words(self) -> str:
        """The sentence."""
        return self.kind.value.format(**self.fields)


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
        return tuple(found.words() for found in self.found() if not found.kind.limits)

    def warnings(self) -> tuple[str, ...]:
        """What limits the use of the calibration; a sentence each."""
        return tuple(found.words() for found in self.found() if found.kind.limits)

    def found(self) -> tuple[Finding, ...]:
        """All of them as values."""
        found = list(scale_findings(self.calibration))
        if self.stereo.board_bend_mm >= _NOTED_BEND_MM:
            found.append(Finding(FindingKind.BOARD_BENT, {"bend_mm": f"{self.stereo.board_bend_mm:.2f}"}))
        worst = max(self.turntable.angle_errors_deg, key=abs)
        if abs(worst) >= _NOTED_ANGLE_DEG:
            at = self.turntable.table_deg[list(self.turntable.angle_errors_deg).index(worst)]
            found.append(Finding(FindingKind.TABLE_OFF, {"error_deg": f"{worst:+.3f}", "table_deg": f"{at:.0f}"}))
        return tuple(found)


def scale_findings(calibration: StereoCalibration) -> tuple[Finding, ...]:
    """What a calibration says of the size of the print and of what its scale rests on."""
    scale, found = calibration.scale, []
    if scale is None:
        return ()
    if scale.source != "none" and abs(scale.print_scale - 1) >= _NOTED_PRINT:
        percent = 100 * (scale.print_scale - 1)
        found.append(Finding(FindingKind.PRINT_LARGER if percent > 0 else FindingKind.PRINT_SMALLER, {"percent": f"{abs(percent):.2f}"}))
    if not scale.verified:
        kind = FindingKind.SCALE_BY_PRINT if scale.source == "print" else FindingKind.SCALE_UNVERIFIED
        found.append(Finding(kind, {"ppm": f"{scale.uncertainty_ppm:.0f}"}))
    return tuple(found)
