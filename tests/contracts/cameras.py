"""Ways to open two cameras, for the contract that all of them keep."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.clock import Clock, ScaledClock, SteppedClock
from scanner_core.devices.camera import Camera, Frame, Trigger
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.camera_drivers import open_camera
from scanner_core.devices.frame_writer import FrameWriter
from scanner_core.devices.recording_camera import RecordingCamera
from scanner_core.devices.rig import RigConfig
from scanner_core.virtual.bench_faults import BenchFault, CameraStalled, FramesDropped
from scanner_core.virtual.camera import VirtualCamera
from scanner_core.virtual.disturbed import Disturbed
from scanner_core.virtual.presets import PRESETS
from tests.core.devices.mjpeg_server import MjpegServer

SIDES = ("left", "right")
COUNT = 12
"""Exposures of every run of the contract; its first run begins at id 100, the second one at 200."""
SINGLES = 4
SIZE_PX = (64, 48)
RATE_HZ = 30.0


@dataclass(frozen=True, slots=True)
class Pair:
    """Two open cameras.

    Attributes
    ----------
    whole : every exposure of a run is delivered, because time waits for the reader
    timed : their frames bear times of `clock`, not those of a recording
    """

    left: Camera
    right: Camera
    clock: Clock
    whole: bool
    timed: bool = True

    def run(self, first_id: int, stop: threading.Event | None = None, count: int = COUNT) -> tuple[list[Frame], list[Frame]]:
        """Both armed with one trigger and read to the end, each in a thread of its own."""
        trigger = Trigger(first_id, count, self.clock.now_s() + 0.25)
        seen: dict[str, list[Frame]] = {}

        def read(camera: Camera) -> None:
            seen[camera.name] = list(camera.frames(stop or threading.Event()))

        for camera in (self.left, self.right):
            camera.start(trigger)
        readers = [threading.Thread(target=read, args=(camera,)) for camera in (self.left, self.right)]
        for reader in readers:
            reader.start()
        for reader in readers:
            reader.join(30.0)
        return seen["left"], seen["right"]


Opening = Callable[[], AbstractContextManager[Pair]]


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of camera.

    Attributes
    ----------
    open : the pair as it should be
    lasting : opening takes time, so that tests which leave the cameras open share a pair
    losing : a pair of which the right camera loses frames; None where nothing can lose any
    silent : a pair of which the right camera gives no frame any more, though it is open
    """

    open: Opening
    lasting: bool = False
    losing: Opening | None = None
    silent: Opening | None = None


# ------------------------------------------------------------------------------------------ virtual
class Noise:
    """Stands for the bench: every exposure of each camera is another image."""

    def image(self, index: int, start_s: float, exposure_ms: float, gain: float, key: int) -> NDArray[np.uint8]:
        return np.random.default_rng([index, key]).integers(0, 256, SIZE_PX[::-1], np.uint8)


@contextmanager
def virtual_pair(fault: BenchFault | None = None) -> Iterator[Pair]:
    clock, disturbed = SteppedClock(), Disturbed(PRESETS["bench"])
    if fault is not None:
        disturbed.let_happen(fault)
    with ExitStack() as opened:
        cameras = [VirtualCamera(side, k, SIZE_PX, RATE_HZ, 2.0, clock, Noise(), 1, disturbed) for k, side in enumerate(SIDES)]
        left, right = (opened.enter_context(camera) for camera in cameras)
        yield Pair(left, right, clock, whole=True)


LOSING = FramesDropped(camera="right", share=0.3)


def virtual() -> Kind:
    return Kind(virtual_pair, losing=partial(virtual_pair, LOSING), silent=partial(virtual_pair, CameraStalled(camera="right")))


# ------------------------------------------------------------------------------------------ replay
@contextmanager
def replayed_pair(left: Path, right: Path, timed: bool) -> Iterator[Pair]:
    clock = SteppedClock()
    with ExitStack() as opened:
        configs = [CameraConfig(side, "replay", str(path), 2.0, 0.0, rate_hz=RATE_HZ) for side, path in zip(SIDES, (left, right), strict=True)]
        cameras = [opened.enter_context(open_camera(config, clock)) for config in configs]
        yield Pair(cameras[0], cameras[1], clock, whole=True, timed=timed)


