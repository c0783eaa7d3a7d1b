"""What a mesh must be to be milled, printed or measured: closed, 2-manifold, facing outwards, free of self-intersections."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.self_intersection import THINNEST, self_intersecting_triangles


@dataclass(frozen=True, slots=True)
class MeshChecks:
    """The verdicts on one mesh.

    Attributes
    ----------
    closed : every edge belongs to exactly two triangles
    manifold : no edge belongs to more than two triangles, and the triangles round every vertex form one fan
    outward : neighbours wind the same way, and every closed component encloses a positive volume
    genus : number of handles of all components together (Euler); None where the surface is not a manifold
    components : pieces that hang together over edges
    boundary_edges : edges of one triangle only
    nonmanifold_edges, nonmanifold_vertices : edges of more than two triangles; vertices with more than one fan
    degenerate : triangles with (next to) no area
    self_intersections : triangles that intersect another one
    """

    closed: bool
    manifold: bool
    outward: bool
    genus: int | None
    components: int
    boundary_edges: int
    degenerate: int
    self_intersections: int
    nonmanifold_edges: int = 0
    nonmanifold_vertices: int = 0

    @property
    def sound(self) -> bool:
        """A closed, outward 2-manifold without self-intersections and without degenerate triangles."""
        return self.closed and self.manifold and self.outward and self.self_intersections == 0 and self.degenerate == 0


def check_mesh(mesh: TriangleMesh, *, self_intersections: int | None = None) -> MeshChecks:
    """Look at every edge, vertex and triangle of a mesh; the vertices are taken as they are indexed, not welded.

    Parameters
    ----------
    mesh : any triangles
    self_intersections : number of triangles that intersect another one, where it is known of this very mesh; the search
        for them takes most of the time
    """
    triangles = mesh.triangles
    if len(triangles) == 0:
        return MeshChecks(False, False, False, None, 0, 0, 0, 0)
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    # One int64 an edge: np.unique of rows would hold the interpreter for half a second.
    count = np.int64(len(mesh.vertices))
    key = np.minimum(start, end) * count + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    ordered = key[order]
    first = np.flatnonzero(np.r_[True, ordered[1:] != ordered[:-1]])
    uses = np.diff(np.r_[first, len(ordered)])
    boundary, crowded = int((uses == 1).sum()), int((uses > 2).sum())

    joined = np.flatnonzero(ordered[1:] == ordered[:-1])  # neighbouring half-edges of one edge, in sorted order
    a, b = order[joined], order[joined + 1]
    components, label = _pieces(a // 3, b // 3, len(triangles))
    extra_fans = _extra_fans(triangles, start, a, b)
    manifold = crowded == 0 and extra_fans == 0

    pairs = first[uses == 2]
    consistent = bool((start[order[pairs]] != start[order[pairs + 1]]).all()) and crowded == 0
    open_pieces = np.unique(label[order[first[uses == 1]] // 3])
    volumes = np.bincount(label, _volumes(mesh), minlength=components)
    volumes[open_pieces] = 1.0
    outward = consistent and bool((volumes > 0).all())

    genus = None
    if manifold:
        used = len(np.unique(triangles))
        loops = _boundary_loops(order[first[uses == 1]], start, end, len(mesh.vertices))
        twice = 2 * components - loops - (used - len(first) + len(triangles))
        genus = twice // 2 if twice % 2 == 0 else None
    return MeshChecks(
        closed=boundary == 0 and crowded == 0,
        manifold=manifold,
        outward=outward,
        genus=genus,
        components=components,
        boundary_edges=boundary,
        degenerate=_degenerate(mesh),
        self_intersections=len(self_intersecting_triangles(mesh)) if self_intersections is None else self_intersections,
        nonmanifold_edges=crowded,
        nonmanifold_vertices=extra_fans,
    )


def _pieces(a: NDArray[np.int64], b: NDArray[np.int64], count: int) -> tuple[int, NDArray[np.int32]]:
    """Connected components of a graph with the links a - b: their number and the label of each of `count` nodes."""
    graph = coo_array((np.ones(len(a), np.int8), (a, b)), shape=(count, count))
    number, label = connected_components(graph, directed=False)
    return int(number), np.asarray(label, np.int32)


def _extra_fans(triangles: NDArray[np.int64], start: NDArray[np.int64], a: NDArray[np.int64], b: NDArray[np.int64]) -> int:
    """Number of vertices whose triangles form more than one fan; a and b are half-edges of the same edge.

    Corners of neighbours at the same vertex are joined; every vertex must end with one group of corners.
    Half-edge h starts at the corner h and ends at the next corner of the same triangle.
    """
    next_a, next_b = a - a % 3 + (a + 1) % 3, b - b % 3 + (b + 1) % 3
    same = start[a] == start[b]  # neighbours that wind against each other run along the edge in the same direction
    links_a = np.concatenate([a, next_a])
    links_b = np.concatenate([np.where(same, b, next_b), np.where(same, next_b, b)])
    groups, label = _pieces(links_a, links_b, triangles.size)
    vertex = np.empty(groups, np.int64)
    vertex[label] = triangles.ravel()
    return int((np.bincount(vertex) > 1).sum())


def _volumes(mesh: TriangleMesh) -> NDArray[np.float64]:
    """Signed volume of the tetrahedron over each triangle, (t,), mm^3."""
    low, high = mesh.bounds()
    a, b, c = (corner - 0.5 * (low + high) for corner in mesh.corners())
    return np.asarray(np.einsum("ij,ij->i", a, np.cross(b, c)) / 6, np.float64)


def _boundary_loops(half_edges: NDArray[np.int64], start: NDArray[np.int64], end: NDArray[np.int64], count: int) -> int:
    if len(half_edges) == 0:
        return 0
    a, b = start[half_edges], end[half_edges]
    _, label = _pieces(a, b, count)
    return len(np.unique(label[a]))


def _degenerate(mesh: TriangleMesh) -> int:
    a, b, c = mesh.corners()
    longest = np.sqrt(np.max([np.einsum("ij,ij->i", e, e) for e in (b - a, c - b, a - c)], axis=0))
    return int((2 * mesh.areas() <= THINNEST * longest * longest).sum())
