"""Where beam and table of the virtual rig are at an instant: the seam between the firmware model and the scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol


@dataclass(frozen=True, slots=True)
class MotionInstant:
    """The mechanics at one instant of the rig's clock.

    `laser_power` is 0 when dark, 1 at full power: what the diode emits, not what was asked for.
    """

    x_deg: float
    y_deg: float
    table_deg: float
    laser_power: float


class MotionTimeline(Protocol):
    """Who can tell where the mechanics were at an instant not later than now (the firmware model, near or remote)."""

    def instant(self, time_s: float) -> MotionInstant: ...
