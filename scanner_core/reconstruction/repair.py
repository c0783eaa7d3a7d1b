"""What is wrong with single places of a surface: folds, self-intersections and bad triangles, found and mended there only.

Folds and self-intersections arise in slits narrower than a few spacings, where both walls pull at the same triangles.
There the umbrella operator takes over from the points until the surface is simple again.  Bad triangles (needles, caps)
are mended by flips and by moves within the surface.  No function changes the number of vertices or of triangles, and
every vertex keeps its index, so that what is known of each vertex stays valid.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.edges import EdgeTable, row_cross, row_dot, valences, vertex_triangles
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import SurfaceWalk, closest_in_triangles
from scanner_core.geometry.remeshing import flip_edges
from scanner_core.geometry.self_intersection import IntersectionWatch, self_intersecting_triangles
from scanner_core.geometry.smoothing import uniform_averaging

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

_FOLD_COSINE = -0.3
"""Two neighbouring triangles that turn by more than this (107 degrees) are a fold; a sharp rim turns by 90."""

_TOLERANCES = ((0.03, 1.0), (0.06, 1.0), (0.12, 1.0), (0.25, 0.5))
"""How far a repair of bad triangles may move the surface, in local edges or, where those are longer, in mean edges of the mesh;
and the share of the wanted quality below which a triangle is bad enough for that."""

_ROUNDS_EACH = 8
"""Rounds of flips and moves with one tolerance."""

_UPRIGHT = 0.5
"""Cosine to the mean normal of its surroundings that a changed triangle keeps, unless it was worse before."""


def folded_triangles(mesh: TriangleMesh, table: EdgeTable | None = None) -> Indices:
    """Triangles at an edge where the surface turns back onto itself, (m,); `table` are the edges, made if None."""
    table = table or EdgeTable.of(mesh.triangles)
    assert table.edge_sides is not None
    normals = mesh.area_vectors()
    normals /= np.maximum(np.sqrt(row_dot(normals, normals)), 1e-30)[:, None]
    pairs = table.edge_sides // 3
    turned = row_dot(np.take(normals, pairs[:, 0], axis=0), np.take(normals, pairs[:, 1], axis=0)) < _FOLD_COSINE
    return np.unique(pairs[turned])


def unfold(mesh: TriangleMesh, rounds: int = 12, table: EdgeTable | None = None) -> TriangleMesh:
    """Smooth the surroundings of folds until there is none; the mesh itself where there was none."""
    if table is not None and not len(folded_triangles(mesh, table)):
        return mesh
    return _smooth_where(mesh, folded_triangles, rounds, lambda: None)[0]


def without_self_intersections(mesh: TriangleMesh, check: Callable[[], None], rounds: int = 25) -> TriangleMesh:
    """Smooth the surroundings of self-intersections until there is none, or `rounds` have passed."""
    return _smooth_where(mesh, self_intersecting_triangles, rounds, check)[0]


def repaired(mesh: TriangleMesh, least_quality: float, check: Callable[[], None], rounds: int = 25) -> tuple[TriangleMesh, int]:
    """The mesh without self-intersections and bad triangles, and how many triangles still intersect another one (0 but for hopeless cases)."""
    mesh, left = _smooth_where(mesh, self_intersecting_triangles, rounds, check)
    mended = improved(mesh, least_quality, check)
    # where none intersected, none does: every change was tested
    return mended, 0 if left == 0 else len(self_intersecting_triangles(mended))


def _smooth_where(mesh: TriangleMesh, find: Callable[[TriangleMesh], Indices], rounds: int, check: Callable[[], None]) -> tuple[TriangleMesh, int]:
    """Smooth round the triangles that are found, and how many were found at last (-1 if it was not looked after the last round)."""
    ever = np.zeros(len(mesh.vertices), bool)
    for tick in range(rounds):
        check()
        bad = find(mesh)
        if not len(bad):
            return mesh, 0
        check()
        averaging = uniform_averaging(mesh)
        ever[mesh.triangles[bad].ravel()] = True
        share = ever.astype(np.float64)
        for _ in range(1 + tick // 3):  # the longer it takes, the wider the surroundings
            share = np.maximum(share, averaging @ share * 0.999)
            share[share > 0.1] = 1.0
        moving = np.flatnonzero(share > 0.1)
        rows = averaging[moving]
        vertices = mesh.vertices.copy()
        for _ in range(4):
            vertices[moving] = 0.5 * (vertices[moving] + rows @ vertices)
        flipped = flip_edges(TriangleMesh(vertices, mesh.triangles))
        mesh = TriangleMesh(vertices, _flips_at(mesh.triangles, flipped.triangles, share > 0.1))
    return mesh, -1


def _flips_at(before: Indices, after: Indices, places: Mask) -> Indices:
    """The triangles after flips that touch chosen vertices (v,) bool; other flips are taken back.

    A flip changes two triangles over the same four vertices, and flips of one call share no vertex: whatever has changed at
    a vertex of a wanted flip belongs to it.
    """
    changed = np.flatnonzero((before != after).any(axis=1))
    if not len(changed):
        return before
    wanted = places[before[changed]].any(axis=1)
    reached = np.zeros(len(places), bool)
    reached[before[changed[wanted]].ravel()] = True
    both = changed[reached[before[changed]].any(axis=1)]
    result = before.copy()
    result[both] = after[both]
    return result


def triangle_qualities(vertices: Array, triangles: Indices) -> Array:
    """4 sqrt(3) area over the sum of the squared sides, (t,): 1 for an equilateral triangle, 0 for one without area."""
    return _quality(*(np.take(vertices, column, axis=0) for column in triangles.T))[0]


def _quality(a: Array, b: Array, c: Array) -> tuple[Array, Array]:
    """Quality (t,) and twice the area vector (t, 3) of triangles."""
    ab, ac, bc = b - a, c - a, c - b
    normal = row_cross(ab, ac)
    sides = row_dot(ab, ab) + row_dot(ac, ac) + row_dot(bc, bc)
    return 2 * np.sqrt(3) * np.sqrt(row_dot(normal, normal)) / np.maximum(sides, 1e-300), normal


def improved(mesh: TriangleMesh, least_quality: float, check: Callable[[], None]) -> TriangleMesh:
    """Mend the triangles of a closed mesh whose quality is below `least_quality`, as far as that goes.

    All are brought to half of it at least wherever that is possible with moves of a quarter of an edge, and to all of it with
    smaller moves.  Edges of bad triangles are flipped where that makes the worse of the two better; corners of bad triangles move over the
    given surface to where their worst triangle is best.  Nothing else changes; no triangle gets worse than the worst of its
    neighbourhood was, no new fold and no new self-intersection arises, and vertices and triangles keep their number, vertices
    also their indices.
    """
    bad = triangle_qualities(mesh.vertices, mesh.triangles) < least_quality
    if not np.any(bad):
        return mesh
    work = _Improvement(mesh, least_quality)
    for tolerance, share in _TOLERANCES:
        work.least = share * least_quality
        for _ in range(_ROUNDS_EACH):
            check()
            flipped = work.flip(tolerance)
            moved = work.move(tolerance)
            if not np.any(work.quality < work.least) or (not flipped and not moved):
                break
    return work.mesh


class _Improvement:
    """The state of one repair of bad triangles."""

    def __init__(self, mesh: TriangleMesh, least: float) -> None:
        self.mesh = mesh
        self.least = least
        self.walk = SurfaceWalk(mesh)  # vertices move on the surface as it was given
        self.start = np.arange(len(mesh.vertices))
        self.edge = float(np.sqrt(2.31 * mesh.area() / len(mesh.triangles)))  # side of the equilateral triangle with the mean area
        self.watch = IntersectionWatch(mesh)
        self.quality = triangle_qualities(mesh.vertices, mesh.triangles)
        self._connect()

    def _connect(self) -> None:
        self.table = EdgeTable.of(self.mesh.triangles)
        self.offsets, self.around = vertex_triangles(self.mesh.triangles, len(self.mesh.vertices))

    def flip(self, tolerance: float) -> int:
        """One round of flips; how many there were."""
        v, t = self.mesh.vertices, self.mesh.triangles
        assert self.table.edge_sides is not None
        poor = self.quality < self.least
        edge = np.unique(self.table.side_edges[poor])
        triangle, corner = np.divmod(self.table.edge_sides[edge], 3)
        one, other = triangle.T
        # triangle (a, b, c) and (b, a, d) become (c, d, b) and (d, c, a)
        a, b, c = (t[one, (corner[:, 0] + i) % 3] for i in range(3))
        d = t[other, (corner[:, 1] + 2) % 3]
        old = np.minimum(self.quality[one], self.quality[other])
        (quality_one, normal_one), (quality_other, normal_other) = _quality(v[c], v[d], v[b]), _quality(v[d], v[c], v[a])
        gain = np.minimum(quality_one, quality_other) - old
        mean = normal_one + normal_other  # the area vector of the border: flips do not change it
        size = np.sqrt(row_dot(mean, mean))
        ok = gain > 0.02
        for normal in (normal_one, normal_other):
            ok &= row_dot(normal, mean) > _UPRIGHT * np.sqrt(row_dot(normal, normal)) * size
        # how far the two diagonals pass each other is how far the surface moves
        across = row_cross(v[b] - v[a], v[d] - v[c])
        apart = np.abs(row_dot(v[c] - v[a], across)) / np.maximum(np.sqrt(row_dot(across, across)), 1e-300)
        ok &= apart <= tolerance * np.minimum(np.sqrt(size), self.edge)
        valence = valences(self.table.edges, len(v))
        ok &= (valence[a] > 3) & (valence[b] > 3) & (c != d)
        keys = self.table.edges[:, 0] * len(v) + self.table.edges[:, 1]
        new = np.minimum(c, d) * len(v) + np.maximum(c, d)
        ok &= keys[np.minimum(np.searchsorted(keys, new), len(keys) - 1)] != new
        chosen = np.flatnonzero(ok)
        chosen = chosen[np.argsort(-gain[chosen], kind="stable")]
        best = np.full(len(v), len(chosen))
        for corners in (a, b, c, d):
            np.minimum.at(best, corners[chosen], np.arange(len(chosen)))
        free = np.all([best[corners[chosen]] == np.arange(len(chosen)) for corners in (a, b, c, d)], axis=0)
        chosen = chosen[free]
        while len(chosen):
            triangles = t.copy()
            triangles[one[chosen]] = np.stack([c[chosen], d[chosen], b[chosen]], axis=1)
            triangles[other[chosen]] = np.stack([d[chosen], c[chosen], a[chosen]], axis=1)
            trial = TriangleMesh(v, triangles)
            crossing = self.watch.among(trial, np.concatenate([one[chosen], other[chosen]]))
            wrong = np.isin(one[chosen], crossing) | np.isin(other[chosen], crossing)
            if not np.any(wrong):
                self.mesh = trial
                self.quality[one[chosen]], self.quality[other[chosen]] = quality_one[chosen], quality_other[chosen]
                self._connect()
                return len(chosen)
            chosen = chosen[~wrong]
        return 0

    def move(self, tolerance: float) -> int:
        """Move an independent set of corners of bad triangles; how many moved."""
        v, t = self.mesh.vertices, self.mesh.triangles
        corners = np.unique(t[self.quality < self.least])
        if not len(corners):
            return 0
        ring, begins, _ = self._ring(corners)
        worst = np.minimum.reduceat(self.quality[ring], begins)
        order = corners[np.argsort(worst, kind="stable")]
        picked = order[self._independent(order)]
        ring, begins, owner = self._ring(picked)
        turn = np.argmax(t[ring] == picked[owner][:, None], axis=1)
        left, right = v[t[ring, (turn + 1) % 3]], v[t[ring, (turn + 2) % 3]]
        here = v[picked]
        old_quality, old_normal = _quality(here[owner], left, right)
        best = np.minimum.reduceat(old_quality, begins)
        upright = np.stack([np.add.reduceat(old_normal[:, i], begins) for i in range(3)], axis=1)
        upright /= np.maximum(np.sqrt(row_dot(upright, upright)), 1e-300)[:, None]
        steepest = np.minimum(self._steepest(old_normal, upright, begins, owner), _UPRIGHT)
        edge = np.sqrt(np.add.reduceat(row_dot(left - here[owner], left - here[owner]), begins) / np.bincount(owner))
        middle = np.stack([np.add.reduceat(left[:, i], begins) for i in range(3)], axis=1) / np.bincount(owner)[:, None]
        place, improves = here.copy(), np.zeros(len(picked), bool)
        for shift in _shifts(upright, middle - here, edge):
            feet = self.walk.feet(here + shift, self.start[picked])
            quality, normal = _quality(feet.points[owner], left, right)
            least = np.minimum.reduceat(quality, begins)
            better = (least > best + 0.005) & (self._steepest(normal, upright, begins, owner) >= steepest)
            try_ = np.flatnonzero(better)
            if not len(try_):
                continue
            mine = np.flatnonzero(better[owner])
            away = closest_in_triangles(here[owner[mine]], feet.points[owner[mine]], left[mine], right[mine])[1]
            nearest = np.minimum.reduceat(away, np.searchsorted(owner[mine], try_))
            fits = try_[nearest <= (tolerance * np.minimum(edge[try_], self.edge)) ** 2]
            best[fits], place[fits], improves[fits] = least[fits], feet.points[fits], True
        moving = np.flatnonzero(improves)
        while len(moving):
            vertices = v.copy()
            vertices[picked[moving]] = place[moving]
            trial = TriangleMesh(vertices, t)
            changed = ring[np.isin(owner, moving)]
            crossing = self.watch.among(trial, changed)
            wrong = np.isin(moving, owner[np.isin(ring, crossing)])
            if not np.any(wrong):
                self.mesh = trial
                self.quality[changed] = triangle_qualities(vertices, t[changed])
                return len(moving)
            moving = moving[~wrong]
        return 0

    def _ring(self, vertices: Indices) -> tuple[Indices, Indices, Indices]:
        """Triangles round vertices, one vertex after the other, (k,); where each list begins, (n,); the place in `vertices` of each, (k,)."""
        count = self.offsets[vertices + 1] - self.offsets[vertices]
        begins = np.cumsum(count) - count
        owner = np.repeat(np.arange(len(vertices)), count)
        return self.around[np.repeat(self.offsets[vertices] - begins, count) + np.arange(len(owner))], begins, owner

    def _independent(self, order: Indices) -> Mask:
        """Of vertices in order of urgency those that share no triangle with a more urgent one."""
        rank = np.full(len(self.mesh.vertices), len(order))
        rank[order] = np.arange(len(order))
        ring, begins, _ = self._ring(order)
        return np.asarray(np.minimum.reduceat(rank[self.mesh.triangles[ring]].min(axis=1), begins) == np.arange(len(order)))

    @staticmethod
    def _steepest(normal: Array, upright: Array, begins: Indices, owner: Indices) -> Array:
        """Least cosine between the triangles round each vertex and its own normal, (n,)."""
        cosine = row_dot(normal, upright[owner]) / np.maximum(np.sqrt(row_dot(normal, normal)), 1e-300)
        return np.asarray(np.minimum.reduceat(cosine, begins))


def _shifts(upright: Array, to_middle: Array, edge: Array) -> list[Array]:
    """Trial moves of vertices (n, 3) within their tangent planes: towards the middle of the ring, and round about."""
    to_middle = to_middle - row_dot(to_middle, upright)[:, None] * upright
    axis = np.zeros_like(upright)
    axis[np.arange(len(axis)), np.argmin(np.abs(upright), axis=1)] = 1.0
    u = row_cross(upright, axis)
    u /= np.maximum(np.sqrt(row_dot(u, u)), 1e-300)[:, None]
    w = row_cross(upright, u)
    shifts = [share * to_middle for share in (0.25, 0.5, 0.75, 1.0)]
    for length in (0.05, 0.15, 0.35):
        for angle in np.arange(8) * np.pi / 4:
            shifts.append(length * edge[:, None] * (np.cos(angle) * u + np.sin(angle) * w))
    return shifts
