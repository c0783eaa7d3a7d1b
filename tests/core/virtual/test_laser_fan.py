"""The line laser of the virtual rig: where its light falls, who sees it, and how bright it is."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.virtual.laser_fan import FanScene, LaserFan, LitPoints
from scanner_core.virtual.line_image import LineShutter
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.specimens.specimen import Specimen
from scanner_core.virtual.surface_noise import SpatialNoise

PRESET = PRESETS["bench"].without("speckle", "warm_up")
RADIUS_MM = 11.0


@cache
def ball() -> Specimen:
    middle, sphere = np.array([0.0, 0.0, RADIUS_MM]), icosahedron([0.0, 0.0, RADIUS_MM], RADIUS_MM)
    for _ in range(4):
        sphere = subdivide_uniform(sphere)
        outward = sphere.vertices - middle
        sphere = TriangleMesh(middle + RADIUS_MM * outward / np.linalg.norm(outward, axis=1, keepdims=True), sphere.triangles)
    return Specimen("ball", sphere)


class Sweep:
    """A fan that stands, or pans with so many degrees a second."""

    def __init__(self, speed_deg_s: float = 0.0, power: float = 1.0) -> None:
        self._speed, self._power = speed_deg_s, power

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(self._speed * time_s, 0.0, 25.0, self._power)


def lit(*terms: str) -> LitPoints:
    found = FanScene(PRESET.without(*terms), LaserFan(), ball(), 1).light([Sweep().instant(0.0)])
    assert found is not None
    return found


def test_the_light_lies_on_ball_and_table_and_in_the_plane() -> None:
    found = lit("stray_light")
    on_ball = np.abs(np.linalg.norm(found.points - [0, 0, RADIUS_MM], axis=1) - RADIUS_MM) < 0.3
    assert (on_ball | (np.abs(found.points[:, 2]) < 1e-6)).all()
    assert on_ball.sum() > 500
    towards = PRESET.laser_target_mm - PRESET.laser_position_mm
    across = np.cross(towards, [0.0, 0.0, 1.0]) / np.linalg.norm(np.cross(towards, [0.0, 0.0, 1.0]))
    assert np.abs((found.points - PRESET.laser_position_mm) @ across).max() < 4.2 * PRESET.beam_sigma_mm


def test_a_camera_does_not_see_the_far_side_or_the_shadow_of_the_ball() -> None:
    found = lit("stray_light")
    for share, camera in zip(found.shares, PRESET.cameras, strict=True):
        seen = found.points[share > 0]
        towards = camera.centre_mm() - seen
        on_ball = seen[:, 2] > 1e-6
        outward = seen - [0, 0, RADIUS_MM]
        assert (np.einsum("ij,ij->i", outward, towards)[on_ball] > -1.0).all()
        # from the table the way to the camera must clear the ball
        start, way = seen[~on_ball], towards[~on_ball] / np.linalg.norm(towards[~on_ball], axis=1, keepdims=True)
        to_middle = np.array([0, 0, RADIUS_MM]) - start
        closest = np.linalg.norm(to_middle - np.einsum("ij,ij->i", to_middle, way)[:, None] * way, axis=1)
        assert (closest > RADIUS_MM - 0.2).all()


def test_a_mirrored_ball_lights_the_table_beside_the_plane() -> None:
    assert lit().stray.sum() > 0
    assert not lit("stray_light").stray.any()


def test_a_standing_line_on_a_wall_that_faces_the_camera_has_the_stated_peak() -> None:
    camera = PRESET.cameras[0]
    eye = camera.centre_mm()
    forward = camera.rotation[2]
    middle = eye + PRESET.distance_mm * forward
    right, down = camera.rotation[0], camera.rotation[1]
    corners = np.array([middle + 60 * (a * right + b * down) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    corners = corners @ np.array([[np.cos(a := np.radians(25.0)), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    wall = Specimen("wall", TriangleMesh(corners, np.array([[0, 1, 2], [0, 2, 3]])))
    scene = FanScene(PRESET.without("stray_light"), LaserFan(peak_dn=150.0), wall, 1)
    left, _ = LineShutter(PRESET).expose(scene, Sweep(), 0.0, PRESET.exposure_ms)
    # on the slanted wall a piece of the fan is longer, and farther from the laser, than one that faces it
    assert 60 < left.max() < 190


def test_light_is_proportional_to_power_and_exposure_and_a_moving_fan_smears_it() -> None:
    scene, shutter = FanScene(PRESET.without("stray_light"), LaserFan(2.0), ball(), 1), LineShutter(PRESET)
    full = shutter.expose(scene, Sweep(), 0.0, 12.0)[0]
    assert np.allclose(shutter.expose(scene, Sweep(power=0.5), 0.0, 12.0)[0], 0.5 * full, rtol=1e-4, atol=1e-4)
    assert np.allclose(shutter.expose(scene, Sweep(), 0.0, 6.0)[0], 0.5 * full, rtol=1e-4, atol=1e-4)
    smeared = shutter.expose(scene, Sweep(12.0), -0.006, 12.0)[0]
    assert smeared.max() < full.max()
    assert float(smeared.sum()) == pytest.approx(float(full.sum()), rel=0.05)
    assert not shutter.expose(scene, Sweep(power=0.0), 0.0, 12.0)[1].any()


def test_noise_of_many_places_is_that_of_each() -> None:
    noise = SpatialNoise(3, 2, 0.2)
    places = np.random.default_rng(0).uniform(-30, 30, (50, 3))
    assert noise.at_many(places) == pytest.approx(np.array([noise.at(*place) for place in places.tolist()]))
