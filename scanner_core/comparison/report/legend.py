"""The legend of the map: the scale of colours as it is on the surface."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART, WITHIN_LEVEL, DeviationScale
from scanner_core.comparison.report.picture import STABLE
from scanner_core.metrology.certificate_page import GREY, HEIGHT_MM, INK, WIDTH_MM, Page

_BAR_MM = 5.0
SWATCHES_MM = 22.0
"""Height of the swatches and of the words between them and the bar."""


def css(colour: Sequence[int]) -> str:
    """A colour as ``#rrggbb``."""
    return "#" + "".join(f"{int(part):02x}" for part in colour)


def bands(scale: DeviationScale) -> list[tuple[float, float, str]]:
    """From, to (um) and colour of every piece of the bar, upwards; grey within the level of detection."""
    pieces = []
    for low, high, colour in zip(scale.edges_um[:-1], scale.edges_um[1:], scale.band_colours, strict=True):
        for a, b in ((low, min(high, -scale.level_um)), (max(low, scale.level_um), high)):
            if b > a:
                pieces.append((float(a), float(b), css(colour)))
    level = min(scale.level_um, scale.limit_um)
    pieces.append((-level, level, css(WITHIN_LEVEL)))
    return sorted(pieces)


def draw_bar(page: Page, scale: DeviationScale, x_mm: float, y_mm: float, height_mm: float) -> None:
    """The bar with its upper left corner at x, y: bands, ticks in mm, the threshold on both sides."""
    middle, per_um = y_mm + 0.5 * height_mm, 0.5 * height_mm / scale.limit_um
    for low, high, colour in bands(scale):
        box(page, x_mm, middle - high * per_um, _BAR_MM, (high - low) * per_um, colour)
    frame(page, x_mm, y_mm, _BAR_MM, height_mm)
    page.text(x_mm, y_mm - 1.8, "AFTER outside of BEFORE", 6.5)
    page.text(x_mm, y_mm + height_mm + 3.4, "AFTER inside of BEFORE", 6.5)
    for value, label in scale.ticks():
        y = middle - value * per_um
        threshold = abs(abs(value) - scale.threshold_um) < 1e-6
        line(page, x_mm + _BAR_MM, y, x_mm + _BAR_MM + 1.2, y, GREY, 0.5)
        page.text(x_mm + _BAR_MM + 2.0, y + 0.85, f"{label} mm", 6.5, bold=threshold)
    for sign in (-1, 1):
        y = middle - sign * scale.threshold_um * per_um
        line(page, x_mm - 1.0, y, x_mm + _BAR_MM + 1.2, y, INK, 1.1)


def draw_swatches(page: Page, scale: DeviationScale, x_mm: float, y_mm: float) -> None:
    """What the other colours mean, one under the other."""
    rows = (
        (css(WITHIN_LEVEL), "", f"undetectable (< {scale.level_um / 1000:.2f} mm)"),
        (css(NO_COUNTERPART), css(HATCH), "no counterpart, left out"),
        ("white", INK, f"threshold {scale.threshold_um / 1000:g} mm"),
        (css(STABLE), "", "stable region"),
    )
    for fill, mark, words in rows:
        if mark == INK:
            line(page, x_mm, y_mm - 1.1, x_mm + 4.2, y_mm - 1.1, INK, 1.1)
        else:
            box(page, x_mm, y_mm - 2.4, 4.2, 2.8, fill)
            for shift in (0.6, 1.8, 3.0) if mark else ():
                line(page, x_mm + shift, y_mm + 0.4, x_mm + shift + 1.0, y_mm - 2.4, mark, 0.7)
        page.text(x_mm + 5.4, y_mm, words, 6.5)
        y_mm += 3.9


def box(page: Page, x_mm: float, y_mm: float, width_mm: float, height_mm: float, colour: str) -> None:
    """A filled rectangle, upper left corner at x, y."""
    from matplotlib.patches import Rectangle

    place = (x_mm / WIDTH_MM, 1 - (y_mm + height_mm) / HEIGHT_MM)
    page.figure.add_artist(
        Rectangle(place, width_mm / WIDTH_MM, height_mm / HEIGHT_MM, transform=page.figure.transFigure, facecolor=colour, linewidth=0)
    )


def frame(page: Page, x_mm: float, y_mm: float, width_mm: float, height_mm: float) -> None:
    """Its outline."""
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]) * (width_mm, height_mm) + (x_mm, y_mm)
    for (xa, ya), (xb, yb) in pairwise(corners):
        line(page, xa, ya, xb, yb, GREY, 0.4)


def line(page: Page, xa_mm: float, ya_mm: float, xb_mm: float, yb_mm: float, colour: str, width: float) -> None:
    """A straight line."""
    from matplotlib.lines import Line2D

    page.figure.add_artist(
        Line2D((xa_mm / WIDTH_MM, xb_mm / WIDTH_MM), (1 - ya_mm / HEIGHT_MM, 1 - yb_mm / HEIGHT_MM), color=colour, linewidth=width)
    )
