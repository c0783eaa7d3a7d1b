"""Parts of meshes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from scanner_core.geometry.mesh import TriangleMesh


def kept(mesh: TriangleMesh, keep: NDArray[np.bool_]) -> tuple[TriangleMesh, NDArray[np.int64]]:
    """The largest piece of what is kept, and the numbers (k,) of its vertices in `mesh`."""
    triangles = mesh.triangles[keep[mesh.triangles].all(axis=1)]
    a, b, c = triangles.T
    count = len(mesh.vertices)
    links = coo_array((np.ones(2 * len(a), np.int8), (np.r_[a, b], np.r_[b, c])), shape=(count, count))
    label = connected_components(links, directed=False)[1][a]
    used, renumbered = np.unique(triangles[label == np.bincount(label).argmax()], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], renumbered.reshape(-1, 3).astype(np.int64)), used
