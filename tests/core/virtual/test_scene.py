"""Ray casting against a slow, explicit oracle."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.aiming import beam_angles
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.scene import TABLE_ALBEDO, Scene
from scanner_core.virtual.specimens import Specimen

Array = NDArray[np.float64]
BENCH = replace(PRESETS["bench"], specular=0.0)


def crossings(mesh: TriangleMesh, start: Array, direction: Array) -> Array:
    """Oracle: all distances at which a ray meets a triangle of the mesh (Moller, Trumbore 1997), sorted."""
    a, b, c = mesh.corners()
    p = np.cross(direction, c - a)
    determinant = ((b - a) * p).sum(axis=1)
    with np.errstate(all="ignore"):
        u = ((start - a) * p).sum(axis=1) / determinant
        q = np.cross(start - a, b - a)
        v = (q @ direction) / determinant
        t = ((c - a) * q).sum(axis=1) / determinant
    return np.sort(t[(u >= 0) & (v >= 0) & (u + v <= 1) & (t > 1e-6)])


def aimed(scene: Scene, place: Array, table_deg: float = 0.0) -> MotionInstant:
    """The beam on a place of the table frame."""
    laser = LaserConfig(tuple(BENCH.laser_position_mm.tolist()), tuple(BENCH.laser_target_mm.tolist()))
    x, y = beam_angles(laser, place[None])[0]
    return MotionInstant(x, y, table_deg, 1.0)


def test_the_beam_turns_by_the_angles_with_which_the_program_aims() -> None:
    scene = Scene(BENCH, None)
    for place in np.random.default_rng(2).uniform((-60, -60, 0), (60, 60, 90), (20, 3)):
        instant = aimed(scene, place)
        expected = place - BENCH.laser_position_mm
        np.testing.assert_allclose(scene.beam(instant.x_deg, instant.y_deg)[0], expected / np.linalg.norm(expected), atol=1e-12)


def test_beam_axes_are_orthonormal() -> None:
    axes = Scene(BENCH, None).beam(3.0, -4.0)
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)


@pytest.mark.parametrize("nodes", [7, 9, 25])
def test_the_beam_s_nodes_have_the_moments_of_its_gaussian(nodes: int) -> None:
    scene = Scene(replace(BENCH, beam_nodes=nodes), None)
    (x, y), w = scene._nodes[0].T, scene._nodes[1]
    sigma = BENCH.beam_sigma_mm
    assert len(w) == nodes
    for power_x, power_y, moment in [(0, 0, 1), (1, 0, 0), (2, 0, sigma**2), (0, 2, sigma**2), (1, 1, 0), (4, 0, 3 * sigma**4), (2, 2, sigma**4)]:
        assert (w * x**power_x * y**power_y).sum() == pytest.approx(moment, abs=1e-12)


def test_an_empty_table_reflects_two_percent() -> None:
    scene = Scene(BENCH, None)
    footprint = scene.light(aimed(scene, np.array([20.0, -15.0, 0.0])))
    assert footprint is not None
    np.testing.assert_allclose(footprint.centre, [20, -15, 0], atol=0.01)
    assert footprint.shares.sum() == pytest.approx(TABLE_ALBEDO)
    assert footprint.seen.all()


def test_a_dark_laser_and_a_beam_beside_the_table_light_nothing() -> None:
    scene = Scene(BENCH, None)
    assert scene.light(MotionInstant(0, 0, 0, 0.0)) is None
    assert scene.light(aimed(scene, np.array([-200.0, 0.0, 0.0]))) is None


@pytest.mark.parametrize("table_deg", [0.0, 201.5])
def test_hits_and_occlusion_agree_with_the_oracle(ear_impression: Specimen, table_deg: float) -> None:
    scene = Scene(BENCH, ear_impression)
    mesh = ear_impression.mesh
    turn = RigidTransform.about_z(-table_deg)
    pivot = turn.apply(BENCH.laser_position_mm)
    eyes = [turn.apply(camera.centre_mm()) for camera in BENCH.cameras]
    rng = np.random.default_rng(3)
    hidden = on_table = 0
    for place in rng.uniform((-9, -8, 0), (9, 8, 22), (6, 3)):
        instant = aimed(scene, place, table_deg)
        footprint = scene.light(instant)
        assert footprint is not None
        axes = turn.rotate(scene.beam(instant.x_deg, instant.y_deg))
        starts = pivot + scene._nodes[0] @ axes[1:]
        assert len(footprint.points) == len(starts)
        for i, start in enumerate(starts):
            met = crossings(mesh, start, axes[0])
            to_table = -start[2] / axes[0][2]
            first = min(to_table, met[0]) if len(met) else to_table
            np.testing.assert_allclose(footprint.points[i], start + first * axes[0], atol=1e-6)
            on_table += first == to_table
            for eye, seen in zip(eyes, footprint.seen, strict=True):
                towards = eye - footprint.points[i]
                distance = np.linalg.norm(towards)
                towards /= distance
                lifted = footprint.points[i] + 2e-3 * footprint.normals[i]
                visible = footprint.normals[i] @ towards > 0 and not len(crossings(mesh, lifted, towards))
                assert seen[i] == visible
                hidden += not visible
    assert hidden > 5
    assert on_table > 3


def test_light_stops_at_the_back_of_an_open_mesh() -> None:
    # a single sheet above the table whose triangles face down, away from the laser
    sheet = TriangleMesh(np.array([[-20.0, -20, 10], [20, -20, 10], [20, 20, 10], [-20, 20, 10]]), np.array([[0, 2, 1], [0, 3, 2]]))
    scene = Scene(BENCH, Specimen("sheet", sheet))
    on_top = scene.light(aimed(scene, np.array([0.0, 0.0, 10.0])))
    assert on_top is not None
    np.testing.assert_allclose(on_top.points[:, 2], 10, atol=1e-9)
    np.testing.assert_allclose(on_top.normals, np.tile([0.0, 0, 1], (7, 1)), atol=1e-9)
    assert on_top.seen.all()
    # light that falls onto the table beside the sheet is hidden from the camera that looks across the sheet
    beside = scene.light(aimed(scene, np.array([0.0, 24.0, 0.0])))
    assert beside is not None
    np.testing.assert_allclose(beside.points[:, 2], 0, atol=1e-9)
    assert not beside.seen[0].any()
    assert beside.seen[1].all()


def test_a_mirror_s_share_lands_where_the_law_of_reflection_says(slab: Specimen) -> None:
    scene = Scene(replace(BENCH, specular=0.1), slab)
    footprint = scene.light(aimed(scene, np.array([0.0, 5.0, 20.0])))
    assert footprint is not None
    assert len(footprint.points) == 8
    direction = np.array([0.0, 5, 20]) - BENCH.laser_position_mm
    direction[0] *= -1  # mirrored by the wall x = 0
    np.testing.assert_allclose(footprint.points[7], np.array([0.0, 5, 20]) - direction * 20 / direction[2], atol=0.02)
    assert footprint.shares[7] == pytest.approx(0.1 * TABLE_ALBEDO)
