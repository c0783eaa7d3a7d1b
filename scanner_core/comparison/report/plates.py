"""The pictures on the page: the map and the stable region from the first viewpoint beside the legend, the other viewpoints below."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.report.legend import SWATCHES_MM, draw_bar, draw_swatches, line
from scanner_core.comparison.report.picture import Painter, Picture, fitted_scale
from scanner_core.comparison.report.viewpoint import Viewpoint, viewpoints
from scanner_core.jobs.progress import IsCancelled
from scanner_core.metrology.certificate_page import GREY, HEIGHT_MM, INK, MARGIN_MM, WIDTH_MM, Page

_PER_MM = 8.0
"""Pixels for a millimetre of paper: 200 dpi."""
_LEGEND, _GAP = 38.0, 4.0
_SHORTEST_BAR = 24.0
_SECOND_TALL = 30.0
_LONGEST_BAR = 12.0
_WIDE = WIDTH_MM - 2 * MARGIN_MM
_MARGIN = 1.04
"""A picture is so much larger than what it shows."""


class Plates:
    """All pictures of one comparison, as large as the page's width and a given height allow."""

    def __init__(self, comparison: Comparison, cancelled: IsCancelled = lambda: False) -> None:
        self._scale = fitted_scale(comparison)
        self._painter = Painter(comparison, self._scale, cancelled)
        self._points = viewpoints(comparison)
        self._wide = 0.5 * (_WIDE - _LEGEND - 2 * _GAP)
        others = len(self._points) - 1
        self._narrow = (_WIDE - _GAP * (others - 1)) / others
        self._told: set[int] = set()

    def height_mm(self, tall_mm: float) -> float:
        """On paper, when the first pictures are at most `tall_mm` tall."""
        return self._first_row(tall_mm)[2] + self._fitting(self._points[1:], self._narrow, _SECOND_TALL)[1] + 16.0

    def draw(self, page: Page, tall_mm: float) -> None:
        """Put them where the page stands."""
        per_mm, high, row = self._first_row(tall_mm)
        first, top = self._points[0], page.y_mm + 5.0
        left, right = MARGIN_MM, MARGIN_MM + self._wide + _GAP
        page.text(left, top - 2.0, first.name, 8, bold=True)
        page.text(right, top - 2.0, "What was held fixed", 8, bold=True)
        size = (round(self._wide * _PER_MM), round(high * _PER_MM))
        self._put(page, self._painter.deviation(first, per_mm / _PER_MM, *size), left, top, self._wide, high)
        self._put(page, self._painter.stable(first, per_mm / _PER_MM, *size), right, top, self._wide, high)
        _scale_bar(page, left + self._wide, top - 2.0, per_mm)
        legend, bar = WIDTH_MM - MARGIN_MM - _LEGEND + 1.0, row - SWATCHES_MM
        draw_bar(page, self._scale, legend, top, bar)
        draw_swatches(page, self._scale, legend, top + bar + 9.0)
        top += row + 5.0
        per_mm, high = self._fitting(self._points[1:], self._narrow, _SECOND_TALL)
        for i, viewpoint in enumerate(self._points[1:]):
            x = MARGIN_MM + i * (self._narrow + _GAP)
            page.text(x, top, viewpoint.name, 7.5, bold=True)
            picture = self._painter.deviation(viewpoint, per_mm / _PER_MM, round(self._narrow * _PER_MM), round(high * _PER_MM))
            self._put(page, picture, x, top + 1.6, self._narrow, high)
        _scale_bar(page, MARGIN_MM + self._narrow, top, per_mm)
        page.y_mm = top + high + 6.0

    def _first_row(self, tall_mm: float) -> tuple[float, float, float]:
        """Millimetres of the surface for one of paper, height of the pictures, and of the row with the legend."""
        per_mm, high = self._fitting(self._points[:1], self._wide, tall_mm)
        return per_mm, high, max(high, _SHORTEST_BAR + SWATCHES_MM)

    def _fitting(self, points: Sequence[Viewpoint], wide_mm: float, tall_mm: float) -> tuple[float, float]:
        """Millimetres of the surface for one of paper, the same for all, and the height that they need on paper."""
        extents = np.array([self._painter.extent_mm(point) for point in points])
        per_mm = _MARGIN * max(extents[:, 0].max() / wide_mm, extents[:, 1].max() / tall_mm, 1e-9)
        return float(per_mm), float(max(_MARGIN * extents[:, 1].max() / per_mm, 6.0))

    def _put(self, page: Page, picture: Picture, x_mm: float, y_mm: float, width_mm: float, height_mm: float) -> None:
        """A picture, and the numbers of those areas on it that no picture has told yet."""
        axes = page.figure.add_axes((x_mm / WIDTH_MM, 1 - (y_mm + height_mm) / HEIGHT_MM, width_mm / WIDTH_MM, height_mm / HEIGHT_MM))
        axes.set_axis_off()
        axes.imshow(picture.pixels, interpolation="none", aspect="auto")
        for rank, right, down in picture.numbers:
            if rank not in self._told:
                self._told.add(rank)
                page.figure.text(
                    (x_mm + right * width_mm) / WIDTH_MM,
                    1 - (y_mm + down * height_mm) / HEIGHT_MM,
                    str(rank),
                    fontsize=5.5,
                    fontweight="bold",
                    color=INK,
                    ha="center",
                    va="center",
                    bbox={"boxstyle": "circle,pad=0.22", "facecolor": "white", "edgecolor": INK, "linewidth": 0.5},
                )


def _scale_bar(page: Page, right_mm: float, y_mm: float, per_mm: float) -> None:
    """A bar as long as a round length on the surface, right aligned on a line of text."""
    longest = _LONGEST_BAR * per_mm
    power = 10.0 ** np.floor(np.log10(longest))
    length = power * max(factor for factor in (1, 2, 5) if factor * power <= longest)
    left = right_mm - length / per_mm
    line(page, left, y_mm - 0.9, right_mm, y_mm - 0.9, INK, 1.0)
    for end in (left, right_mm):
        line(page, end, y_mm - 1.6, end, y_mm - 0.2, INK, 0.6)
    page.text(left - 1.0, y_mm, f"{length:g} mm", 6.5, colour=GREY, align="right")
