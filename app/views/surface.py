"""A mesh made ready to draw, away from the GUI thread and before VTK is imported."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """A mesh with what drawing it needs.

    Attributes
    ----------
    mesh : as it came
    normals : (v, 3) float32
    growing : a preview of an unfinished mesh
    """

    mesh: TriangleMesh
    normals: NDArray[np.float32]
    growing: bool

    @classmethod
    def of(cls, mesh: TriangleMesh, *, growing: bool) -> Surface:
        return cls(mesh, mesh.vertex_normals().astype(np.float32), growing)
