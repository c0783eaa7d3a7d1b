"""The areas of greatest difference: found, grouped and ranked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.area_words import area_words
from scanner_core.comparison.crowns import find_crowns
from scanner_core.comparison.deviation import Deviation
from scanner_core.comparison.measuring import weighted_percentiles
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.comparison.part_motion import motion_of_fit
from scanner_core.comparison.patches import PatchGroup, connected, crown_groups, plain_groups
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.comparison.volume import volume_between
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import IsCancelled, OnProgress, Progress

Array = NDArray[np.float64]
THRESHOLD_UM = 200.0
"""Least deviation of an area; the level of detection where that is greater."""
SMOOTHING_MM = 0.4
_LEAST_PATCH_MM2 = 0.5


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
    what a moved crown pushes over onto the flanks of its neighbours belongs to it.  Elsewhere each connected patch is one.  Entries
    with a motion come first, by how far the part's centre has moved; the others follow by their volume.  Raises `Cancelled`.
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
            mesh, over, seen, find_crowns(mesh, frame.up, smoother, table), frame.up, smoother, table, before.mesh, alignment, cancelled
        )
    )
    progress(Progress("areas", 0.8))
    ranked: list[tuple[float, Area]] = []
    for group in groups:
        motion = None
        if group.fit is not None:
            middle = mesh.vertices[group.body].mean(axis=0)
            motion = motion_of_fit(group.fit, middle, float(area_mm2[group.core].sum()), alignment, None if frame is None else frame.up)
        area = _area(group, mesh, normals, area_mm2, smooth, deviation, table, motion)
        moved = 0.0 if motion is None else float(np.linalg.norm(motion.displacement_mm))
        ranked.append((moved, replace(area, words=area_words(area, frame, parameters.jaw))))
    ranked.sort(key=lambda entry: (-entry[0], -abs(entry[1].volume_mm3)))
    progress(Progress("areas", 1.0))
    return tuple(replace(area, rank=rank) for rank, (_, area) in enumerate(ranked, 1))


def _area(
    group: PatchGroup,
    mesh: TriangleMesh,
    normals: Array,
    area_mm2: Array,
    smooth_um: Array,
    deviation: Deviation,
    table: EdgeTable,
    motion: PartMotion | None,
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
        motion=motion,
    )


def _parts(inside: NDArray[np.bool_], smooth_um: Array, table: EdgeTable, area_mm2: Array) -> int:
    """Connected patches of one sign, specks left out; at least 1."""
    count = 0
    for one_sign in (inside & (smooth_um > 0), inside & (smooth_um < 0)):
        if one_sign.any():
            label = connected(one_sign, table.edges)
            count += int((np.bincount(label[one_sign], area_mm2[one_sign]) >= _LEAST_PATCH_MM2).sum())
    return max(count, 1)
