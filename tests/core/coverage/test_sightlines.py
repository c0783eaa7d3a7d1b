"""What beam and cameras reach of simple bodies, against formulas."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.coverage.sightlines import LIFT_MM, Sightlines, pixel_noise_px
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import NoiseModel
from tests.core.coverage.bodies import box
from tests.core.reconstruction.shapes import ridged, sphere

RIG = load_preset("bench")
assert RIG.calibration is not None
CALIBRATION: StereoCalibration = RIG.calibration
LEAST_COSINE = 0.0759
"""1.5 times the least peak of 10 DN over 0.775 of 255 DN."""


def eyes(table_deg: float) -> np.ndarray:
    """Pivot and cameras in the object frame, (3, 3) mm."""
    in_table = [RIG.laser.position_mm, *(CALIBRATION.rig_to_table().apply(camera.centre_mm()) for camera in (CALIBRATION.left, CALIBRATION.right))]
    return RigidTransform.about_z(-table_deg).apply(np.array(in_table))


def raised(mesh: TriangleMesh, height_mm: float) -> TriangleMesh:
    return TriangleMesh(mesh.vertices + np.array([0.0, 0.0, height_mm]), mesh.triangles)


@pytest.mark.parametrize("table_deg", [0.0, 70.0])
def test_a_ball_is_seen_where_it_faces_all_three(table_deg: float) -> None:
    ball = raised(sphere(10.0, 4), 30.0)
    sight = Sightlines(RIG, CALIBRATION, ball).at(table_deg)
    outward = (ball.vertices - [0, 0, 30.0]) / 10.0
    towards = eyes(table_deg)[:, None] - ball.vertices
    cosines = ((towards * outward).sum(axis=2) / np.linalg.norm(towards, axis=2)).T
    np.testing.assert_allclose(sight.cosines, cosines, atol=8e-3)  # normals of a mesh
    clear = np.abs(cosines - LEAST_COSINE).min(axis=1) > 8e-3
    expected = (cosines > LEAST_COSINE).all(axis=1)
    assert 0.1 < expected.mean() < 0.4
    assert (sight.measurable == expected)[clear].all()
    assert not sight.measurable[outward[:, 2] < -0.8].any()


def test_behind_a_wall_the_beam_is_shadowed_as_far_as_its_slope_says() -> None:
    """A wall across the x axis between the table's middle and the laser."""
    floor, wall = box((-40, -30, 1), (10, 30, 2)), box((10, -30, 1), (12, 30, 22))
    scene = TriangleMesh(np.concatenate([floor.vertices, wall.vertices]), np.concatenate([floor.triangles, wall.triangles + len(floor.vertices)]))
    x = np.linspace(-38, 9, 200)
    places = np.c_[x, np.zeros(200), np.full(200, 2.0)]
    sight = Sightlines(RIG, CALIBRATION, scene, places, np.tile([0.0, 0.0, 1.0], (200, 1))).at(0.0)
    pivot = np.array(RIG.laser.position_mm)
    over_wall = places[:, 2] + LIFT_MM + (pivot[2] - places[:, 2] - LIFT_MM) * (12 - x) / (pivot[0] - x)  # the far edge is nearer to the light
    near_edge = places[:, 2] + LIFT_MM + (pivot[2] - places[:, 2] - LIFT_MM) * (10 - x) / (pivot[0] - x)
    free = (over_wall > 22) & (near_edge > 22)
    assert 20 < free.sum() < 180
    assert (sight.beam_free == free).all()
    assert not sight.measurable[~free].any()
    behind = Sightlines(RIG, CALIBRATION, scene, places, np.tile([0.0, 0.0, 1.0], (200, 1))).at(180.0)
    assert behind.beam_free.all()


@settings(max_examples=6, deadline=None)
@given(st.floats(-180, 180), st.floats(0, 360))
def test_turning_surface_and_table_against_each_other_changes_nothing(turn_deg: float, table_deg: float) -> None:
    body = raised(ridged(3), 20.0)
    turned = TriangleMesh(RigidTransform.about_z(turn_deg).apply(body.vertices), body.triangles)
    here, there = Sightlines(RIG, CALIBRATION, body).at(table_deg), Sightlines(RIG, CALIBRATION, turned).at(table_deg - turn_deg)
    np.testing.assert_allclose(here.cosines, there.cosines, atol=1e-9)
    np.testing.assert_allclose(here.beam_deg, there.beam_deg, atol=1e-9)
    clear = np.abs(here.cosines - LEAST_COSINE).min(axis=1) > 1e-6
    differ = (here.measurable != there.measurable) & clear
    assert differ.sum() <= 1  # a ray that touches an edge may round either way
    both = here.measurable & there.measurable
    np.testing.assert_allclose(here.point_sd_um[both], there.point_sd_um[both], rtol=1e-6)


def test_what_lies_on_the_table_or_outside_the_volume_is_out_of_view() -> None:
    places = np.array([[0, 0, 0.05], [0, 0, 5.0], [80.0, 0, 5.0], [0, 0, 120.0]])
    far = raised(sphere(1.0, 1), 60.0)
    sight = Sightlines(RIG, CALIBRATION, far, places, np.tile([0.0, 0.0, 1.0], (4, 1))).at(0.0)
    assert sight.in_view.tolist() == [False, True, False, False]
    assert np.isnan(sight.point_sd_um).tolist() == [True, False, True, True]


def test_noise_of_the_scan_sets_the_scatter_of_a_point() -> None:
    ball = raised(sphere(10.0, 2), 30.0)
    faint, loud = (Sightlines(RIG, CALIBRATION, ball, noise=model).at(0.0) for model in (NoiseModel(0.0, 4e-5), NoiseModel(0.0, 8e-5, 30.0)))
    seen = faint.measurable
    np.testing.assert_allclose(loud.point_sd_um[seen], np.hypot(2 * faint.point_sd_um[seen], 30.0))


def test_a_dim_spot_is_less_certain_as_the_detector_itself_says() -> None:
    cosines, stated = np.array([0.9, 0.5, 0.25, 0.125]), [0.0078, 0.0137, 0.0260, 0.0510]  # of a rendered scan of a ball, seed 1
    np.testing.assert_allclose(pixel_noise_px(RIG.spot, 198.0 * cosines), stated, rtol=0.15)
