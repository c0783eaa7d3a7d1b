"""The instrument's three axes on a board: degrees to words and back, limits, play, and how long a move may take."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl.identity import ControllerIdentity
from scanner_core.errors import UsageError

if TYPE_CHECKING:
    from scanner_core.devices.rig import LimitsConfig

X, Y, TABLE = 0, 1, 2
NAMES = ("beam x", "beam y", "the table")
Target = Mapping[int, float]
"""Degrees by axis; an axis that is missing stays where it is."""

SPARE_S = 5.0
_SLOW_UNITS_S, _LAZY_UNITS_S2 = 10.0, 10.0
"""What a board that does not tell its rates is given time for: GRBL's own defaults, about."""
_LAST_DIGIT_UNITS = 0.0015
"""A unit of the last digit of a status report, and some."""


class Axes:
    """Beam x, beam y and table of one board; all its methods take and give degrees and seconds."""

    def __init__(self, identity: ControllerIdentity, config: ControllerConfig, limits: LimitsConfig | None) -> None:
        self._identity, self._config = identity, config
        self._letters = ("X", "Y", config.table_axis.upper())
        self._places = tuple(identity.axes.index(letter) for letter in self._letters)
        self._units = config.units_per_deg
        self._allowed = (None, None, None) if limits is None else (limits.x_deg, limits.y_deg, limits.table_deg)
        self.work_offset: tuple[float, ...] = ()
        """Of the board's work coordinates against its machine coordinates, units; empty = not told, taken for none."""

    @property
    def count(self) -> int:
        """Numbers that a position must have."""
        return max(self._places) + 1

    def degrees(self, position: tuple[float, ...]) -> tuple[float, float, float]:
        """Beam x, beam y and table of a work position in the board's units."""
        x_deg, y_deg, table_deg = (position[place] / units for place, units in zip(self._places, self._units, strict=True))
        return x_deg, y_deg, table_deg

    def words(self, target: Target) -> str:
        """Axis words with a point and fixed decimals, whatever the locale."""
        return "".join(f"{self._letters[axis]}{value * self._units[axis]:.4f}" for axis, value in target.items())

    def resolution_deg(self, axis: int) -> float:
        """How far a position that was reached may lie beside the one that was asked for: a step, and the report's last digit."""
        steps = self._identity.steps_per_unit(self._places[axis])
        return ((0.0 if steps is None else 1.0 / steps) + _LAST_DIGIT_UNITS) / abs(self._units[axis])

    def same_place_deg(self, axis: int) -> float:
        """Within this two reports mean the same place."""
        return _LAST_DIGIT_UNITS / abs(self._units[axis])

    # ------------------------------------------------------------------------------------------ limits
    def check(self, target: Target) -> None:
        """Raises :class:`UsageError`: E-USE-01 for what is no number, E-MOT-21 outside of the limits of the rig or of the board."""
        for axis, value in target.items():
            if not math.isfinite(value):
                raise UsageError("E-USE-01", what=f"{value} is no position for {NAMES[axis]}", do="give a finite number of degrees")
            for whose, (low, high) in self._ranges(axis).items():
                slack = self.same_place_deg(axis)
                if not low - slack <= value <= high + slack:
                    raise UsageError("E-MOT-21", axis=NAMES[axis], target=f"{value:g}", whose=whose, low=f"{low:g}", high=f"{high:g}")

    def lowest_deg(self, axis: int) -> float:
        """How far down it may go to come back from below."""
        return max((low for low, _ in self._ranges(axis).values()), default=-math.inf)

    def allows(self, axis: int, value_deg: float) -> bool:
        return all(low <= value_deg <= high for low, high in self._ranges(axis).values())

    def _ranges(self, axis: int) -> dict[str, tuple[float, float]]:
        ranges: dict[str, tuple[float, float]] = {}
        allowed = self._allowed[axis]
        if allowed is not None:
            ranges["the limits of the rig file"] = allowed
        place, units = self._places[axis], self._units[axis]
        travel = self._identity.travel_range_units(place)
        if travel is not None:
            offset = self.work_offset[place] if len(self.work_offset) > place else 0.0
            first, last = sorted((value - offset) / units for value in travel)
            ranges[f"the controller's soft limits ($20, ${130 + place})"] = (first, last)
        return ranges

    # ------------------------------------------------------------------------------------------ play
    def approach(self, axis: int) -> float:
        return self._config.approach_deg[axis]

    def detour(self, here: Target, settled: Mapping[int, bool], target: Target) -> dict[int, float] | None:
        """Where to go first so that every axis arrives at `target` from below; None when it does anyway.

        An axis whose play is known to be taken out (`settled`) only needs it for a move downwards.  At the lower end of its
        limits an axis has nowhere to come from.
        """
        first = dict(target)
        for axis, value in target.items():
            enough = self.approach(axis)
            climb = value - here.get(axis, math.nan)
            if enough > 0.0 and not (climb >= enough or (settled.get(axis, False) and climb >= 0.0)):
                first[axis] = min(value, max(value - enough, self.lowest_deg(axis)))
        return first if first != dict(target) else None

    # ------------------------------------------------------------------------------------------ time
    def rate_deg_s(self, axis: int) -> float | None:
        """The board's own limit; None when it does not tell."""
        rate = self._identity.max_rate_units_s(self._places[axis])
        return None if rate is None else rate / abs(self._units[axis])

    def feed(self, delta: Target, speed_deg_s: float) -> float:
        """F word (units a minute along the path) of a straight move by `delta` degrees at a speed in degrees."""
        length_deg = math.hypot(*delta.values())
        length_units = math.hypot(*(value * self._units[axis] for axis, value in delta.items()))
        per_deg = length_units / length_deg if length_deg > 0.0 else abs(self._units[min(delta)])
        return 60.0 * speed_deg_s * per_deg

    def check_rate(self, delta: Target, speed_deg_s: float) -> None:
        """Raises :class:`UsageError`: it would move slower than planned."""
        if not speed_deg_s > 0.0:
            raise UsageError("E-USE-01", what=f"A speed of {speed_deg_s} deg/s goes nowhere", do="give a speed above 0")
        length = math.hypot(*delta.values())
        for axis, value in delta.items():
            rate = self.rate_deg_s(axis)
            if rate is not None and length > 0.0 and speed_deg_s * abs(value) / length > rate * 1.001:
                letter = self._letters[axis]
                raise UsageError(
                    "E-USE-01",
                    what=f"{speed_deg_s:g} deg/s is faster than axis {letter} of the controller ({rate:g} deg/s)",
                    do="lower the speed in the rig file",
                )

    def travel_s(self, delta: Target) -> float:
        """A deadline that a healthy board keeps at full rate: twice the time of the slowest axis, and some."""
        times = [0.0]
        for axis, value in delta.items():
            rate = self.rate_deg_s(axis) or _SLOW_UNITS_S / abs(self._units[axis])
            times.append((abs(value) if math.isfinite(value) else 0.0) / rate + rate / self._acceleration_deg_s2(axis))
        return 2.0 * max(times) + SPARE_S

    def sweep_s(self, delta: Target, speed_deg_s: float) -> float:
        """After which a move at a given speed is over, with some to spare."""
        length = math.hypot(*(value if math.isfinite(value) else 0.0 for value in delta.values()))
        return length / speed_deg_s + speed_deg_s / min(self._acceleration_deg_s2(axis) for axis in delta) + 0.5

    def braking_s(self) -> float:
        """From full rate to rest, of the axis that takes longest."""
        rates = [self.rate_deg_s(axis) or _SLOW_UNITS_S / abs(self._units[axis]) for axis in (X, Y, TABLE)]
        return max(rate / self._acceleration_deg_s2(axis) for axis, rate in enumerate(rates))

    def _acceleration_deg_s2(self, axis: int) -> float:
        return (self._identity.acceleration_units_s2(self._places[axis]) or _LAZY_UNITS_S2) / abs(self._units[axis])
