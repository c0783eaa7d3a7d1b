"""A fair cap for the part of the surface that no point supports."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import cotangent_laplacian
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


def fair_cap(mesh: TriangleMesh, supported: Mask, check: Callable[[], None], rounds: int = 2) -> TriangleMesh:
    """Pull the unsupported part tight, as a soap film in the rim of the supported one, which does not move.

    Mean curvature flow with long implicit steps (Desbrun et al. 1999): a plane rim gets a plane cap.  A thin plate would go
    on with the slope at the rim and bulge by millimetres; a film that may pull the rim would drag measured surface along.
    """
    free = np.flatnonzero(~supported)
    if not len(free) or not np.any(supported):
        return mesh
    for _ in range(rounds):
        stiffness, area = cotangent_laplacian(mesh)
        inner = stiffness[free][:, free]
        span = float(area[free].sum())
        mass = (area[free] / (0.05 * span))[:, None]
        fixed = np.flatnonzero(supported)
        right = mass * mesh.vertices[free] - stiffness[free][:, fixed] @ mesh.vertices[fixed]

        def apply(x: NDArray[np.floating], inner: sparse.csr_array = inner, mass: Array = mass) -> NDArray[np.floating]:
            return np.asarray(inner @ x + mass * x)

        diagonal = inner.diagonal() + mass[:, 0]
        vertices = mesh.vertices.copy()
        vertices[free] = conjugate_gradients(apply, diagonal, right, mesh.vertices[free], tolerance=1e-4, most=400, check=check)
        mesh = TriangleMesh(vertices, mesh.triangles)
    return mesh
