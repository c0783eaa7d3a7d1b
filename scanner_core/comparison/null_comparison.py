"""The null comparison: the same model measured twice and compared.

Nothing has changed, so whatever seems to have changed is what this rig, with this material, cannot tell from a change: noise
that is the same each time (speckle, gloss, light that enters the material) and the reconstruction's own errors are in it, of
which no formula knows.  It is stored with the rig and shown beside every change.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.measuring import vertex_areas
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.devices.null_level import NullLevel, null_levels
from scanner_core.errors import ComparisonError
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.wall_clock import stamp


def null_level_of(comparison: Comparison, material: str, rig: str) -> NullLevel:
    """The level of detection that two measurements of one model of a material give the rig of a name.

    Raises
    ------
    ComparisonError
        E-CMP-24 when the comparison is not reliable, or its surfaces name another rig: then it is no measurement of this one.
    """
    if others := _other_rigs(comparison, rig):
        raise ComparisonError("E-CMP-24", reason=f"the surfaces were measured with '{others}', not with '{rig}'")
    if not comparison.reliable:
        reason = next(doubt.words for doubt in comparison.doubts if doubt.serious)
        raise ComparisonError("E-CMP-24", reason=reason.rstrip("."))
    found, surfaces = comparison.deviation.statistics, (comparison.before, comparison.after)
    calibrations = dict.fromkeys(str(surface.origin.get("calibration_id") or "unknown") for surface in surfaces)
    dates = [str(surface.origin["date"]) for surface in surfaces if surface.origin.get("date")]
    return NullLevel(
        material=material,
        date=max(dates, key=datetime.fromisoformat) if dates else stamp(),
        calibrations=tuple(calibrations),
        points=int(found.points),
        level_um=float(found.p95_um),
        rms_um=float(found.rms_um),
        mean_um=float(found.mean_um),
        p99_um=float(found.p99_um),
        max_um=float(found.max_um),
        false_area_100_mm2=largest_area_mm2(comparison.after.mesh, np.abs(comparison.deviation.signed_um) > 100.0),
        false_area_200_mm2=largest_area_mm2(comparison.after.mesh, np.abs(comparison.deviation.signed_um) > 200.0),
        before_sha256=comparison.before.sha256,
        after_sha256=comparison.after.sha256,
    )


def largest_area_mm2(mesh: TriangleMesh, marked: NDArray[np.bool_]) -> float:
    """Area of the largest connected part of marked vertices (v,); each vertex has a third of its triangles."""
    if not marked.any():
        return 0.0
    share = vertex_areas(mesh)
    edges = EdgeTable.of(mesh.triangles).edges
    inside = edges[marked[edges].all(axis=1)]
    graph = sparse.coo_array((np.ones(len(inside), np.int8), (inside[:, 0], inside[:, 1])), shape=(len(marked), len(marked)))
    _, label = connected_components(graph, directed=False)
    return float(np.bincount(label[marked], share[marked]).max())


def carried_levels(*surfaces: ComparedSurface) -> tuple[NullLevel, ...]:
    """Those of the rig with which a case was measured; of the first surface whose rig has any."""
    for surface in surfaces:
        if levels := null_levels(surface.origin.get("null_levels", [])):
            return levels
    return ()


def with_null_level(
    comparison: Comparison, levels: Sequence[NullLevel], *, material: str | None = None, calibration_date: str | None = None, rig: str | None = None
) -> Comparison:
    """The comparison with the level of its rig and material beside it; what speaks against that level is a doubt, not serious.

    Parameters
    ----------
    levels : of the rig
    material : of the model; without it, or when the rig has none of it, the largest level is taken and that is said
    calibration_date : ISO 8601, of the calibration in use
    rig : name of the rig that `levels` are of
    """
    if not levels:
        return comparison
    named = [level for level in levels if material is not None and level.material.casefold() == material.strip().casefold()]
    level = named[0] if named else max(levels, key=lambda one: one.level_um)
    doubts = []
    if material is not None and not named:
        doubts.append(Doubt.told("null-other-material", False, material=material, other=level.material))
    elif material is None and len(levels) > 1:
        doubts.append(Doubt.told("null-material-unknown", False, other=level.material))
    if calibration_date is not None and datetime.fromisoformat(level.date).astimezone() < datetime.fromisoformat(calibration_date).astimezone():
        dates = {"date": level.date[:10], "calibrated": calibration_date[:10]}
        doubts.append(Doubt.told("null-older-than-calibration", False, material=level.material, **dates))
    if rig is not None and (others := _other_rigs(comparison, rig)):
        doubts.append(Doubt.told("null-other-rig", False, rig=rig, others=others))
    return replace(comparison, null_level_um=level.level_um, null_area_mm2=level.false_area_200_mm2, pair=(*comparison.pair, *doubts))


def _other_rigs(comparison: Comparison, rig: str) -> str:
    """What the surfaces say that they were measured with, if it is not `rig`; a surface out of a file mostly says nothing."""
    told = {str(surface.origin["rig"]) for surface in (comparison.before, comparison.after) if surface.origin.get("rig")}
    return ", ".join(sorted(told - {rig}))
