"""Polygons into triangles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.mesh_io.malformed import MalformedError

MOST_CORNERS = 10_000
_TRIES = 20
"""Corners looked at for each ear, on average; only polygons that cross themselves need more."""
_VAIN_TESTS = 100_000_000
"""Corners that all vain searches for ears in a file may be compared with; afterwards what is left of a polygon is a fan."""


def triangulated(vertices: NDArray[np.float64], corners: NDArray[np.int64], lengths: NDArray[np.int64]) -> NDArray[np.int64]:
    """Triangles (t, 3) of polygons: triangles as they are, quadrilaterals along the diagonal that keeps both halves
    facing the same way (the shorter one when both do), larger polygons by clipping ears.

    Parameters
    ----------
    vertices : (v, 3) mm
    corners, lengths : the vertex indices of all polygons one after the other, and the number of corners of each

    Raises
    ------
    MalformedError
        A corner that names no vertex, or a polygon with fewer than 3 or more than 10,000 corners.
    """
    if len(lengths) == 0:
        return np.empty((0, 3), np.int64)
    for wrong, why in ((lengths < 3, "fewer than 3"), (lengths > MOST_CORNERS, f"more than {MOST_CORNERS}")):
        if wrong.any():
            row = int(np.argmax(wrong))
            raise MalformedError(f"face {row + 1} of {len(lengths)} has {why} corners")
    bad = (corners < 0) | (corners >= len(vertices))
    if bad.any():
        at = int(np.argmax(bad))
        face = int(np.searchsorted(np.cumsum(lengths), at, side="right"))
        raise MalformedError(f"face {face + 1} of {len(lengths)} names the vertex {corners[at]}, but there are {len(vertices)} vertices (from 0)")
    if (lengths == 3).all():
        return corners.reshape(-1, 3)
    start = np.cumsum(lengths) - lengths
    pieces = [corners[start[lengths == 3, None] + np.arange(3)]]
    origin = [np.flatnonzero(lengths == 3)]
    four = np.flatnonzero(lengths == 4)
    pieces.append(_split_quadrilaterals(vertices, corners[start[four, None] + np.arange(4)]))
    origin.append(np.repeat(four, 2))
    patience = _VAIN_TESTS
    for face in np.flatnonzero(lengths > 4).tolist():
        polygon = corners[start[face] : start[face] + lengths[face]]
        piece, vain = _clip_ears(vertices, polygon, patience)
        patience -= vain
        pieces.append(piece)
        origin.append(np.full(len(piece), face))
    order = np.argsort(np.concatenate(origin), kind="stable")
    return np.asarray(np.concatenate(pieces)[order], np.int64)


def _split_quadrilaterals(vertices: NDArray[np.float64], quads: NDArray[np.int64]) -> NDArray[np.int64]:
    """(q, 4) -> (2 q, 3)."""
    a, b, c, d = (vertices[quads[:, i]] for i in range(4))
    along_ac = np.einsum("ij,ij->i", np.cross(b - a, c - a), np.cross(c - a, d - a))
    along_bd = np.einsum("ij,ij->i", np.cross(b - a, d - a), np.cross(c - b, d - b))
    shorter = np.linalg.norm(c - a, axis=1) <= np.linalg.norm(d - b, axis=1)
    use_ac = np.where((along_ac > 0) == (along_bd > 0), shorter, along_ac > 0)
    order = np.where(use_ac[:, None], [0, 1, 2, 0, 2, 3], [0, 1, 3, 1, 2, 3])
    return np.take_along_axis(quads, order, axis=1).reshape(-1, 3)


def _clip_ears(vertices: NDArray[np.float64], polygon: NDArray[np.int64], most_vain: int) -> tuple[NDArray[np.int64], int]:
    """Triangles (n - 2, 3) of one polygon (n,), in the plane of its mean normal (Meisters, Polygons have ears, 1975);
    and how many corners were compared in vain, about `most_vain` at most.

    A polygon that crosses itself has no such triangulation; its remainder becomes a fan, and the mesh checks tell.
    """
    ring = vertices[polygon]
    normal = np.cross(ring - ring[0], np.roll(ring, -1, axis=0) - ring[0]).sum(axis=0)
    drop = int(np.argmax(np.abs(normal)))
    plane = ring[:, [(drop + 1) % 3, (drop + 2) % 3]] * (1.0 if normal[drop] >= 0 else -1.0, 1.0)
    left = np.arange(len(polygon))
    triangles: list[tuple[int, int, int]] = []
    at = failures = vain = 0
    patience = _TRIES * len(polygon)
    while len(left) > 3 and failures < len(left) and patience > 0 and vain < most_vain:
        patience -= 1
        i, j, k = int(left[at - 1]), int(left[at]), int(left[(at + 1) % len(left)])
        if _is_ear(plane, left, i, j, k):
            triangles.append((i, j, k))
            left = np.delete(left, at)
            failures = 0
            at = at % len(left)
        else:
            failures += 1
            vain += len(left)
            at = (at + 1) % len(left)
    triangles += [(int(left[0]), int(left[m]), int(left[m + 1])) for m in range(1, len(left) - 1)]
    return polygon[np.array(triangles, np.int64)], vain


def _is_ear(plane: NDArray[np.float64], left: NDArray[np.int64], i: int, j: int, k: int) -> bool:
    a, b, c = plane[i], plane[j], plane[k]
    if _turn(a, b, c) <= 0:
        return False
    others = plane[left]
    inside = (_turns(a, b, others) >= 0) & (_turns(b, c, others) >= 0) & (_turns(c, a, others) >= 0)
    others = others[inside]  # the ear's own corners too
    return bool(((others == a).all(axis=1) | (others == b).all(axis=1) | (others == c).all(axis=1)).all())


def _turn(a: NDArray[np.float64], b: NDArray[np.float64], c: NDArray[np.float64]) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def _turns(a: NDArray[np.float64], b: NDArray[np.float64], c: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray((b[0] - a[0]) * (c[:, 1] - a[1]) - (b[1] - a[1]) * (c[:, 0] - a[0]), np.float64)
