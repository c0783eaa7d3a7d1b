"""Cameras of the SDK's own emulation that show images of ours.

The emulation delivers the files of a folder one after the other, in the order of their names and from the first again when it
begins to deliver; each as it is, whatever offset, exposure or gain are set.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from scanner_core.clock import Clock
from scanner_core.devices.basler_camera import BaslerCamera, open_basler
from scanner_core.devices.basler_sdk import load_sdk
from scanner_core.devices.camera_config import CameraConfig, TriggerSource

SERIALS = {"left": "0815-0000", "right": "0815-0001"}
_UNCOMPRESSED = [cv2.IMWRITE_TIFF_COMPRESSION, 1]  # a fifth of the time that the SDK needs for a PNG


@pytest.fixture
def emulation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two emulated cameras on this machine, or skip where there is no wheel of the SDK."""
    pytest.importorskip("pypylon", reason="the extra 'basler' is not installed")
    monkeypatch.setenv("PYLON_CAMEMU", "2")


def basler_config(
    name: str = "left",
    size_px: tuple[int, int] = (64, 48),
    rate_hz: float = 60.0,
    trigger: TriggerSource = TriggerSource.SOFTWARE,
    exposure_ms: float = 1.0,
) -> CameraConfig:
    """A rig file's words for an emulated camera."""
    return CameraConfig(name, "basler", SERIALS[name], exposure_ms, 0.0, size_px, rate_hz, trigger=trigger)


def write_images(folder: Path, images: Sequence[NDArray[np.uint8]]) -> Path:
    """A folder of images for :func:`show`."""
    for k, image in enumerate(images):
        write_image(folder, k, image)
    return folder


def write_image(folder: Path, k: int, image: NDArray[np.uint8]) -> None:
    """The image that comes after `k` others."""
    folder.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(os.fspath(folder / f"{k:06d}.tif"), image, _UNCOMPRESSED)


def device_of(camera: BaslerCamera) -> Any:
    """The SDK's own camera, to let something befall it."""
    return camera._device


def show(camera: BaslerCamera, folder: Path) -> None:
    """Let the camera deliver the images of a folder, which must be of its size."""
    device = device_of(camera)
    device.ImageFileMode.SetValue("On")
    device.ImageFilename.SetValue(os.fspath(folder))


def give_edge(camera: BaslerCamera) -> None:
    """An edge on the trigger line, when the camera is ready for one; a camera that does not grab does not see it."""
    sdk, device = load_sdk(), device_of(camera)
    with suppress(sdk.genicam.GenericException):
        device.WaitForFrameTriggerReady(1000, sdk.pylon.TimeoutHandling_Return)
        device.ExecuteSoftwareTrigger()


def pull_cable(camera: BaslerCamera) -> None:
    """What the SDK learns when the camera is unplugged."""
    device_of(camera).FirePnPCallback.Execute()


def open_emulated(config: CameraConfig, clock: Clock, folder: Path) -> BaslerCamera:
    """An emulated camera that shows the images of a folder; :func:`emulation` must be in force."""
    camera = open_basler(config, clock)
    try:
        show(camera, folder)
    except BaseException:
        camera.close()
        raise
    return camera
