"""The areas of greatest difference: found, grouped and ranked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.area_words import area_words
from scanner_core.comparison.crowns import find_crowns
from scanner_core.comparison.deviation import Deviation
from scanner_core.comparison.measuring import LEAST_NOISE_UM, weighted_percentiles
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.comparison.part_motion import motion_of_fit
from scanner_core.comparison.part_refinement import PartRefinement
from scanner_core.comparison.patches import PatchGroup, connected, crown_groups, plain_groups
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.comparison.volume import volume_between
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]
THRESHOLD_UM = 200.0
"""Least deviation of an area; the level of detection where that is greater."""
SMOOTHING_MM = 0.4
_LEAST_PATCH_MM2 = 0.5
_BOTH_WAYS = 0.1
"""Least share of an area on the other side of the surface for which it is said to differ in both directions."""
_SURE = 2.0
"""Standard uncertainties that a displacement must exceed to be told."""
_EXPLAINED = 1.2
"""P95 of an area's deviation over the largest displacement of its part: no point comes to lie farther off than the part has moved."""
_OFF_MM = 0.2
"""What is farther from where the motion puts it, beyond the noise, has not gone along."""
_THICK_MM = 0.8
"""Of that only what lies this deep inside counts: rims of a tooth, where gum and neighbours round it off, are thin; another tooth is not."""
_MOST_OFF = 0.09
"""Share of such points of the free part of an area above which one motion does not explain it.  Measured: single teeth up to 0.07,
two neighbours under one motion from 0.11."""
_MOST_TURN_DEG = 45.0
"""A tooth is not turned farther from one scan to the next; a fit that says so has slid round a nearly round crown."""
_MOST_RMS = 3.0
"""Rms of what the motion leaves over, in units of the noise and of `_MODEL_UM`."""
_MODEL_UM = 30.0
"""By which a rigid motion misses tissue that did go along with it."""


