"""Phase one: an icosahedron inflates inside the points until it meets them, and is subdivided.

The balloon starts as twelve vertices and twenty triangles in the middle of the largest ball that the points leave free.
It grows to that ball, its triangles are split 1:4 until their edges fit the thinnest part, and then every vertex moves
outwards along its normal, never more than 0.4 of an edge at a time, as far as the distance to the enclosed region's
border allows.  After every step long edges are split, short ones collapsed, and edges flipped: with sparser remeshing,
or longer steps, the balloon folds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.remeshing import collapse_short, flip_edges, relax, split_long
from scanner_core.geometry.smoothing import uniform_averaging
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.region import EnclosedRegion

_STEP = 0.4
"""Longest move of a vertex, in edges."""

_LEAST_EDGE_VOXELS = 1.8
_LEAST_TRIANGLES = 1200
_MOST_ITERATIONS = 1500
_FOLDED = 1.2
_GUARD = (0.88, 1.1)
"""Healthy range of volume(balloon) / volume(region): 0.93 to 1.02 when it fills it, several when it folded."""


@dataclass(frozen=True, slots=True, eq=False)
class Balloon:
    """The inflated balloon.

    Attributes
    ----------
    mesh : closed, genus 0
    edge_mm : length that its edges were kept at
    fill : volume of the balloon over that of the region
    iterations : moves that it took
    """

    mesh: TriangleMesh
    edge_mm: float
    fill: float
    iterations: int


def inflate(region: EnclosedRegion, pace: Pace, tries: int = 3) -> Balloon:
    """Inflate a balloon in a region, with ever finer edges; raises E-REC-03 when none of the tries fills it."""
    edge = choose_edge(region, pace)
    fill = 0.0
    for _ in range(tries):
        balloon = inflate_at(region, edge, pace)
        fill = balloon.fill
        if _GUARD[0] <= fill <= _GUARD[1]:
            return balloon
        edge *= 0.7
    raise ReconstructionError(
        "E-REC-03",
        reason=f"the inflating balloon takes {fill:.2f} times the volume that the points enclose",
        do="scan the thin or hidden parts more densely",
    )


def choose_edge(region: EnclosedRegion, pace: Pace) -> float:
    """The longest edge with which a balloon still gets into every part of the region, mm.

    A balloon of edge e passes where a ball of radius 0.6 e does.  Of the region, nothing may lie farther than another
    0.6 e from what such a ball sweeps in one piece from the start.
    """
    thin = 2 if region.depth_mm.size > 400_000 else 1  # half the resolution is enough to choose a length
    voxel = region.grid.voxel_mm * thin
    depth, inside = region.depth_mm[::thin, ::thin, ::thin], region.inside[::thin, ::thin, ::thin]
    edge = min(0.9 * float(depth.max()), float(np.sqrt(_border_area(region) / (0.433 * _LEAST_TRIANGLES))))
    least = _LEAST_EDGE_VOXELS * region.grid.voxel_mm
    start = np.unravel_index(int(np.argmax(depth)), depth.shape)
    while edge > least:
        pace.check()
        radius = 0.6 * edge
        pieces, _ = ndimage.label(depth >= radius)
        core = pieces == pieces[start]
        away = ndimage.distance_transform_edt(~core) * voxel
        if float(away[inside].max()) <= 2 * radius:
            break
        edge *= 0.8
    return max(edge, least)


def _border_area(region: EnclosedRegion) -> float:
    """Area of a region's border, mm^2: faces of voxels count two thirds, as on a ball."""
    faces = sum(int(np.count_nonzero(np.diff(region.inside, axis=axis))) for axis in range(3))
    return faces * region.grid.voxel_mm**2 / 1.5


def inflate_at(region: EnclosedRegion, edge_mm: float, pace: Pace) -> Balloon:
    """Inflate with a given edge length."""
    grid, depth = region.grid, region.depth_mm
    deepest = np.unravel_index(int(np.argmax(depth)), depth.shape)
    centre = grid.origin + grid.voxel_mm * np.array(deepest, float)
    radius = 0.85 * float(depth.max())
    mesh = icosahedron(centre, 0.3 * radius)
    for size in np.linspace(0.4, 1.0, 4) * radius:
        mesh = icosahedron(centre, float(size))
        pace.report(0.0, mesh, force=True)
    while EdgeTable.of(mesh.triangles).lengths(mesh.vertices).mean() > 1.3 * edge_mm:
        mesh = subdivide_uniform(mesh)
        away = mesh.vertices - centre
        mesh = TriangleMesh(centre + radius * away / np.linalg.norm(away, axis=1)[:, None], mesh.triangles)
        pace.report(0.02, mesh)
    target = region.volume_mm3()
    volumes = [mesh.volume()]
    while len(volumes) <= _MOST_ITERATIONS:
        mesh = _grow(mesh, region, edge_mm)
        volumes.append(mesh.volume())
        pace.report(0.05 + 0.9 * volumes[-1] / target, mesh if pace.wants_preview() else None)
        if volumes[-1] > _FOLDED * target:
            break
        if len(volumes) > 12 and abs(volumes[-1] - volumes[-9]) < 5e-4 * target:
            break
    return Balloon(mesh, edge_mm, volumes[-1] / target, len(volumes) - 1)


def _grow(mesh: TriangleMesh, region: EnclosedRegion, edge_mm: float) -> TriangleMesh:
    """One move outwards, and the remeshing that keeps the balloon healthy."""
    averaging = uniform_averaging(mesh)
    normals = mesh.vertex_normals()
    smooth = normals + averaging @ normals
    smooth /= np.maximum(np.linalg.norm(smooth, axis=1), 1e-30)[:, None]
    room = region.grid.sample(region.depth_mm, mesh.vertices)
    step = np.clip(0.7 * room, -_STEP * edge_mm, _STEP * edge_mm)
    vertices = mesh.vertices + step[:, None] * smooth
    # a little of the umbrella operator, less where the balloon has arrived, keeps the front from wrinkling
    pull = averaging @ vertices - vertices
    along = (pull * smooth).sum(axis=1)[:, None] * smooth
    moving = (np.abs(step) / (_STEP * edge_mm))[:, None]
    vertices = vertices + 0.4 * (pull - along) + (0.05 + 0.25 * moving) * along
    mesh = TriangleMesh(vertices, mesh.triangles)
    mesh = split_long(mesh, 1.35 * edge_mm)
    mesh = collapse_short(mesh, 0.6 * edge_mm)[0]
    return flip_edges(mesh)


def settle(mesh: TriangleMesh, region: EnclosedRegion, rounds: int = 3) -> TriangleMesh:
    """Bring a subdivided balloon back to the region's border, without changing its connectivity."""
    for _ in range(rounds):
        room = region.grid.sample(region.depth_mm, mesh.vertices)
        limit = 0.3 * float(np.sqrt(mesh.area() / len(mesh.triangles)))
        normals = mesh.vertex_normals()
        mesh = relax(TriangleMesh(mesh.vertices + np.clip(0.6 * room, -limit, limit)[:, None] * normals, mesh.triangles), step=0.3)
    return mesh
