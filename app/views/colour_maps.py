"""Colour maps of points, in pairs: one for a dark ground and one for a light one.

In each of them lightness changes steadily in one direction, so that it reads the same in grey print and for people who do not
tell red from green; and no part of it comes near the ground, so that no point sinks into it.  What asks for attention (the
highest residual, the newest point) is farthest from the ground.  Hues follow viridis, plasma and cividis (van der Walt and
Smith 2015; Nunez et al. 2018); those of the views follow Okabe and Ito (2008).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.views.point_colour import PointColour
from app.views.surface_colours import rgb, table


@dataclass(frozen=True, slots=True)
class ColourMap:
    """Colours on a dark and on a light ground: evenly spaced stops, or a cycle of single colours."""

    on_dark: tuple[str, ...]
    on_light: tuple[str, ...]
    cycle: bool = False

    def stops(self, dark: bool) -> tuple[str, ...]:
        return self.on_dark if dark else self.on_light

    def table(self, dark: bool) -> NDArray[np.uint8]:
        """(n, 4) bytes."""
        stops = self.stops(dark)
        return np.array([(*rgb(colour), 255) for colour in stops], np.uint8) if self.cycle else table(stops)


MISSING: Final = {True: "#7d858e", False: "#9aa1a9"}
"""On a dark and on a light ground: what is not known of a point (yet)."""
MAPS: Final = {
    PointColour.HEIGHT: ColourMap(
        ("#5b7fd4", "#3f9fd0", "#3fbcae", "#86d08a", "#e6da78", "#fff3d2"), ("#3a1a66", "#3b4a8a", "#2c6d8e", "#1f868a", "#1a9079", "#28985f")
    ),
    PointColour.VIEW: ColourMap(
        ("#e69f00", "#56b4e9", "#f0e442", "#6f92ee", "#d98fb8", "#c9ced6", "#ee7433", "#1bb489"),
        ("#b87a00", "#2a8fc7", "#857800", "#2450a8", "#b8509a", "#555b63", "#c04e00", "#007f5c"),
        cycle=True,
    ),
    PointColour.RESIDUAL: ColourMap(
        ("#5a6fd6", "#a06fd2", "#e0709f", "#f6955f", "#fbc455", "#fdf3a8"), ("#c97b4e", "#c75c5e", "#ad3a80", "#85159c", "#52089f", "#1f0a6b")
    ),
    PointColour.UNCERTAINTY: ColourMap(
        ("#5a6fd6", "#a06fd2", "#e0709f", "#f6955f", "#fbc455", "#fdf3a8"), ("#c97b4e", "#c75c5e", "#ad3a80", "#85159c", "#52089f", "#1f0a6b")
    ),
    PointColour.DENSITY: ColourMap(
        ("#6079c4", "#8490b4", "#a9a69c", "#c9bb7c", "#e6d45c", "#fff08a"), ("#8d8450", "#777558", "#5f6568", "#44536d", "#243f6b", "#00224e")
    ),
    PointColour.AGE: ColourMap(
        ("#66758a", "#5a8bab", "#52a8bb", "#66c6b6", "#a3e4ae", "#f1fccb"), ("#818c9c", "#587f9a", "#357d93", "#1f6a72", "#124a52", "#06222a")
    ),
}
