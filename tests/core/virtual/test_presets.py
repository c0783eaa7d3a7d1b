"""The rigs that stand on the virtual bench."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.acquisition.aiming import beam_angles, cylinder_outline
from scanner_core.devices import rig
from scanner_core.errors import UsageError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.triangulation import Triangulator
from scanner_core.virtual.presets import ELEVATION_DEG, PRESETS, TARGET, TERMS, VirtualPreset, camera_azimuth_deg


def test_there_is_one_for_every_rig_file() -> None:
    assert tuple(PRESETS) == rig.PRESETS


def test_the_azimuth_gives_the_half_convergence_angle() -> None:
    assert camera_azimuth_deg(36.5) == pytest.approx(43.38, abs=0.005)


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_cameras_stand_near_their_nominal_place_but_not_on_it(preset: VirtualPreset) -> None:
    eyes = [camera.centre_mm() for camera in preset.cameras]
    for eye, camera in zip(eyes, preset.cameras, strict=True):
        towards = np.array(TARGET) - eye
        assert np.linalg.norm(towards) == pytest.approx(preset.distance_mm, abs=5)
        elevation = np.degrees(np.arcsin(-towards[2] / np.linalg.norm(towards)))
        assert elevation == pytest.approx(ELEVATION_DEG, abs=1)
        off_axis = np.degrees(np.arccos(camera.rotation[2] @ towards / np.linalg.norm(towards)))
        assert 0.05 < off_axis < 1.5
        np.testing.assert_allclose(camera.rotation @ camera.rotation.T, np.eye(3), atol=1e-12)
        assert abs(camera.matrix[0, 2] - (camera.size_px[0] - 1) / 2) > 1
    # left at -y, right at +y, and +x is by definition towards the middle between them
    assert eyes[0][1] < -100 < 100 < eyes[1][1]
    np.testing.assert_allclose((eyes[0] + eyes[1])[1], 0, atol=1e-9)


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_both_cameras_see_the_rig_file_s_volume_at_every_angle(preset: VirtualPreset) -> None:
    volume = rig.load_preset(preset.name).volume
    outline = cylinder_outline(volume.radius_mm, volume.height_mm)
    for camera in preset.cameras:
        pixels = camera.project(outline)
        assert (pixels > 10).all()
        assert (pixels < np.array(camera.size_px) - 11).all()


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_the_rig_file_s_limits_let_the_beam_reach_the_whole_volume(preset: VirtualPreset) -> None:
    config = rig.load_preset(preset.name)
    angles = beam_angles(config.laser, cylinder_outline(config.volume.radius_mm, config.volume.height_mm))
    for column, (low, high) in enumerate((config.limits.x_deg, config.limits.y_deg)):
        assert low + 0.3 < angles[:, column].min()
        assert angles[:, column].max() < high - 0.3
    # the nominal laser is near the true one, and not the same
    off = np.linalg.norm(np.array(config.laser.position_mm) - preset.laser_position_mm)
    assert 0.5 < off < 6


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_speckle_stays_inside_the_footprint(preset: VirtualPreset) -> None:
    assert 0 < preset.speckle_shift_mm < preset.beam_sigma_mm
    assert 0 < preset.speckle_contrast <= 0.65


def test_speckle_of_the_bench_is_that_of_its_lens() -> None:
    # 0.65 x 0.633 um / (2 pi x 8.5 / (2 x 4 x 435)) = 26.8 um
    assert PRESETS["bench"].speckle_shift_mm == pytest.approx(0.0268, rel=0.02)
    assert PRESETS["bench"].speckle_cell_mm == pytest.approx(0.13, abs=0.001)


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_every_term_can_be_switched_off(preset: VirtualPreset) -> None:
    for term in TERMS:
        off = preset.without(term)
        assert preset.name == off.name
        assert off.without(term).cameras[0].distortion.tolist() == off.cameras[0].distortion.tolist()
    bare = preset.without(*TERMS)
    assert bare.speckle_shift_mm == 0 == bare.surface_um == bare.specular == bare.backlash_deg
    assert bare.cameras[0].matrix[0, 0] == bare.cameras[0].matrix[1, 1]
    assert not bare.cameras[1].distortion.any()
    with pytest.raises(UsageError, match=r"no term 'fog'"):
        preset.without("fog")


@pytest.mark.parametrize("preset", PRESETS.values(), ids=PRESETS)
def test_the_rig_file_s_calibration_is_of_this_rig(preset: VirtualPreset) -> None:
    """Perfect images of known points, triangulated with the shipped calibration, give the points in the object frame.

    It fails when somebody moves a true camera without calibrating the rig file anew.
    """
    config = rig.load_preset(preset.name)
    calibration = config.calibration
    assert calibration is not None
    half = 0.6 * config.volume.radius_mm
    in_object = np.random.default_rng(8).uniform((-half, -half, 0), (half, half, 0.8 * config.volume.height_mm), (200, 3))
    for table_deg in (0.0, 140.0):
        pixels = [camera.project(RigidTransform.about_z(table_deg).apply(in_object)) for camera in preset.cameras]
        sigma = np.full(len(in_object), 0.05)
        points = Triangulator(calibration).triangulate(*pixels, sigma, sigma).points
        errors = calibration.rig_to_object(table_deg).apply(points) - in_object
        assert np.sqrt((errors**2).sum(axis=1).mean()) < 0.06
