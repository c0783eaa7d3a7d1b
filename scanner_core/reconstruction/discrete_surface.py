"""A mesh with the operators of its surface: normals, areas, Laplacian, curvature, diffusion."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable, row_dot
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import cotangent_laplacian
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients

Array = NDArray[np.float64]

EQUILATERAL = 0.433
"""Area of an equilateral triangle of side 1."""


class DiscreteSurface:
    """The operators of one mesh, computed once.

    Attributes
    ----------
    table : its edges
    normals : (v, 3) unit normals
    stiffness : (v, v) sparse; ``stiffness @ x / area`` is minus the Laplacian of x
    single : the same in single precision, for iterations
    area : (v,) mm^2 that belong to each vertex
    curvature : (v,) sum of the principal curvatures, 1/mm, + where the surface bulges outwards
    edge_mm : side of the equilateral triangle with the mean area
    """

    def __init__(self, mesh: TriangleMesh, check: Callable[[], None]) -> None:
        self.mesh = mesh
        self.check = check
        self.normals = mesh.vertex_normals()
        self.table = EdgeTable.of(mesh.triangles)
        self.stiffness, self.area = cotangent_laplacian(mesh, self.table)
        self.single = self.stiffness.astype(np.float32)
        self.curvature = row_dot(self.stiffness @ mesh.vertices, self.normals) / self.area
        self.edge_mm = float(np.sqrt(self.area.sum() / (EQUILATERAL * len(mesh.triangles))))
        check()

    def diffused(self, values: Array, reach_mm: Array | float, *, tolerance: float = 1e-3, start: Array | None = None) -> Array:
        """Values (v, k) smoothed by an implicit step of diffusion over a reach, one or (v,), mm; constants stay.

        The kernel has a variance of twice the squared reach along each direction.
        """
        mass = (self.area / np.asarray(reach_mm) ** 2).astype(np.float32)[:, None]
        diagonal = mass[:, 0] + self.single.diagonal()
        single = self.single

        def apply(x: NDArray[np.floating]) -> NDArray[np.floating]:
            return np.asarray(mass * x + single @ x)

        begin = values if start is None else start
        right = mass * values.astype(np.float32)
        return conjugate_gradients(apply, diagonal, right, begin, tolerance=tolerance, most=200, check=self.check).astype(np.float64)


def vertex_areas(mesh: TriangleMesh) -> Array:
    """A third of the area of the triangles around each vertex, (v,), mm^2."""
    return np.asarray(np.bincount(mesh.triangles.ravel(), np.repeat(mesh.areas() / 3, 3), minlength=len(mesh.vertices)))


def mean_edge(mesh: TriangleMesh) -> float:
    """Side of the equilateral triangle with the mean area, mm."""
    return float(np.sqrt(mesh.area() / (EQUILATERAL * len(mesh.triangles))))
