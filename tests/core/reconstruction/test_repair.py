"""Repairs of single places: what they mend, and what they leave alone."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.self_intersection import self_intersecting_triangles
from scanner_core.geometry.subdivision import split_edges, subdivide_uniform
from scanner_core.jobs.progress import Cancelled
from scanner_core.reconstruction.repair import folded_triangles, improved, repaired, triangle_qualities, without_self_intersections


def ball(levels: int = 3) -> TriangleMesh:
    mesh = icosahedron((0, 0, 0), 1.0)
    for _ in range(levels):
        mesh = subdivide_uniform(mesh)
        mesh = TriangleMesh(mesh.vertices / np.linalg.norm(mesh.vertices, axis=1)[:, None], mesh.triangles)
    return mesh


def shaken(mesh: TriangleMesh, seed: int, along: float, out: float = 0.0) -> TriangleMesh:
    """Vertices moved at random within the surface and out of it, in mean edges."""
    rng = np.random.default_rng(seed)
    normals = mesh.vertex_normals()
    shift = along * rng.normal(size=normals.shape)
    shift -= np.einsum("ij,ij->i", shift, normals)[:, None] * normals
    shift += out * rng.normal(size=(len(normals), 1)) * normals
    edge = float(EdgeTable.of(mesh.triangles).lengths(mesh.vertices).mean())
    return TriangleMesh(mesh.vertices + edge * shift, mesh.triangles)


def worst(mesh: TriangleMesh) -> float:
    return float(triangle_qualities(mesh.vertices, mesh.triangles).min())


def assert_as_sound(before: TriangleMesh, after: TriangleMesh) -> None:
    assert after.vertices.shape == before.vertices.shape
    assert after.triangles.shape == before.triangles.shape
    checks = check_mesh(after)
    assert checks.sound
    assert checks.genus == check_mesh(before).genus
    assert len(folded_triangles(after)) <= len(folded_triangles(before))


def no_check() -> None:
    pass


def test_quality_of_known_triangles() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0.5, np.sqrt(0.75), 0], [0.5, 0, 0], [0, 1, 0]])
    quality = triangle_qualities(corners, np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]]))
    np.testing.assert_allclose(quality, [1, 0, np.sqrt(3) / 2], atol=1e-12)


def test_a_good_mesh_stays_as_it_is() -> None:
    mesh = ball()
    assert improved(mesh, 0.3, no_check) is mesh


@settings(max_examples=12, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.1, 0.22), st.sampled_from([0.0, 0.03]))
def test_bad_triangles_of_a_shaken_surface_are_mended_in_place(seed: int, along: float, out: float) -> None:
    mesh = shaken(ball(), seed, along, out)
    assume(check_mesh(mesh).sound)
    before = triangle_qualities(mesh.vertices, mesh.triangles)
    better = improved(mesh, 0.3, no_check)
    assert_as_sound(mesh, better)
    assert worst(better) >= min(0.3, before.min())
    assert np.sum(triangle_qualities(better.vertices, better.triangles) < 0.3) <= 0.1 * np.sum(before < 0.3)
    # only corners of bad triangles move, and the surface hardly
    moved = np.flatnonzero((better.vertices != mesh.vertices).any(axis=1))
    assert len(moved) <= 6 * np.sum(before < 0.3)
    assert ClosestPoint(mesh).distance(better.vertices).max() < 1e-9
    assert ClosestPoint(better).distance(mesh.vertices).max() < 0.02


@pytest.mark.parametrize("place", [0.03, 0.5])
def test_needles_and_caps_go_where_only_an_edge_was_split_badly(place: float) -> None:
    """A split near an end leaves needles; a new vertex pulled onto the middle of a far edge leaves caps."""
    mesh = ball(2)
    table = EdgeTable.of(mesh.triangles)
    marked = np.zeros(len(table.edges), bool)
    marked[[5, 100, 222]] = True
    a, b = (mesh.vertices[end] for end in table.edges[marked].T)
    split = split_edges(mesh, table, marked, a + place * (b - a))
    if place == 0.5:
        opposite = table.opposite(mesh.triangles)[marked][:, 0]
        c = mesh.vertices[opposite]
        split.vertices[-3:] += 0.47 * (0.5 * (a + c) - 0.5 * (a + b)) * 2
    assert worst(split) < 0.15
    better = improved(split, 0.3, no_check)
    assert_as_sound(split, better)
    assert worst(better) >= 0.3


def test_a_sharp_rim_keeps_its_corner() -> None:
    mesh = subdivide_uniform(subdivide_uniform(subdivide_uniform(cube())))
    rng = np.random.default_rng(2)
    inner = np.flatnonzero((np.abs(np.abs(mesh.vertices) - 1) < 1e-9).sum(axis=1) == 1)
    shift = 0.05 * rng.normal(size=(len(inner), 3))
    shift[np.abs(np.abs(mesh.vertices[inner]) - 1) < 1e-9] = 0
    vertices = mesh.vertices.copy()
    vertices[inner] += np.clip(shift, -0.06, 0.06)
    mesh = TriangleMesh(vertices, mesh.triangles)
    assert check_mesh(mesh).sound
    better = improved(mesh, 0.65, no_check)
    assert worst(better) > worst(mesh)
    assert_as_sound(mesh, better)
    assert better.volume() == pytest.approx(8.0, abs=5e-3)


def cube() -> TriangleMesh:
    corners = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return TriangleMesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def test_repaired_is_sound_and_says_so_and_leaves_the_rest_alone() -> None:
    mesh = ball()
    dent = np.linalg.norm(mesh.vertices - (0, 0, 1), axis=1) < 0.25
    vertices = mesh.vertices.copy()
    vertices[dent] += 0.15 * np.random.default_rng(0).normal(size=(int(dent.sum()), 3))
    crumpled = TriangleMesh(vertices, mesh.triangles)
    assert len(self_intersecting_triangles(crumpled)) > 0
    better, crossing = repaired(crumpled, 0.3, no_check)
    assert crossing == 0
    assert check_mesh(better).sound
    assert worst(better) >= 0.3
    far = np.linalg.norm(mesh.vertices - (0, 0, 1), axis=1) > 0.9
    np.testing.assert_array_equal(better.vertices[far], mesh.vertices[far])
    rest = far[mesh.triangles].all(axis=1)
    np.testing.assert_array_equal(better.triangles[rest], mesh.triangles[rest])


def test_what_cannot_be_mended_is_counted() -> None:
    one = ball(1)
    beside = one.vertices + np.array([0.9, 0.05, 0.02])
    two = TriangleMesh(np.concatenate([one.vertices, beside]), np.concatenate([one.triangles, one.triangles + len(beside)]))
    better, crossing = repaired(two, 0.3, no_check, rounds=1)
    assert crossing == len(self_intersecting_triangles(better))
    assert crossing > 0


def test_repairs_can_be_cancelled() -> None:
    def check() -> None:
        raise Cancelled

    mesh = shaken(ball(), 3, 0.3)
    for repair in (lambda: improved(mesh, 0.4, check), lambda: without_self_intersections(mesh, check)):
        with pytest.raises(Cancelled):
            repair()