def record(folder: Path, fault: BenchFault | None = None) -> Path:
    """What the contract asks for, once: single frames and two runs."""
    with virtual_pair(fault) as pair:
        writers = [FrameWriter(folder / camera.name, camera.name, 1 << 12, hurry=False) for camera in (pair.left, pair.right)]
        cameras = [
            RecordingCamera(camera, CameraConfig(camera.name, "virtual", "", 2.0, 0.0), writer)
            for camera, writer in zip((pair.left, pair.right), writers, strict=True)
        ]
        recorded = replace(pair, left=cameras[0], right=cameras[1])
        for camera in cameras:
            for _ in range(SINGLES):
                camera.grab()
        for first_id in (100, 200):
            recorded.run(first_id)
        for writer in writers:
            writer.close()
    return folder


def recording(folder: Path) -> Kind:
    whole, losing = record(folder / "whole"), record(folder / "losing", LOSING)
    return Kind(partial(replayed_pair, whole, whole, timed=False), losing=partial(replayed_pair, losing, losing, timed=False))


def pictures(seed: int) -> list[NDArray[np.uint8]]:
    """As many as one test of the contract asks for."""
    return list(np.random.default_rng(seed).integers(0, 256, (2 * COUNT + SINGLES, *SIZE_PX[::-1]), np.uint8))


def images(folder: Path) -> Kind:
    for seed, side in enumerate(SIDES):
        (folder / side).mkdir(parents=True)
        for number, image in enumerate(pictures(seed)):
            (folder / side / f"{number}.png").write_bytes(cv2.imencode(".png", image)[1].tobytes())
    return Kind(partial(replayed_pair, folder / "left", folder / "right", timed=True))


def video(folder: Path) -> Kind:
    for seed, side in enumerate(SIDES):
        writer = cv2.VideoWriter(str(folder / f"{side}.avi"), cv2.VideoWriter.fourcc(*"FFV1"), RATE_HZ, SIZE_PX, False)
        for image in pictures(seed):
            writer.write(image)
        writer.release()
    return Kind(partial(replayed_pair, folder / "left.avi", folder / "right.avi", timed=True))


# ------------------------------------------------------------------------------------------ a stream through OpenCV
def picture(number: int) -> NDArray[np.uint8]:
    return np.full(SIZE_PX[::-1], 3 * (number % 64) + 10, np.uint8)


@contextmanager
def streamed_pair(befalls_right: Callable[[MjpegServer], threading.Event] | None = None) -> Iterator[Pair]:
    clock = ScaledClock()
    with ExitStack() as opened:
        servers = [opened.enter_context(MjpegServer(picture, RATE_HZ)) for _ in SIDES]
        configs = [CameraConfig(side, "opencv", server.url, 5.0, 0.0, rate_hz=RATE_HZ) for side, server in zip(SIDES, servers, strict=True)]
        left, right = (opened.enter_context(open_camera(config, clock)) for config in configs)
        if befalls_right is not None:
            befalls_right(servers[1]).set()
            right.start(Trigger(0, 1, clock.now_s()))  # forgets what it had received before
        yield Pair(left, right, clock, whole=False)


def stream(_: Path) -> Kind:
    losing = partial(streamed_pair, lambda server: server.starved)
    return Kind(streamed_pair, lasting=True, losing=losing, silent=partial(streamed_pair, lambda server: server.stalled))


# ------------------------------------------------------------------------------------------ the SDK's emulation
@contextmanager
def emulated_pair(folder: Path, trigger: TriggerSource) -> Iterator[Pair]:
    from tests.core.devices.basler_emulation import basler_config, open_emulated

    clock = ScaledClock()
    with pytest.MonkeyPatch.context() as patch, ExitStack() as opened:
        patch.setenv("PYLON_CAMEMU", "2")
        configs = [basler_config(side, SIZE_PX, RATE_HZ, trigger) for side in SIDES]
        left, right = (opened.enter_context(open_emulated(config, clock, folder)) for config in configs)
        yield Pair(left, right, clock, whole=False)


def emulation(folder: Path, trigger: TriggerSource) -> Kind:
    pytest.importorskip("pypylon", reason="the extra 'basler' is not installed")
    from tests.core.devices.basler_emulation import write_images

    return Kind(partial(emulated_pair, write_images(folder, pictures(0)), trigger), lasting=True)


# ------------------------------------------------------------------------------------------ real devices
@contextmanager
def pair_of(config: RigConfig) -> Iterator[Pair]:
    with open_rig(config) as rig, rig.left, rig.right:  # a camera that a test leaves armed would hold simulated time for the controller
        yield Pair(rig.left, rig.right, rig.clock, whole=not isinstance(rig.clock, ScaledClock))


def hardware(config: RigConfig) -> Kind:
    """The cameras of a rig file, whatever they are."""
    return Kind(partial(pair_of, config), lasting=True)
