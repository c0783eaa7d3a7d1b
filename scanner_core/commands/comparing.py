"""The comparison as a job of the worker process, and its result in words."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from scanner_core.commands.console import Console
from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.area import Area
from scanner_core.comparison.area_bar import AreaBar
from scanner_core.comparison.compare import CompareRequest
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import above_null
from scanner_core.comparison.frame_words import HELD, shift_sentences
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.series import Series, SeriesRequest
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.devices.null_level import NullLevel
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.jobs.progress import Progress


def run_comparison(
    console: Console, before: ComparedSurface, after: ComparedSurface, parameters: ComparisonParameters, mask: NDArray[np.bool_] | None
) -> Comparison:
    """Compare in the worker process; Ctrl-C ends it within a second."""
    result = _in_worker(console, "compare", CompareRequest(before, after, parameters, mask))
    if not isinstance(result, Comparison):
        raise TypeError(f"the worker answered with {type(result).__name__}")
    return result


def run_series(console: Console, surfaces: Sequence[ComparedSurface], parameters: ComparisonParameters) -> Series:
    """Compare a series in the worker process; Ctrl-C ends it within a second."""
    result = _in_worker(console, "compare-series", SeriesRequest(tuple(surfaces), parameters))
    if not isinstance(result, Series):
        raise TypeError(f"the worker answered with {type(result).__name__}")
    return result


def _in_worker(console: Console, job: str, request: object) -> object:
    def show(progress: Progress) -> None:
        console.progress(progress.phase, progress.fraction, progress.seconds_left)

    result = run_in_worker(job, request, progress=show, cancelled=lambda: False)
    console.clear()
    return result


def comparison_summary(comparison: Comparison) -> list[str]:
    """The result in lines that a person reads."""
    before, after, found = comparison.before, comparison.after, comparison.deviation.statistics
    lines = [
        f"{after.name} ({len(after.mesh.triangles)} triangles, {after.unit}) against {before.name} ({len(before.mesh.triangles)}, {before.unit}).",
        *_alignment(comparison),
        f"Deviation, + outward: mean {found.mean_um:+.1f} um, rms {found.rms_um:.1f} um, 95 % below {found.p95_um:.1f} um, "
        f"largest {found.max_um:.0f} um; {100 * found.no_counterpart_fraction:.1f} % of the surface has no counterpart "
        f"(farther than {comparison.parameters.no_counterpart_mm:g} mm, or beyond a border). "
        f"Level of detection: {comparison.deviation.detection_level_um:.1f} um.",
    ]
    if comparison.null_level_um is not None:
        lines.append(f"The same model measured twice seemed to change by up to {comparison.null_level_um:.1f} um (95 %, null comparison).")
    bar = AreaBar.of(comparison.deviation)
    size = f"of at least {bar.extent_mm2:g} mm2 that differ by more than {bar.deviation_um:.0f} um"
    lines.append(f"Areas {size}: {len(comparison.areas) or 'none'}.")
    lines += [_area(area, comparison) for area in comparison.areas]
    if comparison.alignment.frame is not Frame.GIVEN or any(area.motion for area in comparison.areas):
        lines.append("+- is the expanded uncertainty (k = 2); --json tells standard uncertainties (k = 1).")
    lines += _jaw_advice(comparison)
    lines.append("No serious doubt." if comparison.reliable else "NOT RELIABLE; the warnings say why.")
    return lines


def _jaw_advice(comparison: Comparison) -> list[str]:
    """What would tell the places of the areas in the words of the mouth."""
    if comparison.parameters.jaw is not None or not comparison.areas:
        return []
    arch = arch_frame(comparison.before.mesh, comparison.before.supported)
    return [] if arch is None or arch.forward is None else ["Say --jaw upper or lower for right, left, cheek and tongue."]


def _alignment(comparison: Comparison) -> list[str]:
    alignment = comparison.alignment
    said = f"Alignment, held fixed: {HELD[alignment.frame]}"
    if alignment.frame is not Frame.GIVEN:
        said += f" ({100 * alignment.stable_area_fraction:.0f} % of the area; {alignment.method}): rms {alignment.rms_um:.1f} um, "
        said += f"uncertainty +- {2 * alignment.uncertainty_um:.1f} um, size after / before {alignment.scale_ratio:.5f}"
    return [said + ".", *(f"    {sentence}" for sentence in shift_sentences(comparison))]


def _area(area: Area, comparison: Comparison) -> str:
    place = ", ".join(f"{value:.1f}" for value in area.centroid_mm)
    told = f"{area.rank:3d}. {area.words} [{place}] mm: {area.area_mm2:.1f} mm2, mean {area.mean_um:+.0f} um, 95 % below {area.p95_um:.0f} um"
    told += f", volume {area.volume_mm3:+.2f} mm3"
    if area.motion is not None:
        moved = float(np.linalg.norm(area.motion.displacement_mm))
        told += f"; moved {moved:.3f} mm +- {2 * area.motion.displacement_uncertainty_um:.0f} um, turned {area.motion.angle_deg:.2f} deg"
        told += f" +- {2 * area.motion.angle_uncertainty_deg:.2f} deg"
    return told + (" (not above the null comparison)" if above_null(area, comparison) is False else "")


def null_summary(level: NullLevel, rig: str) -> list[str]:
    """What was stored with a rig."""
    return [
        f"Null comparison of '{level.material}' stored in {rig}: 95 % of the surface seemed to move by less than {level.level_um:.1f} um "
        f"(rms {level.rms_um:.1f} um, 99 % {level.p99_um:.1f} um); the largest area that seemed to move by more than 0.1 mm has "
        f"{level.false_area_100_mm2:.2f} mm2, by more than 0.2 mm {level.false_area_200_mm2:.2f} mm2."
    ]


def series_summary(series: Series) -> list[str]:
    """A series in lines that a person reads."""
    lines = [f"Series of {len(series.names)}, all in the frame of {series.names[0]}."]
    for name, comparison in zip(series.names[1:], series.to_first, strict=True):
        found = comparison.deviation.statistics
        areas = "1 area" if len(comparison.areas) == 1 else f"{len(comparison.areas) or 'no'} areas"
        lines.append(f"{name}: rms {found.rms_um:.1f} um, 95 % below {found.p95_um:.1f} um, {areas} of difference.")
    for number, closure_um in enumerate(series.closure_um, 2):
        lines.append(f"Going through {series.names[number - 1]}, {series.names[number]} lands {closure_um:.1f} um beside its direct place.")
    for track in series.tracks:
        places = ", ".join(f"{value:.1f}" for value in track.centroid_mm)
        course = ", ".join(_at_a_time(name, magnitude_um) for name, magnitude_um in zip(series.names[1:], track.p95_um, strict=True))
        lines.append(f"    {track.words} [{places}] mm; 95 % below: {course}")
    return lines + (_jaw_advice(series.to_first[-1]) if series.tracks else [])


def _at_a_time(name: str, magnitude_um: float) -> str:
    return f"{name} {magnitude_um:.0f} um" if isfinite(magnitude_um) else f"{name} without counterpart"
