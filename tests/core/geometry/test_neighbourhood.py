from __future__ import annotations

import numpy as np

from scanner_core.geometry.neighbourhood import NEIGHBOURS, Neighbourhood
from scanner_core.geometry.normal_grid import NormalGrid
from scanner_core.geometry.view_directions import seen_from


def test_normals_of_a_sphere_point_outwards_along_its_radius() -> None:
    rng = np.random.default_rng(4)
    outwards = rng.normal(size=(4000, 3))
    outwards /= np.linalg.norm(outwards, axis=1)[:, None]
    normals = Neighbourhood(11.0 * outwards + 3.0).normals(outwards)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0)
    along = np.einsum("ij,ij->i", normals, outwards)
    assert np.median(along) > 0.995
    assert (along > 0).all()


def test_normals_follow_the_side_from_which_the_points_were_seen() -> None:
    rng = np.random.default_rng(5)
    plane = np.column_stack([rng.uniform(-5, 5, (500, 2)), np.zeros(500)])
    below = np.tile([0.0, 0.0, -1.0], (500, 1))
    assert np.allclose(Neighbourhood(plane).normals(below), below, atol=1e-9)


def test_too_few_points_keep_what_is_known() -> None:
    towards = np.tile([1.0, 0.0, 0.0], (NEIGHBOURS - 1, 1))
    assert (Neighbourhood(np.zeros((NEIGHBOURS - 1, 3))).normals(towards) == towards).all()


def test_a_view_is_seen_from_where_the_turned_table_has_the_cameras() -> None:
    towards = seen_from(np.array([0.0, 90.0]))
    assert np.allclose(np.linalg.norm(towards, axis=1), 1.0)
    assert towards[0, 0] > 0.8
    assert towards[1, 1] < -0.8


def test_density_is_what_lies_on_a_square_millimetre() -> None:
    rng = np.random.default_rng(6)
    plane = np.column_stack([rng.uniform(-10, 10, (8000, 2)), np.zeros(8000)])  # 20 points / mm2
    inside = (np.abs(plane[:, :2]) < 9).all(axis=1)
    density = Neighbourhood(plane).density_per_mm2()
    assert np.isclose(density[inside].mean(), 20.0, rtol=0.03)
    few = Neighbourhood(plane[: NEIGHBOURS - 1]).density_per_mm2()
    assert np.isnan(few).all()


def test_new_points_take_the_normals_of_their_cell_and_else_the_direction_they_were_seen_from() -> None:
    rng = np.random.default_rng(7)
    outwards = rng.normal(size=(60_000, 3))
    outwards /= np.linalg.norm(outwards, axis=1)[:, None]
    grid = NormalGrid(10 * outwards[10_000:], outwards[10_000:], 1.0)
    towards = np.tile([0.0, 0.0, 1.0], (10_000, 1))
    found = grid.at(10 * outwards[:10_000], towards)
    upper = outwards[:10_000, 2] > 0.2
    along = np.einsum("ij,ij->i", found, outwards[:10_000])[upper]
    assert np.quantile(along, 0.01) > 0.97  # a corner of a cell may have been empty
    assert (grid.at(30 * outwards[:100], towards[:100]) == towards[:100]).all()  # nothing is there
    assert (found[outwards[:10_000, 2] < -0.2] == [0.0, 0.0, 1.0]).all()  # never away from the cameras
