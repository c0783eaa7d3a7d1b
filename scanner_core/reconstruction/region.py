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
from scanner_core.geometry.voxel_region import Field, Region, VoxelGrid, closed_by, euler_number, handles, largest_piece, opened_by, signed_depth
from scanner_core.reconstruction.cloud_scale import CloudScale
from scanner_core.reconstruction.pace import Pace
from scanner_core.reconstruction.table import standing_on_table

Array = NDArray[np.float64]

_COARSE_NODES = 150_000
_FINE_NODES = 2_400_000
_ROUNDS = 12
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


def enclosed_region(points: Array, scale: CloudScale, pace: Pace, table_mm: float | None = None) -> EnclosedRegion:
    """The region enclosed by (n, 3) points; raises E-REC-02 where they enclose nothing.

    `table_mm` is the height z of the table that the object stands on, None when there is none.
    """
    used = ~scale.isolated
    chosen = points[used]
    blur = max(scale.spacing_mm, 0.7 * scale.noise_mm)
    coarse = _grid(chosen, 0.7 * blur, _COARSE_NODES)
    areas = _areas(coarse, chosen, blur)
    normals = _shielded_normals(coarse, chosen, pace)
    for _ in range(_ROUNDS):
        pace.check()
        field = _winding_number(coarse, chosen, normals, areas, max(blur, 0.8 * coarse.voxel_mm))
        turned = -_unit(coarse.gradient(field, chosen))
        changed = float(((turned * normals).sum(axis=1) < 0.5).mean())
        normals = turned
        if changed < 0.002:
            break
    fine = _grid(chosen, 0.7 * blur, _FINE_NODES)
    pace.check()
    if fine.voxel_mm < 0.95 * coarse.voxel_mm:
        areas = _areas(fine, chosen, blur)
        field = _winding_number(fine, chosen, normals, areas, max(blur, 0.8 * fine.voxel_mm))
        pace.check()
        normals = -_unit(fine.gradient(field, chosen))
        field = _winding_number(fine, chosen, normals, areas, max(blur, 0.8 * fine.voxel_mm))
    pace.check()
    level = _weighted_median(fine.sample(field, chosen), areas)
    inside = _body(field, level)
    pace.check()
    _check_body(fine, inside, chosen)
    pace.check()
    if _open_share(fine, inside, chosen, scale.spacing_mm) > _OPEN_SHARE:
        lower = _body(field, _OPEN_LEVEL * level)
        standing = None if table_mm is None else standing_on_table(fine, inside, chosen, normals, scale.spacing_mm, table_mm)
        # Filled columns can wall in single voxels beside an overhang; a cavity would count as a negative handle.
        inside = lower if standing is None else largest_piece(np.asarray(ndimage.binary_fill_holes(standing)))
        pace.check()
    inside, genus = _without_tunnels(inside, pace)
    pace.check()
    depth = signed_depth(inside, fine.voxel_mm)
    return EnclosedRegion(fine, inside, depth, genus)


def _grid(points: Array, voxel_mm: float, most_nodes: int) -> VoxelGrid:
    size = points.max(axis=0) - points.min(axis=0)
    margin = 0.07 * float(size.max())
    volume = float(np.prod(size + 2 * margin))
    return VoxelGrid.around(points, max(voxel_mm, (volume / most_nodes) ** (1 / 3)), margin)


def _areas(grid: VoxelGrid, points: Array, blur_mm: float) -> Array:
    """The area that each point stands for, up to a common factor, (n,); bounded, so that stray points weigh little."""
    density = ndimage.gaussian_filter(grid.splat(points, np.ones(len(points))), 2 * blur_mm / grid.voxel_mm, mode="constant")
    area = 1 / np.maximum(grid.sample(density, points), 1e-12)
    return np.asarray(np.minimum(area, 12 * np.median(area)))


