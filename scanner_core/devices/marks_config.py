"""The fixed marks of a rig, as its file tells of them in the table ``[marks]``: three balls on the rim of the table.

The places are nominal: they serve to find the balls.  What is compared is where the balls were measured before, and the
distances of their centres where somebody has calibrated them.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import resources
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.rig_values import array, number, only
from scanner_core.toml_text import parse_toml, toml_value

Array = NDArray[np.float64]

BALLS = 3
PAIRS = ((0, 1), (1, 2), (2, 0))
"""Balls whose distance is the first, second and third one."""
_LEAST_GAP_DEG = 30.0
_UNLIKE_DEG = 5.0
"""Gaps between neighbours differ by so much, or a table that is turned by one ball would look as before."""
_BESIDE_MM = 3.0
"""A ball stands at most so far beside its nominal place."""
_NEAR_NOMINAL = 0.05
"""A calibrated distance that is farther from the nominal one, in parts of it, is of other balls."""


@dataclass(frozen=True, slots=True)
class MarksConfig:
    """Three balls of one diameter on a circle about the table's axis, which turn with the table.

    Attributes
    ----------
    diameter_mm : of each ball
    radius_mm : of the circle on which their centres stand
    azimuth_deg : of the three centres in the object frame (the table at 0), rising
    height_mm : of the centres over the table
    distances_mm : calibrated distances of the centres 1-2, 2-3 and 3-1, or None
    distance_uncertainty_um : standard uncertainty of each of them
    """

    diameter_mm: float
    radius_mm: float
    azimuth_deg: tuple[float, float, float]
    height_mm: float
    distances_mm: tuple[float, float, float] | None = None
    distance_uncertainty_um: float = 5.0

    def __post_init__(self) -> None:
        gaps = np.diff([*self.azimuth_deg, self.azimuth_deg[0] + 360.0])
        if gaps.min() < _LEAST_GAP_DEG:
            raise ValueError(f"'azimuth_deg' must rise from ball to ball by at least {_LEAST_GAP_DEG:g} degrees within one turn")
        if min(abs(gaps[i] - gaps[j]) for i, j in PAIRS) < _UNLIKE_DEG:
            told = f"the gaps of 'azimuth_deg' ({', '.join(f'{gap:g}' for gap in gaps)} degrees) must differ by at least {_UNLIKE_DEG:g} degrees"
            raise ValueError(f"{told}, or a table that lost a third of a turn would look as before")
        if self.radius_mm <= self.diameter_mm:
            raise ValueError("'radius_mm' must be larger than the balls' diameter")
        for known, nominal, (i, j) in zip(self.distances_mm or (), self.nominal_distances_mm(), PAIRS, strict=False):
            if abs(known - nominal) > _NEAR_NOMINAL * nominal:
                raise ValueError(f"'distances_mm' of balls {i + 1} and {j + 1} is {known:g} mm, but by their places it is {nominal:.1f} mm")

    @property
    def ball_radius_mm(self) -> float:
        return 0.5 * self.diameter_mm

    def places_mm(self) -> Array:
        """Nominal centres (3, 3) mm, object frame: a ball a row."""
        turn = np.radians(self.azimuth_deg)
        return np.asarray(np.c_[self.radius_mm * np.cos(turn), self.radius_mm * np.sin(turn), np.full(BALLS, self.height_mm)], np.float64)

    def nominal_distances_mm(self) -> Array:
        """Of the nominal centres, (3,) in the order of :data:`PAIRS`."""
        return distances_mm(self.places_mm())

    def holds(self, points: Array) -> NDArray[np.bool_]:
        """Whether points (n, 3) mm of the object frame may be of a ball, or of what it stands on: within so much of a nominal place."""
        away = np.linalg.norm((points[:, None, :] - self.places_mm())[:, :, :2], axis=2).min(axis=1)
        near: NDArray[np.bool_] = (away < self.ball_radius_mm + _BESIDE_MM) & (points[:, 2] < self.height_mm + self.ball_radius_mm + _BESIDE_MM)
        return near

    def check_beside(self, volume_radius_mm: float) -> None:
        """ValueError when a ball reaches into the cylinder that is the object's."""
        if self.radius_mm - self.ball_radius_mm <= volume_radius_mm:
            least = volume_radius_mm + self.ball_radius_mm
            raise ValueError(f"in [marks] 'radius_mm' must be more than {least:g} mm, or the balls reach into the volume of the object")


def distances_mm(centres: Array) -> Array:
    """Distances (3,) of three centres (3, 3) mm in the order of :data:`PAIRS`."""
    return np.array([float(np.linalg.norm(centres[i] - centres[j])) for i, j in PAIRS], np.float64)


def read_marks(values: dict[str, Any]) -> MarksConfig:
    """Of a rig file's table; KeyError or ValueError when it cannot be such."""
    only(values, MarksConfig.__dataclass_fields__)
    first, second, third = array(values["azimuth_deg"], "azimuth_deg", (BALLS,), 360.0).tolist()
    known = array(values["distances_mm"], "distances_mm", (BALLS,), 1e4).tolist() if "distances_mm" in values else None
    return MarksConfig(
        diameter_mm=number(values["diameter_mm"], "diameter_mm", 1.0, 100.0),
        radius_mm=number(values["radius_mm"], "radius_mm", 1.0, 1e4),
        azimuth_deg=(first, second, third),
        height_mm=number(values["height_mm"], "height_mm", 0.0, 1e3),
        distances_mm=None if known is None else (known[0], known[1], known[2]),
        distance_uncertainty_um=number(values.get("distance_uncertainty_um", 5.0), "distance_uncertainty_um", 0.01, 1e4),
    )


def dump_marks(marks: MarksConfig | None) -> list[str]:
    """Lines of TOML; :func:`read_marks` of them gives the same values to the last bit."""
    if marks is None:
        return []
    written = {name: getattr(marks, name) for name in marks.__dataclass_fields__}
    return ["", "[marks]", *(f"{name} = {toml_value(value)}" for name, value in written.items() if value is not None)]


def shipped_marks(preset: str) -> MarksConfig:
    """Those of a rig that is shipped with the program, which has none unless they are asked for."""
    text = (resources.files("resources") / "marks" / f"{preset}.toml").read_text(encoding="utf-8")
    return read_marks(parse_toml(text)["marks"])
