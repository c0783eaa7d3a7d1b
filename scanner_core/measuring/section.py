"""Sections of surfaces by a plane: their contours, area and perimeter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class SectionPlane:
    """A plane with axes of its own.

    Attributes
    ----------
    point : (3,) mm, its origin
    normal : (3,) unit
    x, y : (3,) unit, in the plane; ``x x y = normal``
    """

    point: Array
    normal: Array
    x: Array
    y: Array

    @classmethod
    def through(cls, point: Array, normal: Array, upwards: Array | None = None) -> SectionPlane:
        """The plane through a point (3,) across `normal` (3,); `y` is as near to `upwards` (3,) as it can be."""
        normal = np.asarray(normal, np.float64) / np.linalg.norm(normal)
        wanted = np.array([0.0, 0.0, 1.0]) if upwards is None else np.asarray(upwards, np.float64)
        y = wanted - (wanted @ normal) * normal
        if np.linalg.norm(y) < 1e-6:
            y = np.eye(3)[np.argmin(np.abs(normal))]
            y = y - (y @ normal) * normal
        y = y / np.linalg.norm(y)
        return cls(np.asarray(point, np.float64), normal, np.cross(y, normal), y)

    def flat(self, points: Array) -> Array:
        """Places (n, 3) in the plane's own axes, (n, 2) mm."""
        return np.column_stack([(points - self.point) @ self.x, (points - self.point) @ self.y])

    def in_space(self, flat: Array) -> Array:
        """(n, 2) mm of the plane's axes to (n, 3)."""
        return np.asarray(self.point + flat[:, :1] * self.x + flat[:, 1:] * self.y)


@dataclass(frozen=True, slots=True, eq=False)
class SectionSize:
    """How large a section is.

    Attributes
    ----------
    contours : polylines (k, 3) mm, closed ones with their first point again at the end
    area_mm2 : that the contours enclose, holes taken off; None when one of them is open
    perimeter_mm : length of all contours
    """

    contours: list[Array]
    area_mm2: float | None
    perimeter_mm: float

    @property
    def centroid(self) -> Array | None:
        """(3,) mm, of what lies within the largest contour; None without a closed one."""
        closed = [loop for loop in self.contours if is_closed(loop)]
        return loop_centroid(max(closed, key=loop_area)) if closed else None


def measure_section(mesh: TriangleMesh, plane: SectionPlane) -> SectionSize | None:
    """Size of the section of a mesh; None where the plane does not meet it."""
    contours = section(mesh, plane)
    if not contours:
        return None
    perimeter = sum(float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()) for line in contours)
    closed = all(is_closed(line) for line in contours)
    return SectionSize(contours, _area(contours, plane) if closed else None, perimeter)


def _area(loops: list[Array], plane: SectionPlane) -> float:
    """What closed loops enclose: one that lies within an odd number of others is a hole."""
    flat = [plane.flat(loop) for loop in loops]
    total = 0.0
    for number, loop in enumerate(flat):
        around = sum(bool(encloses(other, loop[0])) for i, other in enumerate(flat) if i != number)
        total += (1 - 2 * (around % 2)) * abs(_shoelace(loop))
    return total


def is_closed(contour: Array) -> bool:
    """Whether a polyline (k, 3) comes back to its first point."""
    return len(contour) > 3 and bool((contour[0] == contour[-1]).all())


def loop_area(loop: Array) -> float:
    """Area, mm^2, within a closed flat polyline (k, 3)."""
    return float(np.linalg.norm(_area_vector(loop)))


def loop_centroid(loop: Array) -> Array:
    """Centre (3,) of the area within a closed flat polyline (k, 3)."""
    middle = loop.mean(axis=0)
    parts = 0.5 * np.cross(loop[:-1] - middle, loop[1:] - middle)
    whole = parts.sum(axis=0)
    size = float(whole @ whole)
    if size < 1e-18:
        return np.asarray(middle)
    shares = parts @ whole / size
    return np.asarray(middle + shares @ (loop[:-1] + loop[1:] - 2 * middle) / 3)


