from __future__ import annotations

import numpy as np

from scanner_core.geometry.point_normals import NEIGHBOURS, point_normals
from scanner_core.geometry.view_directions import seen_from


def test_normals_of_a_sphere_point_outwards_along_its_radius() -> None:
    rng = np.random.default_rng(4)
    outwards = rng.normal(size=(4000, 3))
    outwards /= np.linalg.norm(outwards, axis=1)[:, None]
    normals = point_normals(11.0 * outwards + 3.0, outwards)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0)
    along = np.einsum("ij,ij->i", normals, outwards)
    assert np.median(along) > 0.995
    assert (along > 0).all()


def test_normals_follow_the_side_from_which_the_points_were_seen() -> None:
    rng = np.random.default_rng(5)
    plane = np.column_stack([rng.uniform(-5, 5, (500, 2)), np.zeros(500)])
    below = np.tile([0.0, 0.0, -1.0], (500, 1))
    assert np.allclose(point_normals(plane, below), below, atol=1e-9)


def test_too_few_points_keep_what_is_known() -> None:
    towards = np.tile([1.0, 0.0, 0.0], (NEIGHBOURS - 1, 1))
    assert (point_normals(np.zeros((NEIGHBOURS - 1, 3)), towards) == towards).all()


def test_a_view_is_seen_from_where_the_turned_table_has_the_cameras() -> None:
    towards = seen_from(np.array([0.0, 90.0]))
    assert np.allclose(np.linalg.norm(towards, axis=1), 1.0)
    assert towards[0, 0] > 0.8
    assert towards[1, 1] < -0.8
