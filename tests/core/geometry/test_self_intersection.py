"""Intersecting triangles against a brute force in exact integers, and on bodies whose answer is known."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.box_tree import BoxTree
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.self_intersection import THINNEST, IntersectionWatch, _cut, self_intersecting_triangles, self_intersection_pairs
from scanner_core.geometry.weld import weld
from tests.core.geometry.solids import box, joined, moved, sphere, torus

Point = tuple[int, int, int]


def _side(a: Point, b: Point, c: Point, d: Point) -> int:
    """Sign of the volume of the tetrahedron, exactly."""
    (p, q, r), (s, t, u), (v, w, x) = ([i - j for i, j in zip(corner, d, strict=True)] for corner in (a, b, c))
    volume = p * (t * x - u * w) - q * (s * x - u * v) + r * (s * w - t * v)
    return (volume > 0) - (volume < 0)


def _pierces(start: Point, end: Point, a: Point, b: Point, c: Point) -> bool:
    if _side(a, b, c, start) * _side(a, b, c, end) >= 0:
        return False
    return {_side(start, end, a, b), _side(start, end, b, c), _side(start, end, c, a)} in ({1}, {-1})


def _brute(points: list[Point], triangles: list[list[int]]) -> set[tuple[int, int]]:
    """Pairs where an edge of one pierces the other away from shared vertices; no four points lie in one plane."""
    found = set()
    for i, j in combinations(range(len(triangles)), 2):
        shared = set(triangles[i]) & set(triangles[j])
        if len(shared) == 3:
            found.add((i, j))
        for one, other in ((i, j), (j, i)):
            for k in range(3):
                start, end = triangles[one][k], triangles[one][k - 1]
                if len(shared) < 2 and not {start, end} & shared and _pierces(points[start], points[end], *(points[c] for c in triangles[other])):
                    found.add((i, j))
    return found


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.integers(6, 40))
def test_random_triangles_agree_with_exact_brute_force(seed: int, vertex_count: int) -> None:
    rng = np.random.default_rng(seed)
    points = rng.integers(-100_000, 100_000, (vertex_count, 3))
    triangles = np.array([rng.choice(vertex_count, 3, replace=False) for _ in range(25)])
    pairs = self_intersection_pairs(TriangleMesh(points.astype(np.float64), triangles))
    assert {tuple(pair) for pair in pairs.tolist()} == _brute([tuple(p) for p in points.tolist()], triangles.tolist())


@pytest.mark.parametrize("mesh", [box(), sphere(), torus(), sphere(50.0, 120, 60), joined(box(), box(1.0, (2, 0, 0)))])
@pytest.mark.parametrize("seed", [None, 3])
def test_sound_bodies_have_none_wherever_they_stand(mesh: TriangleMesh, seed: int | None) -> None:
    assert len(self_intersecting_triangles(moved(mesh, (1000.0, -300.0, 77.7), seed))) == 0


def test_a_flat_grid_has_none() -> None:
    x, y = np.meshgrid(np.arange(12.0), np.arange(12.0), indexing="ij")
    grid = np.column_stack([x.ravel(), y.ravel(), np.zeros(144)])
    corner = (np.arange(11)[:, None] * 12 + np.arange(11)).ravel()
    triangles = np.concatenate([np.column_stack([corner, corner + 12, corner + 13]), np.column_stack([corner, corner + 13, corner + 1])])
    for seed in (None, 4, 5):
        assert len(self_intersecting_triangles(moved(TriangleMesh(grid, triangles), (10.0, 20.0, 30.0), seed))) == 0


def test_vertices_that_are_doubled_count_as_shared() -> None:
    mesh = sphere()
    soup = TriangleMesh(mesh.vertices[mesh.triangles].reshape(-1, 3), np.arange(3 * len(mesh.triangles)).reshape(-1, 3))
    assert len(self_intersecting_triangles(soup)) == 0


def test_two_spheres_cross_in_a_ring() -> None:
    mesh = joined(sphere(2.0), moved(sphere(2.0), (2.111, 0.1, 0.2), seed=1))
    centre = mesh.vertices[mesh.triangles].mean(axis=1)
    found = self_intersecting_triangles(mesh)
    assert len(found) > 20
    from_first = np.linalg.norm(centre[found], axis=1)
    from_second = np.linalg.norm(centre[found] - (2.111, 0.1, 0.2), axis=1)
    assert np.abs(from_first - from_second).max() < 0.7  # near the circle where both surfaces are


FOLDED = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.8, 0.9, 0], [0.2, 0.3, 0]])


@pytest.mark.parametrize(
    ("triangles", "intersect"),
    [
        ([[0, 1, 2], [1, 3, 2]], False),  # neighbours over an edge, spread out
        ([[0, 1, 2], [1, 4, 2]], True),  # folded back over their common edge
        ([[0, 1, 2], [0, 1, 2]], True),  # twice the same
        ([[0, 1, 4], [2, 3, 4]], False),  # one common vertex, beside each other
        ([[0, 1, 2], [2, 4, 3]], True),  # one common vertex, overlapping in the plane
    ],
)
@pytest.mark.parametrize("seed", [None, 6])
def test_coplanar_neighbours(triangles: list[list[int]], intersect: bool, seed: int | None) -> None:
    mesh = moved(TriangleMesh(FOLDED, np.array(triangles)), (5.0, 6.0, 7.0), seed)
    assert (len(self_intersection_pairs(mesh)) > 0) is intersect


def test_coplanar_triangles_without_a_common_vertex() -> None:
    apart = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.1, 0.1, 0], [1.1, 0.1, 0], [0.1, 1.1, 0]])
    pair = np.array([[0, 1, 2], [3, 4, 5]])
    assert len(self_intersection_pairs(TriangleMesh(apart, pair))) == 1
    assert len(self_intersection_pairs(TriangleMesh(apart + np.repeat([[0, 0, 0], [1, 1, 0]], 3, axis=0), pair))) == 0
    assert len(self_intersection_pairs(TriangleMesh(apart + np.repeat([[0, 0, 0], [0, 0, 1e-4]], 3, axis=0), pair))) == 0


@settings(max_examples=30)
@given(st.integers(0, 2**32 - 1), st.integers(1, 60))
def test_box_pairs_agree_with_brute_force(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    low = rng.integers(0, 6, (count, 3)).astype(np.float64)
    high = low + rng.integers(0, 3, (count, 3))
    expected = {(i, j) for i, j in combinations(range(count), 2) if (low[i] <= high[j]).all() and (low[j] <= high[i]).all()}
    pairs = BoxTree(low, high).overlapping_pairs().tolist()
    assert {tuple(pair) for pair in pairs} == expected
    assert len(pairs) == len(expected)


@settings(max_examples=30)
@given(st.integers(0, 2**32 - 1), st.integers(1, 40))
def test_boxes_within_reach_agree_with_brute_force(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    low = rng.integers(0, 6, (count, 3)).astype(np.float64)
    high = low + rng.integers(0, 3, (count, 3))
    points, reach = rng.uniform(-2, 9, (15, 3)), rng.uniform(0, 4, 15)
    outside = np.maximum(np.maximum(low - points[:, None], points[:, None] - high), 0.0)
    expected = np.argwhere(np.linalg.norm(outside, axis=2) <= reach[:, None])
    which, index = BoxTree(low, high).boxes_within(points, reach)
    assert (np.diff(which) >= 0).all()
    assert sorted(zip(which.tolist(), index.tolist(), strict=True)) == [tuple(row) for row in expected.tolist()]


def _all_box_pairs(mesh: TriangleMesh) -> set[tuple[int, int]]:
    """The plain way: every pair whose boxes overlap is tested, neighbours or not."""
    corners = mesh.vertices[mesh.triangles]
    size = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1)
    usable = np.flatnonzero(length > THINNEST * size * size)
    normal[usable] /= length[usable, None]
    pairs = usable[BoxTree(corners[usable].min(axis=1), corners[usable].max(axis=1)).overlapping_pairs()]
    return {tuple(pair) for pair in _cut(corners, weld(mesh.vertices)[1][mesh.triangles], normal, size, pairs).tolist()}


def _agrees(mesh: TriangleMesh) -> int:
    pairs = self_intersection_pairs(mesh)
    found = {tuple(pair) for pair in pairs.tolist()}
    assert len(found) == len(pairs)
    assert found == _all_box_pairs(mesh)
    return len(found)


@settings(max_examples=40)
@given(st.integers(0, 2**32 - 1), st.floats(0.0, 1.5), st.sampled_from(["sphere", "torus", "two", "uneven"]))
def test_letting_neighbours_go_changes_no_answer(seed: int, noise: float, body: str) -> None:
    """Surfaces from smooth to crumpled, with triangles of one size and of very different sizes."""
    rng = np.random.default_rng(seed)
    mesh = {"sphere": sphere(2.0), "torus": torus(), "two": joined(sphere(2.0), moved(sphere(2.0), (2.1, 0.1, 0.2), 1)), "uneven": box()}[body]
    vertices = mesh.vertices
    if body == "uneven":
        mesh = joined(sphere(2.0, 40, 20), moved(sphere(0.1), (2.0, 0.0, 0.0), 2))
        vertices = mesh.vertices * (1.0, 1.0, 0.3)
    edge = np.linalg.norm(vertices[mesh.triangles[:, 0]] - vertices[mesh.triangles[:, 1]], axis=1)
    scale = np.zeros(len(vertices))
    scale[mesh.triangles[:, 0]] = edge
    _agrees(TriangleMesh(vertices + noise * scale[:, None] * rng.normal(size=vertices.shape), mesh.triangles))


def test_a_fan_that_goes_round_its_vertex_twice_intersects() -> None:
    """All its normals point the same way, so that only the second turn tells it from a smooth place."""
    angle = np.linspace(0, 4 * np.pi, 11)[:-1]
    ring = np.column_stack([np.cos(angle), np.sin(angle), 0.05 * np.sin(angle / 2)])
    vertices = np.concatenate([[[0.0, 0.0, 0.0]], ring])
    spokes = np.arange(10)
    assert _agrees(TriangleMesh(vertices, np.column_stack([np.zeros(10, np.int64), 1 + spokes, 1 + (spokes + 1) % 10]))) > 0


def test_long_needles_among_many_small_triangles() -> None:
    """Spheres round needles hold nearly everything: the tree of boxes takes over."""
    rng = np.random.default_rng(8)
    start = rng.uniform(-3, 3, (300, 3))
    along = 20 * rng.normal(size=(300, 3))
    corners = np.stack([start - along, start + along, start + 0.05 * rng.normal(size=(300, 3))], axis=1)
    needles = TriangleMesh(corners.reshape(-1, 3), np.arange(900).reshape(-1, 3))
    assert _agrees(joined(needles, sphere(2.0, 40, 20))) > 0


@settings(max_examples=20)
@given(st.integers(0, 2**32 - 1), st.floats(0.1, 1.0))
def test_intersections_of_some_triangles_are_those_of_the_whole_mesh(seed: int, noise: float) -> None:
    rng = np.random.default_rng(seed)
    mesh = sphere(2.0)
    mesh = TriangleMesh(mesh.vertices + 0.3 * noise * rng.normal(size=mesh.vertices.shape), mesh.triangles)
    watch = IntersectionWatch(mesh)
    for _ in range(3):
        some = rng.choice(len(mesh.triangles), 20, replace=False)
        vertices = mesh.vertices.copy()
        moved = rng.choice(len(vertices), 3, replace=False)
        vertices[moved] += 0.5 * rng.normal(size=(3, 3))
        mesh = TriangleMesh(vertices, mesh.triangles)
        some = np.union1d(some, np.flatnonzero(np.isin(mesh.triangles, moved).any(axis=1)))
        pairs = self_intersection_pairs(mesh)
        np.testing.assert_array_equal(watch.among(mesh, some), np.unique(pairs[np.isin(pairs, some).any(axis=1)]))
    assert len(watch.among(mesh, some[:0])) == 0
