"""The part of the surface that no point supports: which it is, and a fair cap for it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.spatial import cKDTree

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import cotangent_laplacian, uniform_averaging
from scanner_core.reconstruction.conjugate_gradients import conjugate_gradients

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_AROUND = 16
_ONE_SIDED = 0.8
"""Share of the neighbours' mean distance by which their middle may be off: 0.64 on the rim of the data, 1 far outside."""

_CLOSE = 0.75
"""The nearest point must be so much nearer than the ninth: in the middle of a gap it is about half as far."""

_OFF_NOISE, _OFF_REACH = 2.0, 0.06
"""How far off the plane of its nearest points a vertex may stand: two sigma, and the sag of a curved sheet."""

_REACH = 2.2
"""A vertex is supported within so many local spacings of the data: random points leave gaps of two."""


def supported_vertices(vertices: Array, tree: cKDTree, reach_mm: Array, noise_mm: float) -> Mask:
    """Which vertices (v, 3) lie within reach of the data, (v,).

    `tree` holds the points, `reach_mm` (n,) the distance of each to its eighth neighbour, which is 1.6 spacings on an
    evenly sampled surface.
    """
    away, nearest = tree.query(vertices)
    return np.asarray(away <= _REACH / 1.6 * reach_mm[nearest] + 2 * noise_mm)


def follows_points(vertices: Array, tree: cKDTree, noise_mm: float) -> Mask:
    """Which vertices (v, 3) of a fitted mesh continue the sheet of their nearest points, (v,).

    The cap bends away from the measured surface at its rim: its vertices may be near to points, but they stand off the
    plane through them by more than noise and curvature explain.
    """
    away, nearest = tree.query(vertices, k=_AROUND)
    around = np.asarray(tree.data)[nearest]
    middle = around.mean(axis=1)
    spread = around - middle[:, None]
    normals = np.linalg.eigh(np.einsum("vki,vkj->vij", spread, spread))[1][:, :, 0]
    off = np.abs(((vertices - middle) * normals).sum(axis=1))
    beside = np.linalg.norm(middle - vertices, axis=1)
    reach = away.mean(axis=1)
    close = away[:, 0] <= _CLOSE * away[:, 8] + noise_mm
    return np.asarray(close & (off <= _OFF_NOISE * noise_mm + _OFF_REACH * reach) & (beside <= _ONE_SIDED * reach))


def tidy_support(mesh: TriangleMesh, supported: Mask, rounds: int = 2) -> Mask:
    """Remove specks: a vertex follows the majority of its neighbours."""
    averaging = uniform_averaging(mesh)
    share = supported.astype(np.float64)
    for _ in range(rounds):
        share = 0.5 * share + 0.5 * (averaging @ share)
    return np.asarray(share > 0.5)


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

        def apply(x: Array, inner: sparse.csr_array = inner, mass: Array = mass) -> Array:
            return np.asarray(inner @ x + mass * x)

        diagonal = inner.diagonal() + mass[:, 0]
        placed = conjugate_gradients(apply, diagonal, right, mesh.vertices[free], tolerance=1e-4, most=400, check=check)
        vertices = mesh.vertices.copy()
        vertices[free] = placed
        mesh = TriangleMesh(vertices, mesh.triangles)
    return mesh
