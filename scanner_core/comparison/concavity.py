"""Where a surface folds inwards: the borders of what a person calls a part (minima rule)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components, dijkstra

from scanner_core.comparison.surface_smoothing import SurfaceSmoother
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
_SMOOTHING_MM = 0.5
_CONCAVE_PER_MM = -0.15
"""Sum of the principal curvatures below which a place is a furrow: a blend of 1 mm has some -0.5, noise of 50 um some 0.1."""
_RIM_MM = 0.7
"""So far beside a furrow the surface is still bent by it."""


class Concavity:
    """The furrows of a mesh.

    Hoffman and Richards, Parts of recognition, 1984: parts meet at negative minima of curvature.  Which way the triangles face does
    not matter: most of the area of a body that stands free is convex.
    """

    def __init__(self, mesh: TriangleMesh, smoother: SurfaceSmoother, table: EdgeTable) -> None:
        smooth = np.column_stack([smoother(mesh.vertices[:, axis], _SMOOTHING_MM) for axis in range(3)])
        normals = TriangleMesh(smooth, mesh.triangles).vertex_normals()
        self.curvature_per_mm = smoother.bending(smooth, normals)
        self.table = table
        along = mesh.vertices[table.edges[:, 0]] - mesh.vertices[table.edges[:, 1]]
        lengths = np.maximum(np.linalg.norm(along, axis=1), 1e-9)
        count = len(mesh.vertices)
        self._graph = sparse.csr_array(sparse.coo_array((lengths, (table.edges[:, 0], table.edges[:, 1])), shape=(count, count)))

    def furrows(self, convex: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(v,) whether a vertex lies in a furrow; `convex` (v,) marks bodies that bulge outwards for the most part."""
        facing = np.sign(np.median(self.curvature_per_mm[convex])) if convex.any() else 1.0
        return np.asarray(facing * self.curvature_per_mm < _CONCAVE_PER_MM)

    def core(self, label: Indices, free: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(v,) the part of each body (`label` (v,), where `free`) away from the furrows that bound it.

        A furrow bounds a body where it leads, without a break, from what is not free or from another body: a fissure in its middle
        does not.
        """
        edges = self.table.edges
        across = (label[edges[:, 0]] != label[edges[:, 1]]) | (free[edges[:, 0]] != free[edges[:, 1]])
        border = ~free
        border[edges[across].ravel()] = True
        fold = self.furrows(free) | border
        inside = edges[fold[edges].all(axis=1)]
        graph = sparse.coo_array((np.ones(len(inside)), (inside[:, 0], inside[:, 1])), shape=(len(label),) * 2)
        piece = connected_components(graph, directed=False)[1]
        bounding = fold & np.isin(piece, np.unique(piece[border]))
        return np.asarray(self.distance_mm(np.flatnonzero(bounding), _RIM_MM) > _RIM_MM)

    def distance_mm(self, sources: Indices, limit_mm: float) -> Array:
        """Way along the edges from the nearest source to every vertex (v,), infinite beyond `limit_mm`."""
        if not len(sources):
            return np.full(self._graph.shape[0], np.inf)
        return np.asarray(dijkstra(self._graph, directed=False, indices=sources, limit=limit_mm, min_only=True), np.float64)
