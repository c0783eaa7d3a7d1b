"""Where the surface needs more triangles: the seam between phase two and the published criterion.

An error function gives every vertex the edge length it should have, in mm, up to a common factor.  Phase two splits the
edges that are longest against it until the wanted number of triangles is reached.
"""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import Feet, closest_near
from scanner_core.geometry.smoothing import uniform_averaging

if TYPE_CHECKING:
    from scanner_core.reconstruction.fit import Fit

Array = NDArray[np.float64]

_GRADING = 2.5
"""Longest wanted edge over the middle one, and the middle one over the shortest."""


class Criterion(Enum):
    """The error functions to choose from."""

    DATA_ERROR = "data_error"
    SAG = "sag"
    UNIFORM = "uniform"


def wanted_sizes(criterion: Criterion, fit: Fit) -> Array:
    """Wanted edge lengths at the vertices of a fit, up to a common factor, (v,)."""
    mesh = fit.mesh
    if criterion is Criterion.UNIFORM:
        return np.ones(len(mesh.vertices))
    if criterion is Criterion.SAG:
        return sizes_by_sag(mesh, mesh.vertex_normals())
    feet = closest_near(mesh, fit.level.observations.points)
    return sizes_by_data_error(mesh, feet, fit.robust, fit.residuals_mm, fit.noise_mm)


def sizes_by_data_error(mesh: TriangleMesh, feet: Feet, weights: Array, residuals_mm: Array, noise_mm: float) -> Array:
    """The published criterion: shorter edges where the points' local error exceeds their noise, (v,), median 1.

    The local error of a vertex is the rms residual of the points around it; an error of sag falls with the square of the
    edge length, so edges go with the root of its excess.  `feet` are those of the n points on `mesh`.
    """
    count = len(mesh.vertices)
    corners = mesh.triangles[feet.triangles].ravel()
    shares = feet.weights * weights[:, None]
    squares = np.bincount(corners, (shares * (residuals_mm**2)[:, None]).ravel(), minlength=count)
    weight = np.bincount(corners, shares.ravel(), minlength=count)
    averaging = uniform_averaging(mesh)
    for _ in range(3):
        squares, weight = squares + averaging @ squares, weight + averaging @ weight
    local = np.sqrt(squares / np.maximum(weight, 1e-9))
    local[weight < 1e-6] = noise_mm
    excess = np.maximum(local / max(noise_mm, 1e-9), 0.3)
    return _graded(1 / np.sqrt(excess), averaging)


def sizes_by_sag(mesh: TriangleMesh, normals: Array) -> Array:
    """Shorter edges where normals turn: a facet of edge e on a curvature k departs by e^2 k / 8, (v,), median 1."""
    table = EdgeTable.of(mesh.triangles)
    i, j = table.edges.T
    turn = np.linalg.norm(normals[i] - normals[j], axis=1) / np.maximum(table.lengths(mesh.vertices), 1e-12)
    total = np.bincount(i, turn**2, minlength=len(mesh.vertices)) + np.bincount(j, turn**2, minlength=len(mesh.vertices))
    valence = np.bincount(table.edges.ravel(), minlength=len(mesh.vertices))
    averaging = uniform_averaging(mesh)
    bend = total / np.maximum(valence, 1)
    bend = np.sqrt(0.5 * bend + 0.5 * (averaging @ bend))
    return _graded(1 / np.sqrt(np.maximum(bend, 1e-9)), averaging)


def _graded(sizes: Array, averaging: sparse.csr_array) -> Array:
    """Bounded about the median and varied gently, so that triangles stay well shaped."""
    sizes = np.clip(sizes / np.median(sizes), 1 / _GRADING, _GRADING)
    for _ in range(2):
        sizes = 0.5 * sizes + 0.5 * (averaging @ sizes)
    return sizes / float(np.median(sizes))
