"""How old a calibration is, and whether it may still be used."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from enum import Enum

from scanner_core import wall_clock
from scanner_core.optics.calibration import StereoCalibration

EXPIRING = 0.2
"""Last part of the validity in which a renewal is asked for."""


class AgeState(Enum):
    """What its age says about a calibration."""

    VALID = "valid"
    EXPIRING = "expiring"
    EXPIRED = "expired"


@dataclass(frozen=True, slots=True)
class CalibrationAge:
    """A calibration's age.

    Attributes
    ----------
    days, days_left : since it was made, and until it expires (negative when it has)
    state : valid, expiring (in the last fifth of its time) or expired
    """

    days: float
    days_left: float
    state: AgeState

    def words(self) -> str:
        """One sentence."""
        if self.state is AgeState.EXPIRED:
            return f"It expired {-self.days_left:.0f} days ago."
        if self.state is AgeState.EXPIRING:
            return f"It expires in {self.days_left:.0f} days."
        return f"It is valid for {self.days_left:.0f} more days."


def calibration_age(calibration: StereoCalibration, now: datetime | None = None) -> CalibrationAge:
    """The age at `now` (an aware time; the present when None).

    A date in the future (a clock that was set back) counts as today.

    Raises
    ------
    ValueError
        When the calibration's date is no ISO 8601 date.
    """
    made = datetime.fromisoformat(calibration.date).astimezone()
    days = max(0.0, ((now or wall_clock.now()) - made).total_seconds() / 86400)
    left = calibration.valid_days - days
    state = AgeState.EXPIRED if left < 0 else AgeState.EXPIRING if left < EXPIRING * calibration.valid_days else AgeState.VALID
    return CalibrationAge(days, left, state)
