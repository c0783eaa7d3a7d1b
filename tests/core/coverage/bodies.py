"""Bodies whose sight lines have formulas."""

from __future__ import annotations

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh

Corner = tuple[float, float, float]

_QUADS = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def box(low: Corner, high: Corner) -> TriangleMesh:
    """A box of twelve triangles, outward."""
    vertices = np.array([[(low, high)[x][0], (low, high)[y][1], (low, high)[z][2]] for z in (0, 1) for y in (0, 1) for x in (0, 1)], np.float64)
    triangles = np.array([part for a, b, c, d in _QUADS for part in ((a, b, c), (a, c, d))], np.int64)
    return TriangleMesh(vertices, triangles)


def joined(*bodies: TriangleMesh) -> TriangleMesh:
    """Bodies as one mesh."""
    counts = np.cumsum([0, *(len(body.vertices) for body in bodies)])
    triangles = [body.triangles + first for body, first in zip(bodies, counts, strict=False)]
    return TriangleMesh(np.concatenate([body.vertices for body in bodies]), np.concatenate(triangles))
