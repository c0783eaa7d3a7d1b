"""The correction for the size of the spot, against the light that the virtual rig computes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.clock import make_clock
from scanner_core.metrology.spot_bias import SpotOnSphere, radial_bias_mm
from scanner_core.optics.triangulation import Triangulator
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.exposure import Shutter
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens import load_specimen
from scanner_core.virtual.specimens.sphere import CENTRE_MM, RADIUS_MM
from tests.core.virtual.conftest import ScriptedMotion

RIG = PRESETS["bench"].without("speckle", "stray_light", "warm_up", "backlash")
EXPOSURE_S = 1e-3 * RIG.exposure_ms


@pytest.mark.parametrize(("speed_deg_s", "mean_um"), [(0.0, -6.0), (6.5, -9.0)])
def test_it_is_what_the_middle_of_the_light_says(speed_deg_s: float, mean_um: float) -> None:
    """Noise-free: flux-weighted centroids of both images, triangulated with the true cameras; facets take half a micrometre off."""
    calibration = VirtualBench(RIG, None, make_clock("max"), ScriptedMotion()).truth_calibration()
    triangulator, shutter, scene = Triangulator(calibration), Shutter(RIG, 0), Scene(RIG, load_specimen("sphere"))
    rng = np.random.default_rng(7)
    points = []
    for _ in range(80):
        motion = ScriptedMotion(y_deg=rng.uniform(-2.6, -0.4), x_speed_deg_s=speed_deg_s)
        motion.x_deg = rng.uniform(-1.0, 1.0) - speed_deg_s * 0.5 * EXPOSURE_S
        spots = shutter.expose(scene, motion, 0.0, RIG.exposure_ms).spots
        images = [np.array([[s.flux_dn @ s.x_px, s.flux_dn @ s.y_px]]) / s.flux_dn.sum() for s in spots if s is not None]
        if len(images) < 2:
            continue
        seen = triangulator.triangulate(images[0], images[1], np.ones(1), np.ones(1)).points
        points.append(calibration.rig_to_object(0.0).apply(seen)[0])
    found = np.array(points)
    centre = np.array(CENTRE_MM)
    error = 1e3 * (np.linalg.norm(found - centre, axis=1) - RADIUS_MM)
    sphere = (found[:, 2] > 4) & (np.abs(error) < 100)  # elsewhere a part of the spot lies on the table
    spot_on = SpotOnSphere(tuple(RIG.laser_position_mm.tolist()), RIG.beam_sigma_mm, float(np.radians(speed_deg_s)) * EXPOSURE_S)
    expected = 1e3 * radial_bias_mm(found, np.zeros(len(found)), centre, RADIUS_MM, spot_on, calibration)
    assert sphere.sum() > 30
    assert np.mean(error[sphere]) == pytest.approx(mean_um, abs=1.5)
    assert np.mean(error[sphere] - expected[sphere]) == pytest.approx(-0.5, abs=0.6)
    assert np.percentile(np.abs(error[sphere] - expected[sphere]), 90) < 1.8


def test_a_point_like_spot_has_none() -> None:
    calibration = VirtualBench(RIG, None, make_clock("max"), ScriptedMotion()).truth_calibration()
    top = np.array([[3.0, 0.0, CENTRE_MM[2] + RADIUS_MM], [RADIUS_MM, 0.0, CENTRE_MM[2]]])
    spot = SpotOnSphere(tuple(replace(RIG).laser_position_mm.tolist()), 1e-6)
    assert np.abs(radial_bias_mm(top, np.zeros(2), np.array(CENTRE_MM), RADIUS_MM, spot, calibration)).max() < 1e-9
