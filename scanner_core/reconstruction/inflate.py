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
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.edges import EdgeTable, row_dot
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.remeshing import collapse_short, flip_edges, split_long
from scanner_core.geometry.smoothing import uniform_averaging
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.geometry.voxel_region import Field, Region, VoxelGrid
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.region import EnclosedRegion

Array = NDArray[np.float64]

_STEP = 0.4
"""Longest move of a vertex, in edges."""

_LONGEST_EDGE = 1.0
"""In radii of the largest ball in the region; a plate of thickness t has edges of half of t."""
_LEAST_EDGE_VOXELS = 1.8
LEAST_TRIANGLES = 1200
_MOST_ITERATIONS = 1500
_MOST_TRIANGLES = 2.5
"""A healthy balloon stays below so many times the triangles that the region's border asks for."""
_PASSES = 0.6
"""Radius of the ball that passes where a balloon does, in edges."""
_GRADE = 0.3
"""How fast the edges grow away from a thin part, mm per mm."""
_LENGTH_NODES = 600_000
_TRIES = 2
_TOO_MANY = 30_000
"""Triangles of a balloon that is not tried any more: what needs such short edges has failed twice with longer ones."""
_FOLDED = 1.2
_REACHED = 1.5
"""Distance of a point from the nearest vertex of a balloon that has got there, in edges."""
_GUARD = (0.88, 1.1)
"""Healthy range of volume(balloon) / volume(region): 0.93 to 1.02 when it fills it, several when it folded."""


@dataclass(frozen=True, slots=True, eq=False)
class Balloon:
    """The inflated balloon.

    Attributes
    ----------
    mesh : closed, genus 0
    edge_mm : length that its edges were kept at where the region is thinnest
    fill : volume of the balloon over that of the region
    iterations : moves that it took
    """

    mesh: TriangleMesh
    edge_mm: float
    fill: float
    iterations: int


@dataclass(frozen=True, slots=True, eq=False)
class EdgeLengths:
    """The length of edges that a balloon gets everywhere with: short in thin parts and where it enters them.

    Attributes
    ----------
    grid : nodes, those of the region or every second of them
    lengths_mm : float32 at each node
    """

    grid: VoxelGrid
    lengths_mm: Field

    def least_mm(self) -> float:
        return float(self.lengths_mm.min())

    def at(self, points: Array) -> Array:
        """Length at points, (n,), mm."""
        return self.grid.sample(self.lengths_mm, points)

    def times(self, factor: float) -> EdgeLengths:
        return EdgeLengths(self.grid, self.lengths_mm * np.float32(factor))


def inflate(region: EnclosedRegion, pace: Pace) -> Balloon:
    """Inflate a balloon in a region; raises E-REC-03 when none of some tries fills it.

    A balloon that folded has met itself: behind a spot that is too thin for it, which a region grown by a voxel has not got,
    or across a gap that is too narrow for its edges.  One that does not fill the region needs shorter edges.
    """
    lengths = choose_lengths(region, pace)
    balloon = inflate_at(region, lengths, pace)
    if balloon.fill > _GUARD[1]:
        grown = region.grown()
        wide = choose_lengths(grown, pace)
        for shorter in (1.0, 0.7) if grown.handles == 0 else ():
            again = inflate_at(grown, wide.times(shorter), pace)
            if fills(again):
                return again
        lengths = _shorter_at_gaps(region, lengths, pace)
    for _ in range(_TRIES):
        if fills(balloon):
            return balloon
        lengths = lengths.times(0.7)
        if _triangles_to_come(region, lengths) > _TOO_MANY:
            break
        balloon = inflate_at(region, lengths, pace)
    if fills(balloon):
        return balloon
    raise ReconstructionError(
        "E-REC-03",
        reason=f"the inflating balloon takes {balloon.fill:.2f} times the volume that the points enclose",
        do="scan the thin or hidden parts more densely",
    )


def fills(balloon: Balloon) -> bool:
    """Whether it fills its region and has not folded."""
    return _GUARD[0] <= balloon.fill <= _GUARD[1]


