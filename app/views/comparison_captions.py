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
_SIDES_APART_PX = 80
"""Seen along the line between them, the patient's sides have no meaning in the picture."""


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
        """The patient's sides beside points (n, 3) in every picture, once `right` is known; a length where there is no perspective."""
        self._overlay.sides, self._overlay.bar = [], None
        if points is None:
            return
        middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
        if right is not None:
            reach = float(np.abs((points - middle) @ right).max()) + 4.0
            for view in views:
                ends = view.project(np.array([middle + reach * right, middle - reach * right]))
                if abs(ends[0, 0] - ends[1, 0]) > _SIDES_APART_PX:
                    self._overlay.sides += [(QPointF(*ends[0]), self.tr("R")), (QPointF(*ends[1]), self.tr("L"))]
        if parallel:
            pixels = views[-1].pixels_per_mm(middle)
            length_mm = next((mm for mm in _LENGTHS_MM if mm * pixels >= _SHORTEST_BAR_PX), _LENGTHS_MM[-1])
            self._overlay.bar = (length_mm * pixels, self.tr("{mm:g} mm").format(mm=length_mm))
