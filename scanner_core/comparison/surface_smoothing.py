"""Smoothing of values over a surface, by lengths in mm."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import cg

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import cotangent_laplacian

Array = NDArray[np.float64]
_STEPS = 2
"""Implicit Euler steps of the heat equation: two look enough like a Gaussian, one has a pointed middle."""


class SurfaceSmoother:
    """Heat flow over a mesh, for the time after which a point has spread like a Gaussian of the given sigma.

    ``(M + t L) x' = M x`` with the areas M and the cotangent stiffness L (Desbrun et al., Implicit fairing of irregular meshes,
    1999); a Gaussian of standard deviation s spreads in the time s^2 / 2.  The length does not depend on the triangles' size.
    """

    def __init__(self, mesh: TriangleMesh, table: EdgeTable | None = None) -> None:
        self._stiffness, self.area_mm2 = cotangent_laplacian(mesh, table)

    def __call__(self, values: Array, sigma_mm: float, seen: NDArray[np.bool_] | None = None) -> Array:
        """Values (v,) smoothed; over the vertices that are `seen` (v,) only, the others keep theirs and have no influence."""
        stiffness, area = self._stiffness, self.area_mm2
        if seen is not None and not seen.all():
            inside = np.flatnonzero(seen)
            part = sparse.csr_array(stiffness[inside][:, inside])
            # what leaves over the edge of the part is added back to the diagonal, so that constants stay constant
            part = part - sparse.diags_array(np.asarray(part.sum(axis=1)).ravel())
            result = values.copy()
            if len(inside):
                result[inside] = _flow(part, area[inside], values[inside], sigma_mm)
            return result
        return _flow(stiffness, area, values, sigma_mm)

    def bending(self, places: Array, normals: Array) -> Array:
        """Sum of the principal curvatures, 1/mm, of the mesh with its vertices at `places` (v, 3); + where it bulges along `normals`."""
        return np.asarray(np.einsum("ni,ni->n", self._stiffness @ places, normals) / self.area_mm2)


def _flow(stiffness: sparse.csr_array, area: Array, values: Array, sigma_mm: float) -> Array:
    matrix = sparse.csr_array(sparse.diags_array(area) + (sigma_mm**2 / 2 / _STEPS) * stiffness)
    diagonal = sparse.diags_array(1 / matrix.diagonal())
    for _ in range(_STEPS):
        values = np.asarray(cg(matrix, area * values, x0=values, rtol=1e-5, maxiter=200, M=diagonal)[0])
    return values
