"""The region that the points enclose, on voxels: what guides the balloon.

Points carry no normals, and the base of an object is often not scanned.  The region comes from four steps.

1.  *Shielding* tells outside from inside without normals: a potential that is 1 far away and is absorbed by the points,
    as a cage shields its inside.  At each point it rises towards the outside.
2.  *The winding number*, as the solution of a Poisson equation for the points' oriented area (Kazhdan, Bolitho and
    Hoppe, SGP 2006), solved on the whole grid by a sine transform.  Its own gradient orients the points anew (Hou et al.,
    "Iterative Poisson surface reconstruction for unoriented points", SIGGRAPH 2022), until no point turns any more.
    Where the border of an unscanned base is plane, its level one half is that plane: a flat cap.
3.  *The table*, when it is known that the object stands on one: what hides under a rim that does not turn inwards is body
    down to the table, and nothing reaches below it.  Without it, a rim that is not plane leaves hollows under the object
    in which the balloon would meet itself.
4.  *Cleaning*: the largest piece, without cavities; narrow tunnels are closed and thin bridges cut, so that it has no handle.

The region is only a guide: the surface itself is the balloon's and is fitted to the points.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import fft, ndimage
from scipy.spatial import cKDTree

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.voxel_region import (
    Field,
    NodeWeights,
    Region,
    VoxelGrid,
    closed_by,
    euler_number,
    handles,
    largest_piece,
    opened_by,
    signed_depth,
)
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.table import standing_on_table

Array = NDArray[np.float64]

_COARSE_NODES = 150_000
_GRIDS = ((400_000, 1.0), (2_400_000, 1.0), (2_400_000, 0.7), (2_400_000, 0.5))
"""Nodes of the grid that the region is made on, and its blur in spacings of the points: a finer grid, and a blur that leaves
gaps between the points, only where the one before has lost a thin part."""

_THIN_VOXELS = 2.0
"""Half the thickness that the voxels resolve."""

_MISSED_SHARE = 0.002
_LOST_SHARE = 0.02
"""Share of the points outside a region that asks for a finer grid, and the share that is not trusted even then."""
_ROUNDS = 12
_OPENING = 0.2
"""Wide is an opening of that share of the scanned area: a half-ball has one half."""
_OPEN_SHARE = 0.02
_OPEN_LEVEL = 0.35
"""A scan with an open base is cut at a lower level: the thin wedge that cap and wall make at a slanting rim gets room for
the balloon.  The cap stands out a little then, until it is pulled tight; where there are points the level makes no difference."""


@dataclass(frozen=True, slots=True, eq=False)
class EnclosedRegion:
    """What the points enclose.

    Attributes
    ----------
    grid : the nodes
    inside : bool at each node
    depth_mm : float32 at each node, distance to the border, positive inside
    handles : genus of the region
    """

    grid: VoxelGrid
    inside: Region
    depth_mm: Field
    handles: int

    def volume_mm3(self) -> float:
        return float(self.inside.sum()) * self.grid.voxel_mm**3

    def grown(self) -> EnclosedRegion:
        """The region grown by one voxel on all sides."""
        depth = self.depth_mm + np.float32(self.grid.voxel_mm)
        inside = np.asarray(depth > 0)
        return EnclosedRegion(self.grid, inside, depth, handles(inside))


def enclosed_region(points: Array, scale: CloudScale, pace: Pace, table_mm: float | None = None) -> EnclosedRegion:
    """The region enclosed by (n, 3) points; raises E-REC-02 where they enclose nothing.

    `table_mm` is the height z of the table that the object stands on, None when there is none.
    """
    used = ~scale.isolated
    chosen = points[used]
    _check_flat(chosen)
    blur = max(scale.spacing_mm, 0.7 * scale.noise_mm)
    normals = _oriented(chosen, blur, pace, table_mm)
    best: EnclosedRegion | None = None
    fewest = np.inf
    finest = sharpest = np.inf
    for most_nodes, share in _GRIDS:
        sharp = max(share * scale.spacing_mm, 0.7 * scale.noise_mm)
        grid = _grid(chosen, 0.7 * sharp, most_nodes)
        if (grid.voxel_mm > 0.95 * finest and sharp > 0.95 * sharpest) or (share < 1 and fewest <= _MISSED_SHARE):
            continue
        finest, sharpest = grid.voxel_mm, sharp
        refusal = None
        try:
            region = _region_on(grid, chosen, normals, sharp, scale.spacing_mm, pace, table_mm)
        except ReconstructionError as error:
            refusal = error
            continue
        missed = _missed_share(region, points, scale)
        if missed <= max(fewest, _MISSED_SHARE):
            best, fewest = region, missed
        if missed <= _MISSED_SHARE and not _is_thin(region, pace):
            break
    if best is None:
        assert refusal is not None
        raise refusal
    if fewest > _LOST_SHARE:
        raise ReconstructionError(
            "E-REC-03",
            reason=f"{100 * fewest:.0f} % of the points lie outside the body that was found",
            do="scan the thin parts more densely",
        )
    return best


def oriented_region(points: Array, normals: Array, scale: CloudScale, pace: Pace, most_nodes: int) -> EnclosedRegion:
    """The region of (n, 3) points whose outward normals (n, 3) are known, on one grid; raises E-REC-02 where they enclose nothing.

    The points may be a part of a surface: what is missing is closed by a level of the winding number.
    """
    used = ~scale.isolated
    chosen = points[used]
    _check_flat(chosen)
    blur = max(scale.spacing_mm, 0.7 * scale.noise_mm)
    return _region_on(_grid(chosen, 0.7 * blur, most_nodes), chosen, normals[used], blur, scale.spacing_mm, pace, None)


def _oriented(points: Array, blur_mm: float, pace: Pace, table_mm: float | None) -> Array:
    """Outward normals of (n, 3) points, (n, 3), from rounds of solving and turning on a coarse grid.

    The area vectors of a closed surface sum to zero; those of an open one sum to the area of the opening and face away
    from it.  A wide open sheet may have been oriented in part from its wrong side, so it is done again on a table.
    """
    normals, areas = _oriented_on(points, blur_mm, pace, table_mm)
    away = areas @ normals / areas.sum()
    if table_mm is not None or float(np.linalg.norm(away)) < _OPENING:
        return normals
    axis = np.linalg.qr(np.column_stack([away, np.eye(3)]))[0][:, (1, 2, 0)]
    axis *= np.sign(away @ axis[:, 2])  # the columns of a rotation or a mirror, its last one away from the opening
    turned = points @ axis
    return np.asarray(_oriented_on(turned, blur_mm, pace, float(turned[:, 2].min()) - 2 * blur_mm)[0] @ axis.T)


def _oriented_on(points: Array, blur_mm: float, pace: Pace, table_mm: float | None) -> tuple[Array, Array]:
    """Outward normals of (n, 3) points, on a table or without one, and the area of each point up to a common factor."""
    grid = _grid(points, 0.7 * blur_mm, _COARSE_NODES)
    weights = grid.weights(points)
    areas = _areas(weights, blur_mm)
    normals = _shielded_normals(weights, pace, table_mm)
    poisson = _Poisson(grid, max(blur_mm, 0.8 * grid.voxel_mm))
    pace.report(0.35)
    for _ in range(_ROUNDS):
        pace.check()
        turned = -_unit(weights.gradient(poisson.winding_number(weights, normals, areas)))
        changed = float(((turned * normals).sum(axis=1) < 0.5).mean())
        normals = turned
        if changed < 0.002:
            break
    return normals, areas


def _region_on(
    grid: VoxelGrid, points: Array, normals: Array, blur_mm: float, spacing_mm: float, pace: Pace, table_mm: float | None
) -> EnclosedRegion:
    """The region on a given grid from points and their outward normals, both (n, 3)."""
    pace.report(0.4)
    weights = grid.weights(points)
    areas = _areas(weights, blur_mm)
    poisson = _Poisson(grid, max(blur_mm, 0.8 * grid.voxel_mm))
    field = poisson.winding_number(weights, normals, areas)
    pace.check()
    normals = -_unit(weights.gradient(field))
    field = poisson.winding_number(weights, normals, areas)
    pace.check()
    level = _weighted_median(weights.sample(field), areas)
    inside = _body(field, level)
    pace.check()
    depth = signed_depth(inside, grid.voxel_mm)
    _check_body(grid, depth, weights, points)
    pace.report(0.55)
    body = inside
    if _open_share(grid, inside, points, spacing_mm) > _OPEN_SHARE:
        lower = _body(field, _OPEN_LEVEL * level)
        standing = None if table_mm is None else standing_on_table(grid, inside, points, normals, spacing_mm, table_mm)
        # Filled columns can wall in single voxels beside an overhang; a cavity would count as a negative handle.
        inside = lower if standing is None else largest_piece(np.asarray(ndimage.binary_fill_holes(standing)))
        pace.check()
    inside, genus = _without_tunnels(inside, pace)
    pace.check()
    if inside is not body:
        depth = signed_depth(inside, grid.voxel_mm)
    return EnclosedRegion(grid, inside, depth, genus)


def _grid(points: Array, voxel_mm: float, most_nodes: int) -> VoxelGrid:
    size = points.max(axis=0) - points.min(axis=0)
    margin = 0.07 * float(size.max())
    volume = float(np.prod(size + 2 * margin))
    return VoxelGrid.around(points, max(voxel_mm, (volume / most_nodes) ** (1 / 3)), margin)


def _areas(weights: NodeWeights, blur_mm: float) -> Array:
    """The area that each point stands for, up to a common factor, (n,); bounded, so that stray points weigh little."""
    density = weights.splat(np.ones(weights.matrix.shape[0]))
    density = ndimage.gaussian_filter(density, 2 * blur_mm / weights.grid.voxel_mm, mode="constant")
    area = 1 / np.maximum(weights.sample(density), 1e-12)
    return np.asarray(np.minimum(area, 12 * np.median(area)))


def _shielded_normals(weights: NodeWeights, pace: Pace, table_mm: float | None) -> Array:
    """First outward normals, (n, 3): the direction in which a potential shielded by the points rises.

    Nothing comes in through a table: without that, an open sheet over it, as the floor of a dental arch, has no inside.
    """
    grid = weights.grid
    covered = 0 if table_mm is None else max(0, int(np.floor((table_mm - grid.origin[2]) / grid.voxel_mm)) + 1)
    occupied = weights.splat(np.ones(weights.matrix.shape[0]))
    levels = [(occupied > 0).astype(np.float32)]
    while min(levels[-1].shape) > 12:
        finer = levels[-1]
        padded = np.pad(finer, [(0, n % 2) for n in finer.shape])
        a, b, c = (n // 2 for n in padded.shape)
        levels.append(padded.reshape(a, 2, b, 2, c, 2).mean(axis=(1, 3, 5)))
    potential = np.ones(levels[-1].shape, np.float32)
    for number, wall in enumerate(reversed(levels)):
        if number:
            potential = np.repeat(np.repeat(np.repeat(potential, 2, 0), 2, 1), 2, 2)[tuple(slice(n) for n in wall.shape)]
            for axis in range(3):  # one far away
                ends = np.moveaxis(potential, axis, 0)
                ends[0] = ends[-1] = 1
        under = -(-covered // 2 ** (len(levels) - 1 - number))
        potential[:, :, :under] = 0
        weight = 1 / (6 + 40 * wall[1:-1, 1:-1, 1:-1])
        weight[:, :, : max(under - 1, 0)] = 0
        p = potential
        for _ in range(60):
            around = p[2:, 1:-1, 1:-1] + p[:-2, 1:-1, 1:-1]
            for neighbour in (p[1:-1, 2:, 1:-1], p[1:-1, :-2, 1:-1], p[1:-1, 1:-1, 2:], p[1:-1, 1:-1, :-2]):
                around += neighbour
            around *= weight
            p[1:-1, 1:-1, 1:-1] = around
        pace.check()
    return _unit(weights.gradient(ndimage.gaussian_filter(potential, 1.0)))


class _Poisson:
    """Solves ``laplace w = - div (area * outward normal)`` with w = 0 on the border, by a sine transform.

    The solution, smoothed by a Gaussian of one sigma `blur_mm`, is about 1 inside and 0 outside, up to a common factor.
    """

    def __init__(self, grid: VoxelGrid, blur_mm: float) -> None:
        laplacian = np.zeros(grid.shape, np.float32)
        decay = np.ones(grid.shape, np.float32)
        for axis, nodes in enumerate(grid.shape):
            angle = np.pi * np.arange(1, nodes + 1) / (nodes + 1)
            along = [-1 if i == axis else 1 for i in range(3)]
            laplacian += (2 * np.cos(angle) - 2).astype(np.float32).reshape(along)
            decay *= np.exp(-0.5 * (angle * blur_mm / grid.voxel_mm) ** 2).astype(np.float32).reshape(along)
        decay /= laplacian
        self._response = decay

    def winding_number(self, weights: NodeWeights, normals: Array, areas: Array) -> Field:
        """From the points' outward normals (n, 3) and areas (n,)."""
        source = np.zeros(weights.grid.shape, np.float32)
        for axis in range(3):
            component = np.moveaxis(weights.splat(areas * normals[:, axis]), axis, 0)
            # central differences; no point has weight on the border
            along = np.moveaxis(source, axis, 0)
            along[1:-1] -= component[2:]
            along[1:-1] += component[:-2]
        source *= 0.5
        spectrum = fft.dstn(source, type=1, overwrite_x=True)
        spectrum *= self._response
        return np.asarray(fft.idstn(spectrum, type=1, overwrite_x=True))


