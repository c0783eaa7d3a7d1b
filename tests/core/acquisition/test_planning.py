"""Plans: they cover what the locating pass found, one way, coarse to fine, with the wanted number of points."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.acquisition.plan import PlanRequest, Row, ScanPlan, ViewPlan, read_plan
from scanner_core.acquisition.planning import (
    COARSE_LEAST,
    COARSE_VIEWS,
    coarse_request,
    even_views,
    locating_plan,
    may_stand,
    nearest_turn,
    renumbered,
    scan_plan,
)
from scanner_core.devices.rig import load_preset
from scanner_core.errors import UsageError

RIG = load_preset("bench")
RATE_HZ = 60.0


def _ids(plan: ScanPlan) -> list[int]:
    return [i for view in plan.views for row in view.rows for i in range(row.first_id, row.first_id + row.count)]


def _hits(plan: ScanPlan, radius_mm: float, height_mm: float) -> np.ndarray:
    """Trigger ids of a plan whose beam meets an upright cylinder: solved in the plane for every ray."""
    position, target = np.array(RIG.laser.position_mm), np.array(RIG.laser.target_mm)
    toward = target - position
    azimuth0, elevation0 = np.arctan2(toward[1], toward[0]), np.arctan2(toward[2], np.hypot(toward[0], toward[1]))
    hits = []
    for view in plan.views:
        for row in view.rows:
            pan = np.radians(np.linspace(row.x_from_deg, row.x_to_deg, row.count)) + azimuth0
            tilt = np.radians(row.y_deg) + elevation0
            direction = np.c_[np.cos(tilt) * np.cos(pan), np.cos(tilt) * np.sin(pan), np.full(row.count, np.sin(tilt))]
            for i in range(row.count):
                along = np.linspace(300, 600, 1500)[:, None] * direction[i] + position
                inside = (np.hypot(along[:, 0], along[:, 1]) < radius_mm) & (along[:, 2] > 0) & (along[:, 2] < height_mm)
                if inside.any():
                    hits.append(row.first_id + i)
    return np.array(hits, np.int64)


def test_the_target_is_at_zero_and_left_is_up() -> None:
    target = np.array(RIG.laser.target_mm)
    points = target + np.array([[0, 0, 0], [0, 0, 20.0], [0, 20.0, 0]])
    angles = beam_angles(RIG.laser, points)
    assert np.allclose(angles[0], 0)
    assert angles[1, 1] > 1
    assert abs(angles[1, 0]) < 1e-9
    assert abs(angles[2, 0]) > 1


@settings(max_examples=8, deadline=None)
@given(radius=st.floats(5, 30), height=st.floats(5, 40), points=st.integers(500, 40000), views=st.integers(2, 9))
def test_a_plan_covers_the_object_with_the_wanted_points(radius: float, height: float, points: int, views: int) -> None:
    request = PlanRequest(views=views, points=points, object_radius_mm=radius * 1.5, object_height_mm=height * 1.2)
    located = locating_plan(RIG, request, RATE_HZ, first_id=10)
    assert _ids(located) == list(range(10, 10 + located.planned))
    hits = _hits(located, radius, height)
    plan = scan_plan(RIG, request, RATE_HZ, located, hits, first_id=5000)
    assert _ids(plan) == list(range(5000, 5000 + plan.planned))
    assert sum(view.quota or 0 for view in plan.views) == points
    assert plan.sweep_speed_deg_s <= RIG.limits.sweep_speed_deg_s + 1e-9
    if points <= 3000:
        reached = len(_hits(plan, radius, height))
        assert reached >= 0.93 * points
        assert plan.planned <= 3.5 * points + 2000


def test_rows_go_one_way_and_coarse_to_fine() -> None:
    request = PlanRequest(views=1, points=4000, object_radius_mm=12, object_height_mm=22)
    located = locating_plan(RIG, request, RATE_HZ)
    plan = scan_plan(RIG, request, RATE_HZ, located, _hits(located, 10, 20), located.planned)
    rows = plan.views[0].rows
    assert all(row.x_to_deg > row.x_from_deg for row in rows)
    y_deg = np.array([row.y_deg for row in rows])
    pitch = np.diff(np.sort(y_deg)).min()
    first = y_deg[: len(y_deg) // 8]
    assert np.allclose(np.diff(first), 8 * pitch)
    assert np.ptp(first) > 0.8 * np.ptp(y_deg)


@pytest.mark.parametrize(("views", "first"), [(1, COARSE_LEAST), (6, 6), (16, COARSE_VIEWS)])
def test_the_first_pass_takes_a_part_of_the_points(views: int, first: int) -> None:
    request = coarse_request(PlanRequest(views, 9000, until_um=40.0))
    assert request.views == first
    assert 0 < request.points < 9000


def test_what_is_left_is_spread_half_way_between_the_views_over_what_either_neighbour_found() -> None:
    request = PlanRequest(views=4, points=1000, object_radius_mm=20, object_height_mm=30)
    located = locating_plan(RIG, request, RATE_HZ)
    hits = _hits(located, 12.0, 20.0)
    ids_of_first = {i for row in located.views[0].rows for i in range(row.first_id, row.first_id + row.count)}
    hits = hits[~np.isin(hits, list(ids_of_first))]  # the first view has missed the object
    views = even_views(RIG, request, RATE_HZ, located, hits, 9, 5000)
    assert [view.table_deg for view in views] == [45.0, 135.0, 225.0, 315.0]
    assert [{row.view for row in view.rows} for view in views] == [{9}, {10}, {11}, {12}]
    assert sum(view.quota or 0 for view in views) == 1000
    ids = [i for view in views for row in view.rows for i in range(row.first_id, row.first_id + row.count)]
    assert ids == list(range(5000, 5000 + len(ids)))
    assert min(row.x_from_deg for row in views[0].rows) == pytest.approx(min(row.x_from_deg for row in views[1].rows), abs=0.3)


@given(st.floats(0, 360), st.floats(-700, 700), st.floats(-800, 800))
def test_the_table_takes_the_shortest_way_that_is_allowed(place: float, stands: float, low: float) -> None:
    free = nearest_turn(place, stands, lambda _: True)
    assert abs(free - stands) <= 180 + 1e-6
    assert (free - place) / 360 == pytest.approx(round((free - place) / 360), abs=1e-9)
    bounded = nearest_turn(place, stands, lambda to_deg: to_deg >= low)
    assert bounded in (place, free) or (bounded >= low and bounded > free)


def test_an_object_in_one_view_only_has_its_quota_there() -> None:
    request = PlanRequest(views=4, points=1000, object_radius_mm=12, object_height_mm=22)
    located = locating_plan(RIG, request, RATE_HZ)
    hits = _hits(located, 10, 20)
    last = located.views[2].rows[-1]
    only = hits[(hits >= located.views[1].rows[0].first_id) & (hits < located.views[2].rows[0].first_id)]
    plan = scan_plan(RIG, request, RATE_HZ, located, only, last.first_id + 10_000)
    assert [view.quota for view in plan.views] == [0, 1000, 0, 0]
    assert [len(view.rows) > 0 for view in plan.views] == [False, True, False, False]


def test_without_a_size_the_whole_volume_is_searched() -> None:
    whole = locating_plan(RIG, PlanRequest(views=1, points=5000), RATE_HZ)
    small = locating_plan(RIG, PlanRequest(views=1, points=5000, object_radius_mm=10, object_height_mm=20), RATE_HZ)
    span = [max(row.y_deg for row in plan.views[0].rows) - min(row.y_deg for row in plan.views[0].rows) for plan in (whole, small)]
    assert span[0] > 3 * span[1]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("views = 'a'", "no number"),
        ("speed = 3", "unknown key"),
        ("views = 0", "make no plan"),
        ("points = 1.5", "whole"),
        ("views = [", "E-PLAN-01"),
    ],
)
def test_a_wrong_plan_file_is_named(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(text)
    with pytest.raises(UsageError, match=reason):
        read_plan(path)


def test_a_plan_file(tmp_path: Path) -> None:
    path = tmp_path / "plan.toml"
    path.write_text("views = 6\npoints = 3500\nobject_radius_mm = 12\n")
    assert read_plan(path) == replace(PlanRequest(), views=6, points=3500, object_radius_mm=12)


@pytest.mark.parametrize(
    ("limits", "places"),
    [(None, [0.0, 90.0, 200.0, 350.0]), ((-100.0, 100.0), [0.0, 90.0, 350.0]), ((0.0, 349.0), [0.0, 90.0, 200.0]), ((360.0, 450.0), [0.0, 90.0])],
)
def test_where_a_table_can_stand(limits: tuple[float, float] | None, places: list[float]) -> None:
    rig = RIG.limits
    assert [angle for angle in (0.0, 90.0, 200.0, 350.0) if may_stand(replace(rig, table_deg=limits), angle)] == places


def test_views_that_are_left_count_on() -> None:
    views = [ViewPlan(10.0 * k, (Row(k, 5 * k, 5, 0.0, -1.0, 1.0),)) for k in (3, 5)]
    assert [(view.table_deg, view.rows[0].view, view.rows[0].first_id) for view in renumbered(views, 7)] == [(30.0, 7, 15), (50.0, 8, 25)]