def unreached_share(balloon: Balloon, points: Array, scale: CloudScale) -> float:
    """Share of (n, 3) points that lie, with most of their neighbours, farther from a balloon than its coarseness explains."""
    mesh = balloon.mesh
    table = EdgeTable.of(mesh.triangles)
    longest = np.zeros(len(mesh.vertices))
    for end in (0, 1):
        np.maximum.at(longest, table.edges[:, end], table.lengths(mesh.vertices))
    away, nearest = cKDTree(mesh.vertices).query(points)
    far = away > _REACHED * longest[nearest] + 3 * scale.noise_mm
    return float((far & (far[scale.neighbours].mean(axis=1) > 0.5)).mean())


def choose_lengths(region: EnclosedRegion, pace: Pace, least_triangles: int = LEAST_TRIANGLES) -> EdgeLengths:
    """The longest edges with which a balloon still gets into every part of the region, and has about so many triangles.

    A balloon of edge e passes where a ball of radius 0.6 e does.  What lies farther than another 1.2 e from what the
    centre of such a ball sweeps in one piece from the start needs shorter edges; towards thicker parts they grow slowly.
    """
    thin = 2 if region.depth_mm.size > _LENGTH_NODES else 1  # half the resolution is enough to choose a length
    grid = VoxelGrid(region.grid.origin, region.grid.voxel_mm * thin, region.depth_mm[::thin, ::thin, ::thin].shape)
    depth, inside = region.depth_mm[::thin, ::thin, ::thin], region.inside[::thin, ::thin, ::thin]
    edge = min(_LONGEST_EDGE * float(depth.max()), float(np.sqrt(_border_area(region) / (0.433 * least_triangles))))
    least = min(edge, _LEAST_EDGE_VOXELS * region.grid.voxel_mm)
    lengths = np.full(depth.shape, edge, np.float32)
    start = np.unravel_index(int(np.argmax(depth)), depth.shape)
    while edge > least:
        pace.check()
        pieces, _ = ndimage.label(depth >= _PASSES * edge)
        left = inside & _far_from(pieces == pieces[start], 2 * _PASSES * edge / grid.voxel_mm)
        if not left.any():
            break
        edge = max(0.8 * edge, least)
        _shorten(lengths, left, edge, grid.voxel_mm)
    return EdgeLengths(grid, lengths)


def _shorter_at_gaps(region: EnclosedRegion, lengths: EdgeLengths, pace: Pace) -> EdgeLengths:
    """The same with edges as short as the gaps between parts of the region are wide: across a narrow one, a balloon with
    long edges gets into itself."""
    grid, shortened = lengths.grid, lengths.lengths_mm.copy()
    thin = round(grid.voxel_mm / region.grid.voxel_mm)
    depth = region.depth_mm[::thin, ::thin, ::thin]
    edge = float(shortened.max())
    least = min(edge, _LEAST_EDGE_VOXELS * region.grid.voxel_mm)
    while edge > least:
        pace.check()
        radius = _PASSES * edge
        left = (depth < 0) & (depth > -radius) & _far_from(depth <= -radius, 2 * radius / grid.voxel_mm)
        if not left.any():
            break
        edge = max(0.8 * edge, least)
        _shorten(shortened, left, edge, grid.voxel_mm)
    return EdgeLengths(grid, shortened)


def _far_from(core: Region, voxels: float) -> Region:
    return np.asarray(ndimage.distance_transform_edt(~core) > voxels)


def _shorten(lengths_mm: Field, where: Region, edge_mm: float, voxel_mm: float) -> None:
    """Lower lengths to an edge in a region and within one edge of it; farther away they may grow."""
    away = ndimage.distance_transform_edt(~where) * voxel_mm
    np.minimum(lengths_mm, edge_mm + _GRADE * np.maximum(away - edge_mm, 0), out=lengths_mm, casting="same_kind")


def _border_area(region: EnclosedRegion) -> float:
    """Area of a region's border, mm^2: faces of voxels count two thirds, as on a ball."""
    faces = sum(int(np.count_nonzero(np.diff(region.inside, axis=axis))) for axis in range(3))
    return faces * region.grid.voxel_mm**2 / 1.5


