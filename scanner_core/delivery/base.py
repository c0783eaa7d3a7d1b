"""The base of a closed surface: what the object stood on, and no point could reach."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

_LEAST_SHARE = 0.03
"""Of the whole surface; a smaller piece without points is a hole, not what an object stands on."""
_FLATNESS = 0.9
"""Length of the sum of the area vectors over the area: 1 is a plane, half a sphere has 0.5."""


@dataclass(frozen=True, slots=True, eq=False)
class Base:
    """The flat part of a surface that rests on no point.

    Attributes
    ----------
    triangles : (t,) bool, those of the base
    outward : (3,) unit, the way it faces
    """

    triangles: Mask
    outward: Array


def supported_vertices(mesh: TriangleMesh) -> Mask | None:
    """(v,) which vertices rest on points; None where the mesh does not tell."""
    flags = mesh.vertex_attributes.get("supported")
    return None if flags is None else np.asarray(flags != 0, np.bool_)


def find_base(mesh: TriangleMesh) -> Base | None:
    """The largest connected part without support, when it is flat and large enough to stand on; None without such a part."""
    supported = supported_vertices(mesh)
    if supported is None or supported.all() or not supported.any():
        return None
    bare = np.flatnonzero(~supported[mesh.triangles].any(axis=1))
    if not len(bare):
        return None
    label = _pieces(mesh.triangles[bare])
    areas, vectors = mesh.areas(), mesh.area_vectors()[bare]
    size = np.bincount(label, areas[bare])
    largest = int(np.argmax(size))
    outward = np.asarray(vectors[label == largest].sum(axis=0), np.float64)
    length = float(np.linalg.norm(outward))
    if size[largest] < _LEAST_SHARE * areas.sum() or length < _FLATNESS * size[largest]:
        return None
    triangles = np.zeros(len(mesh.triangles), np.bool_)
    triangles[bare[label == largest]] = True
    return Base(triangles, outward / length)


def coverage(mesh: TriangleMesh) -> float | None:
    """Share of the area beside the base, and what borders on it, that rests on points, 0 to 1; None where the mesh does not tell.

    A triangle counts by the share of its corners that rest on points.
    """
    supported = supported_vertices(mesh)
    if supported is None:
        return None
    areas, base = mesh.areas(), find_base(mesh)
    on_base = np.zeros(len(mesh.vertices), np.bool_)
    if base is not None:
        on_base[mesh.triangles[base.triangles]] = True
    rest = ~on_base[mesh.triangles].any(axis=1)
    total = float(areas[rest].sum())
    return float((areas * supported[mesh.triangles].mean(axis=1))[rest].sum()) / total if total > 0 else None


def without_base(mesh: TriangleMesh) -> TriangleMesh:
    """The surface open at its base; the same mesh when it has none that is known."""
    base = find_base(mesh)
    if base is None:
        return mesh
    kept = mesh.triangles[~base.triangles]
    used, index = np.unique(kept, return_inverse=True)
    attributes = {name: values[used] for name, values in mesh.vertex_attributes.items()}
    return TriangleMesh(mesh.vertices[used], index.reshape(-1, 3).astype(np.int64), attributes)


def _pieces(triangles: NDArray[np.int64]) -> NDArray[np.int32]:
    """Label of each of (n, 3) triangles by the piece that hangs together over edges."""
    table = EdgeTable.of(triangles)
    edge = table.side_edges.ravel()
    order = np.argsort(edge, kind="stable")
    same = np.flatnonzero(np.diff(edge[order]) == 0)
    a, b = order[same] // 3, order[same + 1] // 3
    graph = coo_array((np.ones(len(a), np.int8), (a, b)), shape=(len(triangles), len(triangles)))
    return np.asarray(connected_components(graph, directed=False)[1], np.int32)
