"""What is marked on the surfaces of a comparison: areas with their ranks, the marked tooth, landmarks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF

from app.palettes import DARK
from app.views.compared_actor import ComparedActor
from app.views.comparison_overlay import ComparisonOverlay, Tag
from app.views.line_actor import LineActor, together
from app.views.viewpoint import Viewpoint
from scanner_core.comparison.area import Area
from scanner_core.comparison.colour_scale import THRESHOLD_LINE
from scanner_core.geometry.edges import row_dot

Array = NDArray[np.float64]
Landmark = tuple[str, Sequence[float]] | tuple[str, Sequence[float], str]
"""Name, place (mm, frame of BEFORE), and the surface in whose picture it stands: ``after`` unless ``before`` is said."""
_PART = "#a45cff"
_AWAY_PX = 34.0
"""From what an area shows of itself to its rank, so that the rank covers nothing of it."""
_INSIDE_PX = 14.0
"""From a rank to the edge of its picture."""
_SPOTS = 96
"""Vertices of an area that may carry its rank; of those that face the eye, `_TRIES` are looked for behind the rest of the surface."""
_TRIES = 10
_LIFT_MM = 0.15


class ComparisonMarks:
    """Outlines on the after surface, and words in the overlay."""

    def __init__(self, after: ComparedActor, overlay: ComparisonOverlay) -> None:
        self._after, self._overlay = after, overlay
        self._outlines, self._part_outline = LineActor(DARK.text, 1.4), LineActor(_PART, 4.0)
        self._chosen_outline = (LineActor(DARK.ground, 6.0, behind=True), LineActor("#ffffff", 3.2))
        self._threshold = LineActor("#{:02x}{:02x}{:02x}".format(*THRESHOLD_LINE), 1.8, behind=True)
        self.lines = (self._threshold, *self._chosen_outline, self._outlines, self._part_outline)
        self._areas: list[tuple[Area, NDArray[np.int64], Any]] = []
        self._chosen: int | None = None
        self._landmarks: list[tuple[str, Array, str]] = []

    def clear(self) -> None:
        self.show_areas((), ())
        self.show_part(None)
        self.show_landmarks(())
        self.show_threshold(None)

    def show_areas(self, areas: Sequence[Area], outlines: Sequence[Any]) -> None:
        """With the outline of each, lines as VTK has them or None."""
        spots = [area.vertices[:: max(len(area.vertices) // _SPOTS, 1)] for area in areas]
        self._areas = list(zip(areas, spots, outlines, strict=True))
        self.choose(None)

    def choose(self, rank: int | None) -> None:
        self._chosen = rank
        self._outlines.show_poly(together([outline for area, _, outline in self._areas if area.rank != rank]))
        chosen = next((outline for area, _, outline in self._areas if area.rank == rank), None)
        for line in self._chosen_outline:
            line.show_poly(chosen)

    def show_part(self, outline: Any) -> None:
        """Lines as VTK has them, or None."""
        self._part_outline.show_poly(outline)

    def show_threshold(self, lines: Any) -> None:
        """Where the deviation reaches the threshold; None for no line."""
        self._threshold.show_poly(lines)

    def show_landmarks(self, points: Sequence[Landmark]) -> None:
        self._landmarks = [(mark[0], np.asarray(mark[1], np.float64), mark[2] if len(mark) > 2 else "after") for mark in points]

    def set_seen(self, after: bool, coloured: bool) -> None:
        """Whether the after surface is in the picture at its place, and as a map."""
        for line in self.lines:
            line.set_shown(after and (coloured or line is not self._threshold))

    def place(self, first: Viewpoint, view: Viewpoint, kept: tuple[Array, float], curtain_x: float) -> None:
        """The words where the camera has their points now, before in the `first` picture.

        An area has its rank where it is seen, and none where it is not: behind the surface, beside its picture, left of the
        curtain, or cut away: `kept` is the half space ``normal . p <= offset`` that a section has left.
        """
        tags: list[Tag] = []
        drawn = self._after.drawn
        middle = np.zeros(2) if drawn is None else view.project(0.5 * np.sum(drawn.mesh.bounds(), axis=0)[None])[0]
        low = np.array([view.left, view.top]) + _INSIDE_PX
        high = np.array([view.left + view.width, view.top + view.height]) - _INSIDE_PX
        for area, spots, _ in self._areas:
            place = self._seen(spots, view, kept, curtain_x)
            if place is None:
                continue
            out = place - middle
            spot = np.clip(place + _AWAY_PX * out / max(float(np.hypot(*out)), 1e-6), low, high)
            tags.append(Tag(str(area.rank), QPointF(*place), _free(QPointF(*spot), tags), area.rank == self._chosen, area.rank))
        places = [QPointF(*(first if surface == "before" else view).project(point[None])[0]) for _, point, surface in self._landmarks]
        tags += [Tag(name, place, place + QPointF(0, -18)) for (name, *_), place in zip(self._landmarks, places, strict=True) if name]
        self._overlay.points, self._overlay.tags = places, tags
        self._overlay.update()

    def _seen(self, spots: NDArray[np.int64], view: Viewpoint, kept: tuple[Array, float], curtain_x: float) -> Array | None:
        """Where (2,), pixels, the most central of those of some vertices of the after surface appears that are seen."""
        drawn = self._after.drawn
        if drawn is None or not len(spots):
            return None
        normal, offset = kept
        points = drawn.mesh.vertices[spots] + _LIFT_MM * drawn.normals[spots]
        places, starts = view.project(points), view.near(points)
        over = starts @ normal - offset
        cut = points @ normal - offset
        facing = row_dot(np.asarray(drawn.normals[spots], np.float64), starts - points) > 0
        seen = facing & view.ahead(points) & view.within(places) & (places[:, 0] >= curtain_x) & (cut <= 0)
        if not seen.any():
            return None
        away = np.where(seen, ((places - np.median(places[seen], axis=0)) ** 2).sum(axis=1), np.inf)
        order = np.argsort(away)[: np.count_nonzero(seen)]
        order = order[:: -(-len(order) // _TRIES)]
        share = np.where(over > 0, over / np.maximum(over - cut, 1e-12), 0.0)  # the line of sight begins where the section is
        starts = starts + share[:, None] * (points - starts)
        found = drawn.picker.seen(points[order], starts[order])
        return None if found is None else np.asarray(places[order[found]])


def _free(place: QPointF, taken: Sequence[Tag]) -> QPointF:
    """The nearest place above where a label covers no other one."""
    spot = place
    while any(abs(spot.x() - tag.spot.x()) < 24 and abs(spot.y() - tag.spot.y()) < 24 for tag in taken):
        spot = spot - QPointF(0, 25)
    return spot