def _triangles_to_come(region: EnclosedRegion, lengths: EdgeLengths) -> float:
    """How many triangles a balloon with given edges has when it fills a region."""
    border = region.grid.positions(region.inside & (region.depth_mm < 1.2 * region.grid.voxel_mm))
    edges = lengths.at(border[:: max(1, len(border) // 20_000)])
    return _border_area(region) * float((1 / (0.433 * edges**2)).mean())


def inflate_at(region: EnclosedRegion, lengths: EdgeLengths, pace: Pace) -> Balloon:
    """Inflate with given lengths of edges."""
    grid, depth = region.grid, region.depth_mm
    deepest = np.unravel_index(int(np.argmax(depth)), depth.shape)
    centre = grid.origin + grid.voxel_mm * np.array(deepest, float)
    radius = 0.85 * float(depth.max())
    for size in np.linspace(0.4, 1.0, 4) * radius:
        mesh = icosahedron(centre, float(size))
        pace.report(0.8, mesh, force=True)
    longest = 1.3 * float(lengths.at(centre[None])[0])
    while EdgeTable.of(mesh.triangles).lengths(mesh.vertices).mean() > longest:
        mesh = subdivide_uniform(mesh)
        away = mesh.vertices - centre
        mesh = TriangleMesh(centre + radius * away / np.linalg.norm(away, axis=1)[:, None], mesh.triangles)
        pace.report(0.8, mesh)
    return grown_into(mesh, region, lengths, pace)


def grown_into(mesh: TriangleMesh, region: EnclosedRegion, lengths: EdgeLengths, pace: Pace, most_moves: int = _MOST_ITERATIONS) -> Balloon:
    """Let a closed mesh that lies in a region, or about where it does, grow or shrink until it fills it."""
    target = region.volume_mm3()
    most = _MOST_TRIANGLES * _triangles_to_come(region, lengths) + 500
    volumes = [mesh.volume()]
    table = None
    while len(volumes) <= most_moves:
        mesh, table = _grow(mesh, table, region, lengths)
        volumes.append(mesh.volume())
        pace.report(0.8 + 0.2 * volumes[-1] / target, mesh if pace.wants_preview() else None)
        if volumes[-1] > _FOLDED * target or len(mesh.triangles) > most:
            break
        if len(volumes) > 12 and abs(volumes[-1] - volumes[-9]) < 5e-4 * target:
            break
    return Balloon(mesh, lengths.least_mm(), volumes[-1] / target, len(volumes) - 1)


def _grow(mesh: TriangleMesh, table: EdgeTable | None, region: EnclosedRegion, lengths: EdgeLengths) -> tuple[TriangleMesh, EdgeTable | None]:
    """One move outwards, and the remeshing that keeps the balloon healthy; takes and returns the table of edges where it is known."""
    table = table or EdgeTable.of(mesh.triangles)
    averaging = uniform_averaging(mesh, table)
    normals = mesh.vertex_normals()
    smooth = normals + averaging @ normals
    smooth /= np.maximum(np.sqrt(row_dot(smooth, smooth)), 1e-30)[:, None]
    room = region.grid.sample(region.depth_mm, mesh.vertices)
    edge = lengths.at(mesh.vertices)
    step = np.clip(0.7 * room, -_STEP * edge, _STEP * edge)
    vertices = mesh.vertices + step[:, None] * smooth
    # a little of the umbrella operator, less where the balloon has arrived, keeps the front from wrinkling
    pull = averaging @ vertices - vertices
    along = row_dot(pull, smooth)[:, None] * smooth
    moving = (np.abs(step) / (_STEP * edge))[:, None]
    vertices = vertices + 0.4 * (pull - along) + (0.05 + 0.25 * moving) * along
    moved = TriangleMesh(vertices, mesh.triangles)
    # the table stays true as long as no triangle changes
    changed = split_long(moved, 1.35 * edge, table)
    if changed is not moved:
        edge = lengths.at(changed.vertices)
        table = EdgeTable.of(changed.triangles)
    collapsed = collapse_short(changed, 0.6 * edge, table=table)[0]
    if collapsed is not changed:
        table = EdgeTable.of(collapsed.triangles)
    flipped = flip_edges(collapsed, table=table)
    return flipped, table if flipped is collapsed else None
