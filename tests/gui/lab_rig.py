"""A laboratory's own rig without hardware: cameras that are streams over HTTP, a controller that is a firmware in a process of its own.

Both can be pulled and plugged in again.  What the cameras see is computed, and a person's hands are :class:`Hands`.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera_config import CameraConfig
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.errors import DeviceError
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.remote_timeline import RemoteTimeline
from tests.core.devices.mjpeg_server import MjpegServer

RATE_HZ = 8.0
HELD_S = 0.35
"""A picture is computed so often: the machine that runs the tests has other things to do."""
COMMENT = "# the bench by the window"


class FirmwareProcess:
    """A GRBL board at a URL that stays the same when it is pulled and plugged in again."""

    def __init__(self, **settings: object) -> None:
        self._settings = {"boot_s": 0.02, "homing": False, **settings}
        self._port = 0
        self.plug_in()

    def plug_in(self) -> None:
        program = [sys.executable, "-m", "scanner_core.virtual.firmware_process", "--port", str(self._port), "--settings", json.dumps(self._settings)]
        self._process = subprocess.Popen(program, stdout=subprocess.PIPE)
        assert self._process.stdout is not None
        about = json.loads(self._process.stdout.readline())
        self.url: str = about["serial"]
        self._port = int(self.url.rpartition(":")[2])
        host, _, port = about["witness"].partition(":")
        self.witness = RemoteTimeline(host, int(port))

    def pull(self) -> None:
        self.witness.close()
        self._process.kill()
        self._process.wait()
        assert self._process.stdout is not None
        self._process.stdout.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.pull()


class LabRig:
    """A context manager; `file` is the rig file."""

    def __init__(self, folder: Path, *, calibrated: bool = True, **settings: object) -> None:
        self._ends = ExitStack()
        self.firmware = self._ends.enter_context(FirmwareProcess(**settings))
        self.bench = VirtualBench(PRESETS["bench"], None, self.firmware.witness.clock, self.firmware.witness)
        self._lock = threading.Lock()
        self.servers = {side: self._ends.enter_context(MjpegServer(self._picture(side), RATE_HZ)) for side in ("left", "right")}
        config = load_preset("bench")
        cameras = {side: CameraConfig(side, "opencv", server.url, 2.0, 0.0) for side, server in self.servers.items()}
        controller = ControllerConfig("grbl", self.firmware.url)
        calibration = config.calibration if calibrated else None
        config = replace(
            config,
            name="Lab bench",
            virtual=None,
            controller=controller,
            calibration=calibration,
            image_model={},
            left=cameras["left"],
            right=cameras["right"],
        )
        self.file = folder / "lab-bench.toml"
        self.file.write_text(f"{COMMENT}\n{dump_rig(config)}", encoding="utf-8")

    def _picture(self, side: str) -> Callable[[int], NDArray[np.uint8]]:
        index = ("left", "right").index(side)
        seen, taken_s = np.zeros((294, 604), np.uint8), 0.0

        def picture(number: int) -> NDArray[np.uint8]:
            nonlocal seen, taken_s
            now_s = self.firmware.witness.clock.now_s()
            if now_s - taken_s > HELD_S:
                with self._lock, suppress(DeviceError):  # without a controller nobody knows where beam and table are: what was seen last
                    seen = self.bench.image(index, now_s - 0.01, self.bench.preset.exposure_ms, 1.0, number)
                    taken_s = now_s
            return seen

        return picture

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self._ends.close()
