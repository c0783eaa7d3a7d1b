"""By what points and surfaces are coloured."""

from __future__ import annotations

from enum import Enum


class PointColour(Enum):
    """What the colour of a point tells; the values are kept in the settings."""

    HEIGHT = "height"
    VIEW = "view"
    RESIDUAL = "residual"
    UNCERTAINTY = "uncertainty"
    DENSITY = "density"
    AGE = "age"


class SurfaceColour(Enum):
    """What the colour of a surface tells."""

    SUPPORT = "support"
    UNCERTAINTY = "uncertainty"
