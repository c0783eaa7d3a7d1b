"""What is written into the picture of a comparison: names, keys of lines, the patient's sides, a true length."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QPointF, QRectF, Qt

from app.views.comparison_overlay import ComparisonOverlay
from app.views.section_cut import AFTER_LINE, BEFORE_LINE
from app.views.viewpoint import Viewpoint

Array = NDArray[np.float64]
_LENGTHS_MM = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0)
_SHORTEST_BAR_PX = 60
_SIDES_SEEN = 0.94
"""Cosine of the angle between the line of sight and that between the patient's sides: seen along it they have no place in the picture."""
_OUTSIDE_PX, _EDGE_PX, _TOP_PX, _APART_PX = 20.0, 20.0, 56.0, 60.0
"""Of a side's letter from the surface, at least from the picture's edge, below its name, and at least from the other letter."""


class ComparisonCaptions(QObject):
    """Writes into the overlay."""

    def __init__(self, overlay: ComparisonOverlay) -> None:
        super().__init__(overlay)
        self._overlay = overlay

    def name(self, mode: str | None, *, other: bool, curtain_x: float, section: bool) -> None:
        """Which surface is where; nothing without a mode."""
        overlay, left, right = self._overlay, Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignRight
        whole, half = QRectF(overlay.rect()), 0.5 * overlay.width()
        first, second = self.tr("Before"), self.tr("After")
        overlay.seam_x = half if mode == "side_by_side" else None
        overlay.curtain_x = curtain_x if mode == "curtain" else None
        if mode is None:
            overlay.captions = []
        elif mode == "side_by_side":
            overlay.captions = [(whole, first, left), (whole.adjusted(half, 0, 0, 0), second, left)]
        elif mode in ("curtain", "blend", "morph"):
            overlay.captions = [(whole, first, left), (whole, second, right)]
        else:
            overlay.captions = [(whole, first if mode == "before" or other else second, left)]
        overlay.keys = [(BEFORE_LINE, first), (AFTER_LINE, second)] if mode is not None and section else []
        overlay.update()

    def measure(self, views: Sequence[Viewpoint], points: Array | None, right: Array | None, parallel: bool) -> None:
        """The patient's sides beside points (n, 3) of the surfaces, once `right` is known; a length where there is no perspective."""
        self._overlay.sides, self._overlay.bar = [], None
        if points is None:
            return
        if right is not None:
            for view in views:
                self._overlay.sides += self._sides(view, points[view.ahead(points)], right)
        if parallel:
            pixels = views[-1].pixels_per_mm(0.5 * (points.min(axis=0) + points.max(axis=0)))
            length_mm = next((mm for mm in _LENGTHS_MM if mm * pixels >= _SHORTEST_BAR_PX), _LENGTHS_MM[-1])
            self._overlay.bar = (length_mm * pixels, self.tr("{mm:g} mm").format(mm=length_mm))

    def _sides(self, view: Viewpoint, points: Array, right: Array) -> list[tuple[QPointF, str]]:
        """To the right and to the left of all that is seen of points (n, 3) in one picture."""
        if not len(points) or abs(float(right @ view.direction)) > _SIDES_SEEN:
            return []
        middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
        start, end = view.project(np.array([middle, middle + right]))
        way = (end - start) / np.hypot(*(end - start))
        places = view.project(points)
        centre = 0.5 * (places.min(axis=0) + places.max(axis=0))
        along = (places - centre) @ way
        low = np.array([view.left + _EDGE_PX, view.top + _TOP_PX])
        high = np.array([view.left + view.width, view.top + view.height]) - _EDGE_PX
        first, second = (np.clip(centre + reach * way, low, high) for reach in (along.max() + _OUTSIDE_PX, along.min() - _OUTSIDE_PX))
        apart = (first - second) @ way > _APART_PX
        return [(QPointF(*first), self.tr("R")), (QPointF(*second), self.tr("L"))] if apart else []
