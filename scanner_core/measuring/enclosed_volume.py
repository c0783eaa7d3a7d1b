"""The volume that a closed surface encloses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh


@dataclass(frozen=True, slots=True)
class EnclosedVolume:
    """Of a closed surface.

    Attributes
    ----------
    volume_mm3 : enclosed
    area_mm2 : of the surface
    uncertainty_mm3 : when every vertex is off to the same side by its standard uncertainty, as an error of the calibration would have
        it; chance alone gives much less.  None when the surface has no uncertainties
    """

    volume_mm3: float
    area_mm2: float
    uncertainty_mm3: float | None


def measure_volume(mesh: TriangleMesh) -> EnclosedVolume | None:
    """None for a surface that is not closed: it encloses none."""
    if not check_mesh(mesh).closed:
        return None
    areas = mesh.areas()
    known = mesh.vertex_attributes.get("standard_uncertainty_um")
    uncertainty = None
    if known is not None:
        sigma_mm = 1e-3 * np.asarray(known, np.float64)
        sigma_mm = np.nan_to_num(sigma_mm, nan=float(np.nanmax(sigma_mm, initial=0.0)))
        uncertainty = float(areas @ sigma_mm[mesh.triangles].mean(axis=1))
    return EnclosedVolume(mesh.volume(), float(areas.sum()), uncertainty)