def find_areas(
    before: ComparedSurface,
    after: ComparedSurface,
    alignment: Alignment,
    deviation: Deviation,
    parameters: ComparisonParameters,
    *,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> tuple[Area, ...]:
    """Areas where the smoothed signed deviation exceeds `THRESHOLD_UM` or the level of detection, greatest first.

    On an arch, what differs on a crown that has moved as a rigid body is one entry, however many patches it shows as, and
    what a moved crown pushes over onto the flanks of its neighbours belongs to it.  Elsewhere each connected patch is one.  A motion is
    told only where it is more than its uncertainty and explains the area.  The order is that of the displacement of the part's
    centre or of the P95 of the deviation, whichever is greater.  Raises `Cancelled`.
    """
    progress(Progress("areas", 0.0))
    mesh = TriangleMesh(alignment.transform.apply(after.mesh.vertices), after.mesh.triangles)
    table = EdgeTable.of(mesh.triangles)
    smoother = SurfaceSmoother(mesh, table)
    seen = np.isfinite(deviation.signed_um)
    smooth = smoother(np.where(seen, deviation.signed_um, 0.0), SMOOTHING_MM, seen)
    over = seen & (np.abs(smooth) > np.maximum(deviation.level_um, THRESHOLD_UM))
    if not over.any():
        return ()
    normals, area_mm2 = mesh.vertex_normals(), smoother.area_mm2
    frame = arch_frame(before.mesh, before.supported)
    progress(Progress("areas", 0.2))
    groups = (
        plain_groups(over, table, area_mm2)
        if frame is None
        else crown_groups(
            mesh,
            over,
            seen | _gone_far(before, after, mesh.vertices, deviation, parameters.no_counterpart_mm),
            find_crowns(mesh, frame.up, smoother, table),
            frame.up,
            smoother,
            table,
            before.mesh,
            alignment,
            cancelled,
        )
    )
    progress(Progress("areas", 0.8))
    ranked: list[tuple[float, Area]] = []
    noise_mm = max(alignment.noise_um, LEAST_NOISE_UM) / 1e3
    refinement = PartRefinement(before.mesh, mesh) if any(group.fit is not None for group in groups) else None
    for group in groups:
        if cancelled():
            raise Cancelled
        motion = None
        if group.fit is not None and refinement is not None:
            core = np.zeros(len(mesh.vertices), np.bool_)
            core[group.core] = True
            fit = refinement.refine(group.fit, core, noise_mm, alignment.correlation_length_mm)
            middle = mesh.vertices[group.body].mean(axis=0)
            motion = motion_of_fit(fit, middle, float(area_mm2[group.core].sum()), alignment, None if frame is None else frame.up)
        area = _area(group, mesh, normals, area_mm2, smooth, deviation, table)
        if motion is not None and _explains(motion, group, mesh.vertices, area.p95_um, alignment.noise_um):
            area = replace(area, motion=motion)
        ranked.append((_size_um(area), replace(area, words=area_words(area, frame, parameters.jaw))))
    ranked.sort(key=lambda entry: -entry[0])
    progress(Progress("areas", 1.0))
    return tuple(replace(area, rank=rank) for rank, (_, area) in enumerate(ranked, 1))


def _gone_far(before: ComparedSurface, after: ComparedSurface, places: Array, deviation: Deviation, most_mm: float) -> NDArray[np.bool_]:
    """Vertices (v,) of the after surface, its aligned `places` (v, 3), without counterpart only because they have gone too far.

    What lies opposite to the rim of the before surface, or to a part of it that is no measurement, was never seen there.
    """
    far = after.supported & ~np.isfinite(deviation.signed_um) & (np.linalg.norm(places - deviation.feet_mm, axis=1) > most_mm)
    if far.any():
        table = EdgeTable.of(before.mesh.triangles)
        inner = before.supported.copy()
        inner[table.edges[np.bincount(table.side_edges.ravel(), minlength=len(table.edges)) == 1].ravel()] = False
        far[far] = inner[cKDTree(before.mesh.vertices).query(deviation.feet_mm[far])[1]]
    return np.asarray(far)


def _size_um(area: Area) -> float:
    """By which all entries, moved parts or not, are ranked."""
    return area.p95_um if area.motion is None else max(area.p95_um, 1e3 * float(np.linalg.norm(area.motion.displacement_mm)))


def _explains(motion: PartMotion, group: PatchGroup, places: Array, p95_um: float, noise_um: float) -> bool:
    """Whether a motion is beyond doubt, is what the area of deviation shows, and leaves little more than noise over.

    `places` (v, 3) are the vertices of the aligned after surface.
    """
    assert group.fit is not None, "a motion comes from a fit"
    steps = places[group.body] - group.fit.transform.apply(places[group.body])
    largest_um = 1e3 * float(np.sqrt((steps * steps).sum(axis=1).max()))
    sure = 1e3 * float(np.linalg.norm(motion.displacement_mm)) > _SURE * motion.displacement_uncertainty_um
    off = group.left_mm > _OFF_MM + 2e-3 * noise_um
    judged = places[group.judged]
    thick = off.sum() if off.all() else (cKDTree(judged[~off]).query(judged[off])[0] > _THICK_MM).sum() if off.any() else 0
    rigid = motion.angle_deg < _MOST_TURN_DEG and thick <= _MOST_OFF * len(off) and motion.rms_um < _MOST_RMS * np.hypot(noise_um, _MODEL_UM)
    return bool(sure and rigid and p95_um <= _EXPLAINED * largest_um + 2 * noise_um)


def _area(
    group: PatchGroup,
    mesh: TriangleMesh,
    normals: Array,
    area_mm2: Array,
    smooth_um: Array,
    deviation: Deviation,
    table: EdgeTable,
) -> Area:
    vertices = group.vertices
    inside = np.zeros(len(mesh.vertices), np.bool_)
    inside[vertices] = True
    signed, weight = deviation.signed_um[vertices], area_mm2[vertices]
    corners = inside[mesh.triangles].sum(axis=1)  # a vertex stands for a third of each triangle round it
    at_all = corners > 0
    normal = weight @ normals[vertices]
    length = float(np.linalg.norm(normal))
    return Area(
        rank=0,
        vertices=vertices.astype(np.int64),
        centroid_mm=weight @ mesh.vertices[vertices] / weight.sum(),
        normal=normal / length if length > 1e-9 else np.array([0.0, 0.0, 1.0]),
        area_mm2=float(weight.sum()),
        mean_um=float(np.average(signed, weights=weight)),
        p95_um=float(weighted_percentiles(np.abs(signed), weight, (95.0,))[0]),
        max_um=float(signed[np.argmax(np.abs(signed))]),
        volume_mm3=volume_between(mesh.vertices, deviation.feet_mm, mesh.triangles[at_all], corners[at_all] / 3),
        parts=_parts(inside, smooth_um, table, area_mm2),
        words="",
        both_ways=bool(_BOTH_WAYS < weight[signed > 0].sum() / weight.sum() < 1 - _BOTH_WAYS),
    )


def _parts(inside: NDArray[np.bool_], smooth_um: Array, table: EdgeTable, area_mm2: Array) -> int:
    """Connected patches of one sign, specks left out; at least 1."""
    count = 0
    for one_sign in (inside & (smooth_um > 0), inside & (smooth_um < 0)):
        if one_sign.any():
            label = connected(one_sign, table.edges)
            count += int((np.bincount(label[one_sign], area_mm2[one_sign]) >= _LEAST_PATCH_MM2).sum())
    return max(count, 1)
