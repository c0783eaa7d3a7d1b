"""The arch specimen in few triangles, each time with another grid."""

from __future__ import annotations

from functools import cache

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.virtual.specimens.arch import TREATMENT, solid
from scanner_core.virtual.specimens.implicit import mesh_implicit


@cache
def small_arch(*, treated: bool = False, step_mm: float = 0.8) -> TriangleMesh:
    """Before or after treatment; the open bottom of a scan is cut off at 1 mm."""
    mesh = mesh_implicit(lambda points: solid(points, TREATMENT if treated else {}), (-31.9, -26.9, -0.83), (31.9, 27.9, 13.3), step_mm)
    inside = (mesh.vertices[mesh.triangles][:, :, 2] > 1.0).all(axis=1)
    used, index = np.unique(mesh.triangles[inside], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], index.reshape(-1, 3))


def noisy(mesh: TriangleMesh, noise_um: float, seed: int) -> TriangleMesh:
    """White noise along the normals."""
    along = np.random.default_rng(seed).normal(0.0, 1e-3 * noise_um, len(mesh.vertices))
    return TriangleMesh(mesh.vertices + along[:, None] * mesh.vertex_normals(), mesh.triangles)
