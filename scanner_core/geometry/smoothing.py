"""Laplacians of a mesh, and Taubin's low-pass filter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.geometry.edges import EdgeTable, row_dot, valences
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]


def uniform_averaging(mesh: TriangleMesh) -> sparse.csr_array:
    """Matrix (v, v) that replaces each vertex by the mean of its neighbours; its rows sum to one."""
    return averaging_of(EdgeTable.of(mesh.triangles), len(mesh.vertices))


def averaging_of(table: EdgeTable, vertices: int) -> sparse.csr_array:
    """The matrix of :func:`uniform_averaging` from the edges between so many vertices."""
    i, j = table.edges.T
    share = 1 / np.maximum(valences(table.edges, vertices), 1)
    weights = np.concatenate([share[i], share[j]])
    return sparse.csr_array((weights, (np.concatenate([i, j]), np.concatenate([j, i]))), shape=(vertices, vertices))


def cotangent_laplacian(mesh: TriangleMesh) -> tuple[sparse.csr_array, Array]:
    """Stiffness matrix (v, v) of the Laplacian, positive semi-definite, and the area of each vertex (v,), mm^2.

    ``stiffness @ x / area`` is minus the Laplacian of x; of the coordinates it is the sum of the principal curvatures
    times the outward normal.  Pinkall and Polthier 1993; the cotangents are kept within [0.05, 5], so that slivers cannot
    make a weight negative or huge.  Areas are a third of the triangles around.
    """
    t, count = mesh.triangles, len(mesh.vertices)
    p = mesh.vertices[t]
    to_next = p[:, (1, 2, 0)] - p
    double_area = np.maximum(np.linalg.norm(np.cross(to_next[:, 0], -to_next[:, 2]), axis=1), 1e-30)
    cotangents = np.stack([-row_dot(to_next[:, (i + 2) % 3], to_next[:, (i + 1) % 3]) / double_area for i in range(3)], axis=1)
    half = 0.5 * np.clip(cotangents, 0.05, 5.0).ravel()
    i, j = t.ravel(), t[:, (1, 2, 0)].ravel()
    diagonal = np.bincount(i, half, minlength=count) + np.bincount(j, half, minlength=count)
    rows = np.concatenate([i, j, np.arange(count)])
    columns = np.concatenate([j, i, np.arange(count)])
    stiffness = sparse.csr_array((np.concatenate([-half, -half, diagonal]), (rows, columns)), shape=(count, count))
    area = np.bincount(t.ravel(), np.repeat(double_area / 6, 3), minlength=count)
    return stiffness, np.maximum(area, 1e-12 * max(float(area.max()), 1e-30))


def taubin_mu(lambda_: float, pass_band: float) -> float:
    """The inflating factor mu < -lambda that leaves the frequency `pass_band` unchanged: 1 / lambda + 1 / mu = pass_band."""
    return 1 / (pass_band - 1 / lambda_)


def satisfies_taubin(lambda_: float, mu: float, pass_band: float) -> bool:
    """Taubin's own condition: 0 < lambda < -mu, a pass-band within (0, 1), and 1 / lambda + 1 / mu equal to it.

    Then ``(1 - lambda k)(1 - mu k)`` is 1 at k = 0 and at the pass-band frequency, and below 1 in size up to k = 2 when
    lambda is below ``1 / (1 + ...)``; that last bound is checked as a number.
    """
    if not (0 < lambda_ < -mu and 0 < pass_band < 1 and abs(1 / lambda_ + 1 / mu - pass_band) < 1e-9):
        return False
    k = np.linspace(pass_band, 2.0, 401)
    return bool(np.all(np.abs((1 - lambda_ * k) * (1 - mu * k)) <= 1 + 1e-9))


def taubin_smooth(mesh: TriangleMesh, *, lambda_: float, mu: float, iterations: int) -> TriangleMesh:
    """Taubin's lambda | mu filter: one shrinking and one inflating step of the umbrella operator, `iterations` times.

    No connectivity changes.  G. Taubin, "A signal processing approach to fair surface design", SIGGRAPH 1995, eq. 9-13.
    """
    averaging = uniform_averaging(mesh)
    vertices = mesh.vertices.copy()
    for _ in range(iterations):
        for factor in (lambda_, mu):
            vertices += factor * (averaging @ vertices - vertices)
    return TriangleMesh(vertices, mesh.triangles, dict(mesh.vertex_attributes))
