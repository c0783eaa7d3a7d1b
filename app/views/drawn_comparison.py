"""A comparison made ready to draw, away from the GUI thread: a hundred thousand triangles take most of a second."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.views.drawn_surface import DrawnSurface
from app.views.line_actor import level_lines, outlines
from scanner_core.comparison.colour_scale import DeviationScale
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.deviation import Deviation
from scanner_core.geometry.mesh import TriangleMesh


@dataclass(frozen=True, slots=True, eq=False)
class DrawnComparison:
    """Everything about a comparison that takes time to draw.

    Attributes
    ----------
    before, after : in the frame of BEFORE
    scale : colours of the map
    outlines : of every area, lines as VTK has them or None
    """

    before: DrawnSurface
    after: DrawnSurface
    scale: DeviationScale
    outlines: tuple[Any, ...]

    @classmethod
    def of(cls, comparison: Comparison, threshold_um: float, before: DrawnSurface | None) -> DrawnComparison:
        """With an edge of the colours at the threshold; `before` when it was drawn already."""
        deviation, mesh = comparison.deviation, comparison.after.mesh
        if before is None or before.mesh is not comparison.before.mesh:
            before = DrawnSurface.of(comparison.before.mesh)
        after = DrawnSurface.of(TriangleMesh(comparison.alignment.transform.apply(mesh.vertices), mesh.triangles))
        scale = DeviationScale.fitting(deviation.signed_um, deviation.detection_level_um, threshold_um)
        return cls(before, after, scale, tuple(outline(after, area.vertices) for area in comparison.areas))


def outline(surface: DrawnSurface, vertices: NDArray[np.int64]) -> Any:
    """The border of vertices of a surface, lines as VTK has them or None."""
    return outlines(surface.mesh.vertices, surface.normals, surface.mesh.triangles, [vertices])


def threshold_lines(surface: DrawnSurface, signed_um: NDArray[np.float64], threshold_um: float) -> Any:
    """Where the deviation (v,) um, NaN without counterpart, reaches the threshold to either side; None for a threshold of 0."""
    levels: Sequence[float] = (-threshold_um, threshold_um)
    return level_lines(surface.mesh.vertices, surface.mesh.triangles, signed_um, levels) if threshold_um > 0 else None


def drawn_threshold(surface: DrawnSurface, deviation: Deviation, threshold_um: float) -> tuple[Any, DeviationScale]:
    """The lines of :func:`threshold_lines`, and colours that have an edge there."""
    scale = DeviationScale.fitting(deviation.signed_um, deviation.detection_level_um, threshold_um)
    return threshold_lines(surface, deviation.signed_um, threshold_um), scale
