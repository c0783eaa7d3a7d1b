"""The balls on the rim: rays against the sphere's own equation, shadows, and a scene without them as it was."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.marks_config import shipped_marks
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.rim_balls import RimBalls, true_centres_mm
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import Specimen
from tests.core.virtual.test_scene import aimed

Array = NDArray[np.float64]
BENCH = replace(PRESETS["bench"], specular=0.0)
MARKS = shipped_marks("bench")
CENTRES = true_centres_mm(MARKS)


def test_rays_meet_the_sphere_where_its_equation_says() -> None:
    balls, rng = RimBalls(MARKS), np.random.default_rng(1)
    for centre in CENTRES:
        for _ in range(20):
            start = centre + rng.normal(size=3) * 200
            towards = centre + rng.uniform(-4, 4, 3) - start
            towards /= np.linalg.norm(towards)
            hit = balls.first_hit(start.tolist(), towards.tolist(), 3000.0)
            roots = np.roots([1.0, 2 * towards @ (start - centre), (start - centre) @ (start - centre) - MARKS.ball_radius_mm**2])
            if np.iscomplex(roots).any():
                continue  # another ball may stand behind
            assert hit is not None
            point, normal = np.array(hit[0]), np.array(hit[1])
            np.testing.assert_allclose(point, start + roots.real.min() * towards, atol=1e-6)
            np.testing.assert_allclose(normal, (point - centre) / MARKS.ball_radius_mm, atol=1e-9)
            assert balls.meets(start.tolist(), centre.tolist())
            assert not balls.meets(start.tolist(), (start + 0.99 * roots.real.min() * towards).tolist())


def test_a_ball_that_was_knocked_off_is_not_met() -> None:
    start, towards = (CENTRES[1] + [0, 0, 100]).tolist(), [0.0, 0.0, -1.0]
    assert RimBalls(MARKS).first_hit(start, towards, 3000.0) is not None
    assert RimBalls(MARKS, without=1).first_hit(start, towards, 3000.0) is None


def test_the_beam_lights_a_ball_that_turns_with_the_table_and_both_cameras_see_it() -> None:
    scene = Scene(BENCH, None, balls=RimBalls(MARKS))
    for table_deg in (0.0, 50.0, 200.0):
        turn = np.radians(table_deg)
        back = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
        lit = scene.light(aimed(scene, back @ CENTRES[0], table_deg))
        assert lit is not None
        assert abs(np.linalg.norm(lit.centre - CENTRES[0]) - MARKS.ball_radius_mm) < 0.02
        assert lit.seen.all()


def test_a_ball_hides_what_lies_behind_it() -> None:
    place = CENTRES[0] * [1, 1, 0] + [-12, 0, 0]  # on the table, seen from the laser beyond the ball
    low = replace(BENCH, laser_position_mm=np.array([354.6, 95.0, 40.0]))
    ray: Array = place - low.laser_position_mm
    direction = (ray / np.linalg.norm(ray)).tolist()
    start = low.laser_position_mm.tolist()
    behind = Scene(low, None)._first_hit(start, direction)
    before = Scene(low, None, balls=RimBalls(MARKS))._first_hit(start, direction)
    assert behind is not None
    assert before is not None
    assert behind[0][2] == 0.0
    assert abs(np.linalg.norm(np.array(before[0]) - CENTRES[0]) - MARKS.ball_radius_mm) < 1e-9


def test_elsewhere_the_scene_is_as_without_them(ear_impression: Specimen) -> None:
    bare, marked = Scene(PRESETS["bench"], ear_impression), Scene(PRESETS["bench"], ear_impression, balls=RimBalls(MARKS))
    for x_deg in np.linspace(-1.0, 1.0, 9).tolist():
        instant = MotionInstant(x_deg, 0.5, 30.0, 1.0)
        a, b = bare.light(instant), marked.light(instant)
        assert a is not None
        assert b is not None
        np.testing.assert_array_equal(a.points, b.points)
        np.testing.assert_array_equal(a.seen, b.seen)
        np.testing.assert_array_equal(a.shares, b.shares)
