"""Every verdict on bodies that were built to deserve it."""

from __future__ import annotations

from collections import defaultdict

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from tests.core.geometry.solids import box, joined, moved, sphere, torus


@pytest.mark.parametrize(
    ("mesh", "genus", "components"),
    [
        (box(), 0, 1),
        (moved(sphere(7.0), (100, 3, 4), seed=2), 0, 1),
        (torus(), 1, 1),
        (joined(torus(), moved(torus(), (20, 0, 0)), moved(box(), (0, 0, 9))), 2, 3),
    ],
    ids=["box", "sphere", "torus", "three"],
)
def test_sound_bodies(mesh: TriangleMesh, genus: int, components: int) -> None:
    checks = check_mesh(mesh)
    assert checks.sound
    assert checks.closed
    assert checks.manifold
    assert checks.outward
    assert (checks.genus, checks.components) == (genus, components)
    assert (checks.boundary_edges, checks.degenerate, checks.self_intersections) == (0, 0, 0)


def test_a_missing_triangle_opens_the_body() -> None:
    mesh = sphere()
    checks = check_mesh(TriangleMesh(mesh.vertices, mesh.triangles[1:]))
    assert not checks.closed
    assert checks.manifold
    assert checks.outward
    assert (checks.boundary_edges, checks.genus) == (3, 0)


def test_a_handle_with_a_hole_keeps_its_genus() -> None:
    mesh = torus()
    assert check_mesh(TriangleMesh(mesh.vertices, np.delete(mesh.triangles, [0, 100], axis=0))).genus == 1


def test_inside_out_and_one_turned_triangle() -> None:
    mesh = sphere()
    assert not check_mesh(TriangleMesh(mesh.vertices, mesh.triangles[:, ::-1])).outward
    turned = mesh.triangles.copy()
    turned[5] = turned[5, ::-1]
    checks = check_mesh(TriangleMesh(mesh.vertices, turned))
    assert not checks.outward
    assert checks.closed
    assert checks.manifold


def test_one_body_of_two_inside_out() -> None:
    other = moved(sphere(), (5, 0, 0))
    mesh = joined(sphere(3.0), TriangleMesh(other.vertices, other.triangles[:, ::-1]))
    assert not check_mesh(mesh).outward


def test_three_triangles_at_an_edge() -> None:
    mesh = TriangleMesh(np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0.0]]), np.array([[0, 1, 2], [0, 1, 3], [1, 0, 4]]))
    checks = check_mesh(mesh)
    assert not checks.manifold
    assert not checks.closed
    assert checks.genus is None
    assert checks.nonmanifold_edges == 1


def test_two_boxes_that_share_a_vertex() -> None:
    mesh = joined(box(), box(1.0, (1, 1, 1)))
    triangles = np.where(mesh.triangles == 8, 7, mesh.triangles)
    checks = check_mesh(TriangleMesh(mesh.vertices, triangles))
    assert checks.closed
    assert not checks.manifold
    assert (checks.nonmanifold_vertices, checks.components) == (1, 2)


def test_triangles_without_area_are_counted() -> None:
    mesh = TriangleMesh(np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0.0]]), np.array([[0, 1, 2], [0, 2, 3], [3, 3, 3]]))
    assert check_mesh(mesh).degenerate == 2


def test_no_triangles_deserve_nothing() -> None:
    checks = check_mesh(TriangleMesh(np.zeros((3, 3)), np.empty((0, 3), np.int64)))
    assert not checks.sound
    assert checks.components == 0


def test_crossing_bodies_intersect() -> None:
    checks = check_mesh(joined(sphere(2.0), moved(sphere(2.0), (1.234, 0.3, 0.1), seed=1)))
    assert checks.closed
    assert checks.self_intersections > 0
    assert not checks.sound


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1), st.integers(4, 9), st.integers(1, 14))
def test_random_triangles_agree_with_a_slow_count(seed: int, vertex_count: int, triangle_count: int) -> None:
    rng = np.random.default_rng(seed)
    triangles = np.array([rng.choice(vertex_count, 3, replace=False) for _ in range(triangle_count)])
    checks = check_mesh(TriangleMesh(rng.normal(size=(vertex_count, 3)), triangles))
    faces_of_edge: dict[frozenset[int], list[int]] = defaultdict(list)
    directions: dict[tuple[int, int], int] = defaultdict(int)
    for face, (a, b, c) in enumerate(triangles.tolist()):
        for edge in ((a, b), (b, c), (c, a)):
            faces_of_edge[frozenset(edge)].append(face)
            directions[edge] += 1
    uses = [len(faces) for faces in faces_of_edge.values()]
    assert checks.closed == all(n == 2 for n in uses)
    assert checks.boundary_edges == uses.count(1)
    assert checks.nonmanifold_edges == sum(n > 2 for n in uses)
    assert checks.components == _groups(range(triangle_count), list(faces_of_edge.values()))
    fans = 0
    for vertex in {int(v) for v in triangles.ravel()}:
        round_it = [face for face in range(triangle_count) if vertex in triangles[face]]
        fans += _groups(round_it, [faces for edge, faces in faces_of_edge.items() if vertex in edge]) > 1
    assert checks.nonmanifold_vertices == fans
    assert checks.manifold == (fans == 0 and all(n <= 2 for n in uses))
    if not all(n <= 2 for n in uses) or any(n > 1 for n in directions.values()):
        assert not checks.outward


def _groups(nodes: range | list[int], links: list[list[int]]) -> int:
    """Number of groups after joining the nodes of every link."""
    label = {node: node for node in nodes}
    for link in links:
        for node in link[1:]:
            old, new = label[node], label[link[0]]
            label = {key: new if value == old else value for key, value in label.items()}
    return len(set(label.values()))


def test_a_known_number_of_intersections_is_not_counted_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("scanner_core.geometry.checks.self_intersecting_triangles", lambda mesh: pytest.fail("searched again"))
    assert check_mesh(sphere(), self_intersections=0).sound
    assert not check_mesh(sphere(), self_intersections=2).sound