def _shielded_normals(grid: VoxelGrid, points: Array, pace: Pace) -> Array:
    """First outward normals, (n, 3): the direction in which a potential shielded by the points rises."""
    occupied = grid.splat(points, np.ones(len(points)))
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
        weight = 1 / (6 + 40 * wall[1:-1, 1:-1, 1:-1])
        for _ in range(60):
            p = potential
            around = p[2:, 1:-1, 1:-1] + p[:-2, 1:-1, 1:-1] + p[1:-1, 2:, 1:-1] + p[1:-1, :-2, 1:-1] + p[1:-1, 1:-1, 2:] + p[1:-1, 1:-1, :-2]
            potential = np.pad(around * weight, 1, constant_values=1.0)
        pace.check()
    return _unit(grid.gradient(ndimage.gaussian_filter(potential, 1.0), points))


def _winding_number(grid: VoxelGrid, points: Array, normals: Array, areas: Array, blur_mm: float) -> Field:
    """Solve ``laplace w = - div (area * outward normal)`` with w = 0 on the border: about 1 inside and 0 outside."""
    source = np.zeros(grid.shape, np.float32)
    for axis in range(3):
        component = grid.splat(points, areas * normals[:, axis]).astype(np.float32)
        source -= np.gradient(component, axis=axis)
    spectrum = fft.dstn(source, type=1)
    laplacian = np.zeros(grid.shape, np.float32)
    decay = np.ones(grid.shape, np.float32)
    for axis, nodes in enumerate(grid.shape):
        angle = np.pi * np.arange(1, nodes + 1) / (nodes + 1)
        along = [-1 if i == axis else 1 for i in range(3)]
        laplacian += (2 * np.cos(angle) - 2).astype(np.float32).reshape(along)
        decay = decay * np.exp(-0.5 * (angle * blur_mm / grid.voxel_mm) ** 2).astype(np.float32).reshape(along)
    spectrum *= decay
    spectrum /= laplacian
    return np.asarray(fft.idstn(spectrum, type=1, overwrite_x=True))


def _body(field: Field, level: float) -> Region:
    """The largest piece where a field exceeds a level, without its cavities."""
    return largest_piece(np.asarray(ndimage.binary_fill_holes(field > level)))


def _open_share(grid: VoxelGrid, inside: Region, points: Array, spacing_mm: float) -> float:
    """Share of a region's border that is far from all points."""
    border = grid.positions(inside & ~ndimage.binary_erosion(inside))
    border = border[:: max(1, len(border) // 20_000)]
    bound = 3 * spacing_mm + 2 * grid.voxel_mm
    return float(np.isinf(cKDTree(points).query(border, distance_upper_bound=bound)[0]).mean())


def _check_body(grid: VoxelGrid, inside: Region, points: Array) -> None:
    """Refuse what encloses nothing: points on a plane or a line, or a scan from one side."""
    size = np.sort(np.linalg.svd(points - points.mean(axis=0), compute_uv=False) / np.sqrt(len(points)))
    if size[0] < 0.01 * size[2]:
        raise ReconstructionError("E-REC-02", reason="they lie in a plane or on a line")
    depth = ndimage.distance_transform_edt(inside)
    if not inside.any() or float(depth.max()) < 2.0:
        raise ReconstructionError("E-REC-02", reason="they leave no inside")
    away = cKDTree(grid.positions(inside & (depth < 2))).query(points)[0]
    missed = float((away > max(4 * grid.voxel_mm, 0.05 * np.linalg.norm(points.max(axis=0) - points.min(axis=0)))).mean())
    if missed > 0.25:
        raise ReconstructionError("E-REC-02", reason=f"{100 * missed:.0f} % of them belong to no common body")


def _without_tunnels(inside: Region, pace: Pace) -> tuple[Region, int]:
    """Close tunnels and cut thin bridges, smallest first, until the region has no handle; returns it and those that stay."""
    best, fewest = inside, handles(inside)
    for radius in (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0):
        for change in (closed_by, opened_by):
            if fewest == 0:
                return best, fewest
            pace.check()
            changed = largest_piece(np.asarray(ndimage.binary_fill_holes(change(inside, radius))))
            left = handles(changed)
            if left < fewest:
                best, fewest = _given_back(changed, inside, pace), left
    return best, fewest


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
