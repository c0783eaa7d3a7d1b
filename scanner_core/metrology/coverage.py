"""How much of a sphere's surface was measured, and how evenly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BAND_DEG = 15.0
"""Height of the bands of cells; the cells of a band are as wide as high."""
SECTORS = 24
"""Azimuth sectors in which the polar reach is taken."""


@dataclass(frozen=True, slots=True)
class Coverage:
    """Of one sphere.

    Attributes
    ----------
    polar_deg : angle from the top (the table's +z) down to which points reach in every one of the azimuth sectors: 90 is
        the whole upper hemisphere, 180 the whole sphere
    surface_fraction : share of the sphere's surface whose cells (15 deg) hold a point; shows gaps
    """

    polar_deg: float
    surface_fraction: float


def sphere_coverage(directions: Array) -> Coverage:
    """From vectors (n, 3) of the sphere's centre to its points; their length does not matter."""
    polar, azimuth = spherical_angles_deg(directions)
    sector = (azimuth / (360 / SECTORS)).astype(int) % SECTORS
    reach = np.zeros(SECTORS)
    np.maximum.at(reach, sector, polar)
    areas, filled = 0.0, 0.0
    for low in np.arange(0.0, 180.0, BAND_DEG):
        cells = band_cells(low)
        inside = (polar >= low) & (polar < low + BAND_DEG)
        hit = len(np.unique((azimuth[inside] * cells / 360).astype(int) % cells))
        area = float(np.cos(np.radians(low)) - np.cos(np.radians(low + BAND_DEG)))
        areas += area
        filled += area * hit / cells
    return Coverage(float(reach.min()), filled / areas)


def spherical_angles_deg(directions: Array) -> tuple[Array, Array]:
    """Polar angle from +z (0 to 180) and azimuth (0 to 360) of vectors (n, 3), both (n,)."""
    across = np.hypot(directions[:, 0], directions[:, 1])
    polar = np.degrees(np.arctan2(across, directions[:, 2]))
    azimuth = np.degrees(np.arctan2(directions[:, 1], directions[:, 0])) % 360.0
    return polar, azimuth


def band_cells(low_deg: float) -> int:
    """Cells of the band that begins at the polar angle `low_deg`."""
    middle = np.radians(low_deg + 0.5 * BAND_DEG)
    return max(3, round(360.0 * float(np.sin(middle)) / BAND_DEG))
