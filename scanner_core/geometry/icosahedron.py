"""The regular icosahedron, the body that a reconstruction starts from."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from scanner_core.geometry.mesh import TriangleMesh

_TRIANGLES = (
    (0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
    (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
    (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
    (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1),
)  # fmt: skip


def icosahedron(centre: ArrayLike, radius_mm: float) -> TriangleMesh:
    """Twelve vertices on a sphere of `radius_mm` about `centre` (3,), twenty outward triangles."""
    golden = (1 + np.sqrt(5)) / 2
    corners = np.array([(s, t * golden, 0.0) for t in (1, -1) for s in (-1, 1)])
    vertices = np.concatenate([corners, np.roll(corners, 1, axis=1), np.roll(corners, 2, axis=1)])
    vertices *= radius_mm / np.linalg.norm(vertices[0])
    return TriangleMesh(vertices + np.asarray(centre, np.float64), np.array(_TRIANGLES, np.int64))
