"""What lies under the pointer of a comparison's 3D view."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Pointed:
    """A point of one of the two surfaces.

    Attributes
    ----------
    surface : ``before`` or ``after``
    vertex : the corner nearest to the point, an index of that surface's vertices
    point_mm : in the frame of BEFORE
    signed_um : deviation there, + outward; None without a counterpart, without a map, or on the before surface
    level_um : level of detection there; None without a map or on the before surface
    """

    surface: str
    vertex: int
    point_mm: tuple[float, float, float]
    signed_um: float | None
    level_um: float | None
