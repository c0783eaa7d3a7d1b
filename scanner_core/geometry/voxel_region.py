"""A regular grid of voxels: fields sampled on it, and regions made of its cells."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import fft, ndimage, sparse

Array = NDArray[np.float64]
Field = NDArray[np.float32]
Region = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class VoxelGrid:
    """Nodes at ``origin + voxel_mm * (i, j, k)``.

    Attributes
    ----------
    origin : (3,) float64, the node (0, 0, 0), mm
    voxel_mm : distance of neighbouring nodes
    shape : number of nodes along each axis
    """

    origin: Array
    voxel_mm: float
    shape: tuple[int, int, int]

    @classmethod
    def around(cls, points: Array, voxel_mm: float, margin_mm: float) -> VoxelGrid:
        """A grid that contains (n, 3) points and a margin."""
        low, high = points.min(axis=0) - margin_mm, points.max(axis=0) + margin_mm
        nodes = np.ceil((high - low) / voxel_mm).astype(int) + 1
        # a sine transform of n nodes is a Fourier transform of 2 (n + 1)
        i, j, k = (fft.next_fast_len(int(n) + 1, real=True) - 1 for n in nodes)
        return cls(low - 0.5 * (voxel_mm * (np.array((i, j, k)) - 1) - (high - low)), voxel_mm, (i, j, k))

    def places(self, points: Array) -> Array:
        """Continuous indices of points, (n, 3)."""
        return (points - self.origin) / self.voxel_mm

    def weights(self, points: Array) -> NodeWeights:
        """What it takes to go from values at (n, 3) points to the nodes around them and back."""
        place = self.places(points)
        low = np.clip(np.floor(place).astype(np.int64), 0, np.array(self.shape) - 2)
        part = (place - low).astype(np.float32)
        steps = (self.shape[1] * self.shape[2], self.shape[2], 1)
        index = np.empty((len(points), 8), np.int32)
        weight = np.empty((len(points), 8), np.float32)
        first = low @ np.array(steps)
        for number, (i, j, k) in enumerate(np.ndindex(2, 2, 2)):
            index[:, number] = first + (i * steps[0] + j * steps[1] + k)
            x, y, z = (part[:, axis] if upper else 1 - part[:, axis] for axis, upper in enumerate((i, j, k)))
            weight[:, number] = x * y * z
        rows = np.arange(0, 8 * len(points) + 1, 8, dtype=np.int32)
        nodes = int(np.prod(self.shape))
        return NodeWeights(self, sparse.csr_array((weight.ravel(), index.ravel(), rows), shape=(len(points), nodes)))

    def sample(self, field: NDArray[np.floating], points: Array) -> Array:
        """Trilinear values of a field at points, (n,); the border's value outside."""
        return np.asarray(ndimage.map_coordinates(field, self.places(points).T, order=1, mode="nearest", output=np.float64))

    def positions(self, region: Region) -> Array:
        """Positions of the nodes of a region, (n, 3), mm."""
        return self.origin + self.voxel_mm * np.argwhere(region)


@dataclass(frozen=True, slots=True, eq=False)
class NodeWeights:
    """Trilinear weights of points on a grid, computed once for all the fields that are spread from them or read at them.

    Attributes
    ----------
    grid : the nodes
    matrix : (n, nodes) float32, eight weights for each point
    """

    grid: VoxelGrid
    matrix: sparse.csr_array

    def splat(self, values: NDArray[np.floating]) -> Field:
        """Spread values (n,) over the eight nodes around each point; a field that sums to theirs."""
        return np.asarray((self.matrix.T @ np.asarray(values, np.float32)).reshape(self.grid.shape), np.float32)

    def sample(self, field: Field) -> Array:
        """Values of a field at the points, (n,)."""
        return np.asarray(self.matrix @ field.ravel(), np.float64)

    def gradient(self, field: Field) -> Array:
        """Gradient of a field at the points by central differences of one voxel, (n, 3), per mm."""
        slopes = np.empty((self.matrix.shape[0], 3))
        for axis in range(3):
            rise = np.zeros_like(field)
            upper, lower, middle = ([slice(None)] * 3 for _ in range(3))
            upper[axis], lower[axis], middle[axis] = slice(2, None), slice(None, -2), slice(1, -1)
            np.subtract(field[tuple(upper)], field[tuple(lower)], out=rise[tuple(middle)])
            slopes[:, axis] = self.sample(rise)
        return slopes / (2 * self.grid.voxel_mm)


def signed_depth(region: Region, voxel_mm: float) -> Field:
    """Distance to the border of a region, positive inside, mm; the border runs half-way between voxels."""
    inside = ndimage.distance_transform_edt(region)
    outside = ndimage.distance_transform_edt(~region)
    return np.asarray((np.maximum(inside - 0.5, 0) - np.maximum(outside - 0.5, 0)) * voxel_mm, np.float32)


def largest_piece(region: Region) -> Region:
    """The largest 6-connected component."""
    pieces, count = ndimage.label(region)
    if count <= 1:
        return region
    sizes = np.bincount(pieces.ravel())
    sizes[0] = 0
    return np.asarray(pieces == np.argmax(sizes))


def handles(region: Region) -> int:
    """Number of handles (the genus) of one 6-connected region without cavities, from its Euler number."""
    return 1 - euler_number(region)


def euler_number(region: Region) -> int:
    """Of the union of voxels that share faces: voxels - pairs + squares of four - cubes of eight."""
    r = region
    pairs = [r[1:] & r[:-1], r[:, 1:] & r[:, :-1], r[:, :, 1:] & r[:, :, :-1]]
    squares = [pairs[0][:, 1:] & pairs[0][:, :-1], pairs[1][:, :, 1:] & pairs[1][:, :, :-1], pairs[2][1:] & pairs[2][:-1]]
    cubes = squares[0][:, :, 1:] & squares[0][:, :, :-1]
    return int(r.sum()) - sum(int(p.sum()) for p in pairs) + sum(int(s.sum()) for s in squares) - int(cubes.sum())


def closed_by(region: Region, radius_voxels: float, away: Field | None = None) -> Region:
    """Morphological closing with a ball; the region must keep that distance from the grid's border.

    `away` is the distance of every node to the region in voxels, where it is known.
    """
    grown = (ndimage.distance_transform_edt(~region) if away is None else away) <= radius_voxels
    return np.asarray(ndimage.distance_transform_edt(grown) > radius_voxels) | region


def opened_by(region: Region, radius_voxels: float, depth: Field | None = None) -> Region:
    """Morphological opening with a ball; `depth` is the distance of every node to the outside in voxels, where it is known."""
    core = (ndimage.distance_transform_edt(region) if depth is None else depth) > radius_voxels
    return np.asarray(ndimage.distance_transform_edt(~core) <= radius_voxels) & region
