"""A place of the surface that is not as wanted: where it is, how large, and why."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.coverage.reason import Reason

Vector = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class CoveragePlace:
    """A connected part of the surface with one reason.

    Attributes
    ----------
    reason : why it is not within the wanted uncertainty
    centroid_mm, normal : of its area, object frame
    area_mm2 : of its triangles
    worst_um : largest standard uncertainty of a supported vertex in it; None where nothing in it is supported
    words : one sentence: where it is, why, and what would help
    """

    reason: Reason
    centroid_mm: Vector
    normal: Vector
    area_mm2: float
    worst_um: float | None
    words: str

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {
            "reason": self.reason.value,
            "centroid_mm": [round(x, 2) for x in self.centroid_mm],
            "normal": [round(x, 3) for x in self.normal],
            "area_mm2": round(self.area_mm2, 2),
            "worst_um": None if self.worst_um is None else round(self.worst_um, 1),
            "words": self.words,
        }
