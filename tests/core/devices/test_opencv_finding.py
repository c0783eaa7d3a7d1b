"""Looking for USB cameras: each is opened for a moment, and what keeps it from being used is a value."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from scanner_core.devices.found_camera import CameraState
from scanner_core.devices.opencv_finding import find_opencv_cameras, is_black
from tests.core.devices.captures import FakeNodes, open_fake


def test_every_camera_is_told_with_its_state_and_a_thumbnail(tmp_path: Path) -> None:
    nodes = FakeNodes(tmp_path, "black", "deep", "drivermodel", "held", "unopened", "withheld")
    (tmp_path / "held").write_text("BUSY")
    (tmp_path / "withheld").write_text("NOT_PERMITTED")
    found = {camera.id: camera for camera in find_opencv_cameras(nodes, open_fake)}
    assert {name: (camera.state, camera.error.code if camera.error else "") for name, camera in found.items()} == {
        "black": (CameraState.BLACK, "E-CAM-09"),
        "deep": (CameraState.WRONG_FORMAT, "E-CAM-08"),
        "drivermodel": (CameraState.READY, ""),
        "held": (CameraState.IN_USE, "E-CAM-05"),
        "unopened": (CameraState.GONE, "E-CAM-10"),
        "withheld": (CameraState.NOT_PERMITTED, "E-CAM-06"),
    }
    ready = found["drivermodel"]
    assert ready.description == "model drivermodel"
    assert ready.thumbnail is not None
    assert ready.thumbnail.shape == (240, 320)
    assert ready.report is not None
    assert (ready.report.size_px, ready.report.rate_hz, ready.report.pixel_format) == ((640, 480), 30.0, "YUYV")
    assert found["black"].thumbnail is not None
    assert "model held" in str(found["held"].error)


def test_darkness_with_its_noise_is_not_black() -> None:
    dark = np.zeros((4, 48, 64), np.uint8)
    assert is_black(list(dark))
    dark[2, 10, 10] = 1
    assert not is_black(list(dark))
    assert not is_black(list(np.full((4, 48, 64), 200, np.uint8)))
    assert not is_black([])
