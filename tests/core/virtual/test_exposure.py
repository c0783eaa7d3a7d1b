"""What reaches the sensors while the shutters are open."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest

from scanner_core.virtual.exposure import Exposure, Shutter
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import Specimen
from tests.core.virtual.conftest import ScriptedMotion

CLEAN = replace(PRESETS["bench"], exposure_ms=2.0, speckle=0.0, specular=0.0, warm_up_px=(0.0, 0.0))


def centroid(exposure: Exposure, index: int) -> np.ndarray:
    spot = exposure.spots[index]
    assert spot is not None
    return np.array([spot.flux_dn @ spot.x_px, spot.flux_dn @ spot.y_px]) / spot.flux_dn.sum()


def flux(exposure: Exposure, index: int = 0) -> float:
    spot = exposure.spots[index]
    return 0.0 if spot is None else float(spot.flux_dn.sum())


def test_light_grows_with_exposure_and_power(slab: Specimen, motion: ScriptedMotion) -> None:
    shutter, scene = Shutter(CLEAN, 0), Scene(CLEAN, slab)
    once = flux(shutter.expose(scene, motion, 1.0, 2.0))
    assert once > 100
    assert flux(shutter.expose(scene, motion, 1.0, 5.0)) == pytest.approx(2.5 * once)
    motion.laser_power = 0.3
    assert flux(shutter.expose(scene, motion, 1.0, 2.0)) == pytest.approx(0.3 * once)
    motion.laser_power = 0.0
    assert shutter.expose(scene, motion, 1.0, 2.0).spots == (None, None)


def test_a_fast_beam_is_smeared_about_the_middle_of_its_path(slab: Specimen, motion: ScriptedMotion) -> None:
    shutter, scene = Shutter(CLEAN, 0), Scene(CLEAN, slab)
    still = shutter.expose(scene, motion, 0.0, 2.0)
    motion.x_speed_deg_s = 100.0
    motion.x_deg = -0.1  # 0 in the middle of the exposure from 0 to 2 ms
    moving = shutter.expose(scene, motion, 0.0, 2.0)
    assert flux(moving) == pytest.approx(flux(still), rel=0.01)
    np.testing.assert_allclose(centroid(moving, 0), centroid(still, 0), atol=0.02)
    widths = []
    for exposure in (still, moving):
        spot = exposure.spots[0]
        assert spot is not None
        mean = centroid(exposure, 0)[0]
        widths.append(spot.flux_dn @ (spot.x_px - mean) ** 2 / spot.flux_dn.sum())
    # a path of length L adds L^2 / 12; both ends of the path give its length in px
    motion.x_speed_deg_s = 0.0
    ends = []
    for motion.x_deg in (-0.1, 0.1):
        ends.append(centroid(shutter.expose(scene, motion, 0.0, 2.0), 0)[0])
    assert widths[1] - widths[0] == pytest.approx((ends[1] - ends[0]) ** 2 / 12, rel=0.05)


@dataclass
class SwitchedOn:
    """Dark until `at_s`."""

    at_s: float

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(0, 0, 0, float(time_s >= self.at_s))


def test_a_laser_switched_on_during_the_exposure_gives_its_share(slab: Specimen) -> None:
    shutter, scene = Shutter(CLEAN, 0), Scene(CLEAN, slab)
    whole = flux(shutter.expose(scene, SwitchedOn(0.0), 0.0, 2.0))
    assert flux(shutter.expose(scene, SwitchedOn(0.0012), 0.0, 2.0)) == pytest.approx(whole / 3, rel=1e-6)


def test_the_object_turns_with_the_table(slab: Specimen, motion: ScriptedMotion) -> None:
    """Turned by 20 degrees counter-clockwise, a wall through the axis meets the beam nearer to the laser on one side."""
    shutter, scene = Shutter(CLEAN, 0), Scene(CLEAN, slab)
    motion.x_deg = -2.0  # the azimuth falls: towards +y
    motion.table_deg = 20.0
    footprint = scene.light(motion.instant(0))
    assert footprint is not None
    on_wall = footprint.centre
    np.testing.assert_allclose(on_wall[0], 0, atol=0.01)
    spots = shutter.expose(scene, motion, 0.0, 2.0)
    turn = np.radians(20)
    in_table = np.array([-np.sin(turn) * on_wall[1], np.cos(turn) * on_wall[1], on_wall[2]])
    for index in (0, 1):
        np.testing.assert_allclose(centroid(spots, index), CLEAN.cameras[index].project(in_table[None])[0], atol=0.05)


def test_speckle_moves_the_spot_by_its_rms_and_repeats_at_the_same_place(slab: Specimen, motion: ScriptedMotion) -> None:
    preset = replace(CLEAN, speckle=1.0)
    scene = Scene(preset, slab)
    shutters = [Shutter(preset, seed=3), Shutter(preset, seed=3), Shutter(CLEAN, seed=3)]
    shifts, ratios = [], []
    for motion.x_deg in np.linspace(-3, 3, 300):
        rough, again, smooth = (shutter.expose(scene, motion, 0.0, 2.0) for shutter in shutters)
        for index in (0, 1):
            np.testing.assert_array_equal(centroid(rough, index), centroid(again, index))
        shifts.append(np.concatenate([centroid(rough, i) - centroid(smooth, i) for i in (0, 1)]))
        ratios.append([flux(rough, i) / flux(smooth, i) for i in (0, 1)])
    per_mm = np.array([preset.cameras[i].matrix[k, k] / preset.distance_mm for i in (0, 1) for k in (0, 1)])
    np.testing.assert_allclose(np.std(shifts, axis=0) / per_mm, preset.speckle_shift_mm, rtol=0.2)
    np.testing.assert_allclose(np.mean(ratios, axis=0), 1, atol=0.05)
    np.testing.assert_allclose(np.std(ratios, axis=0), preset.speckle_contrast, rtol=0.2)
    assert np.abs(np.corrcoef(np.array(shifts).T) - np.eye(4)).max() < 0.25


def test_a_beam_that_moves_during_the_exposure_averages_over_the_speckle(slab: Specimen, motion: ScriptedMotion) -> None:
    """Over three sigmas of the beam the shifts fall to about two thirds; along and across the motion alike."""
    preset = replace(CLEAN, speckle=1.0)
    scene = Scene(preset, slab)
    rough, smooth = Shutter(preset, seed=3), Shutter(CLEAN, seed=3)
    sd = {}
    for path_mm in (0.0, 0.45):
        motion.x_speed_deg_s = float(np.degrees(path_mm / preset.distance_mm)) / 2e-3
        shifts = []
        for motion.x_deg in np.linspace(-3, 3, 200):
            a, b = (shutter.expose(scene, motion, 0.0, 2.0) for shutter in (rough, smooth))
            shifts.append(np.concatenate([centroid(a, i) - centroid(b, i) for i in (0, 1)]))
        sd[path_mm] = np.std(shifts, axis=0)
    assert 0.5 < (sd[0.45] / sd[0.0]).mean() < 0.8


def test_a_warm_camera_s_image_has_drifted(slab: Specimen, motion: ScriptedMotion) -> None:
    preset = replace(CLEAN, warm_up_px=(0.5, -0.2), warm_up_s=100.0)
    scene, cold, warm = Scene(CLEAN, slab), Shutter(CLEAN, 0), Shutter(preset, 0)
    for time_s, grown in ((0.0, 0.0), (100.0, 1 - np.exp(-1)), (1e4, 1.0)):
        a, b = (shutter.expose(scene, motion, time_s, 2.0) for shutter in (cold, warm))
        np.testing.assert_allclose(centroid(b, 0) - centroid(a, 0), grown * np.array([0.5, -0.2]), atol=1e-9)
        np.testing.assert_allclose(centroid(b, 1) - centroid(a, 1), -grown * np.array([0.5, -0.2]), atol=1e-9)


def test_the_surface_term_moves_both_images_as_one_point_along_the_normal(slab: Specimen, motion: ScriptedMotion) -> None:
    preset = replace(CLEAN, surface_um=50.0)
    scene, rough, smooth = Scene(preset, slab), Shutter(preset, 0), Shutter(CLEAN, 0)
    heights = []
    for motion.x_deg in np.linspace(-3, 3, 120):
        a, b = rough.expose(scene, motion, 0.0, 2.0), smooth.expose(scene, motion, 0.0, 2.0)
        footprint = scene.light(motion.instant(0))
        assert footprint is not None
        place = footprint.centre
        moved = []
        for i in (0, 1):
            camera = preset.cameras[i]
            per_mm = camera.project((place + np.array([0.01, 0, 0]))[None])[0] - camera.project(place[None])[0]
            shift = centroid(a, i) - centroid(b, i)
            moved.append(0.01 * (shift @ per_mm) / (per_mm @ per_mm))
        assert moved[0] == pytest.approx(moved[1], abs=1e-3)
        heights.append(moved[0])
    assert np.std(heights) == pytest.approx(0.05, rel=0.25)
