"""The frame of a dental arch, found from its shape alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from scanner_core.comparison.measuring import vertex_areas
from scanner_core.geometry.edges import EdgeTable, row_dot
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
_LENGTH_MM = (25.0, 95.0)
"""Of the greatest extent of one jaw's arch, a half one included."""
_FLATTEST = 0.7
"""Extent along the plane's normal over the middle extent: more is no arch."""
_LEAST_HEIGHT_MM = 4.0
"""Of teeth over the rim of a scan."""
_HIGH = 0.5
"""Share of the height above which a vertex belongs to the row of teeth."""
_TOOTHED = 0.2
"""Share of the height by which a place's highest point may lie below the median one of the row, and still be a tooth's."""
_SECTORS = 72
_EMPTY = 2e-3
"""Share of the row's area that a sector may hold and count as empty."""
_LEAST_GAP_DEG, _MOST_GAP_DEG = 40.0, 190.0
"""Of the open side, seen from the middle of the row: a ring has none, half an arch or a single tooth a wider one."""

_LEAST_DEPTH = 0.45
"""From the ends forward to the front, over the distance of the ends: half an arch is a shallow bow, whose middle is no front."""
_MOST_UNEVEN = 0.4
"""Difference of the two legs over the depth: where one is cut off, the middle of what is left is no front either."""


@dataclass(frozen=True, slots=True, eq=False)
class ArchFrame:
    """Directions of an arch, unit vectors in the frame of the mesh.

    Attributes
    ----------
    centre : (3,) mm, in the middle of the row of teeth
    up : (3,) out of the gum, to the occlusal side
    forward : (3,) to the front teeth; None where the shape does not tell (half an arch)
    ridge : (k, 3) mm, points along the middle of the row from its last tooth on one side to that on the other, empty without `forward`
    """

    centre: Array
    up: Array
    forward: Array | None
    ridge: Array

    @property
    def side(self) -> Array | None:
        """(3,) ``forward x up``: to the right of one who looks forward with `up` above the head; None without `forward`."""
        return None if self.forward is None else self._right()

    def shares(self, places: Array) -> Array:
        """How far from the front midline places (n, 3) lie, (n,) as a share of the half arch, + on the side of `side`.  Only with
        `forward`."""
        nearest, way = self._on_ridge(places)
        front = self._front()
        half = max(way[-1] - way[front], way[front], 1e-12)
        share = (way[nearest] - way[front]) / half
        return np.asarray(share if (self.ridge[-1] - self.ridge[0]) @ self._right() > 0 else -share)

    def along(self, place: Array) -> tuple[Array, Array]:
        """At a place (3,): unit vectors outwards from the arch, and along it to the front midline.  Only with `forward`."""
        nearest = int(self._on_ridge(place[None])[0][0])
        front = self._front()
        tangent = self.ridge[min(nearest + 2, len(self.ridge) - 1)] - self.ridge[max(nearest - 2, 0)]
        tangent = tangent - (tangent @ self.up) * self.up
        tangent = tangent / max(float(np.linalg.norm(tangent)), 1e-12)
        outward = np.cross(tangent, self.up)
        inner = 0.5 * (0.5 * (self.ridge[0] + self.ridge[-1]) + self.ridge[front])
        if outward @ (self.ridge[nearest] - inner) < 0:
            outward = -outward
        return outward, -tangent if nearest > front else tangent

    def _right(self) -> Array:
        assert self.forward is not None, "the arch has no front"
        return np.asarray(np.cross(self.forward, self.up))

    def _front(self) -> int:
        """The point of the ridge where it crosses the middle between its ends."""
        across = (self.ridge - 0.5 * (self.ridge[0] + self.ridge[-1])) @ self._right()
        ahead = np.asarray((self.ridge - self.centre) @ np.asarray(self.forward))
        return int(np.argmin(np.where(ahead > np.median(ahead), np.abs(across), np.inf)))

    def _on_ridge(self, places: Array) -> tuple[NDArray[np.int64], Array]:
        """The nearest points of the ridge to places (n, 3), seen along `up`, and the way along the ridge to each of its points, mm."""
        steps = np.diff(self.ridge, axis=0)
        way = np.concatenate([[0.0], np.cumsum(np.sqrt(row_dot(steps, steps)))])
        flat = places - np.outer((places - self.ridge.mean(axis=0)) @ self.up, self.up)
        return np.asarray(cKDTree(self.ridge).query(flat)[1], np.int64), way


def arch_frame(mesh: TriangleMesh, supported: NDArray[np.bool_]) -> ArchFrame | None:
    """The frame of an arch, or None where the shape is none: too large, too small or too thick.

    The plane is that of least extent.  Up is away from the rim of an open scan, or from the part of a closed one that is no
    measurement; without either it is where the supported surface faces.  So it does not rest on which way the triangles face.
    The front is opposite to the gap in the ring of directions in which the row of teeth is seen from its own middle.
    """
    area = vertex_areas(mesh) * supported
    if area.sum() <= 0:
        return None
    centre = area @ mesh.vertices / area.sum()
    about = mesh.vertices - centre
    axes = np.linalg.eigh((about * area[:, None]).T @ about)[1]
    extent = np.ptp(about[area > 0] @ axes, axis=0)
    if not _LENGTH_MM[0] <= extent[2] <= _LENGTH_MM[1] or not _LEAST_HEIGHT_MM <= extent[0] <= _FLATTEST * extent[1]:
        return None
    up = axes[:, 0] * _sign_up(mesh, supported, about, axes[:, 0], area)
    height = about @ up
    low, high = np.percentile(height[area > 0], [2, 98])
    row = (height > low + _HIGH * (high - low)) & (area > 0)
    flat = np.column_stack([about[row] @ axes[:, 1], about[row] @ axes[:, 2]])
    forward, ridge = _front_and_ridge(flat, area[row])
    if forward is not None:
        ridge = _toothed(ridge, flat, height[row], _TOOTHED * (high - low))
    if forward is None:
        return ArchFrame(centre, up, None, np.empty((0, 3)))
    level = float(np.median(height[row]))
    in_space = centre + ridge @ axes[:, 1:].T + level * up
    return ArchFrame(centre, up, axes[:, 1:] @ forward, in_space)


