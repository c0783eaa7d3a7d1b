"""A board behind a socket and two network cameras, as one rig and in real time: what they see together is where it is."""

from __future__ import annotations

import numpy as np

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commissioning.sighting import dark_images, point_of, sight
from scanner_core.virtual.specimens.sphere import CENTRE_MM, RADIUS_MM
from tests.core.devices.live_bench import live_bench

_PLACES_DEG = ((0.0, 0.0), (0.6, 0.0), (0.0, 0.6), (-0.6, -0.6))


def test_points_of_a_board_and_cameras_that_are_not_the_programs_own_lie_on_the_sphere() -> None:
    with live_bench("sphere", rate_hz=15.0) as live, open_rig(live.rig(live.calibration())) as rig:
        dark = dark_images(rig, 1)
        points = [point_of(rig, sight(rig, dark, place, 1)) for place in _PLACES_DEG]
        rig.motion.laser(False)
    found = np.array([point for point in points if point is not None])
    assert len(found) >= 3
    outside_mm = np.linalg.norm(found - CENTRE_MM, axis=1) - RADIUS_MM
    assert np.abs(outside_mm).max() < 0.5, "a spot that was seen before or after it moved lies elsewhere"