def _body(field: Field, level: float) -> Region:
    """The largest piece where a field exceeds a level, without its cavities."""
    return largest_piece(np.asarray(ndimage.binary_fill_holes(field > level)))


def _open_share(grid: VoxelGrid, inside: Region, points: Array, spacing_mm: float) -> float:
    """Share of a region's border that is far from all points."""
    border = grid.positions(inside & ~ndimage.binary_erosion(inside))
    border = border[:: max(1, len(border) // 5_000)]
    bound = 3 * spacing_mm + 2 * grid.voxel_mm
    return float(np.isinf(cKDTree(points).query(border, distance_upper_bound=bound)[0]).mean())


def _check_flat(points: Array) -> None:
    """Refuse points on a plane or a line."""
    size = np.sort(np.sqrt(np.maximum(np.linalg.eigvalsh(np.cov(points.T)), 0)))
    if size[0] < 0.01 * size[2]:
        raise ReconstructionError("E-REC-02", reason="they lie in a plane or on a line")


def _check_body(grid: VoxelGrid, depth: Field, weights: NodeWeights, points: Array) -> None:
    """Refuse what encloses nothing: a scan from one side, or points without a common body."""
    if float(depth.max()) < 1.5 * grid.voxel_mm:
        raise ReconstructionError("E-REC-02", reason="they leave no inside")
    bound = max(4 * grid.voxel_mm, 0.05 * float(np.linalg.norm(points.max(axis=0) - points.min(axis=0))))
    missed = float((np.abs(weights.sample(depth)) > bound).mean())
    if missed > 0.25:
        raise ReconstructionError("E-REC-02", reason=f"{100 * missed:.0f} % of them belong to no common body")


def _missed_share(region: EnclosedRegion, points: Array, scale: CloudScale) -> float:
    """Share of (n, 3) points that lie, with most of their neighbours, outside the region: on parts that it has not got."""
    away = region.grid.sample(region.depth_mm, points) < -2 * region.grid.voxel_mm - 3 * scale.noise_mm
    return float((away & (away[scale.neighbours].mean(axis=1) > 0.5)).mean())


def _is_thin(region: EnclosedRegion, pace: Pace) -> bool:
    """Whether a region has handles, or parts that its voxels hardly resolve."""
    if region.handles:
        return True
    pace.check()
    # nothing may lie far from what a ball of some voxels sweeps: that is how the balloon will get there
    voxel = region.grid.voxel_mm
    radius = _THIN_VOXELS * voxel
    pieces, _ = ndimage.label(region.depth_mm >= radius)
    start = np.unravel_index(int(np.argmax(region.depth_mm)), region.inside.shape)
    if not pieces[start]:
        return True
    away = ndimage.distance_transform_edt(pieces != pieces[start]) * voxel
    return float(away[region.inside].max()) > 2 * radius + voxel


def _without_tunnels(inside: Region, pace: Pace) -> tuple[Region, int]:
    """Close tunnels and cut thin bridges, smallest first, until the region has no handle; returns it and those that stay."""
    fewest = handles(inside)
    if fewest == 0:
        return inside, fewest
    box = tuple(slice(max(s.start - 8, 0), s.stop + 8) for s in ndimage.find_objects(inside.astype(np.int8))[0])
    body = inside[box]
    best = body
    away = ndimage.distance_transform_edt(~body).astype(np.float32)
    pace.check()
    depth = ndimage.distance_transform_edt(body).astype(np.float32)
    for radius in (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0):
        for change, distance in ((closed_by, away), (opened_by, depth)):
            pace.check()
            changed = largest_piece(np.asarray(ndimage.binary_fill_holes(change(body, radius, distance))))
            left = handles(changed)
            if left < fewest:
                best, fewest = _given_back(changed, body, pace), left
            if fewest == 0:
                break
        if fewest == 0:
            break
    whole = np.zeros_like(inside)
    whole[box] = best
    return whole, fewest


def _given_back(opened: Region, inside: Region, pace: Pace) -> Region:
    """Of what an opening took away, return each piece that makes no handle: tips and edges, but not bridges."""
    region = opened.copy()
    pieces, _ = ndimage.label(inside & ~opened)
    for number, box in enumerate(ndimage.find_objects(pieces), start=1):
        if number % 16 == 0:
            pace.check()
        wide = tuple(slice(max(s.start - 1, 0), s.stop + 1) for s in box)
        before = region[wide]
        after = before | (pieces[wide] == number)
        if euler_number(after) == euler_number(before):
            region[wide] = after
    return region


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1), 1e-30)[:, None])


def _weighted_median(values: Array, weights: Array) -> float:
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(total, 0.5 * total[-1])])
