"""A coarse surface with what no point supports, made ready to draw away from the GUI thread and before VTK is imported."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh


@dataclass(frozen=True, slots=True, eq=False)
class HoledSurface:
    """The triangles of a surface in two kinds, and the rim between them.

    Attributes
    ----------
    vertices, normals : (v, 3) float32
    scanned : (s, 3) triangles whose corners are all supported
    open : (h, 3) the others
    rim : (r, 2) the edges where they meet
    """

    vertices: NDArray[np.float32]
    normals: NDArray[np.float32]
    scanned: NDArray[np.int64]
    open: NDArray[np.int64]
    rim: NDArray[np.int64]

    @classmethod
    def of(cls, mesh: TriangleMesh) -> HoledSurface:
        """Of a closed mesh with the attribute `supported`."""
        whole = np.asarray(mesh.vertex_attributes["supported"], np.bool_)[mesh.triangles].all(axis=1)
        scanned = mesh.triangles[whole]
        return cls(mesh.vertices.astype(np.float32), mesh.vertex_normals().astype(np.float32), scanned, mesh.triangles[~whole], _rim(scanned))


def _rim(triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Edges (r, 2) that only one of the triangles has."""
    sides = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
    low, high = sides.min(axis=1), sides.max(axis=1)
    _, first, times = np.unique(low << 32 | high, return_index=True, return_counts=True)  # one number an edge: rows are slow to compare
    return np.asarray(sides[first[times == 1]])
