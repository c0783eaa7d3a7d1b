"""What is marked on the surfaces of a comparison: areas with their ranks, the marked tooth, landmarks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF

from app.theme import GROUND, TEXT
from app.views.compared_actor import ComparedActor
from app.views.comparison_overlay import ComparisonOverlay, Tag
from app.views.line_actor import LineActor, level_lines, outlines
from app.views.surface_picker import SurfacePicker
from app.views.viewpoint import Viewpoint
from scanner_core.comparison.area import Area
from scanner_core.comparison.colour_scale import THRESHOLD_LINE

Array = NDArray[np.float64]
Landmark = tuple[str, Sequence[float]] | tuple[str, Sequence[float], str]
"""Name, place (mm, frame of BEFORE), and the surface in whose picture it stands: ``after`` unless ``before`` is said."""
_PART = "#a45cff"
_AWAY_PX = 34.0
"""From the middle of an area to its rank, so that the rank covers nothing of it."""


class ComparisonMarks:
    """Outlines on the after surface, and words in the overlay."""

    def __init__(self, after: ComparedActor, overlay: ComparisonOverlay) -> None:
        self._after, self._overlay = after, overlay
        self._outlines, self._part_outline = LineActor(TEXT, 1.4), LineActor(_PART, 4.0)
        self._chosen_outline = (LineActor(GROUND, 6.0, behind=True), LineActor("#ffffff", 3.2))
        self._threshold = LineActor("#{:02x}{:02x}{:02x}".format(*THRESHOLD_LINE), 1.8, behind=True)
        self.lines = (self._threshold, *self._chosen_outline, self._outlines, self._part_outline)
        self._areas: tuple[Area, ...] = ()
        self._chosen: int | None = None
        self._landmarks: list[tuple[str, Array, str]] = []
        self._landmark_lines: list[tuple[int, int]] = []

    def clear(self) -> None:
        self.show_areas(())
        self.show_part(None)
        self.show_landmarks((), ())

    def show_areas(self, areas: Sequence[Area]) -> None:
        self._areas = tuple(areas)
        self.choose(None)

    def choose(self, rank: int | None) -> None:
        self._chosen = rank
        self._draw((self._outlines,), [area.vertices for area in self._areas if area.rank != rank])
        self._draw(self._chosen_outline, [area.vertices for area in self._areas if area.rank == rank])

    def show_part(self, vertices: NDArray[np.int64] | None) -> None:
        self._draw((self._part_outline,), [] if vertices is None else [vertices])

    def show_landmarks(self, points: Sequence[Landmark], lines: Sequence[tuple[int, int]]) -> None:
        self._landmarks = [(mark[0], np.asarray(mark[1], np.float64), mark[2] if len(mark) > 2 else "after") for mark in points]
        self._landmark_lines = list(lines)

    def set_seen(self, after: bool, coloured: bool) -> None:
        """Whether the after surface is in the picture at its place, and as a map."""
        for line in self.lines:
            line.set_shown(after and (coloured or line is not self._threshold))

    def show_threshold(self, signed_um: Array, threshold_um: float) -> None:
        """Where the deviation (v,) um reaches the threshold to either side; 0 for no line."""
        mesh = self._after.mesh
        shown = mesh is not None and len(signed_um) == len(mesh.vertices) and threshold_um > 0
        self._threshold.show_poly(level_lines(mesh.vertices, mesh.triangles, signed_um, (-threshold_um, threshold_um)) if mesh and shown else None)

    @property
    def worded(self) -> bool:
        """Something has a word in the picture."""
        return bool(self._areas or self._landmarks)

    def place(self, first: Viewpoint, view: Viewpoint, picker: SurfacePicker | None) -> None:
        """The words where the camera has their points now, before in the `first` picture; what is hidden is faint."""
        tags: list[Tag] = []
        middle = np.zeros(2) if self._after.mesh is None else view.project(0.5 * np.sum(self._after.mesh.bounds(), axis=0)[None])[0]
        for area in self._areas:
            place = view.project(np.asarray(area.centroid_mm)[None])[0]
            out = place - middle
            at, spot = QPointF(*place), QPointF(*(place + _AWAY_PX * out / max(float(np.hypot(*out)), 1e-6)))
            above = np.asarray(area.centroid_mm) + 0.8 * np.asarray(area.normal)
            faint = picker is not None and not picker.visible(above, view)
            tags.append(Tag(str(area.rank), at, _free(spot, tags), faint, area.rank == self._chosen, area.rank))
        places = [QPointF(*(first if surface == "before" else view).project(point[None])[0]) for _, point, surface in self._landmarks]
        tags += [Tag(name, place, place + QPointF(0, -18)) for (name, *_), place in zip(self._landmarks, places, strict=True) if name]
        self._overlay.points, self._overlay.lines = places, [(places[a], places[b]) for a, b in self._landmark_lines]
        self._overlay.tags = tags
        self._overlay.update()

    def _draw(self, lines: Sequence[LineActor], groups: list[NDArray[np.int64]]) -> None:
        mesh = self._after.mesh
        poly = None if mesh is None or not groups else outlines(mesh.vertices, self._after.normals, mesh.triangles, groups)
        for line in lines:
            line.show_poly(poly)


def _free(place: QPointF, taken: Sequence[Tag]) -> QPointF:
    """The nearest place above where a label covers no other one."""
    spot = place
    while any(abs(spot.x() - tag.spot.x()) < 24 and abs(spot.y() - tag.spot.y()) < 24 for tag in taken):
        spot = spot - QPointF(0, 25)
    return spot
