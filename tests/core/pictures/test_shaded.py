"""Small pictures of surfaces: where the surface is, how it is lit, and what is pointed out."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.pictures.shaded import MARKED, PLASTER, looking, shaded_picture

CORNERS = np.array([[x, y, z] for x in (0.0, 40.0) for y in (0.0, 20.0) for z in (0.0, 10.0)])
BOX = TriangleMesh(
    CORNERS,
    np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]),
)


@pytest.mark.parametrize(("towards", "ratio"), [((0, 0, 1), 2.0), ((0, -3, 0), 4.0), ((0.1, 0, 0), 2.0)])
def test_the_surface_fills_the_picture_and_the_ground_is_transparent(towards: tuple[float, ...], ratio: float) -> None:
    picture = shaded_picture(BOX, np.array(towards, np.float64), 160, 120)
    assert picture.shape == (120, 160, 4)
    assert picture.dtype == np.uint8
    rows, columns = np.nonzero(picture[..., 3] > 127)
    width, height = np.ptp(columns) + 1, np.ptp(rows) + 1
    assert width / height == pytest.approx(ratio, rel=0.05)
    assert max(width / 160, height / 120) == pytest.approx(0.88, abs=0.02)
    assert abs(columns.mean() - 79.5) < 1
    assert abs(rows.mean() - 59.5) < 1
    assert (picture[0] == 0).all()


def test_up_in_the_picture_is_up() -> None:
    tip = TriangleMesh(np.array([[-5.0, 0, 0], [5, 0, 0], [0, 0, 20]]), np.array([[0, 1, 2]]))
    picture = shaded_picture(tip, np.array([0.0, -1, 0]), 60, 60)
    widths = (picture[..., 3] > 127).sum(axis=1)
    assert 0 < widths[10] < widths[50]


def test_colours_and_marked_vertices() -> None:
    towards = np.array([0.0, 0, 1])
    plain = shaded_picture(BOX, towards, 80, 60)[30, 40, :3].astype(float)
    assert plain / plain.max() == pytest.approx(np.array(PLASTER) / max(PLASTER), abs=0.02)
    blue = shaded_picture(BOX, towards, 80, 60, np.tile(np.array([0, 0, 255], np.uint8), (8, 1)))[30, 40]
    assert blue[0] == blue[1] == 0
    assert blue[2] > 100
    marked = shaded_picture(BOX, towards, 80, 60, marked=np.arange(4, 8))  # one end
    right, left = marked[30, 68, :3].astype(float), marked[30, 12, :3].astype(float)
    assert right / right.max() == pytest.approx(np.array(MARKED) / max(MARKED), abs=0.02)
    assert left / left.max() == pytest.approx(np.array(PLASTER) / max(PLASTER), abs=0.02)


def test_nothing_to_show() -> None:
    nothing = TriangleMesh(np.array([[1.0, 2, 3]]), np.empty((0, 3), np.int64))
    assert not shaded_picture(nothing, np.array([0.0, 0, 1]), 16, 12).any()


def test_the_axes_of_a_look_are_a_right_handed_frame() -> None:
    for towards in np.random.default_rng(1).normal(size=(20, 3)):
        axes = looking(towards)
        assert np.allclose(axes @ axes.T, np.eye(3))
        assert np.linalg.det(axes) == pytest.approx(1)
        assert axes[1, 2] >= 0
