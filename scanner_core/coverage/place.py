"""A place of the surface that is not as wanted: where it is, how large, and why."""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, atan2, degrees

from scanner_core.coverage.reason import Reason

Vector = tuple[float, float, float]

_STEEP_DEG = 50.0
"""Normals higher or lower than this are of the top and of the underside."""
_OVER_DEG = 75.0
"""Tilts larger than this are easier had by turning the object over."""


@dataclass(frozen=True, slots=True)
class CoveragePlace:
    """A connected part of the surface with one reason.

    Attributes
    ----------
    reason : why it is not within the wanted uncertainty
    centroid_mm, normal : of its area, object frame
    area_mm2 : of its triangles
    worst_um : largest standard uncertainty of a supported vertex in it; None where nothing in it is supported
    tilt_deg : by which the object would have to be tilted for most of it to be seen; None where no tilt helps or is needed
    """

    reason: Reason
    centroid_mm: Vector
    normal: Vector
    area_mm2: float
    worst_um: float | None
    tilt_deg: float | None = None

    @property
    def side(self) -> str:
        """``top``, ``side`` or ``underside``, by the normal."""
        elevation = degrees(asin(max(-1.0, min(1.0, self.normal[2]))))
        return "top" if elevation > _STEEP_DEG else "underside" if elevation < -_STEEP_DEG else "side"

    @property
    def table_deg(self) -> float:
        """Angle of the table at which it faces the laser."""
        return round(-degrees(atan2(self.normal[1], self.normal[0]))) % 360

    @property
    def words(self) -> str:
        """One sentence: where it is, why, and what would help.  :attr:`reason` and the numbers are what it is made of."""
        where = _WHERE[self.side].format(area_mm2=self.area_mm2, height_mm=self.centroid_mm[2], table_deg=self.table_deg)
        help_text = _HELP[self.reason]
        if self.tilt_deg is not None:
            turn = "turn the object over, or tilt it" if self.tilt_deg > _OVER_DEG else "tilt the object"
            help_text = f"{turn} by about {self.tilt_deg:.0f} deg"
        worst = f" (up to {self.worst_um:.0f} um)" if self.reason is Reason.FEW_POINTS and self.worst_um is not None else ""
        return f"{where}: {_WHY[self.reason]}{worst}; {help_text}."

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "reason": self.reason.value,
            "centroid_mm": [round(x, 2) for x in self.centroid_mm],
            "normal": [round(x, 3) for x in self.normal],
            "area_mm2": round(self.area_mm2, 2),
            "worst_um": None if self.worst_um is None else round(self.worst_um, 1),
            "side": self.side,
            "table_deg": self.table_deg,
            "tilt_deg": None if self.tilt_deg is None else round(self.tilt_deg),
            "words": self.words,
        }


_WHERE = {
    "top": "{area_mm2:.1f} mm2 on top, {height_mm:.0f} mm up",
    "side": "{area_mm2:.1f} mm2 on the side that faces the laser at {table_deg:.0f} deg of the table, {height_mm:.0f} mm up",
    "underside": "{area_mm2:.1f} mm2 on the underside, {height_mm:.0f} mm up",
}

_WHY = {
    Reason.WITHIN: "as wanted",
    Reason.FEW_POINTS: "there are too few points",
    Reason.BEAM_SHADOWED: "the object itself stands before the laser at every angle",
    Reason.LEFT_HIDDEN: "the object itself stands before the left camera wherever the laser gets there",
    Reason.RIGHT_HIDDEN: "the object itself stands before the right camera wherever the laser gets there",
    Reason.CAMERAS_HIDDEN: "there is no angle at which the laser gets there and both cameras see it",
    Reason.GRAZING: "the laser or a camera meets it too flatly at every angle",
    Reason.BELOW: "it looks down or lies on the table",
    Reason.OUT_OF_VIEW: "it is outside the cameras' images, the volume or the laser's range",
    Reason.TOO_DARK: "the laser's spot is too dark there",
    Reason.SATURATED: "the laser's spot is too bright there",
}

_HELP = dict.fromkeys(Reason, "put the object down in another way") | {
    Reason.WITHIN: "nothing is to do",
    Reason.FEW_POINTS: "scan on",
    Reason.OUT_OF_VIEW: "move the object to the middle of the table",
    Reason.TOO_DARK: "dust it with a matt white powder, or expose longer",
    Reason.SATURATED: "dust it with a matt powder, or expose shorter",
}
