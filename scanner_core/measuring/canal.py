"""The centre line of an ear canal, from the tip of its impression to where it opens into the concha, and its length."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.measuring.section import SectionPlane, encloses, is_closed, loop_area, loop_centroid, section

Array = NDArray[np.float64]

_STEP_MM = 0.5
_FARTHEST_MM = 45.0
_ROUNDS = 3
_FEWEST = 4
_ASIDE_MM = 1.0
_FLARE = 0.9
"""Millimetres that the radius grows by per millimetre of the way where the canal opens; its own taper is a third of that."""
_JUMP_MM = 1.5
"""From one centroid to the next, half a millimetre on: another part has joined in."""
_WIDEST = 3.0
"""Times the usual area before: there at the latest the canal has opened."""


@dataclass(frozen=True, slots=True, eq=False)
class CanalLine:
    """The centres of sections across a canal.

    Attributes
    ----------
    line : (k, 3) mm, from the tip to the opening
    areas_mm2 : (k,) of the sections there; 0 at the tip
    length_mm : of the line
    opens : it ends where the canal widens; otherwise at the other end of the surface
    """

    line: Array
    areas_mm2: Array
    length_mm: float
    opens: bool


def measure_canal(mesh: TriangleMesh, tip: Array | None = None, *, cancelled: IsCancelled = lambda: False) -> CanalLine | None:
    """The canal that ends in a tip; None where the surface has none there.

    Rings of equal way over the surface from the tip give a first line; then planes across the line cut the surface, the centroids of
    what they cut are the next line, and so on (as for vessels: Antiga and Steinman 2004, with geodesic level sets as Verroust and
    Lazarus 2000).

    Parameters
    ----------
    tip : (3,) mm on or near the surface; without one it is the highest point, since an impression stands on its base

    Raises
    ------
    Cancelled
        within half a second.
    """
    if not len(mesh.triangles):
        return None
    first = int(mesh.vertices[:, 2].argmax() if tip is None else ((mesh.vertices - tip) ** 2).sum(axis=1).argmin())
    line = _rings(mesh, first)
    if len(line) < _FEWEST:
        return None
    areas = np.zeros(len(line))
    for _ in range(_ROUNDS):
        line = _resampled(_smoothed(line))
        line, areas = _recentred(mesh, line, cancelled)
        if len(line) < _FEWEST:
            return None
    opening = _opening(line, areas)
    opens = opening < len(line)
    line, areas = line[:opening], areas[:opening]
    first, last = _rounding(line, areas), 0 if opens else _rounding(line[::-1], areas[::-1])
    line, areas = line[first : len(line) - last], areas[first : len(line) - last]
    if len(line) < _FEWEST:
        return None
    line, areas = np.vstack([_end(mesh, line[::-1]), line]), np.r_[0.0, areas]
    if not opens:
        line, areas = np.vstack([line, _end(mesh, line)]), np.r_[areas, 0.0]
    return CanalLine(line, areas, float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()), opens)


def _rings(mesh: TriangleMesh, first: int) -> Array:
    """Centres (k, 3) of the rings of equal way over the surface from a vertex; up to where a ring falls apart."""
    edges = EdgeTable.of(mesh.triangles).edges
    lengths = np.linalg.norm(mesh.vertices[edges[:, 0]] - mesh.vertices[edges[:, 1]], axis=1)
    graph = csr_array((np.maximum(lengths, 1e-9), (edges[:, 0], edges[:, 1])), (len(mesh.vertices),) * 2)
    way = dijkstra(graph, directed=False, indices=first, limit=_FARTHEST_MM)
    wide = max(_STEP_MM, 1.5 * float(np.median(lengths)))
    centres = []
    for at in np.arange(2 * wide, float(way[np.isfinite(way)].max()), _STEP_MM):
        ring = np.flatnonzero(np.abs(way - at) < wide)
        if len(ring) < 6:
            break
        parts, of = connected_components(graph[ring][:, ring], directed=False)
        sizes = np.bincount(of, minlength=parts)
        if sizes.max() < 0.8 * len(ring):
            break
        ring = ring[of == sizes.argmax()]
        centres.append(mesh.vertices[ring].mean(axis=0))
    return np.array(centres).reshape(-1, 3)


def _recentred(mesh: TriangleMesh, line: Array, cancelled: IsCancelled) -> tuple[Array, Array]:
    """Centroids (k, 3) and areas (k,) of the sections across a line, up to where there is none."""
    tangents = np.gradient(line, axis=0)
    tangents /= np.maximum(np.linalg.norm(tangents, axis=1), 1e-12)[:, None]
    centres: list[Array] = []
    areas: list[float] = []
    for point, tangent in zip(line, tangents, strict=True):
        if cancelled():
            raise Cancelled
        plane = SectionPlane.through(point, tangent)
        loops = [loop for loop in section(mesh, plane) if is_closed(loop)]
        around = [loop for loop in loops if encloses(plane.flat(loop), np.zeros(2))]
        if not around:
            if centres:
                break
            continue  # before the tip
        loop = min(around, key=loop_area)
        centres.append(loop_centroid(loop))
        areas.append(loop_area(loop))
    return np.array(centres).reshape(-1, 3), np.array(areas)


def _opening(line: Array, areas: Array) -> int:
    """Number of the first section that is no longer the canal's; their count when it stays one."""
    way = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    radii = np.sqrt(areas / np.pi)
    for i in range(2, len(line)):
        if way[i] < 2.0 * np.median(radii[: i + 1]):
            continue  # still within the rounding of the tip
        before = min(int(np.searchsorted(way, way[i] - 1.0)), i - 1)
        flare = (radii[i] - radii[before]) / max(way[i] - way[before], 1e-9)
        if way[i] - way[i - 1] > _JUMP_MM or flare > _FLARE or areas[i] > _WIDEST * np.median(areas[:i]):
            return i
    return len(line)


def _rounding(line: Array, areas: Array) -> int:
    """How many sections lie within the rounding of a tip, where a line has no direction of its own: it goes on straight there."""
    way = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    beyond = way > np.sqrt(areas / np.pi)
    return int(beyond.argmax()) if beyond.any() else 0


def _end(mesh: TriangleMesh, line: Array) -> Array:
    """Where a line (k, 3) leaves the surface beyond its last point."""
    ahead = line[-1] - line[max(len(line) - 4, 0)]
    ahead = ahead / np.linalg.norm(ahead)
    away = mesh.vertices - line[-1]
    along = away @ ahead
    across = np.linalg.norm(away - along[:, None] * ahead, axis=1)
    near = (along > 0) & (across < _ASIDE_MM)
    if not near.any():
        return np.asarray(line[-1])
    near &= along < along[near].min() + _ASIDE_MM  # and not the other side of the object
    return np.asarray(line[-1] + float(along[near][across[near].argmin()]) * ahead)


def _smoothed(line: Array) -> Array:
    """The same with every point drawn to its neighbours; its ends stay."""
    for _ in range(3):
        inner = 0.25 * line[:-2] + 0.5 * line[1:-1] + 0.25 * line[2:]
        line = np.vstack([line[:1], inner, line[-1:]])
    return line


def _resampled(line: Array) -> Array:
    """Points every half a millimetre, and a little beyond both ends."""
    ends = [2 * line[0] - line[min(2, len(line) - 1)], line, 2 * line[-1] - line[max(-3, -len(line))]]
    line = np.vstack(ends)
    way = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    at = np.linspace(0.0, way[-1], max(int(way[-1] / _STEP_MM) + 1, 3))
    return np.column_stack([np.interp(at, way, line[:, axis]) for axis in range(3)])
