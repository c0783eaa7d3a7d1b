"""Pairs become observations with a verdict, and points when they pass the gates."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.acquisition.engine import StereoEngine, StereoPair
from scanner_core.case.observation import MEASURED
from scanner_core.devices.rig import VolumeConfig
from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from tests.core.optics.rigs import known_rig

RIG = known_rig()
ENGINE = StereoEngine(RIG, VolumeConfig(radius_mm=50.0, height_mm=60.0), 0.0)
SEEN = Spot(301.0, 146.0, 1.0, 0.8, 200.0, 1500.0, 20, 0.02)
DARK = SpotMiss(MissReason.NO_SPOT)
LARGE = SpotMiss(MissReason.TOO_LARGE, 255.0)


def _spot(pixel: np.ndarray) -> Spot:
    return Spot(float(pixel[0]), float(pixel[1]), 1.0, 0.8, 200.0, 1500.0, 20, 0.02)


def _pair(trigger_id: int, in_object: np.ndarray, table_deg: float, shift_px: float = 0.0) -> StereoPair:
    in_rig = RIG.rig_to_object(table_deg).inverse().apply(in_object)[None]
    left, right = RIG.left.project(in_rig)[0], RIG.right.project(in_rig)[0]
    return StereoPair(trigger_id, 0.1 * trigger_id, _spot(left), _spot(right + np.array([0.0, shift_px])))


def test_points_come_out_in_the_object_frame() -> None:
    wanted = np.random.default_rng(3).uniform([-20, -20, 5], [20, 20, 40], (20, 3))
    seen = ENGINE.evaluate([_pair(i, p, 30.0) for i, p in enumerate(wanted)], 2, 30.0)
    observations, points = seen.observations, seen.points
    assert np.abs(seen.residual_px).max() < 1e-6
    assert seen.expected_px == pytest.approx(0.02, rel=0.15)
    assert [seen.verdict for seen in observations] == [MEASURED] * 20
    assert np.abs(points - wanted).max() < 1e-5
    assert {seen.view for seen in observations} == {2}
    assert observations[7].time_s == pytest.approx(0.7)


@pytest.mark.parametrize(
    ("left", "right", "verdict"),
    [
        (DARK, DARK, "no_spot"),
        (DARK, None, "dropped_frame"),
        (None, None, "dropped_frame"),
        (DARK, SEEN, "hidden_left"),
        (SEEN, DARK, "hidden_right"),
        (LARGE, SEEN, "too_large"),
        (DARK, LARGE, "too_large"),
        (LARGE, DARK, "too_large"),
    ],
)
def test_a_miss_has_its_reason(left: Spot | SpotMiss | None, right: Spot | SpotMiss | None, verdict: str) -> None:
    seen = ENGINE.evaluate([StereoPair(0, 0.0, left, right)], 0, 0.0)
    assert seen.observations[0].verdict == verdict
    assert seen.points.shape == (0, 3)
    assert np.isnan(seen.residual_px).all()


@pytest.mark.parametrize(
    ("place", "shift_px", "verdict"),
    [((0, 0, 10), 3.0, "epipolar"), ((55, 0, 10), 0.0, "outside_volume"), ((0, 0, 70), 0.0, "outside_volume"), ((5, 5, 0.05), 0.0, "table")],
)
def test_a_gate_has_its_reason(place: tuple[float, ...], shift_px: float, verdict: str) -> None:
    pairs = [_pair(0, np.array(place), 0.0, shift_px), _pair(1, np.array([1.0, 2.0, 10.0]), 0.0)]
    seen = ENGINE.evaluate(pairs, 0, 0.0)
    assert [observation.verdict for observation in seen.observations] == [verdict, MEASURED]
    assert len(seen.points) == 1
    assert seen.observations[0].left is not None
    assert np.isfinite(seen.residual_px).all()


def _several(*spots: Spot | SpotMiss | None) -> SpotMiss:
    return SpotMiss(MissReason.AMBIGUOUS, 200.0, tuple(spot for spot in spots if isinstance(spot, Spot)))


def test_a_reflection_is_told_from_the_spot_by_the_other_camera() -> None:
    true, stray = np.array([3.0, 4.0, 20.0]), np.array([-12.0, 6.0, 31.0])
    a, b = _pair(0, true, 0.0), _pair(0, stray, 0.0)
    pairs = [StereoPair(0, 0.0, _several(b.left, a.left), a.right), StereoPair(1, 0.1, a.left, _several(b.right, a.right)), _pair(2, true, 0.0)]
    seen = ENGINE.evaluate(pairs, 0, 0.0)
    assert [observation.verdict for observation in seen.observations] == [MEASURED] * 3
    assert np.abs(seen.points - true).max() < 1e-5
    assert seen.observations[0].left == a.left
    assert seen.observations[1].right == a.right


def test_what_both_cameras_see_twice_is_not_guessed() -> None:
    a, b = _pair(0, np.array([3.0, 4.0, 20.0]), 0.0), _pair(0, np.array([-12.0, 6.0, 31.0]), 0.0)
    pairs = [
        StereoPair(0, 0.0, _several(a.left, b.left), _several(b.right, a.right)),
        StereoPair(1, 0.0, _several(a.left, b.left), DARK),
        StereoPair(2, 0.0, _several(a.left, b.left), None),
        _pair(3, np.array([1.0, 2.0, 10.0]), 0.0),
    ]
    seen = ENGINE.evaluate(pairs, 0, 0.0)
    assert [observation.verdict for observation in seen.observations] == ["ambiguous", "ambiguous", "dropped_frame", MEASURED]
    assert len(seen.points) == 1
    assert seen.observations[0].left is None


def test_candidates_that_fit_no_spot_of_the_other_camera_are_refused() -> None:
    a, b, c = (_pair(0, np.array(place), 0.0) for place in ((3.0, 4.0, 20.0), (-12.0, 6.0, 31.0), (8.0, -9.0, 45.0)))
    seen = ENGINE.evaluate([StereoPair(0, 0.0, _several(a.left, b.left), c.right)], 0, 0.0)
    assert [observation.verdict for observation in seen.observations] == ["ambiguous"]
