"""Stand-ins for ``cv2.VideoCapture``: what a Video4Linux driver does, and what no camera at hand does on demand.

A source's name says how it behaves; they are made inside the process that reads a camera, so everything here can be imported there.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.opencv_process import Source
from scanner_core.devices.opencv_settings import Capture, fourcc_name, fourcc_number
from scanner_core.devices.video_nodes import Access, VideoNode, VideoNodes

FOREVER_S = 3600.0


class DriverModel:
    """A UVC camera behind Video4Linux: two formats, two sizes, 30 frames/s, exposure in 100 us from 3 to 2047, gain to 100."""

    backend = "V4L2"
    sizes = ((640, 480), (320, 240))
    formats = ("YUYV", "MJPG")
    rates = (30.0,)
    offset_s = 0.0
    """Added to the time stamps."""

    def __init__(self) -> None:
        self.values: dict[int, float] = {
            cv2.CAP_PROP_FOURCC: fourcc_number(self.formats[0]),
            cv2.CAP_PROP_FRAME_WIDTH: self.sizes[0][0],
            cv2.CAP_PROP_FRAME_HEIGHT: self.sizes[0][1],
            cv2.CAP_PROP_FPS: self.rates[0],
            cv2.CAP_PROP_AUTO_EXPOSURE: 3,
            cv2.CAP_PROP_EXPOSURE: 157,
            cv2.CAP_PROP_GAIN: 20,
            cv2.CAP_PROP_AUTOFOCUS: 1,
        }
        self.frames = 0
        self._stamp_s = time.monotonic()

    def isOpened(self) -> bool:  # noqa: N802
        return True

    def getBackendName(self) -> str:  # noqa: N802
        return self.backend

    def get(self, prop: int) -> float:
        if prop == cv2.CAP_PROP_POS_MSEC:
            return 1e3 * (self._stamp_s + self.offset_s)
        return self.values.get(prop, -1.0)

    def set(self, prop: int, value: float) -> bool:
        if prop == cv2.CAP_PROP_FOURCC and fourcc_name(value) not in self.formats:
            return False
        if prop == cv2.CAP_PROP_FRAME_WIDTH:  # the driver takes the nearest size
            value, self.values[cv2.CAP_PROP_FRAME_HEIGHT] = min(self.sizes, key=lambda size: abs(size[0] - value))
        if prop == cv2.CAP_PROP_FRAME_HEIGHT or prop not in self.values:
            return prop in self.values
        if prop == cv2.CAP_PROP_FPS:
            value = min(self.rates, key=lambda rate: abs(rate - value))
        if prop == cv2.CAP_PROP_EXPOSURE:
            value = float(np.clip(value, 3, 2047))
        if prop == cv2.CAP_PROP_GAIN:
            value = float(np.clip(value, 0, 100))
        self.values[prop] = value
        return True

    def grab(self) -> bool:
        self._stamp_s += 1.0 / self.rates[0]
        time.sleep(max(0.0, self._stamp_s - time.monotonic()))
        self.frames += 1
        return True

    def retrieve(self) -> tuple[bool, NDArray[Any] | None]:
        return True, self.picture()

    def picture(self) -> NDArray[Any]:
        shape = (int(self.values[cv2.CAP_PROP_FRAME_HEIGHT]), int(self.values[cv2.CAP_PROP_FRAME_WIDTH]), 3)
        return np.full(shape, 40 + self.frames % 100, np.uint8)

    def release(self) -> None:
        pass


class Hanging(DriverModel):
    """The driver stops answering after a second and a half of frames, and does not even let go."""

    def grab(self) -> bool:
        if self.frames > 60:
            time.sleep(FOREVER_S)
        return super().grab()

    def release(self) -> None:
        time.sleep(FOREVER_S)


class Sluggish(DriverModel):
    """Once it delivers, another exposure takes it a second."""

    def set(self, prop: int, value: float) -> bool:
        if prop == cv2.CAP_PROP_EXPOSURE and self.frames > 10:
            time.sleep(1.0)
        return super().set(prop, value)


class Mute(DriverModel):
    """It opens and never gives a frame; every read comes back after the driver's own deadline."""

    def grab(self) -> bool:
        time.sleep(2.0)
        return False


class Deep(DriverModel):
    """16 bits a pixel."""

    def picture(self) -> NDArray[Any]:
        return np.zeros((48, 64), np.uint16)


class Resized(DriverModel):
    """Its frames change their size."""

    def picture(self) -> NDArray[Any]:
        return np.zeros((48 if self.frames < 50 else 24, 64, 3), np.uint8)


class Pulled(DriverModel):
    """Somebody pulls the plug: the node goes, reads fail at once."""

    def __init__(self, node: Path) -> None:
        super().__init__()
        self._node = node

    def grab(self) -> bool:
        if self.frames > 50:
            self._node.unlink(missing_ok=True)
            return False
        return super().grab()


class Flawed(DriverModel):
    """Every sixteenth frame arrives broken."""

    def grab(self) -> bool:
        return super().grab() and self.frames % 16 != 0


class Black(DriverModel):
    """A closed shutter: not even noise."""

    def picture(self) -> NDArray[Any]:
        return np.zeros((48, 64, 3), np.uint8)


class Throwing(DriverModel):
    """OpenCV lets a driver's exception through."""

    def grab(self) -> bool:
        if self.frames > 50:
            raise cv2.error("from its depths")
        return super().grab()


class Unopened(DriverModel):
    def isOpened(self) -> bool:  # noqa: N802
        return False


def open_fake(source: Source) -> Capture:
    """The capture whose class has the name of the node, in lower case."""
    assert isinstance(source, str)
    node = Path(source)
    if node.name == "deaf":
        time.sleep(FOREVER_S)
    if node.name == "pulled":
        return Pulled(node)
    kinds: dict[str, type[DriverModel]] = {
        kind.__name__.lower(): kind for kind in (DriverModel, Hanging, Sluggish, Mute, Deep, Resized, Flawed, Black, Throwing, Unopened)
    }
    return kinds[node.name]()


class FakeNodes(VideoNodes):
    """Nodes that are plain files of a folder; `access` says what stands in them, FREE when they are empty."""

    def __init__(self, root: Path, *names: str) -> None:
        super().__init__(root)
        self._folder = root
        for name in names:
            (root / name).touch()

    def list(self) -> list[VideoNode]:
        return [VideoNode(path, path.name, self.description(path)) for path in sorted(self._folder.iterdir())]

    def resolve(self, identity: str) -> Path:
        return self._folder / identity

    def access(self, path: Path, *, quick: bool = False) -> Access:
        if not path.exists():
            return Access.GONE
        return Access[path.read_text() or "FREE"]

    def description(self, node: Path) -> str:
        return f"model {node.name}"
