"""The reference sphere of the published system on a thin stem."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.virtual.specimens.implicit import mesh_implicit
from scanner_core.virtual.specimens.specimen import Specimen

Array = NDArray[np.float64]

RADIUS_MM = 11.133
CENTRE_MM = (0.0, 0.0, 13.0)
STEM_RADIUS_MM = 1.5
"""The stem is so short that the sphere keeps the laser off it: what is scanned is sphere and table alone."""


def sphere() -> Specimen:
    """Sphere of :data:`RADIUS_MM` about :data:`CENTRE_MM`; its distance is analytic."""
    mesh = mesh_implicit(solid, (-11.9, -11.9, -0.7), (11.9, 11.9, 24.9), 0.2137)
    return Specimen("sphere", mesh, true_radius_mm=RADIUS_MM, analytic_distance=surface_distance)


def solid(points: Array) -> Array:
    """Sphere and stem, the stem cut off at the table."""
    ball = np.linalg.norm(points - np.array(CENTRE_MM), axis=1) - RADIUS_MM
    stem = np.maximum(np.hypot(points[:, 0], points[:, 1]) - STEM_RADIUS_MM, np.maximum(-points[:, 2], points[:, 2] - CENTRE_MM[2]))
    union: Array = np.minimum(ball, stem)
    return union


def surface_distance(points: Array) -> Array:
    """Exact distance (n,) to the union's surface: sphere without the stem's footprint, stem's wall, stem's foot."""
    across, height = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    junction = CENTRE_MM[2] - np.sqrt(RADIUS_MM**2 - STEM_RADIUS_MM**2)
    from_centre = np.hypot(across, height - CENTRE_MM[2])
    in_footprint = (height < CENTRE_MM[2]) & (across * RADIUS_MM < STEM_RADIUS_MM * from_centre)
    to_junction = np.hypot(across - STEM_RADIUS_MM, height - junction)
    ball = np.where(in_footprint, to_junction, np.abs(from_centre - RADIUS_MM))
    wall = np.hypot(across - STEM_RADIUS_MM, height - np.clip(height, 0.0, junction))
    foot = np.hypot(np.maximum(across - STEM_RADIUS_MM, 0.0), height)
    nearest: Array = np.minimum(np.minimum(ball, wall), foot)
    return nearest
