"""What a technician has set up in the firmware model: rates, accelerations, switches, laser mode."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class FirmwareSettings:
    """The state of a board before the host connects.

    Attributes
    ----------
    axes : letters in the order of the status report; X and Y carry the beam
    table_axis : which of them turns the table
    max_rate_deg_min, acceleration_deg_s2, max_travel_deg : for every axis (``$110..``, ``$120..``, ``$130..``)
    work_offset_deg : of the work coordinates (G54) against the machine's, for every axis; empty = none
    spindle_max : S value of full power (``$30``)
    laser_mode : ``$32``
    programmed_power : the status tells the power that was programmed, under M4 also at rest, as grblHAL does; GRBL tells what it emits
    homing : ``$22``; False makes ``$H`` an error
    homing_switches : False lets homing end in ALARM:8
    locked_at_start : power-up in ALARM until ``$H`` or ``$X`` (HOMING_INIT_LOCK)
    resets_on_connect : the port's DTR line resets the board, as on an AVR with a boot loader
    position_survives_reset : False makes a reset by DTR forget the position, as on an AVR; the mechanics stay where they are
    boot_s : silence between a reset by DTR and the banner
    baud : every byte takes 10 bits of it, both ways
    banner, version : how the board introduces itself
    """

    axes: str = "XYZ"
    table_axis: str = "Z"
    max_rate_deg_min: tuple[float, ...] = (12000.0, 12000.0, 3600.0)
    acceleration_deg_s2: tuple[float, ...] = (4000.0, 4000.0, 360.0)
    max_travel_deg: tuple[float, ...] = (90.0, 90.0, 3600.0)
    work_offset_deg: tuple[float, ...] = ()
    spindle_max: float = 1000.0
    laser_mode: bool = True
    programmed_power: bool = False
    soft_limits: bool = False
    homing: bool = True
    homing_switches: bool = True
    locked_at_start: bool = False
    resets_on_connect: bool = True
    position_survives_reset: bool = True
    boot_s: float = 0.3
    baud: int = 115200
    banner: str = "Grbl 1.1h ['$' for help]"
    version: str = "1.1h.20190830"

    def __post_init__(self) -> None:
        sizes = {len(self.axes), len(self.max_rate_deg_min), len(self.acceleration_deg_s2), len(self.max_travel_deg)}
        if len(sizes) != 1 or self.table_axis not in self.axes or not self.axes.startswith("XY"):
            raise ValueError("every axis needs a rate, an acceleration and a travel; X and Y come first; the table must be one of the axes")

    @property
    def offset(self) -> tuple[float, ...]:
        """The work offset of every axis."""
        return self.work_offset_deg or (0.0,) * len(self.axes)

    def numbered(self) -> dict[int, float]:
        """The values of ``$$``."""
        values = {
            0: 10.0, 1: 25.0, 2: 0.0, 3: 0.0, 4: 0.0, 5: 0.0, 6: 0.0, 10: 1.0, 11: 0.01, 12: 0.002, 13: 0.0,
            20: float(self.soft_limits), 21: 0.0, 22: float(self.homing), 23: 0.0, 24: 600.0, 25: 6000.0, 26: 250.0, 27: 1.0,
            30: self.spindle_max, 31: 0.0, 32: float(self.laser_mode),
        }  # fmt: skip
        for axis in range(len(self.axes)):
            values[100 + axis] = 250.0
            values[110 + axis] = self.max_rate_deg_min[axis]
            values[120 + axis] = self.acceleration_deg_s2[axis]
            values[130 + axis] = self.max_travel_deg[axis]
        return dict(sorted(values.items()))


INTEGER_SETTINGS = frozenset({0, 1, 2, 3, 4, 5, 6, 10, 13, 20, 21, 22, 23, 26, 30, 31, 32})
"""Settings that ``$$`` prints without decimals ($30 and $31 in the way of this model)."""
