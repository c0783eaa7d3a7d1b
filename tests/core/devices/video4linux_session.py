"""A session with the camera of ``video4linux_kernel.c``, which must be preloaded; tells what happened as JSON.

``python -m tests.core.devices.video4linux_session ROOT``
"""

from __future__ import annotations

import json
import sys
import threading
import time
from dataclasses import asdict
from pathlib import Path

import numpy as np

from scanner_core.clock import ScaledClock
from scanner_core.devices.camera import Trigger
from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.opencv_camera import OpenCvCamera, open_opencv_camera
from scanner_core.devices.opencv_finding import find_opencv_cameras
from scanner_core.devices.video_nodes import VideoNodes
from scanner_core.errors import DeviceError

CLOCK = ScaledClock()


class Session:
    def __init__(self, root: Path) -> None:
        self.root = root
        self.nodes = VideoNodes(root)
        self.told: dict[str, object] = {}

    def open(self, pixel_format: str) -> OpenCvCamera:
        config = CameraConfig("left", "opencv", self.nodes.list()[0].id, 5.0, 3.0, (320, 240), 30.0, pixel_format)
        return open_opencv_camera(config, CLOCK, self.nodes)

    def refusal(self, camera: OpenCvCamera | None) -> tuple[str, float]:
        """Code of the error that comes, and after how many seconds."""
        begin_s = time.monotonic()
        try:
            if camera is None:
                self.open("")
            while camera is not None:
                camera.grab()
        except DeviceError as error:
            return error.code, time.monotonic() - begin_s
        return "", 0.0

    def format(self, name: str) -> None:
        with self.open(name) as camera:
            camera.start(Trigger(0, 15, CLOCK.now_s() + 0.05))
            frames = list(camera.frames(threading.Event()))
            self.told[name] = {
                "frames": len(frames),
                "dropped": camera.dropped,
                "mean": float(np.mean([frame.image.mean() for frame in frames])),
                "age_s": CLOCK.now_s() - frames[-1].time_s,
                "report": asdict(camera.report()),
                "again": self.refusal(None)[0],
                "state": [found.state.name for found in find_opencv_cameras(self.nodes)],
            }

    def faults(self) -> None:
        with self.open("MJPG") as camera:
            (self.root / "broken").touch()
            camera.start(Trigger(0, 20, CLOCK.now_s()))
            self.told["broken"] = [len(list(camera.frames(threading.Event()))), camera.dropped]
            (self.root / "broken").unlink()
            (self.root / "stall").touch()
            self.told["stall"] = self.refusal(camera)
            (self.root / "stall").unlink()
            time.sleep(2.2)  # the driver's own wait ends
            self.told["after the stall"] = camera.grab().image.shape
            (self.root / "hang").touch()
            begin_s = time.monotonic()
        self.told["close"] = time.monotonic() - begin_s
        (self.root / "hang").unlink()
        with self.open("GREY") as camera:
            (self.root / "dev/video0").unlink()
            self.told["pulled"] = self.refusal(camera)


def main() -> int:
    session = Session(Path(sys.argv[1]))
    session.told["found"] = [(found.id, found.description, found.state.name) for found in find_opencv_cameras(session.nodes)]
    for name in ("YUYV", "MJPG", "GREY", "H264"):
        session.format(name)
    session.faults()
    print(json.dumps(session.told))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
