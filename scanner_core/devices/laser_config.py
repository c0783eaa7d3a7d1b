"""The laser of a rig file: where its light comes from, and whether it makes a spot or a line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from scanner_core.devices.rig_values import FAR_MM, array, number, one_of, only, text

SHAPES = ("spot", "line")
FAN_DEG = 10.0
"""Of a line whose rig file states no angle: 79 mm at 450 mm."""


@dataclass(frozen=True, slots=True)
class LaserConfig:
    """The laser, nominally.

    Attributes
    ----------
    position_mm, target_mm : the beam's pivot in the table frame, and the point that it hits at X0 Y0
    spot_diameter_mm : 1/e^2 diameter of the spot, or thickness of the line
    shape : ``spot``, or ``line``: a fan of light that stands upright and is panned
    fan_deg : full angle of the fan; None for a spot
    """

    position_mm: tuple[float, float, float]
    target_mm: tuple[float, float, float]
    spot_diameter_mm: float = 0.6
    shape: Literal["spot", "line"] = "spot"
    fan_deg: float | None = None

    def __post_init__(self) -> None:
        if (self.shape == "line") != (self.fan_deg is not None):
            raise ValueError("a laser line has an angle 'fan_deg', a spot has none")

    @property
    def is_line(self) -> bool:
        return self.shape == "line"


def read_laser(values: dict[str, Any]) -> LaserConfig:
    """The table ``[laser]``; ValueError, TypeError, KeyError or UsageError for anything else."""
    only(values, LaserConfig.__dataclass_fields__)
    diameter_mm = values.get("spot_diameter_mm", 0.6)
    if not 0 < number(diameter_mm, "spot_diameter_mm", -1e9, 1e9) < 20:
        raise ValueError(f"the laser's spot of {diameter_mm} mm is no spot")
    line = one_of(text(values, "shape", "spot"), "shape", SHAPES) == "line"
    fan_deg = number(values.get("fan_deg", FAN_DEG), "fan_deg", 0.5, 90.0) if line or "fan_deg" in values else None
    places = _triple(values, "position_mm"), _triple(values, "target_mm")
    return LaserConfig(*places, float(diameter_mm), "line" if line else "spot", fan_deg)


def _triple(values: Mapping[str, Any], key: str) -> tuple[float, float, float]:
    x, y, z = array(values[key], key, (3,), FAR_MM).tolist()
    return x, y, z
