"""Laplacians of a mesh, and Taubin's low-pass filter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from scanner_core.geometry.edges import EdgeTable, adjacency, row_cross, row_dot
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]


def uniform_averaging(mesh: TriangleMesh, table: EdgeTable | None = None) -> sparse.csr_array:
    """Matrix (v, v) that replaces each vertex by the mean of its neighbours; its rows sum to one.

    `table` are the edges of the mesh, made if None.
    """
    joined = adjacency((EdgeTable.of(mesh.triangles) if table is None else table).edges, len(mesh.vertices))
    valence = np.diff(joined.indptr)
    joined.data /= np.repeat(valence, valence)
    return joined


def cotangent_laplacian(mesh: TriangleMesh, table: EdgeTable | None = None) -> tuple[sparse.csr_array, Array]:
    """Stiffness matrix (v, v) of the Laplacian, positive semi-definite, and the area of each vertex (v,), mm^2.

    ``stiffness @ x / area`` is minus the Laplacian of x; of the coordinates it is the sum of the principal curvatures
    times the outward normal.  Pinkall and Polthier 1993; the cotangents are kept within [0.05, 5], so that slivers cannot
    make a weight negative or huge.  Areas are a third of the triangles around.
    `table` are the edges of the mesh, made if None.
    """
    table = EdgeTable.of(mesh.triangles) if table is None else table
    t, count = mesh.triangles, len(mesh.vertices)
    a, b, c = mesh.corners()
    sides = b - a, c - b, a - c
    normal = row_cross(sides[0], sides[1])
    double_area = np.maximum(np.sqrt(row_dot(normal, normal)), 1e-30)
    half = np.empty(t.shape)
    for i in range(3):
        half[:, i] = -row_dot(sides[(i + 2) % 3], sides[(i + 1) % 3])
    half /= double_area[:, None]
    np.clip(half, 0.05, 5.0, out=half)
    half *= 0.5
    of_edge = np.bincount(table.side_edges.ravel(), half.ravel(), minlength=len(table.edges))
    i, j = table.edges.T
    here = np.arange(count)
    diagonal = np.bincount(i, of_edge, minlength=count) + np.bincount(j, of_edge, minlength=count)
    # Lower neighbours, the vertex itself, higher neighbours: each list is in order already, so that the rows are sorted too.
    rows, columns = np.concatenate([j, here, i]), np.concatenate([i, here, j])
    stiffness = _rows_in_order(np.concatenate([-of_edge, diagonal, -of_edge]), rows, columns, count)
    area = np.bincount(t.ravel(), np.repeat(double_area / 6, 3), minlength=count)
    return stiffness, np.maximum(area, 1e-12 * max(float(area.max()), 1e-30))


def _rows_in_order(data: Array, rows: NDArray[np.int64], columns: NDArray[np.int64], count: int) -> sparse.csr_array:
    """Square matrix of entries that are all different and whose columns rise within each row."""
    entries = sparse.coo_array((data, (rows, columns)), shape=(count, count))
    entries.has_canonical_format = True  # spares the search for doubled entries
    matrix = sparse.csr_array(entries.tocsr())
    matrix.has_sorted_indices = True
    return matrix


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
