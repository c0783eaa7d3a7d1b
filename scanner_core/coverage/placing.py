"""From the reasons of single vertices to places that a person can go to."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components

from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.sightlines import LIFT_MM
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.ray_caster import RayCaster

Array = NDArray[np.float64]
Numbers = NDArray[np.int64]

LEAST_MM2 = 1.0
"""Smaller parts go to the neighbour that they share the longest border with, or are left out where all round them is as wanted."""
_LOOKS = 96
"""Directions in which a place is looked from to find a tilt."""
_SAMPLE = 24
"""Vertices of a place that are looked at for that."""
_SEEN_FROM_DEG = 35.0
"""Elevation of laser and cameras over the table, about; a place is seen well by all three from there."""


def parts_of(
    surface: TriangleMesh, reasons: NDArray[np.uint8], least_cosine: float, least_mm2: float = LEAST_MM2
) -> list[tuple[CoveragePlace, Numbers]]:
    """Connected vertices with one reason as places, largest first, each with its vertices; what is within the wanted uncertainty is none.

    Parameters
    ----------
    reasons : (v,) index into :data:`REASONS`
    least_cosine : flatter than this no direction sees a place
    """
    table = EdgeTable.of(surface.triangles)
    area = vertex_areas(surface)
    merged = _without_crumbs(table.edges, reasons, area, least_mm2)
    open_ = merged != REASONS.index(Reason.WITHIN)
    part = _parts(table.edges, merged)
    sizes = np.bincount(part, area)
    sums = area[:, None] * surface.vertex_normals()
    supported = np.asarray(surface.vertex_attributes["supported"]) > 0
    uncertainty_um = np.asarray(surface.vertex_attributes["standard_uncertainty_um"], np.float64)
    caster = RayCaster(surface)
    found = []
    for number in np.unique(part[open_]).tolist():
        if sizes[number] < least_mm2:
            continue
        here = np.flatnonzero(part == number)
        weight = area[here]
        x, y, z = (weight @ surface.vertices[here] / weight.sum()).tolist()
        normal = sums[here].sum(axis=0)
        u, v, w = (normal / max(float(np.linalg.norm(normal)), 1e-30)).tolist()
        reason = REASONS[int(merged[here[0]])]
        worst = uncertainty_um[here[supported[here]]]
        place = CoveragePlace(
            reason=reason,
            centroid_mm=(x, y, z),
            normal=(u, v, w),
            area_mm2=float(sizes[number]),
            worst_um=float(worst.max()) if len(worst) else None,
            tilt_deg=_tilt_deg(surface, here, caster, least_cosine) if reason.needs_another_mount else None,
        )
        found.append((place, here))
    return sorted(found, key=lambda part: -part[0].area_mm2)


def vertex_areas(surface: TriangleMesh) -> Array:
    """A third of the triangles round each vertex, (v,) mm^2."""
    return np.asarray(np.bincount(surface.triangles.ravel(), np.repeat(surface.areas() / 3, 3), len(surface.vertices)), np.float64)


def _parts(edges: Numbers, reasons: NDArray[np.uint8]) -> Numbers:
    """Number of the connected part of each vertex, (v,)."""
    alike = edges[reasons[edges[:, 0]] == reasons[edges[:, 1]]]
    graph = sparse.coo_array((np.ones(len(alike), np.bool_), (alike[:, 0], alike[:, 1])), shape=(len(reasons), len(reasons)))
    return np.asarray(connected_components(graph, directed=False)[1], np.int64)


def _without_crumbs(edges: Numbers, reasons: NDArray[np.uint8], area: Array, least_mm2: float) -> NDArray[np.uint8]:
    """Reasons (v,) after small parts were given to the neighbour that is not as wanted either and has the longest common border."""
    merged = reasons.copy()
    for _ in range(3):  # a crumb's neighbour may be a crumb
        part = _parts(edges, merged)
        small = np.bincount(part, area) < least_mm2
        small &= np.bincount(part, merged != REASONS.index(Reason.WITHIN)) > 0
        a, b = np.concatenate([edges, edges[:, ::-1]]).T
        border = small[part[a]] & (part[a] != part[b]) & (merged[b] != REASONS.index(Reason.WITHIN))
        votes = np.zeros((len(small), len(REASONS)), np.int64)
        np.add.at(votes, (part[a[border]], merged[b[border]]), 1)
        taken = (votes.sum(axis=1) > 0)[part]
        if not taken.any():
            break
        merged[taken] = votes.argmax(axis=1)[part[taken]]
    return merged


def _tilt_deg(surface: TriangleMesh, here: Numbers, caster: RayCaster, least_cosine: float) -> float | None:
    """By how much the direction from which most of a place is seen best lies above or below where the rig looks from; None without one."""
    some = here[:: max(1, len(here) // _SAMPLE)]
    normals = surface.vertex_normals()[some]
    starts = surface.vertices[some] + LIFT_MM * normals
    far_mm = 2 * float(np.linalg.norm(np.ptp(surface.vertices, axis=0)))
    looks = _directions(_LOOKS)
    cosines = normals @ looks.T
    seen = np.zeros(len(looks))
    for k, look in enumerate(looks):
        facing = np.flatnonzero(cosines[:, k] > least_cosine)
        free = caster.first_hits(starts[facing], starts[facing] + far_mm * look)[1] < 0
        seen[k] = cosines[facing[free], k].sum()
    if not seen.any():
        return None
    elevation = np.degrees(np.arcsin(looks[int(np.argmax(seen)), 2]))
    return float(abs(_SEEN_FROM_DEG - elevation))


def _directions(count: int) -> Array:
    """Unit vectors (count, 3) spread evenly over the sphere (Fibonacci lattice)."""
    z = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (1 + 5**0.5) * np.arange(count)
    level = np.sqrt(1 - z**2)
    return np.stack([level * np.cos(turn), level * np.sin(turn), z], axis=1)
