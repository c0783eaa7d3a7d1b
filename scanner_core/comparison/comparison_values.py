"""A comparison as JSON: what the command prints, what a case keeps, and what a report quotes."""

from __future__ import annotations

from math import isfinite

from scanner_core.case.provenance import versions
from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.deviation import Deviation
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.surface import ComparedSurface

_ORIGIN = ("kind", "format", "mesh_id", "order", "side", "type", "date", "rig", "calibration_id", "calibration_date", "null_levels")
"""What of a surface's origin is written: never its path, which often holds a name, and never the patient's code."""


def comparison_values(comparison: Comparison) -> dict[str, object]:
    """Everything but the arrays; what is no finite number is None."""
    deviation = comparison.deviation
    return {
        "before": surface_values(comparison.before),
        "after": surface_values(comparison.after),
        "parameters": comparison.parameters.as_dict(),
        "versions": versions(),
        "transform_after_to_before": comparison.alignment.transform.matrix().tolist(),
        "alignment": _alignment(comparison.alignment),
        "deviation": _deviation(deviation),
        "hausdorff_um": {
            "after_to_before": _number(deviation.statistics.hausdorff_after_to_before_um),
            "before_to_after": _number(deviation.statistics.hausdorff_before_to_after_um),
        },
        "areas": [_area(area, comparison) for area in comparison.areas],
        "null_level_um": _number(comparison.null_level_um),
        "null_area_mm2": _number(comparison.null_area_mm2),
        "reliable": comparison.reliable,
        "doubts": [doubt_values(doubt) for doubt in comparison.doubts],
        "warnings": warnings(comparison),
    }


def surface_values(surface: ComparedSurface) -> dict[str, object]:
    """What was compared, with its hash; not where on this machine it lies."""
    return {
        "name": surface.name,
        "sha256": surface.sha256,
        "unit": surface.unit,
        "unit_reason": surface.unit_reason,
        "vertices": len(surface.mesh.vertices),
        "triangles": len(surface.mesh.triangles),
        "supported_vertices": int(surface.supported.sum()),
        "doubts": [doubt_values(doubt) for doubt in surface.doubts],
        "origin": {key: surface.origin[key] for key in _ORIGIN if key in surface.origin},
    }


def doubt_values(doubt: Doubt) -> dict[str, object]:
    return {"code": doubt.code, "words": doubt.words, "serious": doubt.serious}


def told_doubts(comparison: Comparison, before: str, after: str) -> list[tuple[Doubt, str]]:
    """All doubts with their sentences, the serious ones first; those of one surface begin with the name given for it."""
    surfaces = ((before, comparison.before), (after, comparison.after))
    told = [(doubt, f"{name}: {doubt.words}") for name, surface in surfaces for doubt in surface.doubts]
    told += [(doubt, doubt.words) for doubt in (*comparison.pair, *comparison.alignment.doubts)]
    return sorted(told, key=lambda one: not one[0].serious)


def warnings(comparison: Comparison) -> list[str]:
    """All doubts as sentences, the serious ones first; those of one surface name it."""
    return [words for _, words in told_doubts(comparison, comparison.before.name, comparison.after.name)]


def above_null(area: Area, comparison: Comparison) -> bool | None:
    """Whether an area exceeds, in height and in extent, what seemed to have moved when nothing had; None where that is not known."""
    level_um, extent_mm2 = comparison.null_level_um, comparison.null_area_mm2
    if level_um is None:
        return None
    return bool(area.p95_um > level_um and (extent_mm2 is None or area.area_mm2 > extent_mm2))


def _alignment(alignment: Alignment) -> dict[str, object]:
    return {
        "frame": alignment.frame.value,
        "method": alignment.method,
        "stable_area_fraction": _number(alignment.stable_area_fraction),
        "rms_um": _number(alignment.rms_um),
        # of what was not estimated the uncertainty is not 0, but not known
        "uncertainty_um": None if alignment.frame is Frame.GIVEN else _number(alignment.uncertainty_um),
        "noise_um": _number(alignment.noise_um),
        "correlation_length_mm": _number(alignment.correlation_length_mm),
        "scale_ratio": _number(alignment.scale_ratio, 7),
        "scale_ratio_uncertainty": _number(alignment.scale_ratio_uncertainty, 7),
        "overlap": _number(alignment.overlap),
        "shifts": [{"frame": shift.frame.value, "rms_um": _number(shift.rms_um), "max_um": _number(shift.max_um)} for shift in alignment.shifts],
    }


def _deviation(deviation: Deviation) -> dict[str, object]:
    found = deviation.statistics
    names = ("no_counterpart_fraction", "mean_um", "rms_um", "p50_um", "p95_um", "p99_um", "max_um")
    return {
        "points": found.points,
        **{name: _number(getattr(found, name)) for name in names},
        "detection_level_um": _number(deviation.detection_level_um),
        "area_above_mm2": {threshold: _number(area) for threshold, area in found.area_above_mm2.items()},
    }


def _area(area: Area, comparison: Comparison) -> dict[str, object]:
    return {
        "rank": area.rank,
        "centroid_mm": [_number(value, 4) for value in area.centroid_mm.tolist()],
        "area_mm2": _number(area.area_mm2),
        "mean_um": _number(area.mean_um),
        "p95_um": _number(area.p95_um),
        "max_um": _number(area.max_um),
        "volume_mm3": _number(area.volume_mm3, 4),
        "parts": area.parts,
        "words": area.words,
        "motion": None if area.motion is None else motion_values(area.motion),
        "above_null": above_null(area, comparison),
    }


def motion_values(motion: PartMotion) -> dict[str, object]:
    """The rigid motion of a part, before to after, in the frame of BEFORE; as all of the JSON with standard uncertainties (k = 1)."""
    return {
        "transform_before_to_after": motion.transform.matrix().tolist(),
        "centre_mm": [_number(value, 4) for value in motion.centre.tolist()],
        "displacement_mm": [_number(value, 4) for value in motion.displacement_mm.tolist()],
        "displacement_uncertainty_um": _number(motion.displacement_uncertainty_um),
        "angle_deg": _number(motion.angle_deg, 4),
        "angle_uncertainty_deg": _number(motion.angle_uncertainty_deg, 4),
        "axis": [_number(value, 4) for value in motion.axis.tolist()],
        "rms_um": _number(motion.rms_um),
    }


def _number(value: float | None, digits: int = 3) -> float | None:
    return None if value is None or not isfinite(value) else round(float(value), digits)
