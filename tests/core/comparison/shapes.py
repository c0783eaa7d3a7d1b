"""Small bodies of the size of an arch, and parts of them."""

from __future__ import annotations

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from tests.core.geometry.solids import sphere


def egg(largest_mm: float = 60.0, around: int = 24, across: int = 14) -> TriangleMesh:
    """A closed body without symmetry but those of an ellipsoid, standing on z = 0."""
    mesh = sphere(1.0, around, across)
    half = 0.5 * largest_mm * np.array([1.0, 0.8, 0.5])
    return TriangleMesh((mesh.vertices + np.array([0, 0, 1])) * half, mesh.triangles)


def cut(mesh: TriangleMesh, above_mm: float) -> TriangleMesh:
    """What lies above a height, open below."""
    inside = (mesh.vertices[mesh.triangles][:, :, 2] > above_mm).all(axis=1)
    used, index = np.unique(mesh.triangles[inside], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], index.reshape(-1, 3))


def turned_inside_out(mesh: TriangleMesh) -> TriangleMesh:
    return TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1])


def scaled(mesh: TriangleMesh, factor: float) -> TriangleMesh:
    return TriangleMesh(mesh.vertices * factor, mesh.triangles)
