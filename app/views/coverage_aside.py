"""A surface coloured by why its places are not as certain as wanted, with one place marked.  Import it when the 3D view is there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.palettes import DARK
from app.views.coverage_words import ACCEPTED_COLOUR, REASON_COLOURS
from app.views.line_actor import LineActor, outlines
from app.views.mesh_actor import MeshActor
from app.views.surface import Surface
from app.views.surface_colours import rgb
from scanner_core.coverage.reason import REASONS
from scanner_core.coverage.report import CoverageReport


class CoverageAside:
    """One answer."""

    slices = None

    def __init__(self, surface: Surface, report: CoverageReport) -> None:
        self.surface, self._report = surface, report
        self._mesh = MeshActor()
        self._mesh.show(surface)
        look = self._mesh.actor.GetProperty()
        look.SetAmbient(0.4)  # what looks down has its colour too
        look.SetDiffuse(0.6)
        self._rim = (LineActor(DARK.ground, 6.0, behind=True), LineActor("#ffffff", 3.2))
        self.colour(by_uncertainty=False)

    @property
    def actors(self) -> Sequence[Any]:
        return [self._mesh.actor, *(line.actor for line in self._rim)]

    @property
    def bounds_mm(self) -> NDArray[np.float64] | None:
        return np.array(self.surface.mesh.bounds())

    @property
    def range_um(self) -> tuple[float, float] | None:
        return self._mesh.range_um

    def fit_pixels(self, ratio: float) -> None:
        for line in self._rim:
            line.set_pixel_ratio(ratio)

    def colour(self, *, by_uncertainty: bool, accepted: Sequence[int] = ()) -> None:
        """By the standard uncertainty, or by the reason; places that are `accepted`, by number, in a colour of their own."""
        table = np.array([rgb(REASON_COLOURS[reason]) for reason in REASONS], np.uint8)
        painted = table[self._report.reasons]
        for number in accepted:
            painted[self._report.members[number]] = rgb(ACCEPTED_COLOUR)
        self._mesh.paint_vertices(None if by_uncertainty else painted)
        self._mesh.show_uncertainty(by_uncertainty)

    def mark(self, vertices: NDArray[np.int64] | None) -> None:
        """Outline these."""
        mesh = self.surface.mesh
        lines = None if vertices is None else outlines(mesh.vertices, self.surface.normals, mesh.triangles, [vertices])
        for line in self._rim:
            line.show_poly(lines)