def _sign_up(mesh: TriangleMesh, supported: NDArray[np.bool_], about: Array, axis: Array, area: Array) -> float:
    height = about @ axis
    if not supported.all():
        bottom = float(height[~supported].mean())
        return -1.0 if bottom > 0 else 1.0
    table = EdgeTable.of(mesh.triangles)
    uses = np.bincount(table.side_edges.ravel(), minlength=len(table.edges))
    rim = table.edges[uses == 1]
    if len(rim):
        ends = mesh.vertices[rim]
        length = np.sqrt(row_dot(ends[:, 0] - ends[:, 1], ends[:, 0] - ends[:, 1]))
        if length.sum() > 2 * np.sqrt(area.sum()):  # more than small holes
            return -1.0 if float(np.average(height[rim].mean(axis=1), weights=length)) > 0 else 1.0
    # a closed body: the teeth's side is the rougher one, its normals are spread wider
    normals = mesh.vertex_normals() @ axis
    facing_up, facing_down = np.average(np.maximum(normals, 0) ** 4, weights=area), np.average(np.maximum(-normals, 0) ** 4, weights=area)
    return 1.0 if facing_up < facing_down else -1.0


def _front_and_ridge(flat: Array, area: Array) -> tuple[Array | None, Array]:
    """Direction to the front (2,) and points along the middle of the row (k, 2), from flat places (n, 2) of the row."""
    middle = 0.5 * (flat.min(axis=0) + flat.max(axis=0))
    forward: Array | None = None
    for _ in range(3):
        angle = np.arctan2(flat[:, 1] - middle[1], flat[:, 0] - middle[0])
        sector = np.minimum((angle + np.pi) / (2 * np.pi) * _SECTORS, _SECTORS - 1).astype(np.int64)
        held = np.bincount(sector, area, minlength=_SECTORS) / area.sum() > _EMPTY
        first, count = _longest_gap(held)
        gap = 360.0 * count / _SECTORS
        if not _LEAST_GAP_DEG <= gap <= _MOST_GAP_DEG:
            return None, np.empty((0, 2))
        towards = (first + 0.5 * count) / _SECTORS * 2 * np.pi - np.pi
        forward = -np.array([np.cos(towards), np.sin(towards)])
        depth = (flat - middle) @ forward
        # the middle from which the next round looks lies between the legs, half way along them
        across = np.array([-forward[1], forward[0]])
        side = (flat - middle) @ across
        middle = middle + 0.5 * (depth.min() + depth.max()) * forward + 0.5 * (side.min() + side.max()) * across
    angle = np.arctan2(flat[:, 1] - middle[1], flat[:, 0] - middle[0])
    turned = np.mod(angle - towards, 2 * np.pi)
    bins = np.minimum(turned / (2 * np.pi) * _SECTORS, _SECTORS - 1).astype(np.int64)
    weight = np.bincount(bins, area, minlength=_SECTORS)
    used = weight / area.sum() > _EMPTY
    sums = np.column_stack([np.bincount(bins, area * flat[:, i], minlength=_SECTORS) for i in range(2)])
    ridge = sums[used] / weight[used][:, None]
    depth = (ridge - ridge[0]) @ np.asarray(forward)
    ahead = float(depth.max() - min(depth[0], depth[-1]))
    apart = float(np.linalg.norm(ridge[-1] - ridge[0]))
    if ahead < _LEAST_DEPTH * apart or abs(depth[-1]) > _MOST_UNEVEN * ahead:
        return None, np.empty((0, 2))
    return forward, ridge


def _toothed(ridge: Array, flat: Array, height: Array, lower_mm: float) -> Array:
    """The ridge (k, 2) without its ends that bear no tooth: base, or the gum behind the last molar.

    `flat` (n, 2) and `height` (n,) are those of the row's vertices, `lower_mm` how much lower than the others a tooth may be.
    """
    top = np.full(len(ridge), -np.inf)
    np.maximum.at(top, cKDTree(ridge).query(flat)[1], height)
    teeth = np.flatnonzero(top > np.median(top) - lower_mm)
    return ridge[teeth[0] : teeth[-1] + 1]


def _longest_gap(held: NDArray[np.bool_]) -> tuple[int, int]:
    """First sector and number of the longest run of empty ones, round the circle."""
    twice = np.concatenate([held, held])
    best, run = (0, 0), 0
    for i, full in enumerate(twice.tolist()):
        run = 0 if full else run + 1
        if run > best[1]:
            best = (i - run + 1, run)
    return best[0], min(best[1], len(held))
