"""Points of the virtual rig through two network cameras: what a stream of JPEGs costs in micrometres.

The beam rests at one place of a sphere after the other.  At each both cameras are read twice: as the virtual rig gives their frames,
and as OpenCV receives them from two servers that send the same scene as JPEG, exposed anew with other noise.  Told are rms radial
residuals of the sphere that is fitted to either's points, and the rms distance between the two points of a place.
"""

from __future__ import annotations

import argparse
from contextlib import ExitStack
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.devices.camera import Camera
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_drivers import open_camera
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.fitting import fit_sphere
from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.triangulation import Triangulator
from scanner_core.virtual.specimens import load_specimen
from tests.core.devices.mjpeg_server import MjpegServer, Picture

Array = NDArray[np.float64]
REACH_DEG = 0.7
"""Of the beam from the middle of the sphere."""


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """Triangulated from frames as they are and from streamed ones, (n, 3) mm each, the same place in the same row."""

    direct: Array
    streamed: Array

    @property
    def apart_um(self) -> float:
        """Root mean square distance of the two points of a place."""
        return 1e3 * float(np.sqrt(((self.direct - self.streamed) ** 2).sum(axis=1).mean()))


def measure(places: int, quality: int, seed: int, rate_hz: float = 20.0) -> Points:
    """Points at random places of a sphere that stands on the bench."""
    aims = np.random.default_rng(seed).uniform(-REACH_DEG, REACH_DEG, (places, 2))
    with ExitStack() as open_things:
        rig = open_things.enter_context(open_rig(load_preset("bench"), load_specimen("sphere"), 1.0, seed))
        streams = []
        for camera in (rig.left, rig.right):
            server = open_things.enter_context(MjpegServer(_live(rig, camera), rate_hz, quality))
            config = CameraConfig(camera.name, "opencv", server.url, camera.exposure_ms, camera.gain_db)
            streams.append(open_things.enter_context(open_camera(config, rig.clock)))
        detector = SpotDetector(rig.config.spot)
        seen = []
        for x_deg, y_deg in aims:
            rig.motion.aim(x_deg, y_deg)
            rig.motion.laser(True)
            spots = [detector.detect(camera.grab().image) for camera in (rig.left, rig.right, *streams)]
            rig.motion.laser(False)
            if all(isinstance(spot, Spot) for spot in spots):
                seen.append([(spot.x_px, spot.y_px) for spot in spots if isinstance(spot, Spot)])
        assert rig.calibration is not None
        triangulator = Triangulator(rig.calibration)
    px = np.array(seen)
    ones = np.ones(len(px))
    direct, streamed = (triangulator.triangulate(px[:, k], px[:, k + 1], ones, ones).points for k in (0, 2))
    return Points(direct, streamed)


def _live(rig: OpenRig, camera: Camera) -> Picture:
    """What that camera sees now, from a camera object of the server's own."""
    assert rig.bench is not None
    own = rig.bench.camera("left" if camera.name == "left" else "right")
    own.exposure_ms, own.gain_db = camera.exposure_ms, camera.gain_db
    return lambda number: own.grab().image


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--places", type=int, default=60)
    parser.add_argument("--qualities", type=int, nargs="+", default=[95, 85, 70])
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    for quality in given.qualities:
        points = measure(given.places, quality, given.seed)
        direct_um, streamed_um = (1e3 * float(np.sqrt((fit_sphere(p).residuals_mm ** 2).mean())) for p in (points.direct, points.streamed))
        print(
            f"JPEG {quality}: {len(points.direct)} of {given.places} places, seed {given.seed}: radial residual {direct_um:.1f} um direct,"
            f" {streamed_um:.1f} um streamed; the two points {points.apart_um:.1f} um apart (rms)"
        )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
