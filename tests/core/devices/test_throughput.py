"""Frames a second as a camera delivers them."""

from __future__ import annotations

import time

import numpy as np
import pytest

from scanner_core.clock import ScaledClock
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.camera_drivers import open_camera
from scanner_core.devices.throughput import throughput
from scanner_core.jobs.progress import Cancelled
from tests.core.devices.mjpeg_server import MjpegServer


def test_lost_frames_count_against_the_camera_and_a_cancel_ends_it() -> None:
    clock = ScaledClock()
    with (
        MjpegServer(lambda number: np.full((48, 64), number % 200, np.uint8), 30.0) as server,
        open_camera(CameraConfig("left", "opencv", server.url, 1.0, 0.0, rate_hz=30.0), clock) as camera,
    ):
        whole = throughput(camera, 1.0, clock=clock, cancelled=lambda: False)
        server.starved.set()
        halved = throughput(camera, 1.0, clock=clock, cancelled=lambda: False)
        server.stalled.set()
        begin_s = time.monotonic()
        with pytest.raises(Cancelled):
            throughput(camera, 1.0, clock=clock, cancelled=lambda: True)
    assert time.monotonic() - begin_s < 2.0
    assert 20.0 < whole < 40.0
    assert halved < 0.75 * whole