def encloses(loop: Array, place: Array) -> bool:
    """Whether a closed polyline (k, 2) goes round a place (2,)."""
    (x0, y0), (x1, y1) = loop[:-1].T, loop[1:].T
    spans = (y0 <= place[1]) != (y1 <= place[1])
    way = (place[1] - y0) * (x1 - x0) - (place[0] - x0) * (y1 - y0)
    return bool((spans & np.where(y1 > y0, way > 0, way < 0)).sum() % 2)


def _area_vector(loop: Array) -> Array:
    middle = loop.mean(axis=0)
    return np.asarray(0.5 * np.cross(loop[:-1] - middle, loop[1:] - middle).sum(axis=0))


def _shoelace(flat: Array) -> float:
    x, y = (flat - flat.mean(axis=0)).T
    return float(0.5 * (x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


def section(mesh: TriangleMesh, plane: SectionPlane) -> list[Array]:
    """Where a plane cuts a mesh: polylines (k, 3) mm, a closed one with its first point again at its end.

    A vertex exactly in the plane counts as above it, so that every triangle is cut in two points or not at all.
    """
    above = (mesh.vertices - plane.point) @ plane.normal >= 0
    height = (mesh.vertices - plane.point) @ plane.normal
    cut = mesh.triangles[(above[mesh.triangles].sum(axis=1) % 3) != 0]
    if not len(cut):
        return []
    start, end = cut, cut[:, (1, 2, 0)]
    crosses = above[start] != above[end]
    low, high = np.minimum(start, end)[crosses], np.maximum(start, end)[crosses]
    key, number = np.unique(low * len(mesh.vertices) + high, return_inverse=True)
    low, high = key // len(mesh.vertices), key % len(mesh.vertices)
    share = height[low] / (height[low] - height[high])
    points = mesh.vertices[low] + share[:, None] * (mesh.vertices[high] - mesh.vertices[low])
    pairs = number.reshape(-1, 2)  # the two crossed sides of a triangle follow one another
    return [points[chain] for chain in _chains(pairs, len(points))]


def _chains(pairs: NDArray[np.int64], count: int) -> list[list[int]]:
    """Segments between numbered points joined to chains; open ones from end to end, closed ones back to their first point."""
    beside: list[list[int]] = [[] for _ in range(count)]
    for a, b in pairs.tolist():
        beside[a].append(b)
        beside[b].append(a)
    used: set[tuple[int, int]] = set()
    chains = []
    ends = [i for i in range(count) if len(beside[i]) == 1]
    for first in [*ends, *range(count)]:
        chain, here = [first], first
        while True:
            following = next((other for other in beside[here] if (min(here, other), max(here, other)) not in used), None)
            if following is None:
                break
            used.add((min(here, following), max(here, following)))
            chain.append(following)
            here = following
        if len(chain) > 1:
            chains.append(chain)
    return chains


def distance_along(before: list[Array], after: list[Array], plane: SectionPlane, start: Array, end: Array) -> float | None:
    """Signed way, mm, from the contour before to the contour after along the line from `start` to `end` ((2,) mm, in the plane's axes).

    Of each contour the crossing nearest to the middle of the line counts; None where the line does not meet both.
    """
    first = _crossing(before, plane, start, end)
    second = _crossing(after, plane, start, end)
    return None if first is None or second is None else second - first


def _crossing(contours: list[Array], plane: SectionPlane, start: Array, end: Array) -> float | None:
    """Way along the line to its crossing with contours, mm."""
    along = np.asarray(end, np.float64) - start
    length = float(np.linalg.norm(along))
    if length < 1e-12:
        return None
    along = along / length
    across = np.array([-along[1], along[0]])
    found: list[float] = []
    for contour in contours:
        about = plane.flat(contour) - start
        side, way = about @ across, about @ along
        crosses = (side[:-1] >= 0) != (side[1:] >= 0)
        share = side[:-1][crosses] / (side[:-1] - side[1:])[crosses]
        at = way[:-1][crosses] + share * (way[1:] - way[:-1])[crosses]
        found += at[(at >= 0) & (at <= length)].tolist()
    return min(found, key=lambda at: abs(at - 0.5 * length)) if found else None
