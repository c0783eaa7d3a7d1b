from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.reconstruction.discrete_surface import mean_edge
from scanner_core.reconstruction.resampling import coarsened, reduced, split_towards
from tests.core.reconstruction.shapes import sphere


def assert_ball(mesh: TriangleMesh) -> None:
    checks = check_mesh(mesh)
    assert checks.sound
    assert checks.genus == 0
    assert checks.components == 1


@pytest.mark.parametrize("triangles", [1282, 2000, 5118, 5120, 7777])
def test_splits_meet_a_number_exactly_and_carry_values(triangles: int) -> None:
    mesh = sphere(10.0, 3)  # 1,280 triangles
    z = mesh.vertices[:, 2]
    split, values = split_towards(mesh, np.ones(len(z)), np.column_stack([np.full(len(z), 7.0), z]), triangles, lambda: None)
    assert len(split.triangles) == triangles - triangles % 2
    assert_ball(split)
    assert values.shape == (len(split.vertices), 2)
    np.testing.assert_array_equal(values[:, 0], 7)
    np.testing.assert_allclose(values[:, 1], split.vertices[:, 2], atol=0.7)
    np.testing.assert_allclose(np.linalg.norm(split.vertices, axis=1), 10, atol=0.02)  # on the curved surface


def test_splits_go_where_short_edges_are_wanted() -> None:
    mesh = sphere(10.0, 3)
    sizes = np.where(mesh.vertices[:, 2] > 0, 0.5, 1.0)
    split, _ = split_towards(mesh, sizes, np.zeros((len(sizes), 0)), 3200, lambda: None)
    assert_ball(split)
    table = EdgeTable.of(split.triangles)
    lengths = table.lengths(split.vertices)
    height = split.vertices[table.edges, 2].mean(axis=1)
    assert lengths[height > 2].mean() < 0.6 * lengths[height < -2].mean()


def test_splits_stop_where_edges_are_short_enough() -> None:
    mesh = sphere(10.0, 3)
    split, _ = split_towards(mesh, np.ones(len(mesh.vertices)), np.zeros((len(mesh.vertices), 0)), 10**6, lambda: None, down_to=0.55)
    assert len(split.triangles) < 4.5 * len(mesh.triangles)
    assert_ball(split)


def test_coarsening_collapses_short_edges_only() -> None:
    mesh = sphere(10.0, 4)
    edge = mean_edge(mesh)
    unchanged, kept = coarsened(mesh, np.full(len(mesh.vertices), 1.1 * edge), lambda: None)
    np.testing.assert_array_equal(unchanged.triangles, mesh.triangles)
    np.testing.assert_array_equal(kept, np.arange(len(mesh.vertices)))
    upper = mesh.vertices[:, 2] > 0
    sizes = np.where(upper, 2.5 * edge, 0.5 * edge)
    coarse, kept = coarsened(mesh, sizes, lambda: None)
    assert_ball(coarse)
    assert len(coarse.triangles) < len(mesh.triangles)
    low = mesh.vertices[:, 2] < -0.5 * edge  # with a neighbour that wants long edges not even the others' are collapsed
    assert set(np.flatnonzero(low)) <= set(kept.tolist())


def test_vertices_that_are_left_continue_one_that_was_there() -> None:
    mesh = sphere(10.0, 4)
    coarse, kept = coarsened(mesh, np.full(len(mesh.vertices), 2.0 * mean_edge(mesh)), lambda: None)
    assert len(kept) == len(coarse.vertices) == len(np.unique(kept))
    assert float(np.linalg.norm(coarse.vertices - mesh.vertices[kept], axis=1).max()) < 2.0 * mean_edge(mesh)


@pytest.mark.parametrize("triangles", [400, 1001, 5118])
def test_reduction_meets_a_number(triangles: int) -> None:
    mesh = sphere(10.0, 4)
    fewer, kept = reduced(mesh, triangles, lambda: None)
    assert triangles - 2 < len(fewer.triangles) <= triangles
    assert len(kept) == len(fewer.vertices)
    assert_ball(fewer)
