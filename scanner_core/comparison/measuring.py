"""Measuring how far two aligned surfaces differ, both ways."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.deviation import Deviation, DeviationStatistics
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.comparison.signed_distance import SignedDistance, SignedFeet
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]
LEAST_NOISE_UM = 0.5
"""Standard deviation below which no distance of two files is known: the level of detection of identical files is 1 um, not 0."""
COVERAGE = 1.96
"""Two-sided 95 % of a normal distribution."""
_TOUCHING_MM = 1e-6
"""Beside a border this close, a point lies on it, and it is the counterpart: of identical files nothing is left out."""
THRESHOLDS_UM = (100, 250, 500)
_PERCENTILES = (50.0, 95.0, 99.0)


def measure_deviation(
    before: ComparedSurface,
    after: ComparedSurface,
    alignment: Alignment,
    parameters: ComparisonParameters,
    *,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> Deviation:
    """Signed distances of the aligned surfaces, after to before and before to after.

    A vertex has no counterpart, and is NaN, where the closest point is farther than `parameters.no_counterpart_mm`, lies on
    the border of the other surface, the vertex itself beside it, or on a part of it that is no measurement, or where the vertex itself is none.

    Raises `Cancelled`.
    """
    moved = TriangleMesh(alignment.transform.apply(after.mesh.vertices), after.mesh.triangles)
    progress(Progress("deviation", 0.0))
    feet = SignedDistance(before.mesh).feet(moved.vertices, cancelled, parameters.no_counterpart_mm)
    progress(Progress("deviation", 0.4))
    back = SignedDistance(moved).feet(before.mesh.vertices, cancelled, parameters.no_counterpart_mm)
    progress(Progress("deviation", 0.9))
    signed = _with_counterpart(feet, after.supported, before, parameters)
    before_signed = _with_counterpart(back, before.supported, after, parameters)
    level = _level_of_detection(before, after, alignment, feet)
    area = vertex_areas(moved)
    seen = np.isfinite(signed)
    statistics = deviation_statistics(signed, before_signed, np.where(after.supported, area, 0.0))
    typical = weighted_percentiles(level[seen], area[seen], (50.0,))[0] if seen.any() else float(np.median(level))
    progress(Progress("deviation", 1.0))
    return Deviation(signed, before_signed, feet.points, level, float(typical), statistics)


def vertex_areas(mesh: TriangleMesh) -> Array:
    """A third of the triangles around each vertex, (v,) mm^2."""
    return np.asarray(np.bincount(mesh.triangles.ravel(), np.repeat(mesh.areas() / 3, 3), minlength=len(mesh.vertices)), np.float64)


def weighted_percentiles(values: Array, weights: Array, percentiles: tuple[float, ...]) -> Array:
    """Percentiles of values (n,) of which each stands for a share `weights` (n,) of the whole; n at least 1.

    Each value sits in the middle of its share; between them it is linear.
    """
    order = np.argsort(values, kind="stable")
    share = weights[order]
    middle = np.cumsum(share) - 0.5 * share
    return np.asarray(np.interp(np.asarray(percentiles) / 100 * share.sum(), middle, values[order]))


def deviation_statistics(signed_um: Array, before_signed_um: Array, area_mm2: Array) -> DeviationStatistics:
    """Statistics by area of (v,) signed distances, NaN without counterpart; `area_mm2` (v,) is 0 where a vertex does not count.

    The Hausdorff distances are one-sided and of what has a counterpart: over all points they would tell how much farther one scan
    reaches than the other.  Without any counterpart the lengths are NaN.
    """
    seen = np.isfinite(signed_um) & (area_mm2 > 0)
    value, weight = signed_um[seen], area_mm2[seen]
    total = float(area_mm2.sum())
    without = 1.0 - float(weight.sum()) / total if total > 0 else 1.0
    there = before_signed_um[np.isfinite(before_signed_um)]
    back = float(np.abs(there).max()) if len(there) else float("nan")
    if not len(value):
        nan = float("nan")
        none = {str(threshold): 0.0 for threshold in THRESHOLDS_UM}
        return DeviationStatistics(0, without, nan, nan, nan, nan, nan, nan, none, nan, back)
    size = np.abs(value)
    p50, p95, p99 = weighted_percentiles(size, weight, _PERCENTILES)
    return DeviationStatistics(
        points=len(value),
        no_counterpart_fraction=max(without, 0.0),
        mean_um=float(np.average(value, weights=weight)),
        rms_um=float(np.sqrt(np.average(value * value, weights=weight))),
        p50_um=float(p50),
        p95_um=float(p95),
        p99_um=float(p99),
        max_um=float(size.max()),
        area_above_mm2={str(threshold): float(weight[size > threshold].sum()) for threshold in THRESHOLDS_UM},
        hausdorff_after_to_before_um=float(size.max()),
        hausdorff_before_to_after_um=back,
    )


def _with_counterpart(feet: SignedFeet, supported: NDArray[np.bool_], other: ComparedSurface, parameters: ComparisonParameters) -> Array:
    """Signed distances in um, NaN without counterpart."""
    distance = np.abs(feet.signed_mm)
    counts = supported & ~(feet.on_border & (distance > _TOUCHING_MM)) & (distance <= parameters.no_counterpart_mm)
    if not other.supported.all():
        counts &= feet.of_vertices(other.mesh, (~other.supported).astype(np.float64)) < 1e-9
    return np.where(counts, 1e3 * feet.signed_mm, np.nan)


def _level_of_detection(before: ComparedSurface, after: ComparedSurface, alignment: Alignment, feet: SignedFeet) -> Array:
    """(v_after,) um: what noise and alignment alone reach one time in twenty.

    The noise of one distance is the greater of two: the scatter that the alignment has seen on the stable region, which holds
    what both scanners, the resampling and the matching do, but is one number for all places; and the two surfaces' own local
    uncertainty, which tells where a scan is worse than elsewhere, but not what it does not know of.
    """
    noise = np.full(len(feet.signed_mm), max(alignment.noise_um, LEAST_NOISE_UM))
    own = np.zeros(len(noise))
    stated = after.mesh.vertex_attributes.get("standard_uncertainty_um")
    if stated is not None:
        own += _finite(np.asarray(stated, np.float64)) ** 2
    stated = before.mesh.vertex_attributes.get("standard_uncertainty_um")
    if stated is not None:
        own += feet.of_vertices(before.mesh, _finite(np.asarray(stated, np.float64))) ** 2
    noise = np.maximum(noise, np.sqrt(own))
    placed = alignment.uncertainty_along_um(feet.points, feet.normals)
    return np.asarray(COVERAGE * np.sqrt(noise**2 + placed**2))


def _finite(values: Array) -> Array:
    return np.nan_to_num(values, nan=0.0, posinf=0.0, neginf=0.0)
