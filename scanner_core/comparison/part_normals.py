"""Normals of a noisy surface: averaged as far as its noise asks for, and no farther."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable, row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import uniform_averaging

Array = NDArray[np.float64]
_SLOPE_ERROR = 0.05
"""Wanted standard deviation of a normal's tilt, rad."""
_MOST_ROUNDS = 8


class PartNormals:
    """Unit normals (v, 3) of one mesh for any noise; those that were asked for are kept.

    White noise of standard deviation n on vertices that stand for an area a each tilts the normals of the surface, averaged by a
    Gaussian of standard deviation s, by ``n sqrt(a / (8 pi)) / s^2``: its length follows from the tilt that does no harm.  A
    longer one would flatten the cusps and the edges that hold a part in its place.
    """

    def __init__(self, mesh: TriangleMesh, table: EdgeTable) -> None:
        self._plain = mesh.vertex_normals()
        self._averaging = uniform_averaging(mesh, table)
        self._edge_mm = float(np.sqrt(np.mean(table.lengths(mesh.vertices) ** 2)))
        self._area_mm2 = mesh.area() / max(len(mesh.vertices), 1)
        self._known: dict[int, Array] = {}

    def rounds(self, noise_mm: float) -> int:
        """How often each vertex takes the mean of its neighbours: the variance grows by half a squared edge each time."""
        variance = noise_mm * np.sqrt(self._area_mm2 / (8 * np.pi)) / _SLOPE_ERROR
        return int(np.clip(np.rint(2 * variance / max(self._edge_mm, 1e-9) ** 2), 0, _MOST_ROUNDS))

    def __call__(self, noise_mm: float) -> Array:
        rounds = self.rounds(noise_mm)
        if rounds not in self._known:
            normals = self._plain
            for _ in range(rounds):
                normals = self._averaging @ normals
            self._known[rounds] = normals / np.maximum(np.sqrt(row_dot(normals, normals)), 1e-12)[:, None]
        return self._known[rounds]
