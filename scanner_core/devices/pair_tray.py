"""The pair tray: a plate with a seat for each ear's impression, so that both are measured in one run.

It lies on the table with its arrow at the table's reference, so each seat has a fixed place in the object frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import Literal

Side = Literal["left", "right"]


@dataclass(frozen=True, slots=True)
class Seat:
    """Where one ear's impression stands, object frame."""

    side: Side
    x_mm: float
    y_mm: float


@dataclass(frozen=True, slots=True)
class PairTray:
    """A tray with a seat for each ear.

    Attributes
    ----------
    seats : the left ear's and the right ear's
    clear_mm : a strip half way between the seats, so wide, that holds no point
    least_share : of all points that a seat holds at least
    """

    seats: tuple[Seat, Seat]
    clear_mm: float = 2.0
    least_share: float = 0.1

    @property
    def radius_mm(self) -> float:
        """About the axis, of what stands on the seats when an impression is up to 26 mm across."""
        return max(hypot(seat.x_mm, seat.y_mm) for seat in self.seats) + 13.0


PAIR_TRAY = PairTray((Seat("left", -21.0, 0.0), Seat("right", 21.0, 0.0)))
"""The tray that is described in the guide and that the virtual pair stands on."""
