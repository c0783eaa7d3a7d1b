"""What a rig file says of the motion controller."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ControllerConfig:
    """The motion controller; `port` is a serial device or a pyserial URL.

    Attributes
    ----------
    table_axis : letter of the axis that turns the table
    units_per_deg : of beam x, beam y and table: how many units of the board (its "mm") make a degree; negative turns the direction round
    approach_deg : play of beam x, beam y and table is taken out by arriving from below: a move downwards goes so far beyond first;
        0 = the play of that axis does not matter
    witness : the side channel (``host:port``) of a firmware model in a process of its own: the virtual cameras see the beam through
        it.  Empty for hardware and for the firmware model inside this process.
    """

    driver: str
    port: str
    baud: int = 115200
    table_axis: str = "Z"
    units_per_deg: tuple[float, float, float] = (1.0, 1.0, 1.0)
    approach_deg: tuple[float, float, float] = (0.0, 0.0, 1.0)
    witness: str = ""
