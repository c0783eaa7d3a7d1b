"""A regular grid of voxels: fields sampled on it, and regions made of its cells."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

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
        return cls(low, voxel_mm, (int(nodes[0]), int(nodes[1]), int(nodes[2])))

    def places(self, points: Array) -> Array:
        """Continuous indices of points, (n, 3)."""
        return (points - self.origin) / self.voxel_mm

    def splat(self, points: Array, values: Array) -> Array:
        """Spread values (n,) over the eight nodes around each point with trilinear weights; a field that sums to theirs."""
        place = self.places(points)
        low = np.clip(np.floor(place).astype(np.int64), 0, np.array(self.shape) - 2)
        part = place - low
        total = np.zeros(int(np.prod(self.shape)))
        for corner in np.ndindex(2, 2, 2):
            weight = np.prod(np.where(corner, part, 1 - part), axis=1)
            index = np.ravel_multi_index(tuple((low + corner).T), self.shape)
            total += np.bincount(index, weight * values, minlength=len(total))
        return total.reshape(self.shape)

    def sample(self, field: NDArray[np.floating], points: Array) -> Array:
        """Trilinear values of a field at points, (n,); the border's value outside."""
        return np.asarray(ndimage.map_coordinates(field, self.places(points).T, order=1, mode="nearest", output=np.float64))

    def gradient(self, field: NDArray[np.floating], points: Array) -> Array:
        """Gradient of a field at points by central differences of one voxel, (n, 3), per mm."""
        slopes = np.empty((len(points), 3))
        for axis in range(3):
            shift = np.zeros(3)
            shift[axis] = self.voxel_mm
            slopes[:, axis] = (self.sample(field, points + shift) - self.sample(field, points - shift)) / (2 * self.voxel_mm)
        return slopes

    def positions(self, region: Region) -> Array:
        """Positions of the nodes of a region, (n, 3), mm."""
        return self.origin + self.voxel_mm * np.argwhere(region)


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


def closed_by(region: Region, radius_voxels: float) -> Region:
    """Morphological closing with a ball; the region must keep that distance from the grid's border."""
    grown = ndimage.distance_transform_edt(~region) <= radius_voxels
    return np.asarray(ndimage.distance_transform_edt(grown) > radius_voxels) | region


def opened_by(region: Region, radius_voxels: float) -> Region:
    """Morphological opening with a ball."""
    core = ndimage.distance_transform_edt(region) > radius_voxels
    return np.asarray(ndimage.distance_transform_edt(~core) <= radius_voxels) & region
