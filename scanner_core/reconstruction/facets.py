"""The flat facets of a mesh against the curved surface that they stand for."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.smoothing import uniform_averaging
from scanner_core.geometry.subdivision import side_lifts
from scanner_core.reconstruction.discrete_surface import EQUILATERAL, vertex_areas

Array = NDArray[np.float64]


def mean_lifts(mesh: TriangleMesh, normals: Array) -> Array:
    """How far the curved surface stands off the facets around each vertex on average, (v,), mm; + outwards."""
    areas = mesh.areas()
    sag = areas * side_lifts(mesh, normals).mean(axis=1)
    count = len(mesh.vertices)
    corners = mesh.triangles.ravel()
    return np.asarray(np.bincount(corners, np.repeat(sag, 3), minlength=count) / np.bincount(corners, np.repeat(areas, 3), minlength=count))


def centred_facets(mesh: TriangleMesh) -> TriangleMesh:
    """Move vertices from the curved surface outwards (inwards in hollows), so that the facets lie about it, not within it."""
    normals = mesh.vertex_normals()
    return TriangleMesh(mesh.vertices + mean_lifts(mesh, normals)[:, None] * normals, mesh.triangles)


def facet_sag_mm(mesh: TriangleMesh) -> float:
    """How far the curved surface stands off the middle of a facet, in 95 of 100 facets at most, mm."""
    return float(np.percentile(np.abs(side_lifts(mesh, mesh.vertex_normals()).sum(axis=1)) * 4 / 9, 95))


def local_edges(mesh: TriangleMesh) -> Array:
    """Side of the equilateral triangles that fill the surroundings of each vertex, (v,), mm."""
    valence = np.bincount(mesh.triangles.ravel(), minlength=len(mesh.vertices))
    size = 3 * vertex_areas(mesh) / np.maximum(valence, 1)
    size = 0.5 * size + 0.5 * (uniform_averaging(mesh) @ size)
    return np.asarray(np.sqrt(size / EQUILATERAL))
