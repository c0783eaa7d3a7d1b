"""A view that lies beside the others is named with its cause, and nothing is claimed that the shape does not tell."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.jump import locate_jump
from scanner_core.acquisition.view_motion import view_motion
from scanner_core.acquisition.view_watch import ViewWatch
from scanner_core.geometry.local_surface import reference_surface
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]
VIEWS = 12
NOISE_MM = 0.03


def _view(view: int, shape: str, rng: np.random.Generator, points: int = 500) -> Array:
    """Points of a body's side that faces the cameras at a table position, object frame; the body stands beside the axis."""
    towards = -2 * np.pi * view / VIEWS
    azimuth = towards + rng.uniform(-1.1, 1.1, points)
    z = rng.uniform(-0.6, 0.95, points)
    across = np.sqrt(1 - z * z)
    normal = np.c_[across * np.cos(azimuth), across * np.sin(azimuth), z]
    if shape == "sphere":
        ball: Array = normal * (11.0 + rng.normal(0, NOISE_MM, (points, 1))) + np.array([0.0, 0.0, 15.0])
        return ball
    radius = 14 + 1.5 * np.cos(3 * azimuth) + 1.0 * np.sin(5 * azimuth) * across + 1.2 * z * np.cos(2 * azimuth)
    body: Array = normal * (radius + rng.normal(0, NOISE_MM, points))[:, None] * [1.0, 0.8, 1.1] + [6.0, 3.0, 18.0]
    return body


def _watched(shape: str, moved: RigidTransform | None = None, at: int = 5, *, with_camera: bool = False, seed: int = 1) -> ViewWatch:
    rng, watch = np.random.default_rng(seed), ViewWatch(10.0)
    for view in range(VIEWS):
        deg = 360.0 * view / VIEWS
        points = _view(view, shape, rng)
        if moved is not None and view >= at:
            turn = RigidTransform.about_z(deg)
            points = (turn.inverse() @ moved @ turn if with_camera else moved).apply(points)
        watch.add(points)
        watch.end_view(view, deg)
    return watch


@cache
def clean_watch(shape: str) -> ViewWatch:
    return _watched(shape)


@pytest.mark.parametrize("shape", ["sphere", "body"])
def test_clean_views_are_beside_nothing(shape: str) -> None:
    for seed in (1, 2):
        assert (clean_watch(shape) if seed == 1 else _watched(shape, seed=seed)).steps == []


@pytest.mark.parametrize("shape", ["sphere", "body"])
def test_a_camera_that_moved_is_told_by_a_later_view(shape: str) -> None:
    watch = _watched(shape, RigidTransform(np.eye(3), np.array([0.1, 0.03, -0.06])), with_camera=True)
    assert [(step.view, step.cause) for step in watch.steps] == [(5, "camera")]
    assert watch.steps[0].shift_mm == pytest.approx((0.1, 0.03, -0.06), abs=0.05)


def test_an_object_that_moved_is_told_from_a_camera() -> None:
    watch = _watched("body", RigidTransform(np.eye(3), np.array([0.1, 0.05, 0.0])))
    assert [(step.view, step.cause) for step in watch.steps] == [(5, "object")]


def test_a_table_that_slipped_is_named_with_its_turn() -> None:
    watch = _watched("body", RigidTransform.about_z(0.8))
    assert [(step.view, step.cause) for step in watch.steps] == [(5, "table")]
    assert watch.steps[0].turn_deg == pytest.approx(0.8, abs=0.1)


def test_the_turns_of_a_sphere_are_unknown() -> None:
    rng = np.random.default_rng(2)
    motion = view_motion(_view(0, "sphere", rng), reference_surface(np.concatenate([_view(v, "sphere", rng) for v in (0, 1, 11)])))
    assert motion is not None
    assert motion.directions.shape == (6, 3)
    assert motion.turn_about_z(0.0) is None


def test_motions_are_known_as_well_as_they_claim() -> None:
    rng = np.random.default_rng(3)
    surface = reference_surface(np.concatenate([_view(v, "body", rng, 800) for v in (0, 1, 11)]))
    ratios = []
    for _ in range(20):
        motion = view_motion(_view(0, "body", rng, 300), surface)
        assert motion is not None
        ratios += (motion.amounts_mm / motion.uncertainties_mm).tolist()
    assert 0.5 < float(np.std(ratios)) < 1.3


@pytest.mark.parametrize("turn_deg", [0.05, 0.2])
def test_the_closure_of_the_turn_tells_lost_steps(turn_deg: float) -> None:
    watch, rng = clean_watch("body"), np.random.default_rng(9)
    before = _view(0, "body", rng, 200)
    again = RigidTransform.about_z(turn_deg).apply(before) + rng.normal(0, 0.008, before.shape)
    closure = watch.close_turn(again, before)
    assert closure.judged
    assert closure.lost_steps
    assert closure.turn_deg == pytest.approx(turn_deg, abs=4 * closure.turn_uncertainty_deg)
    assert not watch.close_turn(before + rng.normal(0, 0.008, before.shape), before).lost_steps


def test_the_closure_of_a_sphere_is_not_judged() -> None:
    watch, rng = clean_watch("sphere"), np.random.default_rng(9)
    before = _view(0, "sphere", rng, 200)
    closure = watch.close_turn(before + rng.normal(0, 0.008, before.shape), before)
    assert not closure.judged
    assert not closure.lost_steps
    assert closure.closes


def test_a_camera_that_moved_is_no_lost_step() -> None:
    watch, rng = clean_watch("body"), np.random.default_rng(9)
    before = _view(0, "body", rng, 200)
    closure = watch.close_turn(before + np.array([0.1, 0.0, -0.06]), before)
    assert not closure.closes
    assert not closure.lost_steps


@pytest.mark.parametrize("at", [2, 7])
def test_the_view_after_the_jump_is_found(at: int) -> None:
    rng, jump = np.random.default_rng(4), RigidTransform.about_z(0.2)
    views = [jump.apply(_view(v, "body", rng)) if v >= at else _view(v, "body", rng) for v in range(VIEWS)]
    place = locate_jump(views, np.radians(0.2))
    assert place is not None
    assert place.earliest <= at <= place.latest
    assert abs(place.view - at) <= 1
