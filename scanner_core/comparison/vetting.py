"""What is noticed about a surface before it is compared; nothing of it is repaired."""

from __future__ import annotations

import numpy as np

from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.shells import Shells, shells_of
from scanner_core.geometry.checks import MeshChecks, check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.self_intersection import self_intersecting_triangles

LEAST_FULLNESS = 0.01
"""An open surface that encloses less, for its area, is a sheet: nobody can tell which of its sides is the outer one.
A spherical cap of this fullness is as high as a twenty-eighth of its width."""
MOST_TURNED = 0.01
"""Share of the area that may face the other way: triangles at faults of a scan do, and change no number that is told."""
LEAST_FACING = 0.1
"""The area vectors of an arch add up, along its own up and over its area, to 0.3 to 0.5, and to as much below 0 when it faces inwards."""
LARGEST_MM, SMALLEST_MM = 400.0, 5.0
_ROUNDING = 1e-9
_FIRST_SAMPLE = 500
_MOST_CROSSING, _MOST_CROSSING_SHARE = 1000, 0.25


def vet(mesh: TriangleMesh) -> tuple[Doubt, ...]:
    """What a person should know of a mesh in mm with at least one triangle, gravest first."""
    crossing, counted = count_crossing(mesh)
    shells, checks = shells_of(mesh), check_mesh(mesh, self_intersections=crossing)
    found = [*_facing(shells, mesh), *_parts(shells, mesh), *_faults(checks, counted), *_size(mesh)]
    return tuple(sorted(found, key=lambda doubt: not doubt.serious))


def count_crossing(mesh: TriangleMesh) -> tuple[int, bool]:
    """How many triangles intersect another one, and whether all were counted.

    In a soup of large triangles nearly every pair crosses, and counting them all takes time that grows with the square of their number.
    So samples come first, each four times as large as the one before, until one has too many crossings to go on.
    """
    order = np.random.default_rng(0).permutation(len(mesh.triangles))
    size = _FIRST_SAMPLE
    while size < len(order):
        used, triangles = np.unique(mesh.triangles[order[:size]], return_inverse=True)
        crossing = len(self_intersecting_triangles(TriangleMesh(mesh.vertices[used], triangles.reshape(-1, 3))))
        if crossing > min(_MOST_CROSSING, _MOST_CROSSING_SHARE * size):
            return crossing, False
        size *= 4
    return len(self_intersecting_triangles(mesh)), True


def _facing(shells: Shells, mesh: TriangleMesh) -> list[Doubt]:
    if shells.turned_share > MOST_TURNED:
        return [Doubt.told("winding-inconsistent", True, share=_percent(shells.turned_share))]
    faults = []
    if shells.turned_share > _ROUNDING:
        faults.append(Doubt.told("winding-faults", False, share=_percent(shells.turned_share)))
    return faults + _inverted(shells, mesh)


def _inverted(shells: Shells, mesh: TriangleMesh) -> list[Doubt]:
    if shells.closed:
        if shells.fullness >= 0:
            return []
        return [Doubt.told("normals-inverted", True)]
    facing = _arch_facing(mesh)
    if facing < -LEAST_FACING:
        return [Doubt.told("normals-inverted/arch", True)]
    if facing <= LEAST_FACING and shells.fullness < -LEAST_FULLNESS:
        return [Doubt.told("normals-seem-inverted", True)]
    return []


def _arch_facing(mesh: TriangleMesh) -> float:
    """How far an open arch faces to the side of its teeth: the sum of the area vectors along it, over the area; 0 for what is no whole arch."""
    frame = arch_frame(mesh, np.ones(len(mesh.vertices), np.bool_))
    return 0.0 if frame is None or frame.forward is None else float(mesh.area_vectors().sum(axis=0) @ frame.up) / mesh.area()


def _parts(shells: Shells, mesh: TriangleMesh) -> list[Doubt]:
    found = []
    if shells.border_edges:
        lines = {} if shells.borders == 1 else {"count": str(shells.borders)}
        found.append(Doubt.told("open" if lines else "open/one", False, mm=f"{shells.border_mm:.0f}", **lines))
    if shells.count > 1:
        found.append(Doubt.told("several-shells", False, count=str(shells.count), share=_percent(shells.largest_share)))
    return found


def _percent(share: float) -> str:
    return "more than 99.9 %" if share >= 0.9995 else "less than 0.1 %" if share < 0.0005 else f"{100 * share:.1f} %"


def _faults(checks: MeshChecks, counted: bool) -> list[Doubt]:
    found = []
    if checks.nonmanifold_edges or checks.nonmanifold_vertices:
        found.append(Doubt.told("non-manifold", False, edges=str(checks.nonmanifold_edges), corners=str(checks.nonmanifold_vertices)))
    if checks.degenerate == 1:
        found.append(Doubt.told("degenerate-triangles/one", False))
    elif checks.degenerate:
        found.append(Doubt.told("degenerate-triangles", False, count=str(checks.degenerate)))
    if checks.self_intersections:
        found.append(Doubt.told("self-touching" if counted else "self-touching/more", False, count=str(checks.self_intersections)))
    return found


def _size(mesh: TriangleMesh) -> list[Doubt]:
    low, high = mesh.bounds()
    largest = float((high - low).max())
    if SMALLEST_MM <= largest <= LARGEST_MM:
        return []
    return [Doubt.told("size-odd", False, mm=f"{largest:.4g}")]
