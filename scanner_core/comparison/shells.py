"""What a surface is made of: shells, borders, and which way it faces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from scanner_core.geometry.edges import row_cross, row_dot
from scanner_core.geometry.mesh import TriangleMesh


@dataclass(frozen=True, slots=True)
class Shells:
    """The parts of a surface.

    Attributes
    ----------
    count : parts that hang together over edges
    largest_share : of the area, of the largest
    border_edges, borders : edges of one triangle only, and the closed lines that they form
    border_mm : their length
    turned_share : of the area, of the triangles that lie in no shell's largest patch of neighbours that wind the same way
    fullness : signed volume of the largest shell, its borders closed by fans of triangles to their middles, over the 1.5th
        power of its area: 0.094 for a sphere, negative when the shell faces inwards, near 0 for a sheet
    closed : the largest shell has no border
    """

    count: int
    largest_share: float
    border_edges: int
    borders: int
    border_mm: float
    turned_share: float
    fullness: float
    closed: bool


def shells_of(mesh: TriangleMesh) -> Shells:
    """Look at every edge of a mesh with at least one triangle."""
    triangles = mesh.triangles
    start, end = triangles.ravel(), triangles[:, (1, 2, 0)].ravel()
    key = np.minimum(start, end) * np.int64(len(mesh.vertices)) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    first = np.flatnonzero(np.diff(key[order], prepend=-1))
    uses = np.diff(np.append(first, len(order)))
    border = order[first[uses == 1]]
    pairs = first[uses == 2]
    agreeing = pairs[start[order[pairs]] != start[order[pairs + 1]]]
    joined = np.flatnonzero(np.diff(key[order]) == 0)
    count, label = _labels(_triangles(order[joined]), _triangles(order[joined + 1]), len(triangles))
    area = np.bincount(label, mesh.areas(), minlength=count)
    largest = int(np.argmax(area))
    loops, loop = _labels(start[border], end[border], len(mesh.vertices)) if len(border) else (0, np.empty(0, np.int32))
    loops = len(np.unique(loop[start[border]]))
    own = label[_triangles(border)] == largest
    return Shells(
        count=count,
        largest_share=float(area[largest] / max(area.sum(), 1e-300)),
        border_edges=len(border),
        borders=loops,
        border_mm=float(np.linalg.norm(mesh.vertices[start[border]] - mesh.vertices[end[border]], axis=1).sum()),
        turned_share=_turned_share(mesh, label, *(_triangles(order[agreeing + side]) for side in (0, 1))),
        fullness=_capped_volume(mesh, label == largest, start[border][own], end[border][own], loop) / max(area[largest], 1e-300) ** 1.5,
        closed=not own.any(),
    )


def _triangles(half_edges: NDArray[np.int64]) -> NDArray[np.int64]:
    return half_edges // 3


def _turned_share(mesh: TriangleMesh, shell: NDArray[np.int32], a: NDArray[np.int64], b: NDArray[np.int64]) -> float:
    """Share of the area outside of the largest patch of each shell; patches hang together over the neighbours a - b."""
    count, patch = _labels(a, b, len(mesh.triangles))
    area = np.bincount(patch, mesh.areas(), minlength=count)
    of_shell = np.zeros(count, np.int64)
    of_shell[patch] = shell
    largest = np.zeros(int(shell.max()) + 1)
    np.maximum.at(largest, of_shell, area)
    return float(1 - largest.sum() / max(area.sum(), 1e-300))


def _labels(a: NDArray[np.int64], b: NDArray[np.int64], count: int) -> tuple[int, NDArray[np.int32]]:
    number, label = connected_components(coo_array((np.ones(len(a), np.int8), (a, b)), shape=(count, count)), directed=False)
    return int(number), np.asarray(label, np.int32)


def _capped_volume(mesh: TriangleMesh, inside: NDArray[np.bool_], start: NDArray[np.int64], end: NDArray[np.int64], loop: NDArray[np.int32]) -> float:
    """Signed volume (mm^3) of some triangles with every line of their border, half-edges start -> end, closed by a fan."""
    origin = mesh.vertices[mesh.triangles[inside][0, 0]]
    a, b, c = (mesh.vertices[corner] - origin for corner in mesh.triangles[inside].T)
    volume = float(row_dot(a, row_cross(b, c)).sum()) / 6
    if len(start) == 0:
        return volume
    p, q = mesh.vertices[start] - origin, mesh.vertices[end] - origin
    _, line = np.unique(loop[start], return_inverse=True)
    weight = np.linalg.norm(p - q, axis=1) + 1e-300
    total = np.bincount(line, weight)
    middle = np.stack([np.bincount(line, weight * 0.5 * (p + q)[:, axis]) / total for axis in range(3)], axis=1)
    return volume + float(row_dot(middle[line], row_cross(q, p)).sum()) / 6
