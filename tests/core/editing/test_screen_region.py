"""Selections on the screen, against counting point by point."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from scanner_core.editing.screen_region import BrushStroke, Outline, crossings, nearest_in_front, selected
from scanner_core.editing.sight import Sight

SIZE = (640.0, 480.0)


def _sight(towards: NDArray[np.float64], distance: float = 60.0) -> Sight:
    """A perspective camera that looks at the origin from a direction (3,)."""
    back = towards / np.linalg.norm(towards)
    right = np.cross([0.0, 0.0, 1.0], back)
    right /= np.linalg.norm(right)
    turn = np.stack([right, np.cross(back, right), back])
    view = np.eye(4)
    view[:3, :3], view[:3, 3] = turn, [0.0, 0.0, -distance]
    f = 1 / np.tan(np.radians(15.0))
    projection = np.array([[f * SIZE[1] / SIZE[0], 0, 0, 0], [0, f, 0, 0], [0, 0, -1.2, -10.0], [0, 0, -1, 0]])
    return Sight(projection @ view, *SIZE, -back)


def _ball(count: int, radius: float = 10.0) -> NDArray[np.float64]:
    directions = np.random.default_rng(5).normal(size=(count, 3))
    return np.asarray(radius * directions / np.linalg.norm(directions, axis=1)[:, None])


def test_places_are_those_of_the_pinhole() -> None:
    sight = _sight(np.array([1.0, 0.0, 0.0]))
    points = np.array([(0.0, 0.0, 0.0), (0.0, 0.0, 10.0), (0.0, 10.0, 0.0), (70.0, 0.0, 0.0)])
    px = 240 / np.tan(np.radians(15.0)) / 60.0  # of a millimetre at the origin
    assert sight.places(points[:3]) == pytest.approx(np.array([(320, 240), (320, 240 - 10 * px), (320 + 10 * px, 240)]))
    assert np.isnan(sight.places(points[3:])).all()
    assert sight.mm_per_px(points[:1]) == pytest.approx(1 / px)


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(st.floats(0, 100), st.floats(0, 100)), min_size=3, max_size=12), st.integers(0, 1000))
def test_an_outline_holds_what_an_odd_number_of_its_edges_lies_beside(corners: list[tuple[float, float]], seed: int) -> None:
    outline = Outline(np.array(corners))
    places = np.random.default_rng(seed).uniform(-5, 105, (400, 2))
    places[::3] = np.rint(places[::3])
    assert outline.holds(places).tolist() == (crossings(outline.corners, places) % 2 == 1).tolist()


def test_a_box_and_a_line_of_two_points() -> None:
    places = np.array([(5.0, 5.0), (15.0, 5.0), (5.0, 15.0)])
    assert Outline.box(np.array([10.0, 10.0]), np.array([0.0, 0.0])).holds(places).tolist() == [True, False, False]
    assert not Outline(places[:2]).holds(places).any()


def test_a_brush_covers_what_lies_near_its_path() -> None:
    rng = np.random.default_rng(2)
    path, places = rng.uniform(0, 200, (6, 2)), rng.uniform(0, 200, (500, 2))
    share = np.linspace(0, 1, 1501)[:, None]
    fine = np.concatenate([a + share * (b - a) for a, b in pairwise(path)])
    away = np.array([np.linalg.norm(fine - place, axis=1).min() for place in places])
    clear = np.abs(away - 15.0) > 0.1
    assert np.array_equal(BrushStroke(path, 15.0).holds(places)[clear], (away <= 15.0)[clear])
    assert BrushStroke(path[:1], 15.0).holds(path[:1] + 10.0).tolist() == [True]
    assert not BrushStroke(path[:0], 15.0).holds(places).any()


@pytest.mark.parametrize("count", [2_000, 40_000])
def test_the_front_of_a_ball_is_the_half_that_faces_the_eye(count: int) -> None:
    points = _ball(count)
    sight = _sight(np.array([1.0, 0.3, 0.2]))
    eye = -60.0 * sight.direction
    facing = ((eye - points) * points).sum(axis=1) / np.linalg.norm(eye - points, axis=1) / 10.0
    front = sight.in_front(points)
    assert front[facing > 0.3].mean() > 0.995
    assert front[facing < -0.5].mean() < 0.005  # where chance has left a cell without a point of the front


def test_through_takes_both_sides_and_front_most_one() -> None:
    points = _ball(5_000)
    sight = _sight(np.array([1.0, 0.0, 0.0]))
    middle = Outline.box(np.array([280.0, 200.0]), np.array([360.0, 280.0]))
    through, front = (selected(points, sight, middle, through=through) for through in (True, False))
    assert (points[front, 0] > 8.0).all()
    assert np.array_equal(front, through & (points[:, 0] > 0.0))
    assert (through & (points[:, 0] < 0.0)).sum() > 100
    assert not selected(points, sight, Outline.box(np.array([0.0, 0.0]), np.array([9.0, 9.0])), through=False).any()


def test_a_click_means_the_nearest_point_in_front() -> None:
    points = _ball(5_000)
    sight = _sight(np.array([1.0, 0.0, 0.0]))
    number = nearest_in_front(points, sight, np.array([320.0, 240.0]), 12.0)
    assert number is not None
    assert points[number, 0] > 9.9
    assert nearest_in_front(points, sight, np.array([5.0, 5.0]), 12.0) is None
