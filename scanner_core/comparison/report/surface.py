"""The after surface in the frame of BEFORE, with what the comparison found at every vertex."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.report.picture import fitted_scale
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.ply import write_ply


def deviation_surface(comparison: Comparison) -> TriangleMesh:
    """The after surface in the frame of BEFORE with these vertex attributes.

    ``deviation_um`` (float, NaN without counterpart), ``detection_level_um`` (float), ``stable`` (0/1), ``area`` (rank, 0 for none),
    ``red``, ``green``, ``blue`` (colours of the map), and those that the surface had.
    """
    after, deviation = comparison.after, comparison.deviation
    values = np.where(after.supported, deviation.signed_um, np.nan)
    rank = np.zeros(len(values), np.uint16)
    for area in comparison.areas:
        rank[area.vertices] = area.rank
    colours = fitted_scale(comparison).colours(values, deviation.level_um)
    attributes = {
        **after.mesh.vertex_attributes,
        "deviation_um": values.astype(np.float32),
        "detection_level_um": deviation.level_um.astype(np.float32),
        "stable": comparison.alignment.stable.astype(np.uint8),
        "supported": after.supported.astype(np.uint8),
        "area": rank,
        **{name: colours[:, i] for i, name in enumerate(("red", "green", "blue"))},
    }
    return TriangleMesh(comparison.alignment.transform.apply(after.mesh.vertices), after.mesh.triangles, attributes)


def write_deviation(comparison: Comparison, path: Path) -> None:
    """Write it as binary PLY in millimetres."""
    with path.open("wb") as file:
        write_ply(file, deviation_surface(comparison))
